//! Finds the assembly of the first position: all of them are tried, group by group, and `assemble` chooses.

use super::error::{SolveError, label};
use super::gap::gap_text;
use super::solution::Scene;
use super::state::{Branch, State};
use super::view::View;
use crate::math::Vec2;
use crate::model::{Hint, HintKind, LinkId};
use crate::plan::MotionStep;
use crate::structure::{BodyId, BodyOrigin, Dyad, Group, GroupKind, JointKind};

/// More assemblies than this are not followed: without a word on the first groups their number doubles with each.
const MOST: usize = 256;
/// Assemblies nearer than this, relative to the mechanism's extent, are one.
const SAME: f64 = 1e-9;

/// An assembly as far as it is built, with the sum of squared distances that `near` asks for.
#[derive(Clone)]
struct Candidate {
    state: State,
    far: f64,
}

/// Assembles the mechanism for the inputs set in `start`.
pub(super) fn assemble(scene: &Scene<'_>, start: State) -> Result<State, SolveError> {
    let mut start = start;
    start.start(scene.plan);
    let mut candidates = vec![Candidate { state: start, far: 0.0 }];
    for index in 0..scene.plan.motion.len() {
        let mut next: Vec<Candidate> = Vec::new();
        for candidate in &candidates {
            for state in assemblies(scene, &candidate.state, index) {
                if !next.iter().any(|c| same(scene, &c.state, &state)) {
                    next.push(Candidate { state, far: candidate.far });
                }
            }
        }
        if next.is_empty() {
            let state = candidates.swap_remove(0).state;
            return Err(does_not_close(scene, state, index, ""));
        }
        candidates = choose(scene, next, index)?;
        if candidates.len() > MOST {
            return Err(ambiguous(scene, &candidates));
        }
    }
    nearest(scene, candidates)
}

/// All states in which a group can stand.
pub(super) fn assemblies(scene: &Scene<'_>, before: &State, index: usize) -> Vec<State> {
    let step = &scene.plan.motion[index];
    if let MotionStep::General { problem, .. } = step {
        let mut found = super::general::assemblies(before, index, *problem, &scene.plan.general[*problem]);
        found.retain(|state| cylinders_are_positive(scene, state, index));
        return found;
    }
    let roots: &[f64] = if before.has_two_roots(step) { &[1.0, -1.0] } else { &[1.0] };
    let round = radii(step).map(|r| r != 0.0);
    let sides = |round: bool| if round { vec![1.0, -1.0] } else { vec![1.0] };
    let mut out = Vec::new();
    for &root in roots {
        for &first in &sides(round[0]) {
            for &second in &sides(round[1]) {
                let mut state = before.clone();
                state.branches[index] = Branch { root, sides: [first, second], general_sides: 0 };
                state.open = None;
                state.step::<0>(scene.plan, step);
                if state.open.is_none() && cylinders_are_positive(scene, &state, index) {
                    out.push(state);
                }
            }
        }
    }
    out
}

/// The coordinate of a cylinder is a distance: what would turn rod against barrel is no assembly.
fn cylinders_are_positive(scene: &Scene<'_>, state: &State, index: usize) -> bool {
    let pairs = scene.structure.motion[index]
        .joints
        .iter()
        .filter(|j| j.prismatic)
        .map(|j| scene.structure.replaced.joint(j.joint).pair);
    pairs
        .filter(|p| matches!(scene.mechanism.pair(*p).kind, crate::model::PairKind::Cylinder { .. }))
        .all(|p| bare_view(scene, state).displacement(p) >= 0.0)
}

/// Radii of the round profiles of a step's prismatic joints.
fn radii(step: &MotionStep) -> [f64; 2] {
    match step {
        MotionStep::Rrp { slide, .. } | MotionStep::Rpr { slide, .. } => [slide.radius, 0.0],
        MotionStep::Prp { slides, .. } | MotionStep::Translation { slides, .. } => {
            [slides[0].radius, slides[1].radius]
        }
        MotionStep::Rpp { inner, outer, .. } => [inner.radius, outer.radius],
        _ => [0.0, 0.0],
    }
}

