//! Unit tests: the rules of the style one by one, and what holds for every text.

mod every_text;
mod mutants;
mod rules;
#[path = "../../../../tests/share/mod.rs"]
mod share;
mod texts;
