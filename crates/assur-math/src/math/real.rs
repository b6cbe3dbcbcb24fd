//! Real numbers one at a time, for methods that decide by comparing.

use super::Scalar;

/// A real number that can be compared: `f64` or double-double.
pub trait Real: Scalar<Mask = bool> {}

impl<S: Scalar<Mask = bool>> Real for S {}

/// ε of the numbers.
pub(super) fn epsilon<S: Real>() -> S {
    S::of(if S::WIDE { 4.930_380_657_631_324e-32 } else { S::ROUNDING })
}

/// A coefficient in two parts.
#[inline(always)]
pub(super) fn wide<S: Real>([high, low]: [f64; 2]) -> S {
    if S::WIDE { S::of(high) + S::of(low) } else { S::of(high) }
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
