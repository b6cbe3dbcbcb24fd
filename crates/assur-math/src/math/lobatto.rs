//! Chebyshev series from values at the extremes of T_n, both ends among them, t_j = −cos(πj/n). Every other place is one for half
//! the degree (C. W. Clenshaw and A. R. Curtis, A method for numerical integration on an automatic computer, 1960).

use super::chebyshev::Series;
use std::f64::consts::PI;

/// The greatest degree of a series.
const DEGREE: usize = 16;
/// Its places.
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
    /// The places.
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
    pub fn series(&self, from: f64, to: f64, values: &[f64; PLACES], step: usize) -> Series {
        let n = DEGREE / step;
        let half = |k: usize| if k == 0 || k == n { 0.5 } else { 1.0 };
        let coefficients = (0..=n).map(|k| {
            let terms = values.iter().step_by(step).rev().enumerate();
            let sum: f64 = terms.map(|(j, f)| half(j) * f * self.cosines[step * j * k % (2 * DEGREE)]).sum();
            sum * half(k) * 2.0 / n as f64
        });
        Series::new(from, to, coefficients.collect())
    }
}
