//! Elimination of systems in which most coefficients are zero: of each row nothing outside its first and last coefficient is
//! read, and rows without one in the column that is eliminated are left alone.
//!
//! What is left out would add zeros: every number has the bits that [`super::Lu`] gives it.

/// A square matrix and, in its place, its LU factors with partial pivoting. All memory is taken once.
#[derive(Clone, Debug)]
pub struct Sparse {
    n: usize,
    /// Row by row; the factors after [`Sparse::factor`].
    rows: Vec<f64>,
    /// The first coefficient of each row that is not zero, and the place behind the last.
    extents: Vec<(usize, usize)>,
    /// Row of the matrix that each row of the factors came from.
    order: Vec<usize>,
    sign: f64,
    /// Rows with a coefficient in the column that is eliminated.
    hit: Vec<usize>,
    scratch: Vec<f64>,
    /// The inverse, row by row.
    inverse: Vec<f64>,
}

impl Sparse {
    /// The null matrix of order `n`.
    #[must_use]
    pub fn new(n: usize) -> Self {
        Self {
            n,
            rows: vec![0.0; n * n],
            extents: vec![(0, 0); n],
            order: (0..n).collect(),
            sign: 0.0,
            hit: Vec::with_capacity(n),
            scratch: vec![0.0; n],
            inverse: vec![0.0; n * n],
        }
    }

    /// Sign of the determinant of what was factored; 0 when it could not be.
    #[must_use]
    pub const fn sign(&self) -> f64 {
        self.sign
    }

    pub(super) const fn forget(&mut self) {
        self.sign = 0.0;
    }

    /// Writes row `i`.
    pub fn set_row(&mut self, i: usize, row: impl Iterator<Item = f64>) {
        let to = &mut self.rows[i * self.n..][..self.n];
        to.iter_mut().zip(row).for_each(|(to, x)| *to = x);
        let first = to.iter().position(|x| *x != 0.0).unwrap_or(self.n);
        let end = to.iter().rposition(|x| *x != 0.0).map_or(0, |last| last + 1);
        self.extents[i] = (first, end);
    }

    /// Factors the matrix in place; `false` when a pivot is zero or not finite.
    pub fn factor(&mut self) -> bool {
        self.sign = 0.0;
        self.order.iter_mut().enumerate().for_each(|(i, row)| *row = i);
        let (n, mut sign) = (self.n, 1.0);
        for k in 0..n {
            if self.bring_pivot(k) {
                sign = -sign;
            }
            let end = self.extents[k].1;
            let (above, below) = self.rows.split_at_mut((k + 1) * n);
            let pivot = &above[k * n..][..n];
            let diagonal = pivot[k];
            if diagonal == 0.0 || !diagonal.is_finite() {
                return false;
            }
            sign *= diagonal.signum();
            for &i in &self.hit {
                let row = &mut below[(i - k - 1) * n..][..n];
                let ratio = row[k] / diagonal;
                row[k] = ratio;
                // the row of the pivot may end at the diagonal
                let end = end.max(k + 1);
                row[k + 1..end].iter_mut().zip(&pivot[k + 1..end]).for_each(|(x, y)| *x -= ratio * y);
                self.extents[i].1 = self.extents[i].1.max(end);
            }
        }
        self.sign = sign;
        true
    }

    /// Brings the row with the greatest coefficient in column `k` up to row `k`, and notes the rows below that have one there;
    /// whether two rows were swapped.
    fn bring_pivot(&mut self, k: usize) -> bool {
        let n = self.n;
        self.hit.clear();
        let own = self.rows[k * n + k];
        let (mut pivot, mut greatest) = (k, own.abs());
        for i in k + 1..n {
            let x = self.rows[i * n + k];
            if x != 0.0 {
                self.hit.push(i);
            }
            if x.abs() > greatest {
                (pivot, greatest) = (i, x.abs());
            }
        }
        if pivot == k {
            return false;
        }
        if own == 0.0 {
            self.hit.retain(|i| *i != pivot);
        }
        self.order.swap(k, pivot);
        self.extents.swap(k, pivot);
        let (above, below) = self.rows.split_at_mut(pivot * n);
        above[k * n..][..n].swap_with_slice(&mut below[..n]);
        true
    }

