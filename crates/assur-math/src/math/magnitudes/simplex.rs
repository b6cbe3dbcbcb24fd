//! Whether a system of linear equations has a solution without negative numbers: the first phase of the simplex method.

/// A number below this part of the greatest in its row is rounding.
const ROUNDED: f64 = 1e-11;
/// What may be left of the equations, relative to their right sides.
const LEFT: f64 = 1e-9;

/// Equations Σ a_ij z_j = b_i in z_j ≥ 0.
pub(super) struct Equations {
    columns: usize,
    rows: Vec<(Vec<f64>, f64)>,
}

impl Equations {
    pub fn new(columns: usize) -> Self {
        Self { columns, rows: Vec::new() }
    }

    /// A row of zeros, to be filled.
    pub fn row(&mut self, right: f64) -> &mut [f64] {
        self.rows.push((vec![0.0; self.columns], right));
        let last = self.rows.len() - 1;
        &mut self.rows[last].0
    }

    /// Whether there is a solution; also `true` where rounding leaves it open.
    pub fn feasible(self) -> bool {
        let (n, m) = (self.columns, self.rows.len());
        let width = n + 1;
        // the scale of each column is its greatest number, so that one tolerance does for all
        let mut scale = vec![0.0_f64; n];
        for (row, _) in &self.rows {
            let most = row.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            scale.iter_mut().zip(row).for_each(|(s, x)| *s = s.max(x.abs() / most.max(f64::MIN_POSITIVE)));
        }
        let mut table = vec![0.0; m * width];
        for (out, (row, right)) in table.chunks_exact_mut(width).zip(&self.rows) {
            let most = row.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            let by = if *right < 0.0 { -1.0 } else { 1.0 } / if most > 0.0 { most } else { 1.0 };
            for ((o, x), s) in out.iter_mut().zip(row).zip(&scale) {
                *o = if *s > 0.0 { by * x / s } else { 0.0 };
            }
            out[n] = by * right;
        }
        let greatest = table.chunks_exact(width).fold(0.0_f64, |m, row| m.max(row[n]));
        if greatest == 0.0 {
            return true;
        }
        // what is left of all equations, to be brought to nothing: the sum of the rows whose variable is not basic yet
        let mut costs = vec![0.0; width];
        for row in table.chunks_exact(width) {
            costs.iter_mut().zip(row).for_each(|(c, x)| *c += x);
        }
        let mut basis: Vec<Option<usize>> = vec![None; m];
        let most_pivots = 20 * (m + n);
        for pivots in 0..most_pivots {
            if costs[n] <= LEFT * greatest {
                return true;
            }
            // the steepest column; the first one after many steps, which cannot cycle
            let better = |j: &usize| costs[*j] > ROUNDED && !basis.contains(&Some(*j));
            let entering = if 2 * pivots < most_pivots {
                (0..n).filter(better).max_by(|a, b| costs[*a].total_cmp(&costs[*b]))
            } else {
                (0..n).find(better)
            };
            let Some(column) = entering else { return false };
            let ratio = |i: usize| table[i * width + n] / table[i * width + column];
            let usable = (0..m).filter(|i| table[i * width + column] > ROUNDED);
            let order = |a: &usize, b: &usize| {
                let by_size = table[b * width + column].total_cmp(&table[a * width + column]);
                ratio(*a).total_cmp(&ratio(*b)).then(by_size)
            };
            let Some(pivot) = usable.min_by(order) else {
                // what is left cannot be brought down without bound: rounding
                return true;
            };
            exchange(&mut table, &mut costs, width, (pivot, column));
            basis[pivot] = Some(column);
        }
        true
    }
}

fn exchange(table: &mut [f64], costs: &mut [f64], width: usize, (pivot, column): (usize, usize)) {
    let by = table[pivot * width + column];
    table[pivot * width..][..width].iter_mut().for_each(|x| *x /= by);
    let row = table[pivot * width..][..width].to_vec();
    let subtract = |out: &mut [f64]| {
        let factor = out[column];
        if factor != 0.0 {
            out.iter_mut().zip(&row).for_each(|(o, x)| *o -= factor * x);
            out[column] = 0.0;
        }
    };
    table.chunks_exact_mut(width).enumerate().filter(|(i, _)| *i != pivot).for_each(|(_, out)| subtract(out));
    subtract(costs);
    // a right side below zero is rounding
    let last = width - 1;
    table.chunks_exact_mut(width).for_each(|row| row[last] = row[last].max(0.0));
}
