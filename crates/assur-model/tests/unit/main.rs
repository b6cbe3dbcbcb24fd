//! Unit tests, one module per source file.

mod echelon;
mod field;
mod matching;
