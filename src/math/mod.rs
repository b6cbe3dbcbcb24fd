//! 2-vectors, the scalar trait, exact ratios and small linear solves with their condition.

mod dense;
pub mod ratio;
mod rigid;
mod scalar;
mod vec2;

pub use dense::Dense;
pub use ratio::Ratio;
pub use rigid::{acceleration_at, velocity_at};
pub use scalar::Scalar;
pub use vec2::{V2, Vec2};
