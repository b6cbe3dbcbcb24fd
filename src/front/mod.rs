//! The front door of the library: a text goes in, answers come out by name.

#![warn(missing_docs)]

mod checked;
mod columns;
mod drawn;
mod filling;
mod graded;
pub(crate) mod in_order;
mod positions;
mod problem;
mod row_answers;
mod rows;
mod solution;
mod workers;

pub use checked::{Checked, ColumnsError};
pub use columns::{Column, Columns, PoseFailure, Residuals, Values, WrittenUnit};
pub use drawn::DrawError;
pub use graded::{GradeError, Marking, grade};
pub use positions::{Drive, DrivePositions, GivenPositions, PositionsError};
pub use problem::{Options, Problem, solve};
pub use problem::{explain, format};
pub use row_answers::Cells;
#[cfg(feature = "cli")]
pub(crate) use row_answers::Line;
#[cfg(feature = "arrow")]
pub(crate) use row_answers::header_line;
#[cfg(feature = "cli")]
pub(crate) use row_answers::{Missing, digits_count, read_row};
pub use row_answers::{RowAnswers, Texts};
pub use rows::{RowField, RowLayout, Rows};
pub use solution::Diagnostics;
pub use solution::{Answer, Quantity};
pub use solution::{Expectation, Pose, Solution};
pub use workers::{Alone, Workers};
