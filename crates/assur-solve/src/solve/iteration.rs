//! How a group without a closed form comes to a position of a solution: the steps of the solver, taken again.

use super::as_written::{stands_as_written, written};
use super::initial_guess::initial_guess;
use super::inputs::Rates;
use super::solution::{Pose, Solution, Solved};
use super::steps::step_before;
use super::track::Tracker;
use crate::group::NewtonStep;
use crate::plan::MotionStep;
use crate::position::{DriveValue, Model, STARTS, State, extent};
use assur_math::math::SAME;

/// So many roundings, over the condition of a group, two ways to its position may differ by; and no more than this.
const ROUNDINGS: f64 = 64.0;
const MOST: f64 = 1e-6;

/// Where an iteration begins.
#[derive(Clone, Debug, PartialEq)]
pub enum Begun {
    /// At a start of the search for all assemblies.
    Searched,
    /// Where the group stands at these values of the drives, a largest step of the motion before.
    Followed(Vec<DriveValue>),
}

/// The steps of Newton's method by which a group is found.
#[derive(Clone, Debug, PartialEq)]
pub struct Iteration {
    pub begun: Begun,
    /// The steps; the last one leads to the position.
    pub steps: Vec<NewtonStep>,
}

/// The iteration of a group at a position: the first position comes from the search for all assemblies, every other from the motion.
#[must_use]
pub fn iteration(
    model: &Model<'_>,
    solution: &Solution,
    (pose, solved): (&Pose, &Solved),
    index: usize,
) -> Option<Iteration> {
    let is_first = solution.poses.first().is_some_and(|first| std::ptr::eq(first, pose));
    let mut ways = [followed, searched];
    if is_first {
        ways.reverse();
    }
    ways.into_iter().find_map(|way| way(model, solution, (pose, solved), index))
}

fn followed(
    model: &Model<'_>,
    solution: &Solution,
    (pose, solved): (&Pose, &Solved),
    index: usize,
) -> Option<Iteration> {
    let rates = Rates::of(model, &solution.statics);
    let before = step_before(model, &pose.drives);
    let mut tracker = Tracker::new(model, solved.state.clone().ready(model.plan), &pose.drives);
    tracker.advance_to(model, &rates, &before).ok()?;
    let mut state = tracker.state;
    state.motion.inputs.clone_from(&solved.state.motion.inputs);
    state.branches.clone_from(&solved.state.branches);
    state.start(model.plan);
    for step in &model.plan.motion[..index] {
        state.step::<0>(model.plan, step);
    }
    let steps = state.newton_steps(model.plan, index);
    let found = is_there(model, &state, solved, index) && !steps.is_empty();
    found.then_some(Iteration { begun: Begun::Followed(before), steps })
}

fn searched(
    model: &Model<'_>,
    _: &Solution,
    (_, solved): (&Pose, &Solved),
    index: usize,
) -> Option<Iteration> {
    let mut state = solved.state.clone().ready(model.plan);
    let initial_guess = match &model.plan.motion[index] {
        MotionStep::General { problem, .. } => {
            let group = &model.plan.general[*problem];
            initial_guess(model, &state, index, group).or_else(|| {
                stands_as_written(model, &state, index).then(|| written(model, &state, index, group))
            })
        }
        _ => None,
    };
    let steps = state.search_steps(model.plan, index, (STARTS, initial_guess.as_ref()));
    let found = is_there(model, &state, solved, index) && !steps.is_empty();
    found.then_some(Iteration { begun: Begun::Searched, steps })
}

/// Whether a group stands where it does in a solution, as far as rounding tells it near a dead position.
fn is_there(model: &Model<'_>, state: &State, solved: &Solved, index: usize) -> bool {
    let condition = solved.state.motion.conditions[index].abs();
    let same = SAME.max((ROUNDINGS * f64::EPSILON / condition).min(MOST));
    let near = same * extent(model);
    model.structure.motion[index].bodies.iter().all(|body| {
        let (one, two) = (&state.motion.bodies[body.0], &solved.state.motion.bodies[body.0]);
        (one.p - two.p).norm() <= near && (one.u - two.u).norm() <= same
    })
}
