//! `assur`: a small declarative language for planar mechanism problems, and the compiler that solves them.
//!
//! A text goes in, answers come out by name: [`solve()`]. `docs/library.md` has a page of examples.
//!
//! ```
//! let solution = assur::solve("
//! shaft I { wheel a teeth 20 }
//! shaft O { wheel b teeth 50 }
//! mesh k: a - b
//! drive I at 10 rad/s
//! find omega(O)
//! ")?;
//! assert_eq!(solution.poses()[0]["omega(O)"].number(), Some(-4.0));
//! # Ok::<(), assur::Diagnostics>(())
//! ```

#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod cli;
#[doc(hidden)]
pub mod editor;
#[doc(hidden)]
pub mod exercise;
mod front;
#[doc(hidden)]
pub mod handout;
#[cfg(feature = "lsp")]
#[doc(hidden)]
pub mod lsp;
#[doc(hidden)]
pub mod pipeline;
#[doc(hidden)]
pub mod report;

pub use front::{
    Alone, Answer, Cells, Checked, Column, Columns, ColumnsError, Diagnostics, DrawError, Drive,
    DrivePositions, Expectation, GivenPositions, GradeError, Marking, Options, Pose, PoseFailure,
    PositionsError, Problem, Quantity, Residuals, RowAnswers, RowField, RowLayout, Rows, Solution, Texts,
    Values, Workers, WrittenUnit, explain, format, grade, solve,
};

/// The floors below the front door, for the program, the benchmarks and the tests. They change without notice.
#[doc(hidden)]
pub mod internals {
    #[cfg(feature = "cli")]
    pub use crate::cli;
    #[cfg(feature = "lsp")]
    pub use crate::lsp;
    pub use crate::pipeline::{
        Compiled, Origin, Solved, check_source, compile, diagnose, solve_each, solve_source, solve_within,
        test_source,
    };
    pub use crate::{editor, exercise, handout, pipeline, report};
    pub use assur_check as check;
    pub use assur_drawing as drawing;
    pub use assur_format as format;
    pub use assur_math::{element, force, group, math};
    pub use assur_model::{model, structure};
    pub use assur_picture as picture;
    pub use assur_position::{plan, position};
    pub use assur_solve::{answer, measure, measure::accuracy, message, reference, solve};
    pub use assur_syntax as syntax;
    pub use assur_text::{diagnostic, language, source, units};
    pub use assur_worked as worked;
}

// the examples of the page run as tests
#[cfg(doctest)]
#[doc = include_str!("../docs/library.md")]
struct LibraryPage;
