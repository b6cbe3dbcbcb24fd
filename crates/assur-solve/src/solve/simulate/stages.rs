//! What is seen of change points in the stages of a step.

/// The widest gap between two neighbouring stages of a step, as a part of the step; a step has at least so many stages.
const APART: f64 = 0.35;
const SEEN: u32 = 11;

/// What was seen of |σ| in the stages since the present step began.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Stages {
    least: f64,
    seen: u32,
}

impl Stages {
    /// A step begins where |σ| is so.
    pub const fn begin(condition: f64) -> Self {
        Self { least: condition, seen: 0 }
    }

    /// A stage has been evaluated, with this |σ|.
    pub fn note(&mut self, condition: f64) {
        self.least = self.least.min(condition);
        self.seen += 1;
    }

    /// Whether |σ| has stayed above zero, where it may have changed by so much in the step.
    pub fn is_clear(self, turned: f64) -> bool {
        self.seen >= SEEN && self.least > 0.5 * APART * turned
    }
}
