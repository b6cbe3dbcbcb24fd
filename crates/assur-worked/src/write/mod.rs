//! Documents in their formats.

mod html;
mod markdown;
mod plain;
mod typst;

pub use html::{html, html_of_several};
pub use markdown::markdown;
pub use plain::text;
pub use typst::{escaped as typst_escaped, typst};
