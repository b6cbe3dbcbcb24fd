//! Equal cranks and parallel guides: of three or more links of one length that keep two others parallel, all but two only
//! repeat what the others do, and of parallel guides between the same two links all but one. By the count they hold once
//! too often, by their measures they do not.

use super::count::Count;
use super::defect::Defect;
use super::joint::{BodyId, BodyOrigin, JointKind, Replaced};
use super::ring::repeated_mesh;
use super::roller::{label, listed};
use super::trial::{Change, Statement, Trial};
use super::words::{pairs_of, statement};
use crate::math::Vec2;
use crate::model::{LinkId, PairId};
use assur_math::math::SAME;
use assur_text::diagnostic::{Diagnosis, Help};

/// A link with two hinges, between two others.
struct Bar {
    link: LinkId,
    ends: [(BodyId, Vec2); 2],
    length: f64,
}

/// What may be left out and changes nothing, in the part with a condition too many.
pub(super) fn repeated(trial: Trial<'_>, count: &Count, defect: &Defect) -> Option<Diagnosis> {
    repeated_guide(trial, count, defect)
        .or_else(|| repeated_link(trial, count, defect))
        .or_else(|| repeated_mesh(trial, count, defect))
}

fn repeated_guide(trial: Trial<'_>, count: &Count, defect: &Defect) -> Option<Diagnosis> {
    let guides: Vec<(PairId, [BodyId; 2], Vec2)> = trial
        .replaced
        .joints
        .iter()
        .filter(|j| defect.over.iter().flat_map(|part| &part.pairs).any(|p| p.0 == j.pair))
        .filter_map(|j| match j.kind {
            JointKind::Prismatic { slider, guide, direction, .. } if slider < guide => {
                Some((j.pair, [slider, guide], direction))
            }
            JointKind::Prismatic { slider, guide, along, .. } => Some((j.pair, [guide, slider], along)),
            JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => None,
        })
        .collect();
    for (i, (pair, ends, along)) in guides.iter().enumerate().rev() {
        let parallel = |g: &&(PairId, [BodyId; 2], Vec2)| g.1 == *ends && g.2.cross(*along).abs() <= SAME;
        let Some((other, ..)) = guides[..i].iter().find(parallel) else { continue };
        let now = trial.after(&Change::without(Statement::Pair(*pair))).fit;
        if now.surplus < defect.fit.surplus && now.missing == defect.fit.missing {
            return Some(of_guides(trial, count, *pair, *other));
        }
    }
    None
}

fn of_guides(trial: Trial<'_>, count: &Count, pair: PairId, other: PairId) -> Diagnosis {
    let mechanism = trial.mechanism;
    let (what, first) = (statement(mechanism, pair), statement(mechanism, other));
    repeats(
        &what,
        &format!("{first} does"),
        "parallel guides between the same two links",
        format!(
            "leave out {what}: by the count F = {} the slider could not move; it does, because the guides are parallel, but no \
             equation determines how they share the forces; write a slider that touches at two points as one pair with \
             `contacts`, as in `prismatic {}: … {{ contacts -20 mm, 20 mm }}`",
            count.formula(),
            mechanism.pair(other).name
        ),
        vec![
            label("repeats the other guide", mechanism.pair(pair).span),
            label("parallel to this", mechanism.pair(other).span),
        ],
    )
}

/// A link that may be left out and changes nothing, among those with a condition too many.
fn repeated_link(trial: Trial<'_>, count: &Count, defect: &Defect) -> Option<Diagnosis> {
    let bodies: Vec<BodyId> = defect.over.iter().flat_map(|part| part.bodies.clone()).collect();
    let bars = bars(trial.replaced, &bodies);
    for (i, bar) in bars.iter().enumerate().rev() {
        let same: Vec<&Bar> = bars[..i].iter().filter(|b| keeps_parallel(b, bar)).collect();
        // two of them leave the third nothing to hold
        let Some(others) = same.iter().enumerate().find_map(|(k, a)| {
            let b = same[..k].iter().find(|b| one_figure(a, b, bar))?;
            Some([b.link, a.link])
        }) else {
            continue;
        };
        let now = trial.after(&Change::without(Statement::Link(bar.link))).fit;
        if now.surplus < defect.fit.surplus && now.missing == defect.fit.missing {
            return Some(describe(trial, count, bar, others));
        }
    }
    None
}

