//! Newton's method: the direction of every part is taken as it is at present.

use super::Magnitudes;
use crate::math::{Lu, Vec2};

const STEPS: usize = 60;
/// A step of this part of the terms is rounding.
const ROUNDED: f64 = 4e-16;
/// A step below this part of the terms that does not fall any more is rounding too.
const RESTLESS: f64 = 1e-11;

pub struct Found {
    pub x: Vec<f64>,
    /// Sign of the determinant of the system with the directions of the solution; 1 with all weights zero.
    pub sign: f64,
}

impl Magnitudes {
    /// Newton's method; `None` where it does not settle.
    #[doc(hidden)]
    #[must_use]
    pub fn newton(&self, start: &[f64]) -> Option<Found> {
        let n = self.len();
        let (mut system, mut steps) = (Lu::new(n), vec![0.0; n]);
        let (mut x, mut last) = (start.to_vec(), f64::INFINITY);
        for _ in 0..STEPS {
            system.clear();
            for i in 0..n {
                *system.at_mut(i, i) = 1.0;
                steps[i] = -x[i];
            }
            for part in &self.parts {
                let weight = self.weights[part.row];
                let v = part.at(&x);
                let size = v.norm();
                let along = if size > 0.0 { v / size } else { Vec2::zero() };
                for (j, slope) in part.slopes.iter().enumerate() {
                    *system.at_mut(part.row, j) += weight * along.dot(*slope);
                }
                steps[part.row] -= weight * size;
            }
            if !system.factor() {
                return None;
            }
            system.solve(&mut steps);
            let sizes = self.sizes(&x);
            let mut most = 0.0_f64;
            for ((x, step), size) in x.iter_mut().zip(&steps).zip(sizes) {
                *x += step;
                if *step != 0.0 {
                    most = most.max(step.abs() / size);
                }
            }
            if !most.is_finite() {
                return None;
            }
            if most <= ROUNDED || most <= RESTLESS && most >= 0.5 * last {
                return Some(Found { x, sign: system.sign() });
            }
            last = most;
        }
        None
    }
}
