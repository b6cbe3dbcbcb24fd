//! Finds the assembly of the first position: all of them are tried, group by group, and `assemble` chooses.

use super::choices::{ambiguous, not_met, point_of};
use super::error::SolveError;
use super::gap::gap_text;
use super::solution::Scene;
use super::state::{Branch, State};
use super::view::View;
use super::words::{labels, links};
use crate::math::Vec2;
use crate::model::{Hint, HintKind, LinkId};
use crate::plan::MotionStep;
use crate::structure::BodyId;

/// More assemblies than this are not followed: without a word on the groups their number doubles with each.
const MOST: usize = 256;
/// Assemblies nearer than this, relative to the mechanism's extent, are one.
pub(super) const SAME: f64 = 1e-9;

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
            // those of different candidates differ already
            let first = next.len();
            for state in assemblies(scene, &candidate.state, index) {
                if !next[first..].iter().any(|c| same(scene, &c.state, &state)) {
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
            // those nearest to the places named so far go on, unless nothing tells them apart
            candidates.sort_by(|a, b| a.far.total_cmp(&b.far));
            if candidates[MOST].far.total_cmp(&candidates[0].far).is_le() {
                return Err(ambiguous(scene, &states(&candidates)));
            }
            candidates.truncate(MOST);
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
            return Err(not_met(scene, hint, &states(&other), index));
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

pub(super) fn bare_view<'a>(scene: &Scene<'a>, state: &'a State) -> View<'a> {
    static NO_STATICS: super::extremes::Statics = super::extremes::Statics::EMPTY;
    View::new(scene, state, &[], &NO_STATICS)
}

/// The one candidate, or that with the least sum of squared distances.
fn nearest(scene: &Scene<'_>, candidates: Vec<Candidate>) -> Result<State, SolveError> {
    let least = candidates.iter().map(|c| c.far).fold(f64::INFINITY, f64::min);
    let close = super::track::extent(scene) * SAME;
    let mut best: Vec<Candidate> =
        candidates.into_iter().filter(|c| c.far.sqrt() <= least.sqrt() + close || c.far.is_nan()).collect();
    if best.len() == 1 { Ok(best.swap_remove(0).state) } else { Err(ambiguous(scene, &states(&best))) }
}

fn states(candidates: &[Candidate]) -> Vec<&State> {
    candidates.iter().map(|c| &c.state).collect()
}

/// What to say of a group that does not close.
pub(super) fn does_not_close(scene: &Scene<'_>, state: State, index: usize, pose: &str) -> SolveError {
    let mut state = state;
    let step = &scene.plan.motion[index];
    let group = &scene.structure.motion[index];
    let labels = labels(scene, group, "does not close");
    if matches!(step, MotionStep::General { .. }) {
        let help = match point_of(scene, group) {
            Some(point) => format!(
                "say where its points are about, as in `assemble {point} near (200 mm, 100 mm)`, or check the lengths"
            ),
            None => "check the lengths".to_owned(),
        };
        return SolveError::NotFound { pose: pose.to_owned(), links: links(scene, group), help, labels };
    }
    state.step::<0>(scene.plan, step);
    let (gap, help) = gap_text(scene, &state, index);
    SolveError::DoesNotClose { pose: pose.to_owned(), gap, help, labels }
}
