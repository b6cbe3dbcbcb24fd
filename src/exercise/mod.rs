//! The answer key: what a file expects of its own answers.

mod compare;
mod critical;
mod error;
mod expect;
mod family;
mod in_row;
pub mod table;
mod undefined;

pub use critical::criticals;
pub use error::ExpectError;
pub use expect::{Outcome, evaluate};
pub use family::Family;
pub use in_row::InRow;
pub use undefined::why_undefined;
