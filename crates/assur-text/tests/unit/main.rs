//! Unit tests, one module per source file or folder.

mod diagnostic;
mod lines;
mod number;
mod shown;
mod template;
mod units;
