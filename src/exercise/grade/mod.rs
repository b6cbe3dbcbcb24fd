//! Given answers held against an answer key.

mod columns;
mod entry;
mod graded;
mod mark;
mod marker;
mod owed;
mod row_names;
mod rows;
mod rules;
mod sheet;
mod slip;
mod warning;

pub use graded::{Graded, grade};
pub use mark::{GradedRow, Known, Mark, NotCounted, Part, Sum, Verdict};
pub use row_names::cut;
pub use rules::{Credit, Points, Rules, Submissions};
pub use sheet::{NAMES, Quantity, Sheet};
pub use slip::{SLIPS, Slip};
pub use warning::LeftOut;
