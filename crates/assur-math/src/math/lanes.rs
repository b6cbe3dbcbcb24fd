//! Several numbers side by side.
//!
//! Operations are `inline`, not `inline(always)`: they are unrolled first and then written out, else all their loops
//! together keep the compiler busy for minutes.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::Scalar;
use super::scalar::LaneMask;

/// `N` numbers that go through the same operations. Plain arrays: the compiler makes vectors of them. Every lane has the
/// same bits as `f64` alone. Aligned, so that no vector lies across two lines of the cache.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Lanes<const N: usize>(pub [f64; N]);

impl<const N: usize> Lanes<N> {
    #[inline]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        let mut out = self.0;
        for x in &mut out {
            *x = f(*x);
        }
        Self(out)
    }

    #[inline]
    fn each(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut out = self.0;
        for (x, y) in out.iter_mut().zip(other.0) {
            *x = f(*x, y);
        }
        Self(out)
    }
}

impl<const N: usize> Default for Lanes<N> {
    fn default() -> Self {
        Self([0.0; N])
    }
}

macro_rules! operator {
    ($trait:ident, $name:ident) => {
        impl<const N: usize> $trait for Lanes<N> {
            type Output = Self;
            #[inline]
            fn $name(self, other: Self) -> Self {
                self.each(other, f64::$name)
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(f64::neg)
    }
}

/// All bits of a lane where it holds, none elsewhere: what a comparison of vectors leaves.
impl<const N: usize> LaneMask for [u64; N] {
    #[inline]
    fn all(self) -> bool {
        self.iter().fold(u64::MAX, |all, x| all & x) == u64::MAX
    }
}

impl<const N: usize> Scalar for Lanes<N> {
    type Mask = [u64; N];

    #[inline]
    fn of(x: f64) -> Self {
        Self([x; N])
    }
    #[inline]
    fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }
    #[inline]
    fn abs(self) -> Self {
        self.map(f64::abs)
    }
    #[inline]
    fn max(self, other: Self) -> Self {
        self.each(other, Scalar::max)
    }
    #[inline]
    fn min(self, other: Self) -> Self {
        self.each(other, Scalar::min)
    }
    #[inline]
    fn lt(self, other: Self) -> [u64; N] {
        let mut out = [0; N];
        for ((out, x), y) in out.iter_mut().zip(self.0).zip(other.0) {
            *out = if x < y { u64::MAX } else { 0 };
        }
        out
    }
    #[inline]
    fn select(mask: [u64; N], a: Self, b: Self) -> Self {
        let mut out = b.0;
        for ((out, x), mask) in out.iter_mut().zip(a.0).zip(mask) {
            *out = if mask != 0 { x } else { *out };
        }
        Self(out)
    }
}
