//! Sparse elimination over the prime field.

use std::ops::{Add, AddAssign, Mul, Neg, Sub};

/// A row: columns in falling order, each once, with coefficients other than zero.
pub type Row = Vec<(usize, Number)>;

/// Puts the terms of a row in order and adds up those of one column.
pub fn row(mut terms: Vec<(usize, Number)>) -> Row {
    terms.sort_by_key(|t| std::cmp::Reverse(t.0));
    terms.dedup_by(|next, last| {
        let same = next.0 == last.0;
        if same {
            last.1 += next.1;
        }
        same
    });
    terms.retain(|t| !t.1.is_zero());
    terms
}

/// Rows in echelon form: each begins in a column of its own, the highest in which it has a coefficient.
pub struct Echelon {
    pivots: Vec<Option<Row>>,
    rank: usize,
}

impl Echelon {
    #[must_use]
    pub fn new(columns: usize) -> Self {
        Self { pivots: vec![None; columns], rank: 0 }
    }

    pub fn of<'a>(columns: usize, rows: impl IntoIterator<Item = &'a Row>) -> Self {
        let mut echelon = Self::new(columns);
        for row in rows {
            echelon.add(row.clone());
        }
        echelon
    }

    /// Number of independent rows.
    #[must_use]
    pub const fn rank(&self) -> usize {
        self.rank
    }

    /// Adds a row. `false` where it depends on those before it.
    pub fn add(&mut self, mut row: Row) -> bool {
        while let Some(&(column, x)) = row.first() {
            let Some(pivot) = &self.pivots[column] else {
                self.pivots[column] = Some(row);
                self.rank += 1;
                return true;
            };
            row = less(&row, pivot, x);
        }
        false
    }

    /// Whether no row begins in this column.
    pub fn is_free(&self, column: usize) -> bool {
        self.pivots[column].is_none()
    }

    /// The vector that all rows take to zero and that has these values in the free columns.
    pub fn null_vector(&self, free: impl Fn(usize) -> Number) -> Vec<Number> {
        let mut x = vec![Number::ZERO; self.pivots.len()];
        for (column, pivot) in self.pivots.iter().enumerate() {
            x[column] = match pivot {
                None => free(column),
                Some(row) => {
                    let sum = row[1..].iter().fold(Number::ZERO, |sum, t| sum + t.1 * x[t.0]);
                    -sum * row[0].1.inverse()
                }
            };
        }
        x
    }
}

/// `p·row − x·pivot`, where the pivot begins with `p`, and the row with `x` in the same column: no inverse is needed.
fn less(row: &Row, pivot: &Row, x: Number) -> Row {
    let p = pivot[0].1;
    let mut out = Row::with_capacity(row.len() + pivot.len() - 2);
    let (mut a, mut b) = (row[1..].iter().peekable(), pivot[1..].iter().peekable());
    loop {
        let (column, value) = match (a.peek(), b.peek()) {
            (None, None) => return out,
            (Some(&&(i, y)), None) => (i, p * y),
            (None, Some(&&(k, z))) => (k, -(x * z)),
            (Some(&&(i, y)), Some(&&(k, z))) => match i.cmp(&k) {
                std::cmp::Ordering::Greater => (i, p * y),
                std::cmp::Ordering::Less => (k, -(x * z)),
                std::cmp::Ordering::Equal => (i, p * y - x * z),
            },
        };
        a.next_if(|t| t.0 == column);
        b.next_if(|t| t.0 == column);
        if !value.is_zero() {
            out.push((column, value));
        }
    }
}

// Numbers modulo the prime 2⁶¹ − 1: a rank found with random ones is exact, without a tolerance, and is the rank at
// almost all dimensions and positions. It errs with a probability near 10⁻¹⁵ per mechanism (Schwartz and Zippel).

const PRIME: u64 = (1 << 61) - 1;

/// A number modulo the prime.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Number(pub u64);

impl Number {
    pub const ZERO: Self = Self(0);
    pub const ONE: Self = Self(1);
    pub const MINUS_ONE: Self = Self(PRIME - 1);

    /// The random number of a seed, the same on every machine (the mixing steps of SplitMix64).
    pub fn random(seed: u64) -> Self {
        let mut z = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        Self((z ^ (z >> 31)) % PRIME)
    }

    /// Whether it is zero.
    #[must_use]
    pub const fn is_zero(self) -> bool {
        self.0 == 0
    }

    /// Its inverse, by Euclid's algorithm; zero for zero.
    pub fn inverse(self) -> Self {
        // r = t·self modulo the prime, for both
        let (mut r, mut t) = ((PRIME, self.0), (Self::ZERO, Self::ONE));
        while r.1 != 0 {
            let quotient = r.0 / r.1;
            r = (r.1, r.0 - quotient * r.1);
            t = (t.1, t.0 - Self(quotient) * t.1);
        }
        if r.0 == 1 { t.0 } else { Self::ZERO }
    }
}

impl Add for Number {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let sum = self.0 + other.0;
        Self(if sum >= PRIME { sum - PRIME } else { sum })
    }
}

impl AddAssign for Number {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Neg for Number {
    type Output = Self;
    fn neg(self) -> Self {
        Self(if self.0 == 0 { 0 } else { PRIME - self.0 })
    }
}

impl Sub for Number {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Number {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = u128::from(self.0) * u128::from(other.0);
        let (low, high) = (product & u128::from(PRIME), product >> 61);
        // both halves are below 2⁶¹
        #[expect(clippy::cast_possible_truncation, reason = "a sum of two halves below 2^61")]
        let sum = (low + high) as u64;
        Self(if sum >= PRIME { sum - PRIME } else { sum })
    }
}
