//! Numbers modulo the prime 2⁶¹ − 1: a rank found with random ones is exact, without a tolerance, and is the rank at
//! almost all dimensions and positions. It errs with a probability near 10⁻¹⁵ per mechanism (Schwartz and Zippel).

use std::ops::{Add, AddAssign, Mul, Neg, Sub};

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
