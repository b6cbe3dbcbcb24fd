//! Texts and spans, the problems found in them, units of measurement.

pub mod diagnostic;
pub mod source;
pub mod units;
