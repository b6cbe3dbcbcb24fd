//! The one position of a mechanism, solved again and again with other numbers in the memory of the last time. What has more
//! positions, and what something is to be said of, is for [`super::Following`].

use super::assemble::{Assembly, cylinders_are_positive, fits, hints_by_group, radii};
use super::centre_notes::CentreNotes;
use super::cycle::loads_name_quantities;
use super::extremes::asks_extremes;
use super::inputs::{Rates, known_value};
use super::notes::Notes;
use super::refusals::{refusals, unit_speeds};
use super::regular::{self, NO_NOTE, conditions, is_sound};
use super::solution::{Pose, Solution, Solved};
use crate::answer::{PoseAnswers, WholeCycle, balanced, every_query, first_angles_in};
use crate::model::{At, Expr, HintKind, LoadId, Mechanism, PairKind, Positions, Value};
use crate::plan::{Level, Precision};
use crate::position::{
    Branch, DriveValue, Model, PoseOrigin, PoseRequest, State, Wrench, closure_alone, extent, residuals_in,
};

/// What of a position is read beside its answers. What is not read may be missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PoseOutputs {
    /// The residuals of the forces.
    pub residuals: bool,
    /// The angles of all bodies, whether an answer shows them or not.
    pub angles: bool,
}

impl PoseOutputs {
    pub const ALL: Self = Self { residuals: true, angles: true };
    /// Nothing but the answers.
    pub const ANSWERS: Self = Self { residuals: false, angles: false };
}

/// Memory for a position.
pub struct ReusedSolver {
    reads: PoseOutputs,
    /// The hints that are settled with each group.
    hints: Vec<Vec<usize>>,
    /// The ways in which a group can stand.
    ways: Vec<Assembly>,
    /// Distances of cylinders are looked at.
    cylinders: bool,
    rates: Rates,
    loads_name_quantities: bool,
    carried: Vec<f64>,
    totals: Vec<Wrench>,
    evaluated: Vec<(LoadId, Value)>,
}

static NOTHING: WholeCycle = WholeCycle::EMPTY;

impl ReusedSolver {
    /// Memory for a mechanism of closed forms without losses that has one position, and for all that differ from it in numbers
    /// alone; `None` for others.
    #[must_use]
    pub fn of(model: &Model<'_>, reads: PoseOutputs) -> Option<Self> {
        let (mechanism, plan) = (model.mechanism, model.plan);
        let contact = |pair: &crate::model::Pair| matches!(pair.kind, PairKind::Contact { .. });
        let plain = has_one_position(mechanism)
            && plan.is_renumbered()
            && plan.settings.scalar == Precision::F64
            && !plan.effects.loses()
            && mechanism.links.len() > 1
            && mechanism.cycles.is_empty()
            && mechanism.flywheels.is_empty()
            && !mechanism.has_curves
            && !mechanism.asks_again()
            && !mechanism.pairs.iter().any(contact)
            && !asks_extremes(mechanism)
            && CentreNotes::of(mechanism).is_empty()
            && unit_speeds(model).is_none()
            && refusals(model).is_empty();
        let mut angles = reads.angles;
        every_query(mechanism, &mut |query, _| angles |= query.facts().continuous.is_some());
        plain.then(|| Self {
            reads: PoseOutputs { angles, ..reads },
            hints: hints_by_group(model),
            ways: Vec::new(),
            cylinders: mechanism.pairs.iter().any(|pair| matches!(pair.kind, PairKind::Cylinder { .. })),
            rates: Rates::of(model, &NOTHING),
            loads_name_quantities: loads_name_quantities(mechanism),
            carried: Vec::new(),
            totals: Vec::new(),
            evaluated: Vec::new(),
        })
    }

    /// Solves the position of a mechanism that differs from the first in numbers alone; `false` where it is not found, or
    /// something is to be said of it: then the solution is nothing.
    pub fn solve(&mut self, model: &Model<'_>, solution: &mut Solution) -> bool {
        solution.notes.clear();
        (solution.positions, solution.unlisted) = (1, 0);
        if !matches!(solution.poses.as_slice(), [Pose { outcome: Ok(_), .. }]) {
            let outcome = Ok(Solved { state: State::closed(model.plan), ..Solved::default() });
            let (name, origin) = ("1".to_owned(), PoseOrigin::Sweep(0));
            solution.poses.clear();
            solution.poses.push(Pose { name, origin, drives: Vec::new(), outcome });
        }
        let found = match solution.poses.as_mut_slice() {
            [Pose { drives, outcome: Ok(solved), .. }] => {
                drives.clear();
                drives.extend(model.mechanism.drives.iter().map(|drive| first_value(&drive.positions)));
                self.solved(model, drives, solved)
            }
            _ => false,
        };
        if !found {
            solution.poses.clear();
        }
        found
    }

    fn solved(&mut self, model: &Model<'_>, drives: &[DriveValue], solved: &mut Solved) -> bool {
        let Solved { state, angles, .. } = solved;
        self.rates.refresh(model);
        self.rates.at(drives, &mut state.motion.inputs);
        let stands = match model.plan.effects.level {
            Level::Positions => self.moved::<0>(model, state),
            Level::Velocities => self.moved::<1>(model, state),
            Level::Accelerations => self.moved::<2>(model, state),
        };
        if !stands {
            return false;
        }
        if self.reads.angles {
            first_angles_in(model, state, angles);
        } else {
            angles.resize(state.motion.bodies.len() + model.mechanism.pairs.len(), f64::NAN);
        }
        if model.plan.effects.forces {
            let names = self.loads_name_quantities;
            balanced(model, &NOTHING, state, angles, &mut self.evaluated, names);
        }
        solved.condition = conditions(model, state).fold(1.0, f64::min);
        let quiet = conditions(model, state).all(|c| c > NO_NOTE) || self.is_quiet(model, state, drives);
        solved.residuals = if self.reads.residuals {
            residuals_in(model, state, &mut self.totals)
        } else {
            closure_alone(model, state)
        };
        if !quiet || !is_sound(state, &solved.residuals) {
            return false;
        }
        let quantities = std::mem::take(&mut solved.quantities);
        let view = PoseAnswers::new(model, state, angles, &NOTHING);
        solved.quantities = view.all_quantities_in(quantities);
        true
    }

