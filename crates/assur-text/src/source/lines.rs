//! Lines and columns of a text, as editors count them.

use super::Span;
use std::borrow::Cow;
use std::fmt::Write;

/// What a column counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    Utf8,
    /// Units of UTF-16.
    #[default]
    Utf16,
}

/// A place between characters, both from 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct LineColumn {
    pub line: usize,
    pub column: usize,
}

/// Where the lines of a text begin. A line ends with LF, CR LF or CR.
#[derive(Clone, Debug)]
pub struct Lines<'t> {
    text: &'t str,
    starts: Vec<usize>,
}

impl<'t> Lines<'t> {
    /// The lines of a text.
    #[must_use]
    pub fn of(text: &'t str) -> Self {
        let bytes = text.as_bytes();
        let ends = |&i: &usize| bytes[i] == b'\n' || (bytes[i] == b'\r' && bytes.get(i + 1) != Some(&b'\n'));
        let starts = std::iter::once(0).chain((0..bytes.len()).filter(ends).map(|i| i + 1)).collect();
        Self { text, starts }
    }

    /// Line and column of a byte; one within a character is that character's first, one past the end is the end.
    #[must_use]
    pub fn place(&self, byte: usize, encoding: Encoding) -> LineColumn {
        let byte = self.text.floor_char_boundary(byte.min(self.text.len()));
        let line = self.starts.partition_point(|&start| start <= byte) - 1;
        let before = &self.text[self.starts[line]..byte];
        LineColumn { line, column: units(before, encoding) }
    }

    /// The byte of a place; a column past the end of its line is that end. Nothing for a line that there is not, and for a place within a
    /// character.
    #[must_use]
    pub fn byte(&self, place: LineColumn, encoding: Encoding) -> Option<usize> {
        let start = *self.starts.get(place.line)?;
        let end = self.starts.get(place.line + 1).copied().unwrap_or(self.text.len());
        let line = self.text[start..end].trim_end_matches(['\n', '\r']);
        let mut column = 0;
        for (at, c) in line.char_indices() {
            if column >= place.column {
                return (column == place.column).then_some(start + at);
            }
            column += match encoding {
                Encoding::Utf8 => c.len_utf8(),
                Encoding::Utf16 => c.len_utf16(),
            };
        }
        (place.column >= column).then_some(start + line.len())
    }
}

fn units(text: &str, encoding: Encoding) -> usize {
    match encoding {
        Encoding::Utf8 => text.len(),
        Encoding::Utf16 => text.encode_utf16().count(),
    }
}

// Changes of a text.

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

// Texts of others as a reader sees them: nothing in them commands the terminal or turns the line around.

/// Whether a terminal obeys the character instead of showing it: controls, and marks of writing direction.
#[must_use]
pub fn is_obeyed(c: char) -> bool {
    let turns =
        matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns || c.is_control()
}

/// The text with such characters as `\u{1b}`; ends of lines and tabs stay.
#[must_use]
pub fn shown(text: &str) -> Cow<'_, str> {
    escaped(text, |c| is_obeyed(c) && !matches!(c, '\n' | '\t'))
}

/// The same within a line: ends of lines and tabs are escaped too.
#[must_use]
pub fn shown_in_line(text: &str) -> Cow<'_, str> {
    escaped(text, is_obeyed)
}

fn escaped(text: &str, obeyed: impl Fn(char) -> bool) -> Cow<'_, str> {
    let Some(first) = text.find(&obeyed) else { return Cow::Borrowed(text) };
    let mut out = text[..first].to_owned();
    for c in text[first..].chars() {
        if obeyed(c) {
            // writing to a String does not fail
            let _ = write!(out, "{}", c.escape_unicode());
        } else {
            out.push(c);
        }
    }
    Cow::Owned(out)
}
