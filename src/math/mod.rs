//! 2-vectors, the scalar trait and small linear solves with their condition.

mod scalar;
mod vec2;

pub use scalar::Scalar;
pub use vec2::{V2, Vec2};
