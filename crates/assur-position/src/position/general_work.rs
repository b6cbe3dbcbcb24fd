//! Memory of the steps that solve a general group.

use crate::group::general::{Acceleration, General, Load, Pose, Velocity};
use crate::math::Vec2;

/// Memory of a general system.
#[derive(Clone, Debug)]
pub struct Workspace {
    pub(super) equations: General,
    pub(super) poses: Vec<Pose>,
    pub(super) velocities: Vec<Velocity>,
    pub(super) accelerations: Vec<Acceleration>,
    pub(super) loads: Vec<Load>,
    pub(super) lambda: Vec<f64>,
    /// Multipliers of the laws of wheels of the best state so far.
    pub(super) kept: Vec<f64>,
}

impl Workspace {
    /// Memory for a system, laid out once.
    #[must_use]
    pub fn new(equations: &General, bodies: usize, moving: usize) -> Self {
        let rest = Pose { p: Vec2::zero(), u: Vec2::new(1.0, 0.0) };
        Self {
            equations: equations.clone(),
            poses: vec![rest; bodies],
            velocities: vec![Velocity::default(); bodies],
            accelerations: vec![Acceleration::default(); bodies],
            loads: vec![Load::default(); moving],
            lambda: vec![0.0; 3 * moving],
            kept: vec![0.0; equations.laws.len()],
        }
    }
}
