//! The front door of the library: a text goes in, answers come out by name.

mod answer;
mod diagnostics;
mod problem;
mod solution;

pub use answer::{Answer, Quantity};
pub use diagnostics::Diagnostics;
pub use problem::{Options, Problem, solve};
pub use solution::{Expectation, Pose, Solution};
