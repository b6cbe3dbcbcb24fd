//! Forces on bodies and in joints.

use crate::math::V2;

/// A force and a moment on a body.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wrench<S = f64> {
    /// Force, N.
    pub force: V2<S>,
    /// Moment about the origin of the body's frame, N m.
    pub moment: S,
}

/// The reaction in a joint, on the joint's `body`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Reaction<S = f64> {
    /// Force, N.
    pub force: V2<S>,
    /// Couple about the joint's reference point, N m.
    pub couple: S,
}

/// What a law does at one position.
#[derive(Clone, Copy, Debug, Default)]
pub struct LawForce {
    /// The multiplier of its coefficients.
    pub multiplier: f64,
    /// What is left of the forces on its two sides: 1 and 1 without losses.
    pub sides: [f64; 2],
    /// The sense that its forces between teeth are taken with: the sign of the multiplier, or 0 where that decides itself.
    pub sense: f64,
}
