//! Square linear systems with twice the digits.

use super::{Double, Scalar};

/// A pivot below this part of its row's greatest element is none.
const NOTHING: f64 = 1e-26;

/// LU factors of a matrix with partial pivoting on rows scaled to their greatest element. Elements that are zero cost
/// nothing: the systems of many bodies are mostly zeros.
#[derive(Clone, Debug)]
pub struct Factors {
    n: usize,
    rows: Vec<Vec<(usize, Double)>>,
    /// Factors below the diagonal, by row: column and factor, in the order of elimination.
    lower: Vec<Vec<(usize, Double)>>,
    /// Row of the matrix that each row of the factors came from.
    order: Vec<usize>,
}

impl Factors {
    /// Factors the matrix whose rows are given, of `n` numbers each; `None` where it is singular to within some digits
    /// more than `f64` has.
    #[must_use]
    pub fn new(matrix: Vec<Vec<Double>>) -> Option<Self> {
        let n = matrix.len();
        let mut rows = matrix;
        let mut scale = Vec::with_capacity(n);
        for row in &rows {
            let most = row.iter().fold(0.0, |most: f64, x| most.max(x.high.abs()));
            if !(row.len() == n && most > 0.0 && most.is_finite()) {
                return None;
            }
            scale.push(1.0 / most);
        }
        let mut order: Vec<usize> = (0..n).collect();
        let mut lower: Vec<Vec<(usize, Double)>> = vec![Vec::new(); n];
        for k in 0..n {
            let size = |i: usize| (rows[i][k].high * scale[order[i]]).abs();
            let pivot = (k..n).fold(k, |best, i| if size(i) > size(best) { i } else { best });
            let most = size(pivot);
            if most.is_nan() || most <= NOTHING {
                return None;
            }
            rows.swap(k, pivot);
            lower.swap(k, pivot);
            order.swap(k, pivot);
            let (head, tail) = rows.split_at_mut(k + 1);
            let pivot_row = &head[k];
            let filled: Vec<usize> = (k + 1..n).filter(|&j| pivot_row[j].high != 0.0).collect();
            for (row, lower) in tail.iter_mut().zip(&mut lower[k + 1..]) {
                if row[k].high == 0.0 {
                    continue;
                }
                let factor = row[k] / pivot_row[k];
                for &j in &filled {
                    row[j] = row[j] - factor * pivot_row[j];
                }
                lower.push((k, factor));
            }
        }
        let sparse = |(i, row): (usize, Vec<Double>)| {
            row.into_iter().enumerate().skip(i).filter(|(_, x)| x.high != 0.0).collect()
        };
        let rows = rows.into_iter().enumerate().map(sparse).collect();
        Some(Self { n, rows, lower, order })
    }

    /// Solves A x = b.
    #[must_use]
    pub fn solve(&self, b: &[Double]) -> Vec<Double> {
        let mut x: Vec<Double> = self.order.iter().map(|&i| b[i]).collect();
        for i in 0..self.n {
            x[i] = self.lower[i].iter().fold(x[i], |sum, &(k, factor)| sum - factor * x[k]);
        }
        for i in (0..self.n).rev() {
            let mut known = x[i];
            let mut diagonal = Double::one();
            for &(j, value) in &self.rows[i] {
                if j == i {
                    diagonal = value;
                } else {
                    known = known - value * x[j];
                }
            }
            x[i] = known / diagonal;
        }
        x
    }
}
