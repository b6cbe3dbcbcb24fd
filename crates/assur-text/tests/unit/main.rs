//! Unit tests, one module per source file or folder.

mod diagnostic;
mod number;
mod shown;
mod units;
