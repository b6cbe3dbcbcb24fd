//! Small dense linear systems in `f64`: the one elimination, by nalgebra on memory taken once, and its condition beside.

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
    #[must_use]
    pub fn order(&self) -> usize {
        self.order.len()
    }

    /// Element in row `i`, column `j`, to be written. Before the next [`Lu::factor`] every element must be.
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

    /// Solves Aᵀ x = b in place, after [`Lu::factor`].
    pub fn solve_transposed(&mut self, b: &mut [f64]) {
        let n = self.order();
        let (factors, x) = (self.factors.as_slice(), self.scratch.as_mut_slice());
        for i in 0..n {
            let column = &factors[i * n..][..n];
            let known: f64 = column[..i].iter().zip(&*x).map(|(a, x)| a * x).sum();
            x[i] = (b[i] - known) / column[i];
        }
        for i in (0..n).rev() {
            let column = &factors[i * n..][..n];
            let known: f64 = column[i + 1..].iter().zip(&x[i + 1..]).map(|(a, x)| a * x).sum();
            x[i] -= known;
        }
        for (x, &row) in self.scratch.iter().zip(&self.order) {
            b[row] = *x;
        }
    }

    /// Adds the magnitudes in each row of the inverse to `sums`, after [`Lu::factor`].
    fn add_inverse_rows(&mut self, sums: &mut [f64]) {
        for k in 0..self.order() {
            self.scratch.fill(0.0);
            self.scratch[k] = 1.0;
            // nothing comes before the k-th
            let lower = self.factors.view_range(k.., k..);
            let _ = lower.solve_lower_triangular_with_diag_mut(&mut self.scratch.rows_range_mut(k..), 1.0);
            let _ = self.factors.solve_upper_triangular_mut(&mut self.scratch);
            for (sum, x) in sums.iter_mut().zip(self.scratch.iter()) {
                *sum += x.abs();
            }
        }
    }
}

impl Default for Lu {
    fn default() -> Self {
        Self::new(0)
    }
}

/// A square matrix with row-scaled LU factors beside it, and their condition. All memory is taken once.
#[derive(Clone, Debug)]
pub struct Dense {
    n: usize,
    matrix: Vec<f64>,
    /// Factors of the matrix whose rows are scaled to unit sum of magnitudes.
    factors: Lu,
    scale: Vec<f64>,
}

impl Dense {
    /// The null matrix of order `n`.
    #[must_use]
    pub fn new(n: usize) -> Self {
        Self { n, matrix: vec![0.0; n * n], factors: Lu::new(n), scale: vec![0.0; n] }
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
        self.factors.sign = 0.0;
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
        self.factors.sign
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

#[cfg(test)]
mod tests {
    use super::*;

    fn filled(rows: &[&[f64]]) -> Dense {
        let mut a = Dense::new(rows.len());
        for (i, row) in rows.iter().enumerate() {
            a.row_mut(i).copy_from_slice(row);
        }
        a
    }

    #[test]
    fn solves_both_ways() {
        let rows: [&[f64]; 3] = [&[0.0, 2.0, 1.0], &[100.0, 3.0, -1.0], &[1.0, 0.5, 4.0]];
        let mut a = filled(&rows);
        assert!(a.factor());
        assert_eq!(a.sign(), -1.0);
        let x = [1.0, -2.0, 3.0];
        let mut b = [0, 1, 2].map(|i: usize| (0..3).map(|j| rows[i][j] * x[j]).sum::<f64>());
        a.solve(&mut b);
        let mut c = [0, 1, 2].map(|j: usize| (0..3).map(|i| rows[i][j] * x[i]).sum::<f64>());
        a.solve_transposed(&mut c);
        for i in 0..3 {
            assert!((b[i] - x[i]).abs() < 1e-14 && (c[i] - x[i]).abs() < 1e-14);
        }
    }

    #[test]
    fn factors_in_place() {
        let rows = [[1.0, 2.0], [4.0, 2.0]];
        let mut lu = Lu::new(2);
        let mut fill = |rows: [[f64; 2]; 2]| {
            rows.iter().enumerate().for_each(|(i, row)| lu.set_row(i, row.iter().copied()));
            (lu.factor(), lu.clone())
        };
        let (regular, mut lu) = fill(rows);
        assert!(regular);
        assert_eq!((lu.order(), lu.sign(), lu.least_pivot()), (2, -1.0, 1.5));
        let mut b = [5.0, 8.0];
        lu.solve(&mut b);
        assert_eq!(b, [1.0, 2.0]);
        let (regular, lu) = fill([[3.0, 7.0], [3.0, 7.0]]);
        assert!(!regular && lu.sign() == 0.0);
        assert!(!fill([[1.0, 0.0], [0.0, f64::NAN]]).0);
    }

    #[test]
    fn nothing_is_regular() {
        let mut lu = Lu::new(0);
        assert!(lu.factor());
        lu.solve(&mut []);
        lu.solve_transposed(&mut []);
    }

    #[test]
    fn tells_its_condition() {
        let mut sums = [0.0; 2];
        let mut a = filled(&[&[1.0, 0.0], &[0.0, 1e9]]);
        assert!(a.factor());
        assert_eq!(a.reciprocal_condition(&mut sums), 1.0);
        let mut a = filled(&[&[1.0, 1.0], &[1.0, 1.0 + 1e-6]]);
        assert!(a.factor());
        let sigma = a.reciprocal_condition(&mut sums);
        assert!(sigma > 1e-7 && sigma < 1e-6);
        let mut a = filled(&[&[1.0, 2.0], &[2.0, 4.0]]);
        assert!(!a.factor());
        assert_eq!((a.sign(), a.reciprocal_condition(&mut sums)), (0.0, 0.0));
        assert!(!filled(&[&[f64::NAN]]).factor());
    }
}
