//! Finds the assembly of the first position: all of them are tried, group by group, and `assemble` chooses.

use super::as_written::{is_as_written, resting, written};
use super::failure::Cause;
use super::initial_guess::initial_guess;
use super::unassembled::{ambiguous, does_not_close, not_met};
use crate::answer::{PoseAnswers, first_angles};
use crate::group::general::InitialGuess;
use crate::math::Vec2;
use crate::model::{Hint, HintKind, LinkId, PairKind};
use crate::plan::MotionStep;
use crate::position::{BodyState, Branch, DEAD, Model, SAME, STARTS, State, Workspace, extent};

/// More assemblies than this are not followed: without a word on the first groups their number doubles with each.
const MOST: usize = 256;

/// An assembly as far as it is built, with the sum of squared distances that `near` asks for.
#[derive(Clone)]
struct Candidate {
    state: State,
    far: f64,
}

/// A way in which a group can stand.
#[derive(Clone)]
pub(super) struct Assembly {
    branch: Branch,
    pub conditioning: f64,
    certificate: f64,
    bodies: Vec<BodyState>,
    /// Memory of a general group that stands so.
    work: Option<(usize, Workspace)>,
}

impl Assembly {
    pub(crate) fn of(model: &Model<'_>, state: &State, index: usize) -> Self {
        let work = match &model.plan.motion[index] {
            MotionStep::General { problem, .. } => {
                state.scratch.motion_work.get(*problem).cloned().flatten().map(|work| (*problem, work))
            }
            _ => None,
        };
        let bodies = model.structure.motion[index].bodies.iter().map(|b| state.motion.bodies[b.0]).collect();
        let (conditioning, certificate) = (state.motion.conditions[index], state.motion.certificates[index]);
        Self { branch: state.branches[index], conditioning, certificate, bodies, work }
    }

    /// Takes over how the group of a state without general groups stands.
    pub(super) fn take(&mut self, model: &Model<'_>, state: &State, index: usize) {
        self.branch = state.branches[index];
        (self.conditioning, self.certificate) =
            (state.motion.conditions[index], state.motion.certificates[index]);
        self.bodies.clear();
        self.bodies.extend(model.structure.motion[index].bodies.iter().map(|b| state.motion.bodies[b.0]));
        self.work = None;
    }

    /// Puts the group of a state this way.
    pub(super) fn put(&self, model: &Model<'_>, state: &mut State, index: usize) {
        state.branches[index] = self.branch;
        state.motion.conditions[index] = self.conditioning;
        state.motion.certificates[index] = self.certificate;
        state.motion.open = None;
        for (body, stands) in model.structure.motion[index].bodies.iter().zip(&self.bodies) {
            state.motion.bodies[body.0] = *stands;
        }
        state.carry_parts(model.plan, Some(index));
        if let Some((problem, work)) = &self.work {
            state.scratch.motion_work[*problem] = Some(work.clone());
        }
    }

    pub(super) fn is_same(&self, other: &Self, extent: f64) -> bool {
        let mut bodies = self.bodies.iter().zip(&other.bodies);
        bodies.all(|(x, y)| is_same(x, y, || extent))
    }

    /// Whether the group of a state stands this way, with an extent that is asked for only where it decides.
    pub(super) fn is_here(
        &self,
        model: &Model<'_>,
        state: &State,
        index: usize,
        extent: impl Fn() -> f64,
    ) -> bool {
        let mut bodies = model.structure.motion[index].bodies.iter().zip(&self.bodies);
        bodies.all(|(body, stands)| is_same(stands, &state.motion.bodies[body.0], &extent))
    }
}

fn is_same(x: &BodyState, y: &BodyState, extent: impl Fn() -> f64) -> bool {
    (x.u - y.u).norm() <= SAME && (x.p - y.p).norm() <= SAME * extent()
}

/// Assembles the mechanism for the inputs set in `start`.
pub(crate) fn assemble(model: &Model<'_>, start: State) -> Result<State, Cause> {
    assemble_from(model, start, STARTS)
}

