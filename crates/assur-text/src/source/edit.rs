//! Changes of a text.

use super::Span;

/// A part of a text and what is to be in its place.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Edit {
    /// The part; empty where something is added.
    pub span: Span,
    pub with: String,
}

impl Edit {
    /// `with` in the place of what is at `span`.
    pub fn new(span: Span, with: impl Into<String>) -> Self {
        Self { span, with: with.into() }
    }
}

/// A text with edits made, which are in order and do not overlap; one that does not fit the text is left out.
#[must_use]
pub fn edited(text: &str, edits: &[Edit]) -> String {
    let mut out = String::with_capacity(text.len());
    let mut from = 0;
    for edit in edits {
        let at = if edit.span == Span::END { Span::new(text.len(), text.len()) } else { edit.span };
        let fits = text.is_char_boundary(at.end) && at.start <= at.end;
        let Some(kept) = text.get(from..at.start).filter(|_| fits) else { continue };
        out.push_str(kept);
        out.push_str(&edit.with);
        from = at.end;
    }
    out.push_str(&text[from..]);
    out
}
