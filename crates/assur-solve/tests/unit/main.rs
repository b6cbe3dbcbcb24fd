//! Unit tests, one module per source file.

mod columns;