    /// Whether groups near a change point lose so few digits that nothing is to be said.
    fn is_quiet(&mut self, model: &Model<'_>, state: &State, drives: &[DriveValue]) -> bool {
        let (name, origin) = ("1".to_owned(), PoseOrigin::Sweep(0));
        let (mut notes, pose) = (Notes::default(), PoseRequest { name, origin, drives: drives.to_vec() });
        let motion = regular::of_motion(model, state, &mut self.carried, &mut notes, &pose);
        let forces =
            !model.plan.effects.forces || regular::of_forces(model, state, &mut notes, &pose).is_ok();
        motion.is_ok() && forces && notes.is_empty()
    }

    /// Moves every group in the only way that its hints leave, as `assemble` does; `false` where they leave none or several.
    fn moved<const LEVEL: u8>(&mut self, model: &Model<'_>, state: &mut State) -> bool {
        state.start(model.plan);
        model.plan.motion.iter().enumerate().all(|(index, step)| {
            let found = self.only_way(model, state, index);
            if let Some(branch) = found {
                state.branches[index] = branch;
                state.motion.open = None;
                state.step::<LEVEL>(model.plan, step);
            }
            found.is_some() && state.motion.open.is_none()
        })
    }

    fn only_way(&mut self, model: &Model<'_>, state: &mut State, index: usize) -> Option<Branch> {
        let Self { hints, ways, cylinders, .. } = self;
        let step = &model.plan.motion[index];
        if hints[index].is_empty() && is_single(model, index) {
            return Some(Branch::FIRST);
        }
        let (roots, [first, second]) = choices(step);
        let (mut count, mut only) = (0, None);
        for branch in every_branch(roots, first, second) {
            state.branches[index] = branch;
            state.motion.open = None;
            state.step::<0>(model.plan, step);
            let stands =
                state.motion.open.is_none() && (!*cylinders || cylinders_are_positive(model, state, index));
            let here = |way: &Assembly| way.is_here(model, state, index, || extent(model));
            if !stands || ways[..count].iter().any(here) {
                continue;
            }
            match ways.get_mut(count) {
                Some(way) => way.take(model, state, index),
                None => ways.push(Assembly::of(model, state, index)),
            }
            count += 1;
            let kinds = hints[index].iter().map(|hint| &model.mechanism.hints[*hint].kind);
            let mut kinds = kinds.filter(|hint| !matches!(hint, HintKind::Near { .. }));
            if kinds.all(|hint| fits(model, state, hint)) && only.replace(branch).is_some() {
                return None;
            }
        }
        only
    }
}

fn first_value(positions: &Positions) -> DriveValue {
    match positions {
        Positions::List(list) => list.first().and_then(known_value).map_or(DriveValue::None, DriveValue::of),
        Positions::None | Positions::Numbers(_) | Positions::Range { .. } => DriveValue::None,
    }
}

/// The roots of a group with a closed form, and on which sides its round profiles can lie.
fn choices(step: &crate::plan::MotionStep) -> (&'static [f64], [&'static [f64]; 2]) {
    let either: &[f64] = &[1.0, -1.0];
    let one: &[f64] = &[1.0];
    let roots = if step.has_two_roots() { either } else { one };
    (roots, radii(step).map(|r| if r != 0.0 { either } else { one }))
}

/// Whether a group can stand in one way alone, whatever its numbers, and it closes if that does.
fn is_single(model: &Model<'_>, index: usize) -> bool {
    let (roots, [first, second]) = choices(&model.plan.motion[index]);
    roots.len() * first.len() * second.len() == 1
        && !model.structure.motion[index].joints.iter().any(|joint| joint.prismatic)
}

fn every_branch<'c>(
    roots: &'c [f64],
    first: &'c [f64],
    second: &'c [f64],
) -> impl Iterator<Item = Branch> + use<'c> {
    let sides = move |&a: &'c f64| second.iter().map(move |&b| [a, b]);
    let with_sides = move |&root: &'c f64| {
        first.iter().flat_map(sides).map(move |sides| Branch { root, sides, general_sides: 0 })
    };
    roots.iter().flat_map(with_sides)
}

/// Whether each drive has one value, known before anything is solved, and nothing asks for another position.
fn has_one_position(mechanism: &Mechanism) -> bool {
    let known = |expr: &Expr| known_value(expr).is_some();
    let one = |positions: &Positions| matches!(positions, Positions::List(list) if matches!(list.as_slice(), [e] if known(e)));
    let beside = mechanism.expects.iter().any(|e| matches!(e.at, Some(At::Drives(_))));
    let rates = mechanism.drives.iter().flat_map(|d| d.speed.iter().chain(&d.acceleration));
    mechanism.poses.is_empty()
        && !beside
        && mechanism.drives.iter().all(|d| one(&d.positions))
        && rates.into_iter().all(known)
}
