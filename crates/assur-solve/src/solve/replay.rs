//! Positions of a solved file solved again: each from a step before it, as the sweep comes to it.

use super::cycle::loads_name_quantities;
use super::inputs::Rates;
use super::solution::{Pose, Solution, Solved};
use super::steps::step_before;
use super::track::Tracker;
use crate::answer::{WholeCycle, balanced};
use crate::model::{LoadId, Value};
use crate::plan::Plan;
use crate::position::{BodyState, Branch, DriveInput, Model, PoseOrigin, State};
use crate::reference::{Reference, reference};

/// Where a position is come from, and what it is asked for.
#[derive(Clone, Debug)]
struct Start {
    bodies: Vec<BodyState>,
    branches: Vec<Branch>,
    inputs: Vec<DriveInput>,
    angles: Vec<f64>,
}

/// Positions of a solved file, to be solved again.
#[derive(Debug)]
pub struct Replay<'a> {
    model: Model<'a>,
    statics: &'a WholeCycle,
    starts: Vec<Start>,
    state: State,
    evaluated: Vec<(LoadId, Value)>,
    quantities: bool,
}

impl<'a> Replay<'a> {
    /// The positions of a solution that have an answer, `most` of them, evenly spread.
    #[must_use]
    pub fn new(model: &Model<'a>, solution: &'a Solution, most: usize) -> Self {
        let solved = |p: &'a Pose| p.outcome.as_ref().ok().filter(|s| !s.state.forces.locked).map(|s| (p, s));
        let asked = solution.poses.iter().filter(|p| !matches!(p.origin, PoseOrigin::Expected(_)));
        let all: Vec<(&Pose, &Solved)> = asked.filter_map(solved).collect();
        let count = all.len().min(most);
        let iterates = !model.plan.is_batchable();
        let rates = Rates::of(model, &solution.statics);
        let starts = (0..count).map(|i| all[i * all.len() / count]);
        let starts = starts.map(|(pose, solved)| start(model, &rates, pose, solved, iterates)).collect();
        Self {
            model: *model,
            statics: &solution.statics,
            starts,
            state: State::new(model.plan),
            evaluated: Vec::new(),
            quantities: loads_name_quantities(model.mechanism),
        }
    }

    #[must_use]
    pub fn len(&self) -> usize {
        self.starts.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.starts.is_empty()
    }

    /// What the drives say, position after position.
    #[must_use]
    pub fn inputs(&self) -> Vec<DriveInput> {
        self.starts.iter().flat_map(|s| s.inputs.iter().copied()).collect()
    }

    /// The position last solved with twice the digits, see [`reference()`].
    #[must_use]
    pub fn reference(&self) -> Option<Reference> {
        reference(&self.model, &self.state, &self.evaluated)
    }

    /// The assemblies at a position.
    #[must_use]
    pub fn branches(&self, index: usize) -> &[Branch] {
        &self.starts[index].branches
    }

    /// Solves one position by a plan of the same mechanism.
    pub fn run(&mut self, plan: &Plan, index: usize) -> &State {
        let (start, state) = (&self.starts[index], &mut self.state);
        state.motion.bodies.copy_from_slice(&start.bodies);
        state.branches.clone_from_slice(&start.branches);
        state.motion.inputs.copy_from_slice(&start.inputs);
        state.forces.locked = false;
        state.run_planned_motion(plan);
        if plan.effects.forces && state.motion.open.is_none() {
            let model = Model { plan, ..self.model };
            balanced(&model, self.statics, state, &start.angles, &mut self.evaluated, self.quantities);
        }
        state
    }
}

fn start(model: &Model<'_>, rates: &Rates, pose: &Pose, solved: &Solved, iterates: bool) -> Start {
    let mut from = solved.state.clone();
    if iterates {
        let mut tracker = Tracker::new(model, solved.state.clone().ready(model.plan), &pose.drives);
        if tracker.advance_to(model, rates, &step_before(model, &pose.drives)).is_ok() {
            from = tracker.state;
        }
    }
    Start {
        bodies: from.motion.bodies,
        branches: solved.state.branches.clone(),
        inputs: solved.state.motion.inputs.clone(),
        angles: solved.angles.clone(),
    }
}
