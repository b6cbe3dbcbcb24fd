//! Memory for rates beyond accelerations.

use super::body::BodyState;
use super::kinematics::{DriveInput, Motion};
use crate::math::Lu;
use crate::plan::Plan;
use crate::plan::equation::RateGroup;

/// Memory for rates beyond accelerations.
#[derive(Clone, Debug)]
pub struct RateWork {
    /// The bodies where they are, all at rest, and drives that rest.
    pub resting: Motion,
    pub groups: Vec<(Lu, Vec<f64>)>,
}

impl RateWork {
    pub fn new(plan: &Plan, groups: &[RateGroup]) -> Self {
        let memory = |group: &RateGroup| (Lu::new(3 * group.bodies.len()), vec![0.0; 3 * group.bodies.len()]);
        Self { resting: Motion::at_rest(plan), groups: groups.iter().map(memory).collect() }
    }

    /// Takes over where bodies are.
    pub fn rest(&mut self, motion: &Motion) {
        for (rest, body) in self.resting.bodies.iter_mut().zip(&motion.bodies) {
            *rest = BodyState { p: body.p, u: body.u, turned: body.turned, ..BodyState::rest() };
        }
        for (rest, input) in self.resting.inputs.iter_mut().zip(&motion.inputs) {
            *rest = DriveInput { place: input.place, value: input.value, ..DriveInput::default() };
        }
    }
}
