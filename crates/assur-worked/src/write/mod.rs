//! Documents in their formats.

mod fragment;
mod html;
mod markdown;
mod plain;
mod typst;

pub use fragment::{PicturePlace, fragment, inline};
pub use html::{html, html_of_several};
pub use markdown::markdown;
pub use plain::text;
pub use typst::{escaped as typst_escaped, typst};
