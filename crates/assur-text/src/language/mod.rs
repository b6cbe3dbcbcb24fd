//! The words of the language as data: what the checker, suggestions, completions and the reference read.

mod codes;
mod dimension;
mod units;

pub use codes::{CODES, Code, explain};
pub use dimension::{Dimension, Kind};
pub use units::{Symbol, UNITS, symbol};
