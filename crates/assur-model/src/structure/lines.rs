//! Closed chains of prismatic pairs at the written numbers: each pair fixes the angle between its two bodies, and a pair that closes a
//! chain fixes one that the others fix already. Where both differ no position exists.

use std::collections::VecDeque;
use std::f64::consts::PI;

use assur_text::diagnostic::Diagnosis;

use super::joint::{JointId, JointKind, Replaced};
use super::roller::listed;
use super::trial::{Change, Statement, Trial};
use super::words::statement;
use crate::math::Vec2;
use crate::model::{Guide, Mechanism, PairId, PairKind};
use crate::units::significant;

/// Angles that are nearer to each other are one, rad.
const SAME: f64 = 1e-9;

/// A prismatic pair between two bodies: the angle of the slider is that of the guide and this.
pub(super) struct Edge {
    pub pair: PairId,
    pub joint: JointId,
    slider: usize,
    guide: usize,
    turned: f64,
    /// It closes no chain.
    kept: bool,
}

/// Where a body stands among those that prismatic pairs join.
#[derive(Clone, Copy)]
pub(super) struct Placed {
    /// The first body of its chain, from which angles count.
    pub root: usize,
    pub angle: f64,
    /// The edge and the body by which it was reached.
    by: Option<(usize, usize)>,
}

/// The first prismatic pair whose two lines cannot be parallel.
pub(super) fn contradiction(trial: Trial<'_>) -> Option<Diagnosis> {
    let Trial { mechanism, replaced, .. } = trial;
    let (edges, placed) = chains(mechanism, replaced);
    let edge = edges.iter().find(|edge| is_off(edge, &placed))?;
    let PairKind::Prismatic(own) = &mechanism.pair(edge.pair).kind else { return None };
    Some(apart(trial, (&edges, &placed), (edge, own)))
}

/// Whether all lines that prismatic pairs lay on each other can be parallel; pairs may be among them that the mechanism has not.
pub(super) fn agree(mechanism: &Mechanism, replaced: &Replaced) -> bool {
    let (edges, placed) = chains(mechanism, replaced);
    !edges.iter().any(|edge| is_off(edge, &placed))
}

fn is_off(edge: &Edge, placed: &[Option<Placed>]) -> bool {
    let angle = |body: usize| placed[body].map_or(f64::NAN, |placed| placed.angle);
    !edge.kept && wrapped(angle(edge.slider) - angle(edge.guide) - edge.turned).abs() > SAME
}

/// The prismatic pairs, those by a point first, so that lines on lines close the chains; and where they place the bodies.
pub(super) fn chains(mechanism: &Mechanism, replaced: &Replaced) -> (Vec<Edge>, Vec<Option<Placed>>) {
    let joints = replaced.joints.iter().enumerate();
    let edge = joints.filter_map(|(i, joint)| {
        let JointKind::Prismatic { slider, direction, guide, along, .. } = joint.kind else { return None };
        let turned = angle(along) - angle(direction);
        let (slider, guide) = (slider.0, guide.0);
        Some(Edge { pair: joint.pair, joint: JointId(i), slider, guide, turned, kept: false })
    });
    let mut edges: Vec<Edge> = edge.collect();
    if edges.len() < 2 {
        return (Vec::new(), Vec::new());
    }
    let by_line = |pair: PairId| match mechanism.pairs.get(pair.index()).map(|pair| &pair.kind) {
        Some(PairKind::Prismatic(own)) => own.own_line.is_some(),
        _ => false,
    };
    edges.sort_by_key(|edge| by_line(edge.pair));
    let placed = place(&mut edges, replaced.bodies.len());
    (edges, placed)
}

