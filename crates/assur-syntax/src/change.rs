//! Characters that were replaced to make a text readable.

use assur_text::source::Span;

/// A replacement that is reported.
pub struct Change {
    pub span: Span,
    pub kind: Kind,
    pub with: &'static str,
}

#[derive(Clone, Copy, PartialEq)]
pub enum Kind {
    FullWidth,
    Quote,
    Sign,
    Invisible,
}
