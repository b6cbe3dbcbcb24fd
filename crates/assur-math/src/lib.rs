//! Pure mathematics of mechanisms: vectors and scalars, machine elements, structural groups, forces.

pub mod element;
pub mod force;
pub mod group;
pub mod math;
