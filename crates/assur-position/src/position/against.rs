//! Loads against the motion in a motion under loads, where the run and not the velocity says in which sense they act.

use crate::math::Vec2;

/// How such a load acts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Against {
    /// What its value is multiplied by, in the ground's axes; of a torque the first number.
    pub part: Vec2,
    /// What it holds at rest, N or N m.
    pub held: Vec2,
}
