//! Small dense linear systems, solved in place with their condition.

/// A square matrix with row-scaled LU factors beside it. All memory is taken once.
#[derive(Clone, Debug)]
pub struct Dense {
    n: usize,
    matrix: Vec<f64>,
    /// Factors of the matrix whose rows are scaled to unit sum of magnitudes.
    factors: Vec<f64>,
    scale: Vec<f64>,
    /// Row of the matrix that each row of the factors came from.
    order: Vec<usize>,
    sign: f64,
    scratch: Vec<f64>,
}

impl Dense {
    /// The null matrix of order `n`.
    #[must_use]
    pub fn new(n: usize) -> Self {
        Self {
            n,
            matrix: vec![0.0; n * n],
            factors: vec![0.0; n * n],
            scale: vec![0.0; n],
            order: vec![0; n],
            sign: 0.0,
            scratch: vec![0.0; n],
        }
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
        let n = self.n;
        self.sign = 0.0;
        for i in 0..n {
            let sum: f64 = self.row(i).iter().map(|x| x.abs()).sum();
            if !(sum > 0.0 && sum.is_finite()) {
                return false;
            }
            self.scale[i] = 1.0 / sum;
            self.order[i] = i;
            for j in 0..n {
                self.factors[i * n + j] = self.matrix[i * n + j] * self.scale[i];
            }
        }
        let mut sign = 1.0;
        for k in 0..n {
            let column = |i: usize| self.factors[i * n + k].abs();
            let pivot = (k + 1..n).fold(k, |best, i| if column(i) > column(best) { i } else { best });
            if pivot != k {
                self.order.swap(k, pivot);
                let (head, tail) = self.factors.split_at_mut(pivot * n);
                head[k * n..][..n].swap_with_slice(&mut tail[..n]);
                sign = -sign;
            }
            let diagonal = self.factors[k * n + k];
            if diagonal == 0.0 || diagonal.is_nan() {
                return false;
            }
            sign *= diagonal.signum();
            let (head, tail) = self.factors.split_at_mut((k + 1) * n);
            let pivot_row = &head[k * n..][..n];
            for row in tail.chunks_exact_mut(n) {
                let ratio = row[k] / diagonal;
                row[k] = ratio;
                for j in k + 1..n {
                    row[j] -= ratio * pivot_row[j];
                }
            }
        }
        self.sign = sign;
        true
    }

    /// What row `i` was multiplied by before it was factored: 1 over the sum of its magnitudes.
    #[must_use]
    pub fn row_scale(&self, i: usize) -> f64 {
        self.scale[i]
    }

    /// Sign of the determinant of what was factored; 0 when it could not be.
    #[must_use]
    pub fn sign(&self) -> f64 {
        self.sign
    }

    /// Solves A x = b in place, after [`Dense::factor`].
    pub fn solve(&mut self, b: &mut [f64]) {
        for i in 0..self.n {
            self.scratch[i] = b[self.order[i]] * self.scale[self.order[i]];
        }
        self.substitute();
        b.copy_from_slice(&self.scratch);
    }

    /// L U y = scratch, y left in scratch.
    fn substitute(&mut self) {
        let n = self.n;
        for i in 0..n {
            let row = &self.factors[i * n..][..n];
            let known: f64 = (0..i).map(|j| row[j] * self.scratch[j]).sum();
            self.scratch[i] -= known;
        }
        for i in (0..n).rev() {
            let row = &self.factors[i * n..][..n];
            let known: f64 = (i + 1..n).map(|j| row[j] * self.scratch[j]).sum();
            self.scratch[i] = (self.scratch[i] - known) / row[i];
        }
    }

    /// Solves Aᵀ x = b in place, after [`Dense::factor`].
    pub fn solve_transposed(&mut self, b: &mut [f64]) {
        let n = self.n;
        let at = |i: usize, j: usize| self.factors[i * n + j];
        self.scratch.copy_from_slice(b);
        for i in 0..n {
            let known: f64 = (0..i).map(|j| at(j, i) * self.scratch[j]).sum();
            self.scratch[i] = (self.scratch[i] - known) / at(i, i);
        }
        for i in (0..n).rev() {
            let known: f64 = (i + 1..n).map(|j| at(j, i) * self.scratch[j]).sum();
            self.scratch[i] -= known;
        }
        for i in 0..n {
            b[self.order[i]] = self.scratch[i] * self.scale[self.order[i]];
        }
    }

    /// 1 / (‖A‖ ‖A⁻¹‖) of the row-scaled matrix in the greatest row sum, in (0, 1]; 0 when it could not be factored.
    /// `sums` is room for one number per row.
    pub fn reciprocal_condition(&mut self, sums: &mut [f64]) -> f64 {
        if self.sign == 0.0 {
            return 0.0;
        }
        sums.fill(0.0);
        for k in 0..self.n {
            self.scratch.fill(0.0);
            self.scratch[k] = 1.0;
            self.substitute();
            for (sum, x) in sums.iter_mut().zip(&self.scratch) {
                *sum += x.abs();
            }
        }
        if !sums.iter().all(|sum| sum.is_finite()) {
            return 0.0;
        }
        1.0 / sums.iter().fold(1.0, |most: f64, &sum| most.max(sum))
    }
}
