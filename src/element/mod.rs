//! Machine elements: pure mathematics, no names, no spans, no text.

pub mod synthesis;
