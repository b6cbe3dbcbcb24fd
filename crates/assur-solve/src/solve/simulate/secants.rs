//! The method of secants for several unknowns: C. G. Broyden, A class of methods for solving nonlinear simultaneous equations
//! (1965), from a first matrix that is nearly right.
//!
//! The equations of friction are broken lines or nearly so. Where the determinant of their matrix has not the sign that it has
//! without friction, they have no solution or several.

use crate::math::Lu;
use crate::position::STILL;
use crate::solve::failure::Halt;

/// Steps at most; where nothing breaks as many as there are unknowns nearly suffice.
const MOST: usize = 40;
/// What is left of the equations, relative to their terms.
const ENOUGH: f64 = 1e-13;
/// Differences are taken over this part of the terms.
const APART: f64 = 1e-5;

/// Memory, with the unknowns.
#[derive(Clone, Debug, Default)]
pub(super) struct Secants {
    pub x: Vec<f64>,
    left: Vec<f64>,
    then: Vec<f64>,
    step: Vec<f64>,
    product: Vec<f64>,
    row: Vec<f64>,
    /// The inverse of the matrix, by rows.
    inverse: Vec<f64>,
    /// Its determinant without friction over what it has become.
    turned: f64,
}

impl Secants {
    /// For so many unknowns, all zero.
    pub fn resize(&mut self, n: usize) {
        for list in
            [&mut self.x, &mut self.left, &mut self.then, &mut self.step, &mut self.product, &mut self.row]
        {
            list.clear();
            list.resize(n, 0.0);
        }
        self.inverse.resize(n * n, 0.0);
    }

    /// Solves the equations from the unknowns as they are. `first` is factored; `equations` leaves what is left of each and
    /// returns the greatest of the terms in all.
    pub fn solve(
        &mut self,
        first: &mut Lu,
        mut equations: impl FnMut(&[f64], &mut [f64]) -> Result<f64, Halt>,
    ) -> Result<(), Halt> {
        let sign = first.sign();
        for exact in [false, true] {
            if exact && !self.differences(first, sign, &mut equations)? {
                return Err(Halt::Jam);
            }
            self.invert(first);
            if !self.settles(&mut equations)? {
                continue;
            }
            if self.turned > STILL {
                return Ok(());
            }
            if !self.differences(first, sign, &mut equations)? {
                return Err(Halt::Jam);
            }
            equations(&self.x, &mut self.left)?;
            return Ok(());
        }
        Err(Halt::Jam)
    }

    fn invert(&mut self, matrix: &mut Lu) {
        let n = self.x.len();
        self.turned = 1.0;
        for j in 0..n {
            self.row.fill(0.0);
            self.row[j] = 1.0;
            matrix.solve(&mut self.row);
            for i in 0..n {
                self.inverse[i * n + j] = self.row[i];
            }
        }
    }

    fn settles(
        &mut self,
        equations: &mut impl FnMut(&[f64], &mut [f64]) -> Result<f64, Halt>,
    ) -> Result<bool, Halt> {
        let n = self.x.len();
        let mut greatest = equations(&self.x, &mut self.left)?;
        for _ in 0..MOST {
            if self.left.iter().all(|left| left.abs() <= ENOUGH * greatest) {
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
                    return Ok(false);
                }
            }
            if !moved {
                return Ok(true);
            }
            greatest = equations(&self.x, &mut self.then)?;
            self.learn();
            std::mem::swap(&mut self.left, &mut self.then);
        }
        Ok(false)
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

    /// Factors the matrix of differences at the unknowns; whether its determinant has a sign.
    fn differences(
        &mut self,
        matrix: &mut Lu,
        sign: f64,
        equations: &mut impl FnMut(&[f64], &mut [f64]) -> Result<f64, Halt>,
    ) -> Result<bool, Halt> {
        let n = self.x.len();
        if self.x.iter().any(|x| !x.is_finite()) {
            self.x.fill(0.0);
        }
        let apart = APART * equations(&self.x, &mut self.left)?;
        for j in 0..n {
            let before = self.x[j];
            self.x[j] += apart;
            equations(&self.x, &mut self.then)?;
            let over = self.x[j] - before;
            self.x[j] = before;
            for i in 0..n {
                *matrix.at_mut(i, j) = (self.then[i] - self.left[i]) / over;
            }
        }
        Ok(matrix.factor() && matrix.sign() == sign)
    }
}
