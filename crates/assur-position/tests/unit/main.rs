//! Unit tests, one module per source file.

#[cfg(feature = "lanes")]
mod lanes;
