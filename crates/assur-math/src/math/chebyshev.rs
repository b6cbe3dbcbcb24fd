//! A function on an interval by its Chebyshev series: integral, derivative, roots.
//!
//! f(x) = Σ c_k T_k(t), t = (2x − a − b)/(b − a). The coefficients come from the values at the n zeros of T_n,
//! t_j = cos(π(2j + 1)/2n): c_k = (2/n) Σ f_j cos(πk(2j + 1)/2n), c_0 half of it. No node lies at an end, where a function
//! may jump. The integral over the interval is (b − a)/2 Σ 2c_k/(1 − k²) over even k (Fejér's first rule).

use super::root::root;
use std::f64::consts::PI;

/// Nodes of a series.
pub const NODES: usize = 16;

/// The nodes on [−1, 1] and the cosines of the transform.
#[derive(Clone, Debug)]
pub struct Nodes {
    cosines: [f64; 4 * NODES],
    /// Of each node the factors of its value in all coefficients.
    factors: [[f64; NODES]; NODES],
}

/// A series on an interval.
#[derive(Clone, Debug)]
pub struct Series {
    /// Where the interval begins.
    pub from: f64,
    pub to: f64,
    coefficients: Vec<f64>,
}

impl Default for Nodes {
    fn default() -> Self {
        Self::new()
    }
}

impl Nodes {
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // far below 2^52
    pub fn new() -> Self {
        let cosines: [f64; 4 * NODES] =
            std::array::from_fn(|i| libm::cos(PI * i as f64 / (2 * NODES) as f64));
        let factor = |j: usize, k: usize| cosines[k * (2 * j + 1) % (4 * NODES)];
        Self { factors: std::array::from_fn(|j| std::array::from_fn(|k| factor(j, k))), cosines }
    }

    /// A node of an interval; they run from its end to its beginning.
    #[must_use]
    pub fn at(&self, from: f64, to: f64, node: usize) -> f64 {
        let t = self.cosines[2 * node + 1];
        0.5 * ((from + to) + (to - from) * t)
    }

    /// The series of a function with these values at the nodes.
    #[must_use]
    pub fn series(&self, from: f64, to: f64, values: &[f64; NODES]) -> Series {
        Series { from, to, coefficients: self.coefficients(values).to_vec() }
    }

    /// The coefficients of many functions: of each polynomial those of all, from the values of all at each node.
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // far below 2^52
    pub fn coefficients_of_all(&self, values: &[Vec<f64>; NODES]) -> [Vec<f64>; NODES] {
        std::array::from_fn(|k| {
            let factors = std::array::from_fn(|j| self.factors[j][k]);
            let mut sums = vec![0.0; values[0].len()];
            add_rows(&mut sums, values, &factors);
            let times = if k == 0 { 1.0 } else { 2.0 };
            sums.iter_mut().for_each(|sum| *sum = *sum * times / NODES as f64);
            sums
        })
    }

    /// The coefficients of a function with these values at the nodes.
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // far below 2^52
    pub fn coefficients(&self, values: &[f64; NODES]) -> [f64; NODES] {
        // node by node: all sums grow side by side
        let mut sums = [0.0; NODES];
        for (f, factors) in values.iter().zip(&self.factors) {
            sums.iter_mut().zip(factors).for_each(|(sum, factor)| *sum += f * factor);
        }
        std::array::from_fn(|k| sums[k] * if k == 0 { 1.0 } else { 2.0 } / NODES as f64)
    }
}

impl Nodes {
    /// One of the coefficients of a function, from its values at the nodes.
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // far below 2^52
    pub fn coefficient(&self, k: usize, value: impl Fn(usize) -> f64) -> f64 {
        let sum: f64 = self.factors.iter().enumerate().map(|(j, factors)| value(j) * factors[k]).sum();
        sum * if k == 0 { 1.0 } else { 2.0 } / NODES as f64
    }

    /// The factors of the values at the nodes in the value at a place where T_0 … T_(n−1) are these.
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // far below 2^52
    pub fn weights(&self, polynomials: &[f64; NODES]) -> [f64; NODES] {
        self.factors.map(|factors| {
            let sum: f64 = factors.iter().zip(polynomials).map(|(factor, t)| factor * t).sum();
            // the first counts half
            (2.0 * sum - factors[0] * polynomials[0]) / NODES as f64
        })
    }
}

