//! Friction against independent paths.

mod all_solutions;
mod fixed_point;
mod pair_friction;