/// As [`assemble`], with a given number of starts of the search for the assemblies of a general group.
pub(super) fn assemble_from(model: &Model<'_>, start: State, starts: usize) -> Result<State, Cause> {
    let mut start = start;
    start.start(model.plan);
    let hints = hints_by_group(model);
    let unnamed = |(rests, hints): (bool, &Vec<usize>)| rests && hints.is_empty();
    let as_written: Vec<bool> = resting(model).into_iter().zip(&hints).map(unnamed).collect();
    let search = Search { model, extent: extent(model), starts, hints };
    if !as_written.contains(&true) {
        return search.assemble(start, None);
    }
    // `assemble` comes first where it decides; without it the search among all assemblies is spared
    if model.mechanism.hints.is_empty() {
        search.assemble(start.clone(), Some(&as_written)).or_else(|_| search.assemble(start, None))
    } else {
        search
            .assemble(start.clone(), None)
            .or_else(|cause| search.assemble(start, Some(&as_written)).map_err(|_| cause))
    }
}

struct Search<'a> {
    model: &'a Model<'a>,
    extent: f64,
    starts: usize,
    /// The hints that are settled with each group.
    hints: Vec<Vec<usize>>,
}

impl Search<'_> {
    /// Assembles group by group; those marked in `as_written` as they are written, where they fit so.
    fn assemble(&self, start: State, as_written: Option<&[bool]>) -> Result<State, Cause> {
        let model = self.model;
        let mut candidates = vec![Candidate { state: start, far: 0.0 }];
        for (index, hints) in self.hints.iter().enumerate() {
            let here = as_written.is_some_and(|groups| groups[index]);
            let mut ways: Vec<(usize, Assembly)> = Vec::new();
            for (i, candidate) in candidates.iter_mut().enumerate() {
                let found = self.ways(&mut candidate.state, index, here);
                ways.extend(found.into_iter().map(|assembly| (i, assembly)));
            }
            if ways.is_empty() {
                let state = candidates.swap_remove(0).state;
                return Err(does_not_close(model, state, index));
            }
            candidates = choose(model, hints, candidates, ways, index)?;
            if candidates.len() > MOST {
                // those nearest to the places named so far go on, unless nothing tells them apart
                candidates.sort_by(|a, b| a.far.total_cmp(&b.far));
                if candidates[MOST].far.total_cmp(&candidates[0].far).is_le() {
                    return Err(ambiguous(model, &states(&candidates)));
                }
                candidates.truncate(MOST);
            }
        }
        nearest(model, candidates)
    }

    /// The way in which a group stands as written, if it is asked for and fits; else all ways.
    fn ways(&self, state: &mut State, index: usize, as_written: bool) -> Vec<Assembly> {
        let (model, extent) = (self.model, self.extent);
        let is_written = |way: &Assembly| is_as_written(model, index, &way.bodies, extent);
        if as_written && let MotionStep::General { problem, .. } = &model.plan.motion[index] {
            let guess = written(model, state, index, &model.plan.general[*problem]);
            let mut found = general(model, state, index, *problem, (0, Some(&guess)));
            found.retain(&is_written);
            if !found.is_empty() {
                found.truncate(1);
                return found;
            }
        }
        let mut ways = ways_from(model, state, index, extent, self.starts);
        if as_written && ways.iter().any(&is_written) {
            ways.retain(&is_written);
        }
        ways
    }
}

/// All ways in which a group can stand, each once.
pub(super) fn every_way(model: &Model<'_>, state: &mut State, index: usize, extent: f64) -> Vec<Assembly> {
    ways_from(model, state, index, extent, STARTS)
}

fn ways_from(
    model: &Model<'_>,
    state: &mut State,
    index: usize,
    extent: f64,
    starts: usize,
) -> Vec<Assembly> {
    let mut ways: Vec<Assembly> = Vec::new();
    for assembly in assemblies(model, state, index, starts) {
        if !ways.iter().any(|w| w.is_same(&assembly, extent)) {
            ways.push(assembly);
        }
    }
    ways
}

/// All ways in which a group can stand; leaves it in one of them.
fn assemblies(model: &Model<'_>, state: &mut State, index: usize, starts: usize) -> Vec<Assembly> {
    let step = &model.plan.motion[index];
    if let MotionStep::General { problem, .. } = step {
        let guess = initial_guess(model, state, index, &model.plan.general[*problem]);
        return general(model, state, index, *problem, (starts, guess.as_ref()));
    }
    if let MotionStep::Triad { triad, .. } = step {
        let found = crate::position::triad_assemblies(state, index, triad);
        return found.iter().map(|state| Assembly::of(model, state, index)).collect();
    }
    if let MotionStep::CamTurned { cam, .. } = step {
        return flanks(model, state, index, model.plan.cams[*cam].flanks.len());
    }
    let roots: &[f64] = if step.has_two_roots() { &[1.0, -1.0] } else { &[1.0] };
    let round = radii(step).map(|r| r != 0.0);
    let sides = |round: bool| if round { vec![1.0, -1.0] } else { vec![1.0] };
    let mut out = Vec::new();
    for &root in roots {
        for &first in &sides(round[0]) {
            for &second in &sides(round[1]) {
                state.branches[index] = Branch { root, sides: [first, second], general_sides: 0 };
                state.motion.open = None;
                state.step::<0>(model.plan, step);
                if state.motion.open.is_none() && cylinders_are_positive(model, state, index) {
                    out.push(Assembly::of(model, state, index));
                }
            }
        }
    }
    if !step.has_two_roots() && out.iter().all(|assembly| assembly.conditioning.abs() <= DEAD) {
        // parallel guides: the sides of circles in contact are nothing to choose from, and the position is told to be dead
        out.truncate(1);
    }
    out
}