fn same(scene: &Scene<'_>, a: &State, b: &State) -> bool {
    let extent = super::track::extent(scene);
    a.bodies
        .iter()
        .zip(&b.bodies)
        .all(|(x, y)| (x.p - y.p).norm() <= SAME * extent && (x.u - y.u).norm() <= SAME)
}

/// The first group whose solution settles a link.
fn settled(scene: &Scene<'_>, link: LinkId) -> Option<usize> {
    let body = BodyId(link.index());
    scene.structure.motion.iter().position(|g| g.bodies.contains(&body))
}

fn links_of(scene: &Scene<'_>, hint: &Hint) -> Vec<LinkId> {
    match &hint.kind {
        HintKind::Side { point, from, to, .. } => vec![point.0, from.0, to.0],
        HintKind::Along { point, other, pair, .. } => {
            let mut links = scene.mechanism.pair(*pair).kind.links();
            links.extend([point.0, other.0]);
            links
        }
        HintKind::Coordinate { pair, .. } => {
            let kind = &scene.mechanism.pair(*pair).kind;
            let mut links = kind.links();
            if let crate::model::PairKind::Cylinder { barrel, rod, .. } = kind {
                links.extend([*barrel, *rod]);
            }
            links
        }
        HintKind::Near { point, .. } => vec![point.0],
    }
}

/// Keeps the candidates that fit the hints settled by this group, and adds the distances of its `near` clauses.
fn choose(
    scene: &Scene<'_>,
    mut candidates: Vec<Candidate>,
    index: usize,
) -> Result<Vec<Candidate>, SolveError> {
    for hint in &scene.mechanism.hints {
        let last = links_of(scene, hint).into_iter().map(|l| settled(scene, l)).max().flatten();
        if last != Some(index) {
            continue;
        }
        if let HintKind::Near { point, place } = &hint.kind {
            for c in &mut candidates {
                let away = c.state.bodies[point.0.index()].position(point.1) - *place;
                c.far += away.dot(away);
            }
            continue;
        }
        let (fit, other): (Vec<_>, Vec<_>) =
            candidates.into_iter().partition(|c| fits(scene, &c.state, &hint.kind));
        if fit.is_empty() {
            return Err(not_met(scene, hint, &other, index));
        }
        candidates = fit;
    }
    Ok(candidates)
}

fn fits(scene: &Scene<'_>, state: &State, hint: &HintKind) -> bool {
    let at = |p: &(LinkId, Vec2)| state.bodies[p.0.index()].position(p.1);
    match hint {
        HintKind::Side { point, from, to, left } => {
            let from = at(from);
            let side = (at(to) - from).cross(at(point) - from);
            if *left { side >= 0.0 } else { side <= 0.0 }
        }
        HintKind::Along { point, other, pair, ahead } => {
            let view = bare_view(scene, state);
            let Some(guide) = view.guide(*pair) else { return true };
            let along = (at(point) - at(other)).dot(view.along(&guide));
            if *ahead { along >= 0.0 } else { along <= 0.0 }
        }
        HintKind::Coordinate { pair, bound, greater } => {
            let angles: Vec<f64> = state.bodies.iter().map(|b| b.u.angle()).collect();
            let view = View { angles: &angles, ..bare_view(scene, state) };
            let value = view.displacement(*pair);
            if *greater { value >= *bound } else { value <= *bound }
        }
        HintKind::Near { .. } => true,
    }
}

fn bare_view<'a>(scene: &Scene<'a>, state: &'a State) -> View<'a> {
    static NO_STATICS: super::extremes::Statics = super::extremes::Statics::EMPTY;
    View::new(scene, state, &[], &NO_STATICS)
}

