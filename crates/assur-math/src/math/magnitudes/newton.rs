//! Newton's method: the direction of every part is taken as it is at present.

use super::AbsLinearSystem;
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

impl AbsLinearSystem {
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

// The solution that is reached from the system without weights when they grow from zero.

/// The least step of the part that the weights have reached.
const SHORTEST: f64 = 1e-5;
/// No part may change by more than this share of the greatest in one step.
const CHANGE: f64 = 0.2;

impl AbsLinearSystem {
    /// Follows the solution of `at(0)`, whose weights or slopes are zero, to that of `at(1)`. `None` where it ends on the way:
    /// it grows beyond all bounds, or turns back. `at` may leave out single parts of the way.
    #[must_use]
    pub fn follow(at: impl Fn(f64) -> Option<Self>) -> Option<Vec<f64>> {
        let start = at(0.0)?;
        let mut x = start.newton(&vec![0.0; start.len()])?.x;
        let mut parts: Vec<_> = start.parts.iter().map(|p| p.at(&x)).collect();
        let (mut reached, mut step) = (0.0, 0.25);
        while reached < 1.0 {
            let next: f64 = f64::min(1.0, reached + step);
            let taken = at(next).and_then(|system| {
                let found =
                    system.newton(&x).filter(|f| f.sign * system.orientation * start.orientation > 0.0)?;
                let now: Vec<_> = system.parts.iter().map(|p| p.at(&found.x)).collect();
                let most = parts.iter().chain(&now).map(|v| v.norm()).fold(0.0, f64::max);
                let change = now.iter().zip(&parts).map(|(a, b)| (*a - *b).norm()).fold(0.0, f64::max);
                (change <= CHANGE * most).then_some((found.x, now))
            });
            if let Some((found, now)) = taken {
                (x, parts, reached) = (found, now, next);
                step *= 2.0;
            } else {
                step *= 0.5;
                if step < SHORTEST {
                    return None;
                }
            }
        }
        Some(x)
    }
}
