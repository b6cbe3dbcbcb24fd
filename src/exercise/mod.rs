//! The answer key: the expectations of a file.

mod error;
pub mod expect;
pub mod grade;
mod mismatch;
pub mod table;
pub mod turns;
mod undefined;

pub use error::ExpectError;
pub use expect::{Outcome, evaluate};
pub use mismatch::{in_one, mismatches};
pub use undefined::why_undefined;
