//! One position in another scalar: with twice the digits, the reference for what `f64` loses.

use super::kinematics::DriveInput;
use super::state::State;
use crate::math::{Double, Scalar, V2, Vec2};
use crate::plan::{ForceStep, Level, MotionStep, Plan};

/// A scalar in which a position can be computed from drive values in `f64`.
pub trait Edge: Scalar + Default {
    /// The direction (cos, sin) of an angle, rad.
    fn direction(angle: f64) -> V2<Self>;
    /// The same number with twice the digits of `f64`.
    fn widened(self) -> Double;
}

impl Edge for f64 {
    fn direction(angle: f64) -> V2<Self> {
        Vec2::direction(angle)
    }
    fn widened(self) -> Double {
        Double::of(self)
    }
}

impl Edge for Double {
    fn direction(angle: f64) -> V2<Self> {
        Self::direction(angle)
    }
    fn widened(self) -> Double {
        self
    }
}

/// Motion, loads and forces of the position that a state's inputs ask for, with its assemblies, all operations with twice
/// the digits; angles of drives are turned into directions with as many. `None` where a step has no closed form or a load
/// is evaluated at every position, see [`Plan::is_batchable`]. What the plan forms of points, directions, masses and gravity is
/// formed with twice the digits too. The closed forms with more digits: what they are worth shows `reference`, which
/// does not use them.
#[must_use]
pub fn precise(plan: &Plan, reference: &State) -> Option<State<Double>> {
    in_scalar(plan, reference)
}

/// As [`precise`], in any scalar.
#[must_use]
pub fn in_scalar<S: Edge>(plan: &Plan, reference: &State) -> Option<State<S>> {
    if !plan.is_batchable() {
        return None;
    }
    let mut state = State::closed(plan);
    state.branches.clone_from(&reference.branches);
    state.set_inputs(&reference.motion.inputs);
    state.run_closed(plan);
    Some(state)
}

impl<S: Edge> State<S> {
    /// What the drives say, in another scalar.
    pub fn set_inputs(&mut self, inputs: &[DriveInput]) {
        for (out, input) in self.motion.inputs.iter_mut().zip(inputs) {
            *out = input.in_scalar();
        }
    }

    /// Motion, loads and forces of a plan that is [batchable](Plan::is_batchable). Allocates nothing.
    pub fn run_closed(&mut self, plan: &Plan) {
        self.start(plan);
        match plan.effects.level {
            Level::Positions => plan.motion.iter().for_each(|step| self.closed_motion::<0>(step)),
            Level::Velocities => plan.motion.iter().for_each(|step| self.closed_motion::<1>(step)),
            Level::Accelerations => plan.motion.iter().for_each(|step| self.closed_motion::<2>(step)),
        }
        if plan.effects.forces {
            self.known_loads(plan);
            self.set_lines(plan);
            for (index, step) in plan.forces.iter().enumerate() {
                self.forces.conditions[index] = self.closed_forces(step);
            }
        }
    }

    /// Motion with accelerations, and the loads that are numbers in `wrenches`, of such a plan. Allocates nothing.
    pub fn run_closed_loads(&mut self, plan: &Plan) {
        self.start(plan);
        plan.motion.iter().for_each(|step| self.closed_motion::<2>(step));
        self.known_loads(plan);
    }

    // all closed forms written out within a loop take the compiler minutes
    #[inline(never)]
    fn closed_motion<const LEVEL: u8>(&mut self, step: &MotionStep) {
        self.closed_form::<LEVEL>(step);
    }

    #[inline(never)]
    fn closed_forces(&mut self, step: &ForceStep) -> S {
        self.closed_force(step)
    }
}

impl DriveInput {
    /// In another scalar; the direction of an angle is formed in it.
    #[must_use]
    pub fn in_scalar<S: Edge>(&self) -> DriveInput<S> {
        let input = self.map(S::of);
        // a point has no value of its own
        let angle = self.place == Vec2::direction(self.value);
        DriveInput { place: if angle { S::direction(self.value) } else { input.place }, ..input }
    }
}
