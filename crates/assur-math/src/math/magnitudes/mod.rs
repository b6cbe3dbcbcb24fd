//! Linear systems with magnitudes: friction and losses depend on how large a force is, not on its sense.
//!
//! ```text
//! x_i + w_i Σ_p |v_p(x)| = 0,   v_p(x) = c_p + Σ_j g_pj x_j,
//! ```
//!
//! where the parts p of row i are numbers or plane vectors. With the sign of every number and the direction of every vector
//! given the system is linear. It may have one solution, several, or none.

#[doc(hidden)]
pub mod newton;
mod search;
mod simplex;

pub use search::Solutions;

use super::Vec2;

/// What stands between the bars: a number (`y` is zero everywhere) or a plane vector, affine in the unknowns.
#[derive(Clone, Debug)]
pub struct Part {
    /// Row that it belongs to.
    pub row: usize,
    /// A vector, not a number.
    pub plane: bool,
    /// Its value where all unknowns are zero.
    pub constant: Vec2,
    /// Its growth per unit of each unknown.
    pub slopes: Vec<Vec2>,
}

/// A system with magnitudes.
#[derive(Clone, Debug)]
pub struct AbsLinearSystem {
    /// Sign of the determinant that the system was divided by to come to this form.
    pub orientation: f64,
    /// Weight of each row.
    pub weights: Vec<f64>,
    /// The parts of all rows.
    pub parts: Vec<Part>,
}

impl Part {
    #[must_use]
    pub fn at(&self, x: &[f64]) -> Vec2 {
        self.slopes.iter().zip(x).fold(self.constant, |sum, (slope, x)| sum + *slope * *x)
    }
}

impl AbsLinearSystem {
    #[must_use]
    pub fn len(&self) -> usize {
        self.weights.len()
    }

    /// Whether there are no unknowns.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.weights.is_empty()
    }

    /// The same with all weights multiplied.
    #[must_use]
    pub fn scaled(&self, by: f64) -> Self {
        let weights = self.weights.iter().map(|w| w * by).collect();
        Self { weights, parts: self.parts.clone(), ..*self }
    }

    /// Sizes of the terms in each row: what a residual is small against.
    fn sizes(&self, x: &[f64]) -> Vec<f64> {
        let mut sizes: Vec<f64> = x.iter().map(|x| x.abs()).collect();
        for part in &self.parts {
            let terms = part.slopes.iter().zip(x).map(|(slope, x)| slope.norm() * x.abs());
            let size = part.constant.norm() + terms.sum::<f64>();
            sizes[part.row] += self.weights[part.row].abs() * size;
        }
        sizes
    }

    /// Greatest residual of a row over the terms in it.
    #[must_use]
    pub fn residual(&self, x: &[f64]) -> f64 {
        let mut left = x.to_vec();
        for part in &self.parts {
            left[part.row] += self.weights[part.row] * part.at(x).norm();
        }
        let relative = left.iter().zip(self.sizes(x)).map(|(r, s)| if *r == 0.0 { 0.0 } else { r.abs() / s });
        relative.fold(0.0, f64::max)
    }
}
