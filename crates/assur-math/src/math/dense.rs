//! Small dense linear systems in `f64`: the one elimination, by nalgebra on memory taken once, and its condition beside.

use super::sparse::Sparse;
use nalgebra::{DMatrix, DVector};

/// A square matrix and, in its place, its LU factors with partial pivoting. All memory is taken once.
#[derive(Clone, Debug)]
pub struct Lu {
    /// The matrix; the factors after [`Lu::factor`].
    factors: DMatrix<f64>,
    /// Row of the matrix that each row of the factors came from.
    order: Vec<usize>,
    sign: f64,
    scratch: DVector<f64>,
}

impl Lu {
    /// The null matrix of order `n`.
    #[must_use]
    pub fn new(n: usize) -> Self {
        Self { factors: DMatrix::zeros(n, n), order: (0..n).collect(), sign: 0.0, scratch: DVector::zeros(n) }
    }

    /// Order of the matrix.
    #[inline]
    #[must_use]
    pub fn order(&self) -> usize {
        self.order.len()
    }

    /// Element in row `i`, column `j`, to be written. Before the next [`Lu::factor`] every element must be.
    #[inline]
    pub fn at_mut(&mut self, i: usize, j: usize) -> &mut f64 {
        &mut self.factors[(i, j)]
    }

    /// Writes row `i`.
    pub fn set_row(&mut self, i: usize, row: impl Iterator<Item = f64>) {
        self.factors.row_mut(i).iter_mut().zip(row).for_each(|(slot, x)| *slot = x);
    }

    /// Sets every element to zero.
    pub fn clear(&mut self) {
        self.factors.fill(0.0);
    }

    /// Factors the matrix in place; `false` when a pivot is zero or not finite.
    pub fn factor(&mut self) -> bool {
        self.sign = 0.0;
        self.order.iter_mut().enumerate().for_each(|(i, row)| *row = i);
        let mut sign = 1.0;
        for k in 0..self.order() {
            let pivot = k + self.factors.view_range(k.., k).icamax();
            if pivot != k {
                self.order.swap(k, pivot);
                self.factors.swap_rows(k, pivot);
                sign = -sign;
            }
            let diagonal = self.factors[(k, k)];
            if diagonal == 0.0 || !diagonal.is_finite() {
                return false;
            }
            sign *= diagonal.signum();
            let (mut left, mut right) = self.factors.columns_range_pair_mut(k, k + 1..);
            let mut ratios = left.rows_range_mut(k + 1..);
            ratios /= diagonal;
            for mut column in right.column_iter_mut() {
                let (top, mut below) = column.rows_range_pair_mut(k, k + 1..);
                below.axpy(-top[0], &ratios, 1.0);
            }
        }
        self.sign = sign;
        true
    }

    /// Sign of the determinant of what was factored; 0 when it could not be.
    #[must_use]
    pub fn sign(&self) -> f64 {
        self.sign
    }

    /// The least magnitude of a pivot, after [`Lu::factor`].
    #[must_use]
    pub fn least_pivot(&self) -> f64 {
        (0..self.order()).fold(f64::INFINITY, |least, i| least.min(self.factors[(i, i)].abs()))
    }

    /// Solves A x = b in place, after [`Lu::factor`]. Products are added by rising column: positions near a dead one depend
    /// on the order.
    pub fn solve(&mut self, b: &mut [f64]) {
        let n = self.order();
        let (factors, x) = (self.factors.as_slice(), self.scratch.as_mut_slice());
        for i in 0..n {
            let known: f64 = (0..i).map(|j| factors[j * n + i] * x[j]).sum();
            x[i] = b[self.order[i]] - known;
        }
        for i in (0..n).rev() {
            let known: f64 = (i + 1..n).map(|j| factors[j * n + i] * x[j]).sum();
            x[i] = (x[i] - known) / factors[i * n + i];
        }
        b.copy_from_slice(x);
    }
}

impl Default for Lu {
    fn default() -> Self {
        Self::new(0)
    }
}

/// A square matrix with row-scaled LU factors beside it, and their condition: zeros in it cost little. All memory is taken once.
#[derive(Clone, Debug)]
pub struct Dense {
    n: usize,
    matrix: Vec<f64>,
    /// Factors of the matrix whose rows are scaled to unit sum of magnitudes.
    factors: Sparse,
    scale: Vec<f64>,
}

impl Dense {
    /// The null matrix of order `n`.
    #[must_use]
    pub fn new(n: usize) -> Self {
        Self { n, matrix: vec![0.0; n * n], factors: Sparse::new(n), scale: vec![0.0; n] }
    }

    /// Order of the matrix.
    #[must_use]
    pub fn order(&self) -> usize {
        self.n
    }

    /// Sets every element to zero.
    pub fn clear(&mut self) {
        self.matrix.fill(0.0);
    }

    /// Row `i`.
    #[must_use]
    pub fn row(&self, i: usize) -> &[f64] {
        &self.matrix[i * self.n..][..self.n]
    }

    /// Row `i`, to be written.
    pub fn row_mut(&mut self, i: usize) -> &mut [f64] {
        &mut self.matrix[i * self.n..][..self.n]
    }

    /// Factors the matrix with partial pivoting; `false` when a pivot is zero or not finite.
    pub fn factor(&mut self) -> bool {
        self.factors.forget();
        for i in 0..self.n {
            let row = &self.matrix[i * self.n..][..self.n];
            let sum: f64 = row.iter().map(|x| x.abs()).sum();
            if !(sum > 0.0 && sum.is_finite()) {
                return false;
            }
            let scale = 1.0 / sum;
            self.scale[i] = scale;
            self.factors.set_row(i, row.iter().map(|x| x * scale));
        }
        self.factors.factor()
    }

    /// What row `i` was multiplied by before it was factored: 1 over the sum of its magnitudes.
    #[must_use]
    pub fn row_scale(&self, i: usize) -> f64 {
        self.scale[i]
    }

    /// Sign of the determinant of what was factored; 0 when it could not be.
    #[must_use]
    pub fn sign(&self) -> f64 {
        self.factors.sign()
    }

    /// Solves A x = b in place, after [`Dense::factor`].
    pub fn solve(&mut self, b: &mut [f64]) {
        b.iter_mut().zip(&self.scale).for_each(|(x, scale)| *x *= scale);
        self.factors.solve(b);
    }

    /// Solves Aᵀ x = b in place, after [`Dense::factor`].
    pub fn solve_transposed(&mut self, b: &mut [f64]) {
        self.factors.solve_transposed(b);
        b.iter_mut().zip(&self.scale).for_each(|(x, scale)| *x *= scale);
    }

    /// 1 / (‖A‖ ‖A⁻¹‖) of the row-scaled matrix in the greatest row sum, in (0, 1]; 0 when it could not be factored.
    /// `sums` is room for one number per row.
    pub fn reciprocal_condition(&mut self, sums: &mut [f64]) -> f64 {
        if self.sign() == 0.0 {
            return 0.0;
        }
        sums.fill(0.0);
        self.factors.add_inverse_rows(sums);
        if !sums.iter().all(|sum| sum.is_finite()) {
            return 0.0;
        }
        1.0 / sums.iter().fold(1.0, |most: f64, &sum| most.max(sum))
    }
}
