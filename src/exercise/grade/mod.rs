//! Given answers held against an answer key.

mod columns;
mod common_mistake;
mod graded;
mod mark;
mod marker;
mod places;
mod regions;
mod rows;
mod rules;
mod sheet;

pub use common_mistake::{CommonMistake, SLIPS};
pub use graded::left_out_words;
pub use graded::{Graded, grade};
pub use mark::{GradedRow, Known, Mark, NotCounted, Part, Sum, Verdict};
pub use regions::{Piece, Region, pieces, regions};
pub use rules::{Credit, Points, Rules, Submissions};
pub use sheet::cut;
pub use sheet::{Entry, NAMES, Quantity, Sheet};
