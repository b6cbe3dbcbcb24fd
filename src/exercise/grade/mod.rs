//! Given answers held against an answer key.

mod columns;
mod entry;
mod graded;
mod mark;
mod marker;
mod owed;
mod rows;
mod rules;
mod sheet;
mod slip;
mod warning;

pub use graded::{Graded, grade};
pub use mark::{GradedRow, Mark, NotCounted, Part, Sum, Verdict};
pub use rules::{Credit, Points, Rules, Submissions};
pub use sheet::{NAMES, Quantity, Sheet, SheetRow};
pub use slip::{SLIPS, Slip};
pub use warning::LeftOut;
