//! Machine elements: pure mathematics, no names, no spans, no text.

pub mod cam;
pub mod gear;
pub mod geneva;
#[doc(hidden)]
pub mod search;