fn general(
    model: &Model<'_>,
    state: &State,
    index: usize,
    problem: usize,
    starts: (usize, Option<&InitialGuess>),
) -> Vec<Assembly> {
    let group = &model.plan.general[problem];
    let mut found = crate::position::general_assemblies(state, index, problem, group, starts);
    found.retain(|state| cylinders_are_positive(model, state, index));
    found.iter().map(|state| Assembly::of(model, state, index)).collect()
}

/// The flanks of a cam that reach the lift at which its follower stands.
fn flanks(model: &Model<'_>, state: &mut State, index: usize, count: usize) -> Vec<Assembly> {
    let mut out = Vec::new();
    for flank in 0..u32::try_from(count).unwrap_or(u32::MAX) {
        state.branches[index] = Branch { general_sides: flank, ..Branch::FIRST };
        state.motion.open = None;
        state.step::<0>(model.plan, &model.plan.motion[index]);
        if state.motion.open.is_none() {
            out.push(Assembly::of(model, state, index));
        }
    }
    out
}

/// The coordinate of a cylinder is a distance: what would turn rod against barrel is no assembly.
pub(super) fn cylinders_are_positive(model: &Model<'_>, state: &State, index: usize) -> bool {
    let pairs = model.structure.motion[index]
        .joints
        .iter()
        .filter(|j| j.prismatic)
        .map(|j| model.structure.replaced.joint(j.joint).pair);
    pairs
        .filter(|p| matches!(model.mechanism.pair(*p).kind, PairKind::Cylinder { .. }))
        .all(|p| PoseAnswers::bare(model, state).displacement(p) >= 0.0)
}

/// Radii of the round profiles of a step's prismatic joints.
pub(super) fn radii(step: &MotionStep) -> [f64; 2] {
    match step {
        MotionStep::Rrp { slide, .. } | MotionStep::Rpr { slide, .. } => [slide.radius, 0.0],
        MotionStep::Prp { slides, .. } | MotionStep::Translation { slides, .. } => {
            [slides[0].radius, slides[1].radius]
        }
        MotionStep::Rpp { inner, outer, .. } => [inner.radius, outer.radius],
        _ => [0.0, 0.0],
    }
}

/// The hints that are settled with each group, by their indices: those that speak of links of no later one.
pub(super) fn hints_by_group(model: &Model<'_>) -> Vec<Vec<usize>> {
    let mut settled = vec![None; model.structure.replaced.bodies.len()];
    for (i, group) in model.structure.motion.iter().enumerate() {
        group.bodies.iter().for_each(|b| settled[b.0] = Some(i));
    }
    let mut hints = vec![Vec::new(); model.structure.motion.len()];
    for (i, hint) in model.mechanism.hints.iter().enumerate() {
        let last = links_of(model, hint)
            .into_iter()
            .filter_map(|l| settled[model.structure.replaced.body_of(l).0])
            .max();
        if let Some(last) = last {
            hints[last].push(i);
        }
    }
    hints
}

fn links_of(model: &Model<'_>, hint: &Hint) -> Vec<LinkId> {
    match &hint.kind {
        HintKind::Side { point, from, to, .. } => vec![point.0, from.0, to.0],
        HintKind::Along { point, other, pair, .. } => {
            let mut links = model.mechanism.pair(*pair).kind.links();
            links.extend([point.0, other.0]);
            links
        }
        HintKind::Coordinate { pair, .. } => {
            let kind = &model.mechanism.pair(*pair).kind;
            let mut links = kind.links();
            if let PairKind::Cylinder { barrel, rod, .. } = kind {
                links.extend([*barrel, *rod]);
            }
            links
        }
        HintKind::Near { point, .. } => vec![point.0],
    }
}

