//! Elimination with partial pivoting in any real number; `dense` does it in `f64`.

use super::Real;

/// A square matrix and, in its place, its factors.
#[derive(Clone, Debug)]
pub(super) struct Elimination<S> {
    n: usize,
    rows: Vec<S>,
    /// Row of the matrix that each row of the factors came from.
    order: Vec<usize>,
    scratch: Vec<S>,
}

impl<S: Real> Elimination<S> {
    pub(super) fn new(n: usize) -> Self {
        Self { n, rows: vec![S::zero(); n * n], order: (0..n).collect(), scratch: vec![S::zero(); n] }
    }

    /// Writes every element and factors; `false` when a pivot is zero or not a number.
    pub(super) fn factor(&mut self, element: impl Fn(usize, usize) -> S) -> bool {
        let n = self.n;
        for i in 0..n {
            self.order[i] = i;
            for j in 0..n {
                self.rows[i * n + j] = element(i, j);
            }
        }
        (0..n).all(|k| self.eliminate(k))
    }

    fn eliminate(&mut self, k: usize) -> bool {
        let n = self.n;
        let mut pivot = k;
        for i in k + 1..n {
            if self.rows[pivot * n + k].abs().lt(self.rows[i * n + k].abs()) {
                pivot = i;
            }
        }
        if pivot != k {
            self.order.swap(k, pivot);
            (0..n).for_each(|j| self.rows.swap(k * n + j, pivot * n + j));
        }
        let (above, below) = self.rows.split_at_mut((k + 1) * n);
        let top = &above[k * n..];
        if !S::zero().lt(top[k].abs()) {
            return false;
        }
        for row in below.chunks_exact_mut(n) {
            let ratio = row[k] / top[k];
            row[k] = ratio;
            for j in k + 1..n {
                row[j] = row[j] - ratio * top[j];
            }
        }
        true
    }

    /// Solves in place, after [`Elimination::factor`].
    pub(super) fn solve(&mut self, b: &mut [S]) {
        let n = self.n;
        for i in 0..n {
            let row = &self.rows[i * n..(i + 1) * n];
            let known = row[..i].iter().zip(&self.scratch);
            self.scratch[i] = known.fold(b[self.order[i]], |x, (a, y)| x - *a * *y);
        }
        for i in (0..n).rev() {
            let row = &self.rows[i * n..(i + 1) * n];
            let known = row[i + 1..].iter().zip(&self.scratch[i + 1..]);
            self.scratch[i] = known.fold(self.scratch[i], |x, (a, y)| x - *a * *y) / row[i];
        }
        b.copy_from_slice(&self.scratch);
    }
}
