//! Unit tests, one module per source file.

mod directions;
#[cfg(feature = "lanes")]
mod lanes;
