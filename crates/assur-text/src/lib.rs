//! Words of the language, texts and spans, the problems found in them, units of measurement.

pub mod diagnostic;
pub mod language;
pub mod source;
pub mod units;
