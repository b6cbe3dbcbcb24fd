//! Several numbers side by side.
//!
//! Operations are `inline`, not `inline(always)`: they are unrolled first and then written out, else all their loops
//! together keep the compiler busy for minutes.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::Scalar;
use super::scalar::Truths;

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
impl<const N: usize> Truths for [u64; N] {
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

#[cfg(test)]
mod tests {
    use super::*;

    const X: [f64; 4] = [0.1, -2.0, f64::NAN, 7.5];
    const Y: [f64; 4] = [3.0, -2.0, 1.0, f64::INFINITY];

    /// The bits of every lane are those of the operation on one number.
    fn same(got: Lanes<4>, one: impl Fn(f64, f64) -> f64) {
        for i in 0..4 {
            let want = one(X[i], Y[i]);
            assert!(got.0[i].to_bits() == want.to_bits() || got.0[i].is_nan() && want.is_nan());
        }
    }

    #[test]
    fn every_lane_is_the_number_alone() {
        let (x, y) = (Lanes(X), Lanes(Y));
        same(x + y, |x, y| x + y);
        same(x - y, |x, y| x - y);
        same(x * y, |x, y| x * y);
        same(x / y, |x, y| x / y);
        same(-x, |x, _| -x);
        same(x.sqrt(), |x, _| x.sqrt());
        same(x.abs(), |x, _| x.abs());
        same(x.max(y), Scalar::max);
        same(x.min(y), Scalar::min);
        same(x.two_product(y).1, |x, y| x.two_product(y).1);
        assert_eq!(x.lt(y), [u64::MAX, 0, 0, u64::MAX]);
        same(Lanes::select(x.lt(y), x, y), |x, y| if x < y { x } else { y });
    }

    #[test]
    fn all_lanes() {
        assert!([u64::MAX; 3].all() && ![u64::MAX, 0, u64::MAX].all());
        assert!(true.all() && !false.all());
    }

    #[test]
    fn a_product_and_its_error_are_exact() {
        // (1 + 2⁻⁵²)² = 1 + 2⁻⁵¹ + 2⁻¹⁰⁴
        let x = 1.0 + f64::EPSILON;
        assert_eq!(x.two_product(x), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
        let x = 1.0 + f32::EPSILON;
        assert_eq!(x.two_product(x), (1.0 + 2.0 * f32::EPSILON, f32::EPSILON * f32::EPSILON));
    }
}