fn describe(trial: Trial<'_>, count: &Count, bar: &Bar, others: [LinkId; 2]) -> Diagnosis {
    let mechanism = trial.mechanism;
    let quoted = |l: LinkId| format!("`{}`", mechanism.link(l).name);
    let pairs: Vec<String> =
        pairs_of(mechanism, bar.link).iter().map(|p| format!("`{}`", mechanism.pair(*p).name)).collect();
    let mut labels = vec![label("moves as the others do", mechanism.link(bar.link).span)];
    labels.extend(others.map(|l| label("of the same length", mechanism.link(l).span)));
    repeats(
        &quoted(bar.link),
        &format!("{} do", listed(&others.map(quoted), "and")),
        "equal cranks between the same two links",
        format!(
            "leave out {} with its pairs {}, the motion stays the same: by the count F = {} nothing could move; it does, \
             because the lengths are equal, but no equation determines how these links share the forces",
            quoted(bar.link),
            listed(&pairs, "and"),
            count.formula()
        ),
        labels,
    )
}

/// Bars in the order of their links, none of them driven.
fn bars(replaced: &Replaced, bodies: &[BodyId]) -> Vec<Bar> {
    let mut hinges: Vec<Vec<((BodyId, Vec2), Vec2)>> = vec![Vec::new(); replaced.bodies.len()];
    let mut others = vec![0; replaced.bodies.len()];
    for joint in &replaced.joints {
        if let JointKind::Revolute(members) = &joint.kind
            && let [a, b] = members.as_slice()
        {
            hinges[a.0.0].push((*b, a.1));
            hinges[b.0.0].push((*a, b.1));
        } else {
            joint.bodies().iter().for_each(|b| others[b.0] += 1);
        }
    }
    let bars = bodies.iter().filter_map(|&body| {
        let BodyOrigin::Link(link) = replaced.bodies[body.0].origin else { return None };
        let [(end_a, at_a), (end_b, at_b)] = hinges[body.0].as_slice() else { return None };
        let ends = if end_a.0 <= end_b.0 { [*end_a, *end_b] } else { [*end_b, *end_a] };
        (others[body.0] == 0).then(|| Bar { link, ends, length: (*at_a - *at_b).norm() })
    });
    bars.collect()
}

/// Both join the same two links and have one length.
fn keeps_parallel(a: &Bar, b: &Bar) -> bool {
    a.ends[0].0 == b.ends[0].0 && a.ends[1].0 == b.ends[1].0 && (a.length - b.length).abs() <= SAME * a.length
}

/// Their ends form the same triangle (or line) on both links.
fn one_figure(a: &Bar, b: &Bar, c: &Bar) -> bool {
    let side = |k: usize, x: &Bar, y: &Bar| y.ends[k].1 - x.ends[k].1;
    let [(b_0, c_0), (b_1, c_1)] = [0, 1].map(|k| (side(k, a, b), side(k, a, c)));
    let size = b_0.norm().max(c_0.norm());
    let equal = |x: f64, y: f64| (x - y).abs() <= SAME * size * size;
    equal(b_0.dot(b_0), b_1.dot(b_1))
        && equal(c_0.dot(c_0), c_1.dot(c_1))
        && equal(b_0.dot(c_0), b_1.dot(c_1))
        && equal(b_0.cross(c_0), b_1.cross(c_1))
}

/// A link or guide that only repeats others of its kind.
pub fn repeats(
    what: &str,
    others: &str,
    how: &'static str,
    help: impl Into<Help>,
    labels: impl IntoIterator<Item = miette::LabeledSpan>,
) -> Diagnosis {
    Diagnosis::error(
        "mech::determinacy::repeated",
        format!(
            "{what} {} what {others} already: {how}",
            if what.contains("` and `") { "repeat" } else { "repeats" }
        ),
    )
    .labels(labels)
    .help(help)
}
