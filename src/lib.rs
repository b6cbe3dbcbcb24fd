//! `assur`: a small declarative language for planar mechanism problems, and the compiler that solves them.

#[cfg(feature = "cli")]
pub mod cli;
pub mod exercise;
mod front;
pub mod pipeline;
pub mod report;

pub use assur_check as check;
pub use assur_math::{element, force, group, math};
pub use assur_model::{model, structure};
pub use assur_solve::{answer, measure, message, plan, position, reference, solve};
pub use assur_syntax as syntax;
pub use assur_text::{diagnostic, language, source, units};
pub use measure::accuracy;

pub use front::{Answer, Diagnostics, Expectation, Options, Pose, Problem, Quantity, Solution, solve};
pub use pipeline::{
    Compiled, Origin, Solved, check_source, compile, diagnose, solve_each, solve_source, solve_within,
    test_source,
};

// the examples of the page run as tests
#[cfg(doctest)]
#[doc = include_str!("../docs/library.md")]
struct LibraryPage;
