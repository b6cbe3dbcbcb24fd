//! Lines of the text, and lines with a part of them replaced.

use assur_text::source::Span;

/// The line, or lines, around a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    /// Its first byte.
    pub(super) start: usize,
    /// Its end, without the line end.
    pub(super) end: usize,
}

impl Line {
    /// The line that holds a byte.
    pub(super) fn around(text: &str, at: usize) -> Self {
        let is_end = |b: &u8| matches!(b, b'\n' | b'\r');
        let bytes = text.as_bytes();
        let at = at.min(bytes.len());
        let start = bytes[..at].iter().rposition(&is_end).map_or(0, |i| i + 1);
        let end = bytes[at..].iter().position(is_end).map_or(bytes.len(), |i| at + i);
        Self { start, end }
    }
}

/// The lines of a span with the span replaced, without the blanks around them.
pub(super) fn mended(text: &str, span: Span, with: &str) -> String {
    let start = Line::around(text, span.start).start;
    let end = Line::around(text, span.end).end;
    let before = text.get(start..span.start).unwrap_or_default();
    let after = text.get(span.end..end).unwrap_or_default();
    format!("{before}{with}{after}").trim().to_owned()
}
