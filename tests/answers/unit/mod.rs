//! Unit tests of `src/exercise` and `src/report`, one module per source file.

mod compare;
mod csv;
mod formula;
mod latex;
mod line;
mod markdown;
mod number;
mod symbols;
mod text;
