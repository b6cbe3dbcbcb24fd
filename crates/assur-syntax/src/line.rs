//! Lines of the text, and help that replaces a part of them.

use assur_text::diagnostic::Help;
use assur_text::source::{Edit, Span};

/// The line, or lines, around a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
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

/// `write: …`: the lines of a place with it replaced.
pub(super) fn corrected(text: &str, at: Span, with: &str) -> Help {
    let there = text.get(at.start..at.end).unwrap_or_default();
    let before = length_alike(there.chars(), with.chars());
    let (there, with) = (&there[before..], &with[before..]);
    let behind = length_alike(there.chars().rev(), with.chars().rev());
    let removed = &there[..there.len() - behind];
    let start = at.start + before;
    let edit = Edit::new(Span::new(start, start + removed.len()), &with[..with.len() - behind]);
    let help = Help::lines(text, at, vec![edit]);
    // a comment that stood there would be lost
    if removed.contains("//") && !with.contains("//") { help.to_string().into() } else { help }
}

/// The bytes that two texts have alike from their beginning.
fn length_alike(a: impl Iterator<Item = char>, b: impl Iterator<Item = char>) -> usize {
    a.zip(b).take_while(|(a, b)| a == b).map(|(a, _)| a.len_utf8()).sum()
}