/// The angle of each body, from the ground or from the first body of its chain; marks the edges that reach one.
fn place(edges: &mut [Edge], bodies: usize) -> Vec<Option<Placed>> {
    let mut group: Vec<usize> = (0..bodies).collect();
    for edge in edges.iter_mut() {
        let (one, other) = (group[edge.slider], group[edge.guide]);
        edge.kept = one != other;
        group.iter_mut().filter(|g| **g == one).for_each(|g| *g = other);
    }
    let mut placed = vec![None; bodies];
    for root in 0..bodies {
        if placed[root].is_some() {
            continue;
        }
        placed[root] = Some(Placed { root, angle: 0.0, by: None });
        let mut queue = VecDeque::from([(root, 0.0)]);
        while let Some((body, angle)) = queue.pop_front() {
            for (index, edge) in edges.iter().enumerate().filter(|(_, edge)| edge.kept) {
                let (next, turned) = match body {
                    _ if body == edge.guide => (edge.slider, edge.turned),
                    _ if body == edge.slider => (edge.guide, -edge.turned),
                    _ => continue,
                };
                if placed[next].is_none() {
                    placed[next] = Some(Placed { root, angle: angle + turned, by: Some((index, body)) });
                    queue.push_back((next, angle + turned));
                }
            }
        }
    }
    placed
}

/// A prismatic pair whose lines have two directions, and the number that makes them one.
fn apart(
    trial: Trial<'_>,
    (edges, placed): (&[Edge], &[Option<Placed>]),
    (edge, own): (&Edge, &Guide),
) -> Diagnosis {
    let Trial { mechanism, replaced, .. } = trial;
    let Edge { slider, guide, .. } = *edge;
    let pair = mechanism.pair(edge.pair);
    let angle_of = |body: usize| placed[body].map_or(0.0, |placed| placed.angle);
    let part = |link| replaced.part(link).map_or(0.0, |part| part.angle);
    let (link, base) = (&mechanism.link(own.slider).name, &mechanism.link(own.guide).name);
    let stands = angle_of(slider) + part(own.slider);
    let lies = angle_of(guide) + part(own.guide) + angle(own.along);
    let by = |body: usize| {
        let mut names = Vec::new();
        let mut at = placed[body];
        while let Some((index, from)) = at.and_then(|placed| placed.by) {
            names.push(format!("`{}`", mechanism.pair(edges[index].pair).name));
            at = placed[from];
        }
        if names.is_empty() { String::new() } else { format!(" (by {})", listed(&names, "and")) }
    };
    let (own_angle, wanted) = (angle(own.direction), degrees(lies - stands));
    let (what, help, aside) = match &own.own_line {
        Some(line) => (
            format!("`{line}` of `{link}` lies at {}", degrees(stands + own_angle)),
            format!("write `line {line} through {} along {wanted}` in `{link}`", own.point_name),
            String::new(),
        ),
        None => (
            format!("the x axis of `{link}` lies at {}", degrees(stands)),
            format!("write `angle {}` in `{}`", degrees(stands - lies), pair.name),
            if own_angle == 0.0 {
                String::new()
            } else {
                format!(", and `angle` is {}", degrees(-own_angle))
            },
        ),
    };
    let line = &own.line_name;
    Diagnosis::error(
        "mech::determinacy::not_parallel",
        format!(
            "`prismatic {}` cannot hold: {what}{}, `{line}` of `{base}` at {}{}{aside}",
            pair.name,
            by(slider),
            degrees(lies),
            by(guide),
        ),
    )
    .label(pair.span, "lays two lines on each other that are not parallel")
    .help(or_without(trial, edge.pair, help))
}

/// A help, and the other one where a pair is too many.
pub(super) fn or_without(trial: Trial<'_>, pair: PairId, help: String) -> String {
    let is_spare = trial.after(&Change::without(Statement::Pair(pair))).is_sound();
    if is_spare { format!("{help}, or leave out {}", statement(trial.mechanism, pair)) } else { help }
}

pub(super) fn degrees(angle: f64) -> String {
    format!("{} deg", significant(wrapped(angle).to_degrees(), 12))
}

/// Within half a turn.
fn wrapped(angle: f64) -> f64 {
    let turns = (angle / (2.0 * PI)).round();
    angle - turns * 2.0 * PI
}

pub(super) fn angle(direction: Vec2) -> f64 {
    libm::atan2(direction.y, direction.x)
}
