//! The answer key: what a file expects of its own answers.

mod compare;
mod critical;
mod error;
mod expect;
mod family;
pub mod grade;
mod in_row;
mod own_rows;
pub mod table;
mod undefined;

pub use critical::criticals;
pub use error::ExpectError;
pub use expect::{Outcome, evaluate};
pub use family::Family;
pub use in_row::InRow;
pub use own_rows::{OwnRows, SolvedRow, row_words};
pub use undefined::why_undefined;
