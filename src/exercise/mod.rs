//! The answer key: the expectations of a file.

#[doc(hidden)]
pub mod compare;
mod error;
mod expect;
mod for_row;
pub mod grade;
mod mismatch;
pub mod table;
mod undefined;

pub use error::ExpectError;
pub use expect::{Outcome, evaluate};
pub use for_row::ForRow;
pub use mismatch::{in_one, mismatches};
pub use undefined::why_undefined;
