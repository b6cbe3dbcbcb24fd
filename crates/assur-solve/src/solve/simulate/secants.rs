//! The method of secants for several unknowns: C. G. Broyden, A class of methods for solving nonlinear simultaneous equations
//! (1965), from the matrix of the last solution near by, or from one of differences.
//!
//! The equations of friction are broken lines or nearly so. Without friction the determinant of their matrix is 1; where it is not
//! positive they have no solution, or one to which no friction that grows from nothing leads.

use crate::math::Lu;
use crate::position::STILL;
use crate::solve::failure::Halt;

/// Steps at most from a matrix.
const MOST: usize = 12;
/// Matrices of differences at most.
const MATRICES: usize = 8;
/// Differences are taken over this part of the terms.
const APART: f64 = 1e-5;

/// What is left of the equations: whether it is nothing, and the greatest of their terms.
pub(super) type Left = Result<(bool, f64), Halt>;

/// Memory, with the unknowns.
#[derive(Clone, Debug, Default)]
pub(super) struct Secants {
    pub x: Vec<f64>,
    left: Vec<f64>,
    then: Vec<f64>,
    step: Vec<f64>,
    product: Vec<f64>,
    row: Vec<f64>,
    matrix: Lu,
    /// The inverse of the matrix, by rows.
    inverse: Vec<f64>,
    /// The matrix is that of a solution near by.
    known: bool,
    /// What its determinant has become over what it was when it was found.
    turned: f64,
}

impl Secants {
    /// For so many unknowns, which begin at zero, and of which no matrix is known.
    pub fn begin(&mut self, n: usize) {
        let Self { x, left, then, step, product, row, .. } = self;
        for list in [x, left, then, step, product, row] {
            list.clear();
            list.resize(n, 0.0);
        }
        self.inverse.resize(n * n, 0.0);
        if self.matrix.order() != n {
            self.matrix = Lu::new(n);
        }
        self.known = false;
    }

    /// Solves the equations from the unknowns as they are.
    ///
    /// # Errors
    /// They have no solution with a positive determinant, or one of them is not defined.
    pub fn solve(&mut self, mut equations: impl FnMut(&[f64], &mut [f64]) -> Left) -> Result<(), Halt> {
        if std::mem::replace(&mut self.known, false)
            && self.settles(MOST, &mut equations)?
            && self.turned > STILL
        {
            self.known = true;
            return Ok(());
        }
        for _ in 0..MATRICES {
            let positive = self.differences((1.0, 0.0), &mut equations)?;
            if !self.invert() {
                break;
            }
            // near a corner the matrix is that of one side
            let settled = self.settles(if positive { MOST } else { 1 }, &mut equations)?;
            if settled && positive && self.turned > STILL {
                self.known = true;
                return Ok(());
            }
            if settled && self.differences((1.0, 0.0), &mut equations)? {
                equations(&self.x, &mut self.left)?;
                self.known = self.invert();
                return Ok(());
            }
        }
        self.x.fill(0.0);
        Err(Halt::Jam)
    }

    /// Whether the determinant is positive on all sides of the solution, where it is a corner; `least` is what the terms are where
    /// they cancel. Leaves the equations anywhere near it.
    ///
    /// # Errors
    /// One of the equations is not defined.
    pub fn is_stable(
        &mut self,
        least: f64,
        mut equations: impl FnMut(&[f64], &mut [f64]) -> Left,
    ) -> Result<bool, Halt> {
        for side in [1.0, -1.0] {
            if !self.x.is_empty() && !self.differences((side, least), &mut equations)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The inverse of the matrix that was factored last; false where there is none.
    fn invert(&mut self) -> bool {
        let n = self.x.len();
        self.turned = 1.0;
        for j in 0..n {
            self.row.fill(0.0);
            self.row[j] = 1.0;
            self.matrix.solve(&mut self.row);
            for i in 0..n {
                self.inverse[i * n + j] = self.row[i];
            }
        }
        self.inverse.iter().all(|x| x.is_finite())
    }

    fn settles(
        &mut self,
        most: usize,
        equations: &mut impl FnMut(&[f64], &mut [f64]) -> Left,
    ) -> Result<bool, Halt> {
        let n = self.x.len();
        let mut settled = equations(&self.x, &mut self.left)?.0;
        for _ in 0..most {
            if settled {
                return Ok(true);
            }
            let mut moved = false;
            for i in 0..n {
                let row = &self.inverse[i * n..][..n];
                let before = self.x[i];
                self.x[i] -= row.iter().zip(&self.left).map(|(a, b)| a * b).sum::<f64>();
                self.step[i] = self.x[i] - before;
                moved |= self.step[i] != 0.0;
                if !self.x[i].is_finite() {
                    self.x.fill(0.0);
                    return Ok(false);
                }
            }
            if !moved {
                return Ok(true);
            }
            settled = equations(&self.x, &mut self.then)?.0;
            self.learn();
            std::mem::swap(&mut self.left, &mut self.then);
        }
        Ok(settled)
    }

    /// Makes the matrix right for the last step.
    fn learn(&mut self) {
        let n = self.x.len();
        for (then, left) in self.then.iter().zip(&mut self.left) {
            // the change of the equations
            *left = then - *left;
        }
        let change = &self.left;
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        for i in 0..n {
            self.product[i] = dot(&self.inverse[i * n..][..n], change);
            self.row[i] = (0..n).map(|k| self.step[k] * self.inverse[k * n + i]).sum();
        }
        let (along, square) = (dot(&self.step, &self.product), dot(&self.step, &self.step));
        self.turned *= along / square;
        if along == 0.0 {
            return;
        }
        for i in 0..n {
            let factor = (self.step[i] - self.product[i]) / along;
            for j in 0..n {
                self.inverse[i * n + j] += factor * self.row[j];
            }
        }
    }

    /// Factors the matrix of differences to one side of the unknowns; whether its determinant is positive.
    fn differences(
        &mut self,
        (side, least): (f64, f64),
        equations: &mut impl FnMut(&[f64], &mut [f64]) -> Left,
    ) -> Result<bool, Halt> {
        let n = self.x.len();
        let apart = side * APART * equations(&self.x, &mut self.left)?.1.max(least);
        for j in 0..n {
            let before = self.x[j];
            self.x[j] += apart;
            equations(&self.x, &mut self.then)?;
            let over = self.x[j] - before;
            self.x[j] = before;
            for i in 0..n {
                *self.matrix.at_mut(i, j) = (self.then[i] - self.left[i]) / over;
            }
        }
        Ok(self.matrix.factor() && self.matrix.sign() > 0.0)
    }
}
