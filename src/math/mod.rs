//! 2-vectors, the scalar trait and small linear solves with their condition.

mod dense;
mod lanes;
mod rigid;
mod scalar;
mod vec2;

pub use dense::Dense;
pub use lanes::Lanes;
pub use rigid::{acceleration_at, velocity_at};
pub use scalar::{Scalar, Truths};
pub use vec2::{V2, Vec2};
