//! The front door of the library: a text goes in, answers come out by name.

#![warn(missing_docs)]

mod again;
mod answer;
mod cells;
mod checked;
mod columns;
mod diagnostics;
mod document;
mod drawn;
mod filling;
mod graded;
mod positions;
mod problem;
mod queues;
mod row_answers;
mod rows;
mod side_by_side;
mod solution;
pub(crate) mod stages;
mod workers;

pub use answer::{Answer, Quantity};
pub use cells::Cells;
#[cfg(feature = "arrow")]
pub(crate) use cells::header_line;
#[cfg(feature = "cli")]
pub(crate) use cells::{Missing, digits_count, read_row};
pub use checked::{Checked, ColumnsError};
pub use columns::{Column, Columns, PoseFailure, Residuals, Values, WrittenUnit};
pub use diagnostics::Diagnostics;
pub use document::{explain, format};
pub use drawn::DrawError;
pub use graded::{GradeError, Marking, grade};
pub use positions::{Drive, DrivePositions, GivenPositions, PositionsError};
pub use problem::{Options, Problem, solve};
#[cfg(feature = "cli")]
pub(crate) use row_answers::Line;
pub use row_answers::{RowAnswers, Texts};
pub use rows::{RowField, RowLayout, Rows};
pub use solution::{Expectation, Pose, Solution};
pub use workers::{Alone, Workers};
