//! Runs of different tolerance go over the same motion.

/// Where something else than the error bounds the steps, those of a finer run are shorter by this: equal ones would say nothing
/// of their error.
pub(super) const SHORTER: f64 = 0.7;
/// Those of the run after it are shorter by this, and so on in turn.
const NEXT: f64 = 0.8;

/// One of the runs over a motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pass {
    pub tolerance: f64,
    /// It measures the greatest magnitudes of each kind.
    pub measures: bool,
    /// Where something else than the error bounds its steps, they are shorter by this.
    pub shorter: f64,
}

impl Pass {
    /// The first of several runs.
    pub const fn coarse(tolerance: f64) -> Self {
        Self { tolerance, measures: true, shorter: 1.0 }
    }

    /// A run that nothing else is asked of.
    pub const fn only(tolerance: f64) -> Self {
        Self { tolerance, measures: false, shorter: 1.0 }
    }

    /// A run with which no other is compared.
    pub const fn alone(tolerance: f64) -> Self {
        Self { tolerance, measures: false, shorter: SHORTER }
    }

    /// A run after this one, at a finer tolerance.
    pub fn finer(self, tolerance: f64) -> Self {
        let shorter = if self.shorter == SHORTER { NEXT } else { SHORTER };
        Self { tolerance, measures: false, shorter }
    }
}
