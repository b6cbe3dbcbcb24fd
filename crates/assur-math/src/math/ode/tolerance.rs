//! What error of a step is allowed.

use super::Real;

/// The allowed error of each component: absolute + relative · |y|.
#[derive(Clone, Debug)]
pub struct Tolerance<S> {
    relative: Vec<S>,
    absolute: Vec<S>,
}

impl<S: Real> Tolerance<S> {
    /// Of each component its relative and its absolute one.
    #[must_use]
    pub fn each(components: &[(f64, f64)]) -> Self {
        // nothing is divided by zero where neither is given and y vanishes
        let absolute = components.iter().map(|&(_, absolute)| S::of(absolute).max(S::tiny()));
        Self {
            relative: components.iter().map(|&(relative, _)| S::of(relative)).collect(),
            absolute: absolute.collect(),
        }
    }

    /// The same for all of n components.
    #[must_use]
    pub fn uniform(n: usize, relative: f64, absolute: f64) -> Self {
        Self::each(&vec![(relative, absolute); n])
    }

    /// How many components it is for.
    pub(super) fn order(&self) -> usize {
        self.absolute.len()
    }

    /// The error that is allowed of component i where it has this magnitude.
    #[inline]
    pub(super) fn scale(&self, i: usize, magnitude: S) -> S {
        self.absolute[i] + self.relative[i] * magnitude
    }

    /// Σ (error / allowed)², at these values.
    #[inline]
    pub(super) fn square_sum(&self, y: &[S], mut error: impl FnMut(usize) -> S) -> S {
        let mut sum = S::zero();
        for (i, y) in y.iter().enumerate() {
            let ratio = error(i) / self.scale(i, y.abs());
            sum = sum + ratio * ratio;
        }
        sum
    }
}
