//! `assur`: a small declarative language for planar mechanism problems, and the compiler that solves them.

pub mod force;
pub mod group;
pub mod math;
pub mod source;
