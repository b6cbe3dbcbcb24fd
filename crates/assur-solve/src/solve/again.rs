//! Positions of a solved file solved again: each from a step before it, as the sweep comes to it.

use super::cycle::loads_name_quantities;
use super::extremes::Statics;
use super::inputs::Rates;
use super::pose::balanced;
use super::solution::{Pose, PoseOrigin, Solution, Solved};
use super::steps::step_before;
use super::track::Tracker;
use crate::model::{LoadId, Value};
use crate::plan::{Level, LoadStep, Plan};
use crate::position::{BodyState, Branch, DriveInput, Scene, State};
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
pub struct Again<'a> {
    scene: Scene<'a>,
    statics: &'a Statics,
    starts: Vec<Start>,
    state: State,
    evaluated: Vec<(LoadId, Value)>,
    /// A load hangs on the motion.
    evaluates: bool,
    quantities: bool,
}

impl<'a> Again<'a> {
    /// The positions of a solution that have an answer, `most` of them, evenly spread.
    #[must_use]
    pub fn new(scene: &Scene<'a>, solution: &'a Solution, most: usize) -> Self {
        let solved = |p: &'a Pose| p.outcome.as_ref().ok().filter(|s| !s.state.locked).map(|s| (p, s));
        let asked = solution.poses.iter().filter(|p| !matches!(p.origin, PoseOrigin::Expected(_)));
        let all: Vec<(&Pose, &Solved)> = asked.filter_map(solved).collect();
        let count = all.len().min(most);
        let iterates = !scene.plan.laned();
        let rates = Rates::of(scene, &solution.statics);
        let starts = (0..count).map(|i| all[i * all.len() / count]);
        let starts = starts.map(|(pose, solved)| start(scene, &rates, pose, solved, iterates)).collect();
        let evaluates = scene.plan.loads.iter().any(|l| matches!(l, LoadStep::Evaluated(_)));
        Self {
            scene: *scene,
            statics: &solution.statics,
            starts,
            state: State::new(scene.plan),
            evaluated: Vec::new(),
            evaluates,
            quantities: loads_name_quantities(scene.mechanism),
        }
    }

    /// Number of positions.
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
        reference(&self.scene, &self.state, &self.evaluated)
    }

    /// The assemblies at a position.
    #[must_use]
    pub fn branches(&self, index: usize) -> &[Branch] {
        &self.starts[index].branches
    }

    /// Solves one position by a plan of the same mechanism.
    pub fn run(&mut self, plan: &Plan, index: usize) -> &State {
        let (start, state) = (&self.starts[index], &mut self.state);
        state.bodies.copy_from_slice(&start.bodies);
        state.branches.clone_from_slice(&start.branches);
        state.inputs.copy_from_slice(&start.inputs);
        state.locked = false;
        match plan.effects.level {
            Level::Positions => state.run_motion::<0>(plan),
            Level::Velocities => state.run_motion::<1>(plan),
            Level::Accelerations => state.run_motion::<2>(plan),
        }
        if !plan.effects.forces || state.open.is_some() {
            return state;
        }
        let scene = Scene { plan, ..self.scene };
        if self.evaluates {
            balanced(&scene, self.statics, state, &start.angles, &mut self.evaluated, self.quantities);
        } else {
            state.run_loads(&scene, &[]);
            state.set_lines(plan);
            if plan.effects.friction {
                state.set_senses(plan);
            }
            state.run_forces(plan);
        }
        state
    }
}

fn start(scene: &Scene<'_>, rates: &Rates, pose: &Pose, solved: &Solved, iterates: bool) -> Start {
    let mut from = solved.state.clone();
    if iterates {
        let mut tracker = Tracker::new(scene, solved.state.clone().ready(scene.plan), &pose.drives);
        if tracker.go(scene, rates, &step_before(scene, &pose.drives)).is_ok() {
            from = tracker.state;
        }
    }
    Start {
        bodies: from.bodies,
        branches: solved.state.branches.clone(),
        inputs: solved.state.inputs.clone(),
        angles: solved.angles.clone(),
    }
}