/// The one candidate, or that with the least sum of squared distances.
fn nearest(scene: &Scene<'_>, candidates: Vec<Candidate>) -> Result<State, SolveError> {
    let least = candidates.iter().map(|c| c.far).fold(f64::INFINITY, f64::min);
    let close = super::track::extent(scene) * SAME;
    let mut best: Vec<Candidate> =
        candidates.into_iter().filter(|c| c.far.sqrt() <= least.sqrt() + close || c.far.is_nan()).collect();
    if best.len() == 1 { Ok(best.swap_remove(0).state) } else { Err(ambiguous(scene, &best)) }
}

/// The first group in which the first two candidates differ.
fn ambiguous(scene: &Scene<'_>, candidates: &[Candidate]) -> SolveError {
    let Some(first) = candidates.first() else {
        return SolveError::Ambiguous { count: 0, help: String::new(), labels: Vec::new() };
    };
    let extent = super::track::extent(scene);
    let differs = |group: &Group, other: &State| {
        group.bodies.iter().any(|b| {
            let (x, y) = (&first.state.bodies[b.0], &other.bodies[b.0]);
            (x.p - y.p).norm() > SAME * extent || (x.u - y.u).norm() > SAME
        })
    };
    let index = scene
        .structure
        .motion
        .iter()
        .position(|g| candidates.iter().any(|c| differs(g, &c.state)))
        .unwrap_or(0);
    let mut lines: Vec<String> = Vec::new();
    for c in candidates {
        let line = line_to_paste(scene, &c.state, index);
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    SolveError::Ambiguous {
        count: lines.len(),
        help: format!(
            "write one of\n{}",
            lines.iter().map(|l| format!("  {l}")).collect::<Vec<_>>().join("\n")
        ),
        labels: group_labels(scene, index),
    }
}

fn not_met(scene: &Scene<'_>, hint: &Hint, others: &[Candidate], index: usize) -> SolveError {
    let mut lines: Vec<String> = Vec::new();
    for c in others {
        let line = line_to_paste(scene, &c.state, index);
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    let mut labels = vec![label("no assembly fits this", hint.span)];
    labels.extend(group_labels(scene, index));
    SolveError::HintNotMet {
        help: format!(
            "these exist:\n{}",
            lines.iter().map(|l| format!("  {l}")).collect::<Vec<_>>().join("\n")
        ),
        labels,
    }
}

/// Labels at the pairs of a group.
pub(super) fn group_labels(scene: &Scene<'_>, index: usize) -> Vec<miette::LabeledSpan> {
    let mut seen = Vec::new();
    for joint in &scene.structure.motion[index].joints {
        let pair = scene.structure.replaced.joint(joint.joint).pair;
        if !seen.contains(&pair) {
            seen.push(pair);
        }
    }
    seen.into_iter().map(|p| label("in this group", scene.mechanism.pair(p).span)).collect()
}

/// The links of a group in words.
pub(super) fn group_name(scene: &Scene<'_>, index: usize) -> String {
    let names: Vec<String> = scene.structure.motion[index]
        .bodies
        .iter()
        .filter(|b| matches!(scene.structure.replaced.bodies[b.0].origin, BodyOrigin::Link(_)))
        .map(|&b| scene.structure.replaced.body_name(scene.mechanism, b))
        .collect();
    names.join(", ")
}

/// An `assemble` line that chooses this state of a group.
fn line_to_paste(scene: &Scene<'_>, state: &State, index: usize) -> String {
    let group = &scene.structure.motion[index];
    by_kind(scene, state, group).unwrap_or_else(|| near_line(scene, state, group))
}

fn by_kind(scene: &Scene<'_>, state: &State, group: &Group) -> Option<String> {
    let GroupKind::Dyad(dyad) = group.kind else { return None };
    let replaced = &scene.structure.replaced;
    let real = |i: usize| {
        let pair = scene.mechanism.pair(replaced.joint(group.joints[i].joint).pair);
        let simple =
            matches!(pair.kind, crate::model::PairKind::Revolute(_) | crate::model::PairKind::Prismatic(_));
        simple.then_some(pair)
    };
    let pin = |i: usize| {
        let joint = group.joints[i];
        match &replaced.joint(joint.joint).kind {
            JointKind::Revolute(members) => {
                members.iter().find(|m| m.0 == joint.body).map(|m| state.bodies[joint.body.0].position(m.1))
            }
            JointKind::Prismatic { .. } => None,
        }
    };
    match dyad {
        Dyad::Rrr => {
            let (a, c, b) = (pin(0)?, pin(1)?, pin(2)?);
            let side = if (b - a).cross(c - a) >= 0.0 { "left" } else { "right" };
            Some(format!("assemble {} {side} of {}-{}", real(1)?.name, real(0)?.name, real(2)?.name))
        }
        Dyad::Rrp => {
            let (a, c) = (pin(0)?, pin(1)?);
            let guide = real(2)?;
            let JointKind::Prismatic { guide: base, along, .. } = replaced.joint(group.joints[2].joint).kind
            else {
                return None;
            };
            if !matches!(guide.kind, crate::model::PairKind::Prismatic(_)) {
                return None;
            }
            let ahead = (c - a).dot(along.turned(state.bodies[base.0].u)) >= 0.0;
            let word = if ahead { "ahead of" } else { "behind" };
            Some(format!("assemble {} {word} {}", real(1)?.name, real(0)?.name))
        }
        Dyad::Rpr => {
            let pair = replaced.joint(group.joints[1].joint).pair;
            let radius = matches!(
                replaced.joint(group.joints[1].joint).kind,
                JointKind::Prismatic { offset, .. } if offset > 0.0
            );
            let value = bare_view(scene, state).displacement(pair);
            if radius || !value.is_finite() || value == 0.0 {
                return None;
            }
            let sign = if value > 0.0 { ">" } else { "<" };
            Some(format!("assemble {} {sign} 0", scene.mechanism.pair(pair).name))
        }
        Dyad::Prp | Dyad::Rpp => None,
    }
}

/// `assemble L.P near (x, y)` with the point of the group that is farthest from the links' joints to known bodies.
fn near_line(scene: &Scene<'_>, state: &State, group: &Group) -> String {
    let points = group.bodies.iter().filter_map(|b| match scene.structure.replaced.bodies[b.0].origin {
        BodyOrigin::Link(id) => Some((*b, scene.mechanism.link(id))),
        BodyOrigin::Imaginary(_) => None,
    });
    let outer: Vec<Vec2> = group
        .joints
        .iter()
        .filter(|j| !j.inner)
        .filter_map(|j| match &scene.structure.replaced.joint(j.joint).kind {
            JointKind::Revolute(members) => {
                members.iter().find(|m| m.0 == j.body).map(|m| state.bodies[j.body.0].position(m.1))
            }
            JointKind::Prismatic { .. } => None,
        })
        .collect();
    let mut best: Option<(f64, String)> = None;
    for (body, link) in points {
        for point in &link.points {
            let p = state.bodies[body.0].position(point.at);
            let away = outer.iter().map(|o| (*o - p).norm()).fold(f64::MAX, f64::min);
            if best.as_ref().is_none_or(|b| away > b.0) {
                let text = format!("assemble {}.{} near ({:.4} m, {:.4} m)", link.name, point.name, p.x, p.y);
                best = Some((away, text));
            }
        }
    }
    best.map_or_else(|| "assemble LINK.POINT near (x, y)".to_owned(), |b| b.1)
}

/// What to say of a group that does not close.
pub(super) fn does_not_close(scene: &Scene<'_>, state: State, index: usize, pose: &str) -> SolveError {
    let mut state = state;
    let step = &scene.plan.motion[index];
    if matches!(step, MotionStep::General { .. }) {
        return SolveError::NotFound {
            pose: pose.to_owned(),
            group: group_name(scene, index),
            labels: group_labels(scene, index),
        };
    }
    state.step::<0>(scene.plan, step);
    let (gap, help) = gap_text(scene, &state, index);
    SolveError::DoesNotClose { pose: pose.to_owned(), gap, help, labels: group_labels(scene, index) }
}
