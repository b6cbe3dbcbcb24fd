//! Unit tests, one module per source file.

mod overrides;
mod tolerance;
