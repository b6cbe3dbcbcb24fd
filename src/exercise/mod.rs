//! The answer key: what a file expects of its own answers.

mod compare;
mod critical;
mod error;
mod expect;
mod undefined;

pub use critical::criticals;
pub use error::ExpectError;
pub use expect::{Outcome, evaluate};
pub use undefined::why_undefined;
