//! The front door of the library: a text goes in, answers come out by name.

mod again;
mod answer;
mod checked;
mod columns;
mod diagnostics;
mod document;
mod drawn;
mod graded;
mod positions;
mod problem;
mod row_answers;
mod rows;
mod solution;
mod workers;

pub use answer::{Answer, Quantity};
pub use checked::{Checked, ColumnsError};
pub use columns::{Column, Columns, PoseFailure, Residuals, WrittenUnit};
pub use diagnostics::Diagnostics;
pub use document::{explain, format};
pub use drawn::DrawError;
pub use graded::{GradeError, Marking, grade};
pub use positions::{Drive, DrivePositions, GivenPositions, PositionsError};
pub use problem::{Options, Problem, solve};
pub use row_answers::RowAnswers;
pub use rows::{Cells, RowField, RowLayout, Rows};
pub use solution::{Expectation, Pose, Solution};
pub use workers::{Alone, Workers};