/// Adds multiples of as many rows of numbers as there are nodes to a row, in their order.
pub fn add_rows(sums: &mut [f64], rows: &[Vec<f64>; NODES], factors: &[f64; NODES]) {
    let count = sums.len();
    for (rows, factors) in rows.chunks_exact(4).zip(factors.chunks_exact(4)) {
        // four at a time: the sums are read and written less often
        let ([a, b, c, d], [p, q, r, s]) = (rows, factors) else { return };
        let (a, b, c, d) = (&a[..count], &b[..count], &c[..count], &d[..count]);
        for (i, sum) in sums.iter_mut().enumerate() {
            *sum = *sum + p * a[i] + q * b[i] + r * c[i] + s * d[i];
        }
    }
}

/// T_0 … T_(n−1) at a place of an interval.
#[must_use]
pub fn polynomials(from: f64, to: f64, x: f64) -> [f64; NODES] {
    let t = ((x - from) + (x - to)) / (to - from);
    let mut values = [1.0; NODES];
    values[1] = t;
    for k in 2..NODES {
        values[k] = 2.0 * t * values[k - 1] - values[k - 2];
    }
    values
}

/// The sum of a series at t in [−1, 1], by Clenshaw's recurrence.
#[must_use]
pub fn sum(coefficients: &[f64], t: f64) -> f64 {
    let [first, rest @ ..] = coefficients else { return 0.0 };
    let (mut b_1, mut b_2) = (0.0, 0.0);
    for c in rest.iter().rev() {
        (b_1, b_2) = (2.0 * t * b_1 - b_2 + c, b_1);
    }
    t * b_1 - b_2 + first
}

/// The same at several t side by side.
#[must_use]
pub fn sums<const N: usize>(coefficients: &[f64], t: &[f64; N]) -> [f64; N] {
    let [first, rest @ ..] = coefficients else { return [0.0; N] };
    let (mut b_1, mut b_2) = ([0.0; N], [0.0; N]);
    for c in rest.iter().rev() {
        for i in 0..N {
            (b_1[i], b_2[i]) = (2.0 * t[i] * b_1[i] - b_2[i] + c, b_1[i]);
        }
    }
    std::array::from_fn(|i| t[i] * b_1[i] - b_2[i] + first)
}

/// Below this the sum of a series is nowhere in [−t, t], t ≥ 1.
#[must_use]
pub fn least(coefficients: &[f64], t: f64) -> f64 {
    let [first, rest @ ..] = coefficients else { return 0.0 };
    // |T_k| is greatest at the ends
    let (mut away, mut before, mut polynomial) = (0.0, 1.0, t);
    for c in rest {
        away += c.abs() * polynomial;
        (before, polynomial) = (polynomial, 2.0 * t * polynomial - before);
    }
    first - away
}

/// The greatest of the last coefficients: what the series leaves off is about as large.
#[must_use]
pub fn tail(coefficients: &[f64]) -> f64 {
    let last = coefficients.iter().rev().take(3);
    last.fold(0.0, |most, c| if c.is_nan() { f64::INFINITY } else { c.abs().max(most) })
}

/// Values that a series does not pass on [−1, 1]: |T_k| ≤ 1.
#[must_use]
pub fn bounds(coefficients: &[f64]) -> (f64, f64) {
    let [first, rest @ ..] = coefficients else { return (0.0, 0.0) };
    let away: f64 = rest.iter().map(|c| c.abs()).sum();
    (first - away, first + away)
}

/// The integral of a series over an interval.
#[must_use]
#[allow(clippy::cast_precision_loss)] // far below 2^52
pub fn integral((from, to): (f64, f64), coefficients: &[f64]) -> f64 {
    let even = coefficients.iter().enumerate().step_by(2);
    let sum: f64 = even.map(|(k, c)| 2.0 * c / (1.0 - (k * k) as f64)).sum();
    0.5 * (to - from) * sum
}

/// The value of a series at a place of an interval.
#[must_use]
pub fn value((from, to): (f64, f64), coefficients: &[f64], x: f64) -> f64 {
    sum(coefficients, ((x - from) + (x - to)) / (to - from))
}

