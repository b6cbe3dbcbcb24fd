//! Unit tests, one module per source file.

mod comma;
mod document;
mod given;
