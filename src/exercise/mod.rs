//! The answer key: what a file expects of its own answers.

mod compare;
mod error;
mod expect;
mod undefined;

pub use error::ExpectError;
pub use expect::{Outcome, evaluate};
pub use undefined::why_undefined;
