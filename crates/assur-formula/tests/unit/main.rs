//! Formulas: what is left out, brackets, digits, formats.

mod digits;
mod lay;
mod operators;
mod print;