    /// What stands left of the diagonal in row `i`, from which column on.
    fn lower(&self, i: usize) -> (usize, &[f64]) {
        let from = self.extents[i].0.min(i);
        (from, &self.rows[i * self.n + from..i * self.n + i])
    }

    /// What stands right of the diagonal in row `i`, and the diagonal.
    fn upper(&self, i: usize) -> (&[f64], f64) {
        let end = self.extents[i].1.max(i + 1);
        (&self.rows[i * self.n + i + 1..i * self.n + end], self.rows[i * self.n + i])
    }

    /// Solves A x = b in place, after [`Sparse::factor`].
    pub fn solve(&mut self, b: &mut [f64]) {
        let mut x = std::mem::take(&mut self.scratch);
        for i in 0..self.n {
            let (from, row) = self.lower(i);
            let known: f64 = row.iter().zip(&x[from..]).map(|(a, x)| a * x).sum();
            x[i] = b[self.order[i]] - known;
        }
        for i in (0..self.n).rev() {
            let (row, diagonal) = self.upper(i);
            let known: f64 = row.iter().zip(&x[i + 1..]).map(|(a, x)| a * x).sum();
            x[i] = (x[i] - known) / diagonal;
        }
        b.copy_from_slice(&x);
        self.scratch = x;
    }

    /// Solves Aᵀ x = b in place, after [`Sparse::factor`].
    pub fn solve_transposed(&mut self, b: &mut [f64]) {
        let mut x = std::mem::take(&mut self.scratch);
        x.fill(0.0);
        for i in 0..self.n {
            let (row, diagonal) = self.upper(i);
            let own = (b[i] - x[i]) / diagonal;
            x[i] = own;
            x[i + 1..].iter_mut().zip(row).for_each(|(known, a)| *known += a * own);
        }
        for i in (0..self.n).rev() {
            let column = self.rows[i..].iter().step_by(self.n).skip(i + 1);
            let known: f64 = column.zip(&x[i + 1..]).map(|(a, x)| a * x).sum();
            x[i] -= known;
        }
        for (x, &row) in x.iter().zip(&self.order) {
            b[row] = *x;
        }
        self.scratch = x;
    }

    /// Adds the magnitudes in each row of the inverse to `sums`, after [`Sparse::factor`].
    pub(super) fn add_inverse_rows(&mut self, sums: &mut [f64]) {
        let n = self.n;
        let mut inverse = std::mem::take(&mut self.inverse);
        // L Y = 1, all columns at once; row i of Y ends at its diagonal
        for i in 0..n {
            let (before, rest) = inverse.split_at_mut(i * n);
            let own = &mut rest[..n];
            own.fill(0.0);
            own[i] = 1.0;
            let (from, row) = self.lower(i);
            for (j, a) in (from..).zip(row).filter(|(_, a)| **a != 0.0) {
                own[..=j].iter_mut().zip(&before[j * n..]).for_each(|(x, y)| *x -= a * y);
            }
        }
        // U X = Y
        for i in (0..n).rev() {
            let (before, behind) = inverse.split_at_mut((i + 1) * n);
            let own = &mut before[i * n..];
            let (row, diagonal) = self.upper(i);
            for (j, a) in row.iter().enumerate().rev().filter(|(_, a)| **a != 0.0) {
                own.iter_mut().zip(&behind[j * n..]).for_each(|(x, y)| *x -= a * y);
            }
            own.iter_mut().for_each(|x| *x /= diagonal);
        }
        for k in 0..n {
            for (i, sum) in sums.iter_mut().enumerate() {
                *sum += inverse[i * n + k].abs();
            }
        }
        self.inverse = inverse;
    }
}
