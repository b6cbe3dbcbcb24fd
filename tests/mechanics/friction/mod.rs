//! Friction against independent paths.

mod all_solutions;
pub mod fixed_point;
pub mod pair_friction;
