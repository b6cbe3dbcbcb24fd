//! Chebyshev series from values at the extremes of T_n, both ends among them, t_j = −cos(πj/n). Every other place is one for half
//! the degree (C. W. Clenshaw and A. R. Curtis, A method for numerical integration on an automatic computer, 1960).

use super::chebyshev::{bounds, derive, integral, roots, tail, value};
use std::f64::consts::PI;

/// The greatest degree of a series.
const DEGREE: usize = 16;
pub const PLACES: usize = DEGREE + 1;

/// The places on [−1, 1] and the cosines of the transform.
#[derive(Clone, Debug)]
pub struct Extremes {
    cosines: [f64; 2 * DEGREE],
}

impl Default for Extremes {
    fn default() -> Self {
        Self::new()
    }
}

impl Extremes {
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // far below 2^52
    pub fn new() -> Self {
        Self { cosines: std::array::from_fn(|i| libm::cos(PI * i as f64 / DEGREE as f64)) }
    }

    /// A place of an interval; the first and the last are its ends.
    #[must_use]
    pub fn at(&self, from: f64, to: f64, place: usize) -> f64 {
        match place {
            0 => from,
            DEGREE => to,
            inner => 0.5 * ((from + to) + (to - from) * self.cosines[DEGREE - inner]),
        }
    }

    /// The series through the values at every place, or at every second one where `step` is 2.
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // far below 2^52
    pub fn series(&self, from: f64, to: f64, values: &[f64; PLACES], step: usize) -> Short {
        let n = DEGREE / step;
        let half = |k: usize| if k == 0 || k == n { 0.5 } else { 1.0 };
        let mut coefficients = [0.0; PLACES];
        for (k, coefficient) in coefficients[..=n].iter_mut().enumerate() {
            let terms = values.iter().step_by(step).rev().enumerate();
            let sum: f64 = terms.map(|(j, f)| half(j) * f * self.cosines[step * j * k % (2 * DEGREE)]).sum();
            *coefficient = sum * half(k) * 2.0 / n as f64;
        }
        Short { from, to, coefficients, count: n + 1 }
    }
}

/// A series of few terms, without memory of its own.
#[derive(Clone, Copy, Debug)]
pub struct Short {
    /// Where its interval begins.
    pub from: f64,
    pub to: f64,
    coefficients: [f64; PLACES],
    count: usize,
}

impl Short {
    /// Its coefficients, of T_0 first.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients[..self.count]
    }

    /// The greatest of the last coefficients.
    #[must_use]
    pub fn tail(&self) -> f64 {
        tail(self.coefficients())
    }

    #[must_use]
    pub fn value(&self, x: f64) -> f64 {
        value((self.from, self.to), self.coefficients(), x)
    }

    /// Values that it does not pass within the interval.
    #[must_use]
    pub fn bounds(&self) -> (f64, f64) {
        bounds(self.coefficients())
    }

    /// The integral over the interval.
    #[must_use]
    pub fn integral(&self) -> f64 {
        integral((self.from, self.to), self.coefficients())
    }

    /// Tells where it turns, with its value there.
    pub fn turns(&self, mut found: impl FnMut(f64, f64)) {
        let mut slope = [0.0; PLACES];
        derive(self.coefficients(), &mut slope[..self.count]);
        let terms = (self.count - 1).max(1);
        roots((self.from, self.to), &slope[..terms], |t| found(t, self.value(t)));
    }
}
