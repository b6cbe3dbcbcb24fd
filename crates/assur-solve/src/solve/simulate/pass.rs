//! Runs of different tolerance or steps go over the same motion.

use super::trace::{Fraction, Trace};

/// Where something else than the error bounds the steps, those of a finer run are shorter by this: equal ones would say nothing
/// of their error.
pub(super) const SHORTER: f64 = 0.7;
/// Those of the run after it are shorter by this, and so on in turn.
const NEXT: f64 = 0.8;

/// Evaluations of all runs over a motion.
pub(super) const EVALUATIONS: usize = 12_000_000;

/// One of the runs over a motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pass<'r> {
    pub tolerance: f64,
    /// It measures the greatest magnitudes of each kind.
    pub measures: bool,
    /// Where something else than the error bounds its steps, they are shorter by this.
    pub shorter: f64,
    /// The run before, of whose steps an explicit method takes a part.
    pub before: Option<(&'r Trace, Fraction)>,
    /// What is much for each work and what is nothing, where a run before has shown it, J.
    pub works: &'r [(f64, f64)],
    /// Evaluations after which it is given up.
    pub most: usize,
}

impl<'r> Pass<'r> {
    /// The first of several runs.
    pub const fn coarse(tolerance: f64) -> Self {
        Self { tolerance, measures: true, shorter: 1.0, before: None, works: &[], most: EVALUATIONS }
    }

    /// One run alone, in steps as long as those of the first of several.
    pub const fn in_long_steps(tolerance: f64) -> Self {
        Self { tolerance, measures: false, shorter: 1.0, before: None, works: &[], most: EVALUATIONS }
    }

    /// One run alone, in steps as short as those of the second of several.
    pub const fn in_short_steps(tolerance: f64) -> Self {
        Self { tolerance, measures: false, shorter: SHORTER, before: None, works: &[], most: EVALUATIONS }
    }

    /// Whether an implicit method had taken over at an instant, s, in the run before.
    pub fn is_stiff(self, t: f64) -> bool {
        self.before.and_then(|(trace, _)| trace.stiff).is_some_and(|stiff| stiff <= t)
    }

    /// A run after this one, which has left a trace, at a finer tolerance; in this part of its steps or not.
    pub fn finer(self, tolerance: f64, trace: &'r Trace, part: Option<Fraction>) -> Self {
        let shorter = if self.shorter == SHORTER { NEXT } else { SHORTER };
        let before = part.map(|part| (trace, part));
        Self { tolerance, measures: false, shorter, before, works: &trace.works, ..self }
    }
}
