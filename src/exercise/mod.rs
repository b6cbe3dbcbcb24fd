//! The answer key: what a file expects of its own answers.

#[doc(hidden)]
pub mod compare;
mod critical;
mod error;
mod expect;
mod family;
mod followed;
pub mod grade;
mod in_row;
mod mismatch;
mod other_assembly;
mod own_rows;
mod scales;
pub mod table;
mod undefined;

pub use critical::criticals;
pub use error::ExpectError;
pub use expect::{Outcome, evaluate};
pub use family::Family;
pub use followed::{Each, Followed, SizeError, followed, is_long, most_positions};
pub use in_row::InRow;
pub use mismatch::{in_one, mismatches};
pub use other_assembly::in_other_assembly;
pub use own_rows::{OwnRows, SolvedRow, file_row_words, row_words};
pub use scales::{ScaleError, scales};
pub use undefined::why_undefined;
