//! Unit tests, one module per source file.

mod directions;
