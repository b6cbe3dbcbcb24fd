//! Newton's method: the direction of every part is taken as it is at present.

use super::{Magnitudes, eliminate};
use crate::math::Vec2;

/// Most steps.
const STEPS: usize = 60;
/// A step of this part of the terms is rounding.
const ROUNDED: f64 = 4e-16;
/// A step below this part of the terms that does not fall any more is rounding too.
const RESTLESS: f64 = 1e-11;

/// A solution.
pub struct Found {
    /// The unknowns.
    pub x: Vec<f64>,
    /// Determinant of the system with the directions of the solution; 1 with all weights zero.
    pub determinant: f64,
}

impl Magnitudes {
    /// Newton's method; `None` where it does not settle.
    #[doc(hidden)]
    #[must_use]
    pub fn newton(&self, start: &[f64]) -> Option<Found> {
        let n = self.len();
        let width = n + 1;
        let (mut x, mut last) = (start.to_vec(), f64::INFINITY);
        for _ in 0..STEPS {
            let mut rows = vec![0.0; n * width];
            for i in 0..n {
                rows[i * width + i] = 1.0;
                rows[i * width + n] = -x[i];
            }
            for part in &self.parts {
                let (row, weight) = (&mut rows[part.row * width..][..width], self.weights[part.row]);
                let v = part.at(&x);
                let size = v.norm();
                let along = if size > 0.0 { v / size } else { Vec2::zero() };
                for (slot, slope) in row.iter_mut().zip(&part.slopes) {
                    *slot += weight * along.dot(*slope);
                }
                row[n] -= weight * size;
            }
            let determinant = eliminate(&mut rows, n, width);
            if determinant == 0.0 || !determinant.is_finite() {
                return None;
            }
            let sizes = self.sizes(&x);
            let mut most = 0.0_f64;
            for i in 0..n {
                let step = rows[i * width + n];
                x[i] += step;
                if step != 0.0 {
                    most = most.max(step.abs() / sizes[i]);
                }
            }
            if !most.is_finite() {
                return None;
            }
            if most <= ROUNDED || most <= RESTLESS && most >= 0.5 * last {
                return Some(Found { x, determinant });
            }
            last = most;
        }
        None
    }
}
