//! What a kernel may ask of a number.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number, or several of them side by side.
///
/// Every kernel in `group` and `force` is generic over it, so that one formula serves `f64`, SIMD lanes and
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
    type Mask: LaneMask;

    /// More digits than `f64`: numbers that a plan holds rounded are formed again.
    const EXTENDED: bool = false;

    /// The same value in every lane.
    fn of(x: f64) -> Self;
    /// Square root; NaN below zero.
    fn sqrt(self) -> Self;
    fn abs(self) -> Self;
    /// The greater of the two.
    fn max(self, other: Self) -> Self;
    /// The lesser of the two.
    fn min(self, other: Self) -> Self;
    /// `self < other`, lane by lane.
    fn lt(self, other: Self) -> Self::Mask;
    /// `a` where the mask holds, `b` elsewhere.
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self;

    /// A number whose reciprocal times the square of a length is finite.
    #[inline(always)]
    fn tiny() -> Self {
        Self::of(1e-280)
    }
    /// The product and its rounding error (Dekker); the same with and without a fused multiplication.
    #[inline(always)]
    fn two_product(self, other: Self) -> (Self, Self) {
        let split = |x: Self| {
            // 2²⁷ + 1, of half of the digits (Veltkamp)
            let scaled = x * Self::of(134_217_729.0);
            let high = scaled - (scaled - x);
            (high, x - high)
        };
        let (a, b) = (split(self), split(other));
        let product = self * other;
        (product, a.1 * b.1 - (((product - a.0 * b.0) - a.1 * b.0) - a.0 * b.1))
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

/// One truth per lane.
pub trait LaneMask: Copy + Debug {
    /// Holds in every lane.
    fn all(self) -> bool;
}

impl LaneMask for bool {
    #[inline(always)]
    fn all(self) -> bool {
        self
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
        Self::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self::abs(self)
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
}

// Real numbers one at a time, for methods that decide by comparing.

/// A real number that can be compared: `f64` or double-double.
pub trait Real: Scalar<Mask = bool> {}

impl<S: Scalar<Mask = bool>> Real for S {}

/// ε of the numbers.
pub(super) fn epsilon<S: Real>() -> S {
    S::of(if S::EXTENDED { 4.930_380_657_631_324e-32 } else { f64::EPSILON })
}

/// A coefficient in two parts.
#[inline(always)]
pub(super) fn wide<S: Real>([high, low]: [f64; 2]) -> S {
    if S::EXTENDED { S::of(high) + S::of(low) } else { S::of(high) }
}

/// Neither infinite nor NaN.
pub(super) fn finite<S: Real>(x: S) -> bool {
    (x * S::zero()).lt(S::one())
}

/// Neither zero nor NaN.
pub(super) fn nonzero<S: Real>(x: S) -> bool {
    S::zero().lt(x.abs())
}

/// The eighth root: powers of the system's library differ from machine to machine, roots do not.
pub(super) fn eighth_root<S: Real>(x: S) -> S {
    x.sqrt().sqrt().sqrt()
}

/// x^(1/m) to a hundredth or so, for step lengths: the bits of 1/m by square roots.
#[allow(clippy::cast_precision_loss)] // far below 2^52
pub(super) fn rough_root<S: Real>(x: S, m: usize) -> S {
    let (mut left, mut power, mut root) = (1.0 / m as f64, x, S::one());
    for _ in 0..16 {
        (left, power) = (2.0 * left, power.sqrt());
        if left >= 1.0 {
            (left, root) = (left - 1.0, root * power);
        }
    }
    root
}
