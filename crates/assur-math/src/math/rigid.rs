//! A rigid body in the plane: the motion of one of its points from the motion of another.

use super::{Scalar, V2};

/// Velocity of the point at `r` from O: v = v_O + ω × r.
#[inline(always)]
pub fn velocity_at<S: Scalar>(v_o: V2<S>, omega: S, r: V2<S>) -> V2<S> {
    v_o + r.perp() * omega
}

/// Acceleration of the point at `r` from O: a = a_O + α × r − ω² r.
#[inline(always)]
pub fn acceleration_at<S: Scalar>(a_o: V2<S>, omega: S, alpha: S, r: V2<S>) -> V2<S> {
    a_o + r.perp() * alpha - r * (omega * omega)
}
