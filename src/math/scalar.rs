//! What a kernel may ask of a number.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number, or several of them side by side.
///
/// Every kernel in `group` and `force` is generic over it, so that one formula serves `f64`, `f32`, SIMD lanes and
/// double-double. Where lanes may differ a branch is a [`Scalar::select`].
pub trait Scalar:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// The outcome of a comparison, one truth per lane.
    type Mask: Copy;

    /// The same value in every lane.
    fn of(x: f64) -> Self;
    /// Square root; NaN below zero.
    fn sqrt(self) -> Self;
    /// Magnitude.
    fn abs(self) -> Self;
    /// The greater of the two.
    fn max(self, other: Self) -> Self;
    /// The lesser of the two.
    fn min(self, other: Self) -> Self;
    /// `self < other`, lane by lane.
    fn lt(self, other: Self) -> Self::Mask;
    /// `a` where the mask holds, `b` elsewhere.
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self;

    /// The product and what its rounding left out, up to the last place of the pair.
    #[inline(always)]
    fn two_product(self, other: Self) -> (Self, Self) {
        (self * other, Self::zero())
    }
    /// A number whose reciprocal times any square of a length is finite.
    #[inline(always)]
    fn tiny() -> Self {
        Self::of(1e-280)
    }

    /// Zero in every lane.
    fn zero() -> Self {
        Self::of(0.0)
    }
    /// One in every lane.
    fn one() -> Self {
        Self::of(1.0)
    }
}

impl Scalar for f64 {
    type Mask = bool;

    #[inline(always)]
    fn of(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self < other { other } else { self }
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn select(mask: bool, a: Self, b: Self) -> Self {
        if mask { a } else { b }
    }
    #[inline(always)]
    fn two_product(self, other: Self) -> (Self, Self) {
        let product = self * other;
        (product, libm::fma(self, other, -product))
    }
}
