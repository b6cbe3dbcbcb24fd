//! The steps of Newton's method, for those who want to read them.

use super::general::Pose;

/// A step of Newton's method: where it begins, and the linear equations that it solves.
#[derive(Clone, Debug, PartialEq)]
pub struct NewtonStep {
    /// Poses of the bodies that are sought, before the step.
    pub poses: Vec<Pose>,
    /// By how much every equation does not hold: m, or rad.
    pub residuals: Vec<f64>,
    /// The derivatives of every equation by x, y and the angle of every body, m and rad.
    pub jacobian: Vec<Vec<f64>>,
}

/// Sees the steps of an iteration; `()` sees nothing, and costs nothing.
pub trait IterationLog {
    /// An iteration begins: another before it came to nothing.
    fn begin(&mut self);
    /// A step of it.
    fn step(&mut self, step: impl FnOnce() -> NewtonStep);
}

impl IterationLog for () {
    #[inline(always)]
    fn begin(&mut self) {}
    #[inline(always)]
    fn step(&mut self, _: impl FnOnce() -> NewtonStep) {}
}

impl IterationLog for Vec<NewtonStep> {
    fn begin(&mut self) {
        self.clear();
    }

    fn step(&mut self, step: impl FnOnce() -> NewtonStep) {
        self.push(step());
    }
}
