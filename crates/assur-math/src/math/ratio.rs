//! Exact rational numbers, as far as 128 bits carry them.

use super::Lu;

/// A fraction in lowest terms with a positive denominator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ratio {
    numerator: i128,
    denominator: i128,
}

/// Numbers with more decimal figures than this are no ratios that somebody wrote.
const MOST_FIGURES: usize = 15;

fn gcd(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (a.unsigned_abs(), b.unsigned_abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    // a divisor of a number that fits, except of the least one
    i128::try_from(a).unwrap_or(1)
}

impl Ratio {
    pub const ZERO: Self = Self { numerator: 0, denominator: 1 };
    pub const ONE: Self = Self { numerator: 1, denominator: 1 };

    /// The fraction of two whole numbers; `None` where the denominator is zero or the terms do not fit.
    #[must_use]
    pub fn new(numerator: i128, denominator: i128) -> Option<Self> {
        if denominator == 0 {
            return None;
        }
        let divisor = gcd(numerator, denominator);
        let (n, d) = (numerator.checked_div(divisor)?, denominator.checked_div(divisor)?);
        if d > 0 {
            return Some(Self { numerator: n, denominator: d });
        }
        Some(Self { numerator: n.checked_neg()?, denominator: d.checked_neg()? })
    }

    /// The shortest decimal that is read as this number: 0.3 is 3/10. `None` for numbers with many figures, which are
    /// rounded already.
    #[must_use]
    pub fn of_decimal(x: f64) -> Option<Self> {
        if !x.is_finite() {
            return None;
        }
        let text = format!("{x:e}");
        let (mantissa, exponent) = text.split_once('e')?;
        let exponent: i32 = exponent.parse().ok()?;
        let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        if whole.len() + part.len() > MOST_FIGURES {
            return None;
        }
        let figures: i128 = format!("{whole}{part}").parse().ok()?;
        let shift = exponent - i32::try_from(part.len()).ok()?;
        let power = 10_i128.checked_pow(shift.unsigned_abs())?;
        if shift >= 0 { Self::new(figures.checked_mul(power)?, 1) } else { Self::new(figures, power) }
    }

    #[must_use]
    #[allow(clippy::cast_precision_loss)] // each term is rounded once
    pub fn value(self) -> f64 {
        self.numerator as f64 / self.denominator as f64
    }

    /// Whether it is zero.
    #[must_use]
    pub const fn is_zero(self) -> bool {
        self.numerator == 0
    }

    /// Difference; `None` where it does not fit.
    #[must_use]
    pub fn minus(self, other: Self) -> Option<Self> {
        let divisor = gcd(self.denominator, other.denominator);
        let (a, b) = (self.denominator / divisor, other.denominator / divisor);
        let first = self.numerator.checked_mul(b)?;
        let second = other.numerator.checked_mul(a)?;
        Self::new(first.checked_sub(second)?, a.checked_mul(other.denominator)?)
    }

    /// Product; `None` where it does not fit.
    #[must_use]
    pub fn times(self, other: Self) -> Option<Self> {
        let (g, h) = (gcd(self.numerator, other.denominator), gcd(other.numerator, self.denominator));
        if self.is_zero() || other.is_zero() {
            return Some(Self::ZERO);
        }
        let numerator = (self.numerator / g).checked_mul(other.numerator / h)?;
        Self::new(numerator, (self.denominator / h).checked_mul(other.denominator / g)?)
    }

    /// Quotient; `None` where it does not fit, or the divisor is zero.
    #[must_use]
    pub fn over(self, other: Self) -> Option<Self> {
        self.times(Self::new(other.denominator, other.numerator)?)
    }
}

/// Solves A X = B for square A, row by row: A has `n` rows of `n` numbers, B `n` rows of `columns`. In exact ratios where
/// all numbers are such; else in floating point with partial pivoting. `None` where A is singular.
#[must_use]
pub fn solve(a: &[f64], b: &[f64], n: usize) -> Option<Vec<f64>> {
    if n == 0 {
        return Some(Vec::new());
    }
    let columns = b.len() / n;
    match exactly(a, b, n, columns) {
        Some(exact) => exact,
        None => rounded(a, b, n, columns),
    }
}

/// `None` where the numbers are no ratios or do not fit; `Some(None)` where the matrix is singular.
fn exactly(a: &[f64], b: &[f64], n: usize, columns: usize) -> Option<Option<Vec<f64>>> {
    let width = n + columns;
    let mut rows = Vec::with_capacity(n * width);
    for i in 0..n {
        for x in a[i * n..][..n].iter().chain(&b[i * columns..][..columns]) {
            rows.push(Ratio::of_decimal(*x)?);
        }
    }
    for k in 0..n {
        let Some(pivot) = (k..n).find(|&i| !rows[i * width + k].is_zero()) else { return Some(None) };
        for j in 0..width {
            rows.swap(k * width + j, pivot * width + j);
        }
        let diagonal = rows[k * width + k];
        for j in k..width {
            rows[k * width + j] = rows[k * width + j].over(diagonal)?;
        }
        for i in (0..n).filter(|&i| i != k) {
            let factor = rows[i * width + k];
            if factor.is_zero() {
                continue;
            }
            for j in k..width {
                let taken = factor.times(rows[k * width + j])?;
                rows[i * width + j] = rows[i * width + j].minus(taken)?;
            }
        }
    }
    let found = (0..n).flat_map(|i| rows[i * width + n..(i + 1) * width].iter().map(|x| x.value()));
    Some(Some(found.collect()))
}

/// Pivots below this part of the greatest number of their row are rounding.
const SINGULAR: f64 = 1e-13;

fn rounded(a: &[f64], b: &[f64], n: usize, columns: usize) -> Option<Vec<f64>> {
    let (mut lu, mut greatest) = (Lu::new(n), Vec::with_capacity(n));
    for (i, row) in a.chunks_exact(n).enumerate() {
        let most = row.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        if !(most > 0.0 && most.is_finite()) {
            return None;
        }
        lu.set_row(i, row.iter().map(|x| x / most));
        greatest.push(most);
    }
    if !lu.factor() || lu.least_pivot() <= SINGULAR {
        return None;
    }
    let mut found = vec![0.0; n * columns];
    let mut x = vec![0.0; n];
    for j in 0..columns {
        (0..n).for_each(|i| x[i] = b[i * columns + j] / greatest[i]);
        lu.solve(&mut x);
        (0..n).for_each(|i| found[i * columns + j] = x[i]);
    }
    Some(found)
}