/// Keeps the ways that fit the hints settled by this group, and adds the distances of its `near` clauses.
fn choose(
    model: &Model<'_>,
    hints: &[usize],
    mut candidates: Vec<Candidate>,
    mut ways: Vec<(usize, Assembly)>,
    index: usize,
) -> Result<Vec<Candidate>, Cause> {
    let built = |candidates: &[Candidate], ways: &[(usize, Assembly)]| -> Vec<Candidate> {
        let each = ways.iter().map(|(i, assembly)| {
            let mut candidate = candidates[*i].clone();
            assembly.put(model, &mut candidate.state, index);
            candidate
        });
        each.collect()
    };
    let kind = |hint: &usize| &model.mechanism.hints[*hint].kind;
    for hint in hints.iter().filter(|h| !matches!(kind(h), HintKind::Near { .. })) {
        let mut fit_by = |(i, assembly): &(usize, Assembly)| {
            let state = &mut candidates[*i].state;
            assembly.put(model, state, index);
            beyond(model, state, kind(hint))
        };
        let by: Vec<f64> = ways.iter().map(&mut fit_by).collect();
        // what is at the bound but for rounding fits where nothing else does
        let least = if by.iter().any(|by| *by > SAME) { SAME } else { 0.0 };
        let mut by = by.iter();
        let (fit, other): (Vec<_>, Vec<_>) =
            ways.into_iter().partition(|_| by.next().is_some_and(|by| *by >= least));
        if fit.is_empty() {
            let other = built(&candidates, &other);
            return Err(not_met(model, *hint, &states(&other), index));
        }
        ways = fit;
    }
    let mut next = match (candidates.as_mut_slice(), ways.as_slice()) {
        // the common case copies nothing
        ([one], [(_, assembly)]) => {
            assembly.put(model, &mut one.state, index);
            candidates
        }
        _ => built(&candidates, &ways),
    };
    for hint in hints {
        if let HintKind::Near { point, place } = kind(hint) {
            for c in &mut next {
                let away = c.state.motion.bodies[point.0.index()].position(point.1) - *place;
                c.far += away.dot(away);
            }
        }
    }
    Ok(next)
}

pub(super) fn fits(model: &Model<'_>, state: &State, hint: &HintKind) -> bool {
    beyond(model, state, hint) >= 0.0
}

/// By how much it fits a hint: an angle, or a length over the extent.
fn beyond(model: &Model<'_>, state: &State, hint: &HintKind) -> f64 {
    let at = |p: &(LinkId, Vec2)| state.motion.bodies[p.0.index()].position(p.1);
    let signed = |x: f64, positive: bool| if positive { x } else { -x };
    match hint {
        HintKind::Side { point, from, to, left } => {
            let line = at(to) - at(from);
            let side = line.cross(at(point) - at(from)) / (line.norm() * extent(model));
            // a line of no length has no sides
            if side.is_nan() { 0.0 } else { signed(side, *left) }
        }
        HintKind::Along { point, other, pair, ahead } => {
            let view = PoseAnswers::bare(model, state);
            let Some(guide) = view.guide(*pair) else { return 0.0 };
            signed((at(point) - at(other)).dot(view.along(&guide)) / extent(model), *ahead)
        }
        HintKind::Coordinate { pair, bound, greater } => {
            // angles are asked for by revolute pairs alone
            let revolute = matches!(model.mechanism.pair(*pair).kind, PairKind::Revolute(_));
            let angles = if revolute { first_angles(model, state) } else { Vec::new() };
            let view = PoseAnswers { angles: &angles, ..PoseAnswers::bare(model, state) };
            let size = if revolute { 1.0 } else { extent(model) };
            signed((view.displacement(*pair) - *bound) / size, *greater)
        }
        HintKind::Near { .. } => 0.0,
    }
}

/// The one candidate, or that with the least sum of squared distances.
fn nearest(model: &Model<'_>, candidates: Vec<Candidate>) -> Result<State, Cause> {
    let least = candidates.iter().map(|c| c.far).fold(f64::INFINITY, f64::min);
    let close = extent(model) * SAME;
    let mut best: Vec<Candidate> =
        candidates.into_iter().filter(|c| c.far.sqrt() <= least.sqrt() + close || c.far.is_nan()).collect();
    if best.len() == 1 { Ok(best.swap_remove(0).state) } else { Err(ambiguous(model, &states(&best))) }
}

fn states(candidates: &[Candidate]) -> Vec<&State> {
    candidates.iter().map(|c| &c.state).collect()
}