/// Tells where a series changes its sign within an interval, in order.
#[allow(clippy::cast_precision_loss)] // far below 2^52
pub fn roots((from, to): (f64, f64), coefficients: &[f64], mut found: impl FnMut(f64)) {
    let [first, rest @ ..] = coefficients else { return };
    // |T_k| ≤ 1
    if first.abs() > (1.0 + 1e-9) * rest.iter().map(|c| c.abs()).sum::<f64>() {
        return;
    }
    let parts = 4 * coefficients.len();
    let at = |i: usize| {
        // denser towards the ends, as the series turns there
        let t = -libm::cos(PI * i as f64 / parts as f64);
        if i == parts { to } else { from + 0.5 * (to - from) * (1.0 + t) }
    };
    let value = |x: f64| value((from, to), coefficients, x);
    let (mut x, mut f) = (from, value(from));
    for i in 1..=parts {
        let next = at(i);
        let g = value(next);
        if f * g < 0.0 {
            // from the near end of the interval, so that a root close to it keeps its digits
            found(from + root(x - from, next - from, f, g, |d| value(from + d)));
        } else if g == 0.0 && i < parts {
            found(next);
        }
        (x, f) = (next, g);
    }
}

/// The antiderivative in t, times a factor, with this value at −1: one coefficient more.
#[allow(clippy::cast_precision_loss)] // far below 2^52
pub fn integrate(coefficients: &[f64], factor: f64, start: f64, out: &mut [f64]) {
    let c = |k: usize| coefficients.get(k).copied().unwrap_or(0.0);
    for (k, out) in out.iter_mut().enumerate().skip(1) {
        let before = if k == 1 { 2.0 * c(0) } else { c(k - 1) };
        *out = factor * (before - c(k + 1)) / (2 * k) as f64;
    }
    let [first, rest @ ..] = out else { return };
    // T_k(−1) = (−1)^k
    let at_start: f64 = rest.iter().enumerate().map(|(k, c)| if k % 2 == 0 { -c } else { *c }).sum();
    *first = start - at_start;
}

/// The derivative in t: as many coefficients.
#[allow(clippy::cast_precision_loss)] // far below 2^52
pub fn derive(coefficients: &[f64], out: &mut [f64]) {
    out.fill(0.0);
    for k in (1..coefficients.len()).rev() {
        let beyond = out.get(k + 1).copied().unwrap_or(0.0);
        out[k - 1] = beyond + 2.0 * k as f64 * coefficients[k];
    }
    if let Some(first) = out.first_mut() {
        *first *= 0.5;
    }
}

impl Series {
    /// With these coefficients, of T_0 first.
    #[must_use]
    pub const fn new(from: f64, to: f64, coefficients: Vec<f64>) -> Self {
        Self { from, to, coefficients }
    }

    /// Its coefficients, of T_0 first.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// The greatest of the last coefficients: what the series leaves off is about as large.
    #[must_use]
    pub fn tail(&self) -> f64 {
        tail(&self.coefficients)
    }

    #[must_use]
    pub fn value(&self, x: f64) -> f64 {
        value((self.from, self.to), &self.coefficients, x)
    }

    /// Values that it does not pass within the interval: |T_k| ≤ 1.
    #[must_use]
    pub fn bounds(&self) -> (f64, f64) {
        bounds(&self.coefficients)
    }

    /// The integral over the interval.
    #[must_use]
    pub fn integral(&self) -> f64 {
        integral((self.from, self.to), &self.coefficients)
    }

    /// The function less a constant.
    #[must_use]
    pub fn less(mut self, constant: f64) -> Self {
        if let Some(first) = self.coefficients.first_mut() {
            *first -= constant;
        }
        self
    }

    /// The function times a constant.
    #[must_use]
    pub fn times(mut self, factor: f64) -> Self {
        self.coefficients.iter_mut().for_each(|c| *c *= factor);
        self
    }

    /// The antiderivative that has a given value where the interval begins.
    #[must_use]
    pub fn antiderivative(&self, start: f64) -> Self {
        let mut coefficients = vec![0.0; self.coefficients.len() + 1];
        integrate(&self.coefficients, 0.5 * (self.to - self.from), start, &mut coefficients);
        Self { from: self.from, to: self.to, coefficients }
    }

    #[must_use]
    pub fn derivative(&self) -> Self {
        let n = self.coefficients.len();
        let mut d = vec![0.0; n];
        derive(&self.coefficients, &mut d);
        let scale = 2.0 / (self.to - self.from);
        let coefficients = d.into_iter().take(n.saturating_sub(1).max(1)).map(|c| c * scale).collect();
        Self { from: self.from, to: self.to, coefficients }
    }

    /// Where the series changes its sign within the interval, in order.
    #[must_use]
    pub fn roots(&self) -> Vec<f64> {
        let mut found = Vec::new();
        roots((self.from, self.to), &self.coefficients, |root| found.push(root));
        found
    }
}
