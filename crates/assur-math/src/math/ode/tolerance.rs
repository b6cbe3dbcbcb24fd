//! What error of a step is allowed.

use super::{Real, epsilon};

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

    /// What an estimate of order 3 must allow so that a method of order 5 keeps to the tolerance: a tenth of its power 2/3
    /// (volume II, section IV.8, and the authors' program); the greatest relative one among them. Where only an absolute
    /// tolerance is given it stands for a relative one.
    pub(super) fn of_third_order(&self) -> (Self, S) {
        let pairs = self.relative.iter().zip(&self.absolute);
        let new = pairs.map(|(&relative, &absolute)| {
            let unit = if S::zero().lt(relative) { relative } else { absolute };
            let root = cube_root(unit.min(S::one()));
            let factor = S::of(0.1) * root * root / unit;
            (relative * factor, (absolute * factor).max(S::tiny()), unit * factor)
        });
        let new: Vec<_> = new.collect();
        let tolerance =
            Self { relative: new.iter().map(|x| x.0).collect(), absolute: new.iter().map(|x| x.1).collect() };
        (tolerance, new.iter().fold(epsilon(), |most: S, x| most.max(x.2)))
    }

    /// Decimal digits of the finest.
    pub(super) fn digits(&self) -> usize {
        let pairs = self.relative.iter().zip(&self.absolute);
        let units = pairs.map(|(r, a)| if S::zero().lt(*r) { *r } else { *a });
        let mut finest = units.fold(S::one(), S::min);
        let mut digits = 0;
        while finest.lt(S::one()) && digits < 32 {
            finest = finest * S::of(10.0);
            digits += 1;
        }
        digits
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

/// The cube root of a number in (0, 1], by Newton's method from above.
fn cube_root<S: Real>(x: S) -> S {
    let mut root = S::one();
    loop {
        let next = root - (root - x / (root * root)) * S::of(1.0 / 3.0);
        if !next.lt(root) {
            return root;
        }
        root = next;
    }
}
