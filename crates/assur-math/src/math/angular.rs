//! Numbers that may be angles.

use super::{Double, Scalar};
use std::f64::consts::PI;

/// A number of which sine and cosine can be formed.
pub trait Angular: Scalar<Mask = bool> {
    /// π.
    fn pi() -> Self;
    /// Sine and cosine of an angle, rad.
    fn sine_cosine(self) -> (Self, Self);
}

impl Angular for f64 {
    fn pi() -> Self {
        PI
    }
    fn sine_cosine(self) -> (Self, Self) {
        libm::sincos(self)
    }
}

impl Angular for Double {
    fn pi() -> Self {
        Self::PI
    }
    fn sine_cosine(self) -> (Self, Self) {
        let u = self.as_direction();
        (u.y, u.x)
    }
}
