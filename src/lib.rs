//! `assur`: a small declarative language for planar mechanism problems, and the compiler that solves them.

pub mod diagnostic;
pub mod force;
pub mod group;
pub mod math;
pub mod model;
pub mod plan;
pub mod solve;
pub mod source;
pub mod structure;
pub mod syntax;
pub mod units;
