//! `assur`: a small declarative language for planar mechanism problems, and the compiler that solves them.

pub mod check;
pub mod diagnostic;
pub mod math;
pub mod model;
pub mod source;
pub mod syntax;
pub mod units;
