//! Files and spans in a text.

mod lines;

pub use lines::{Edit, edited};
pub use lines::{Encoding, LineColumn, Lines};
pub use lines::{is_obeyed, shown, shown_in_line};

/// A range of bytes in a source text, end exclusive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

impl Span {
    /// The end of the text, however long it is.
    pub const END: Self = Self::new(usize::MAX, usize::MAX);

    /// The bytes `start..end`.
    #[must_use]
    pub const fn new(start: usize, end: usize) -> Self {
        Self { start, end }
    }

    /// The least span that covers both.
    #[must_use]
    pub fn to(self, other: Self) -> Self {
        Self::new(self.start.min(other.start), self.end.max(other.end))
    }
}

impl From<Span> for miette::SourceSpan {
    fn from(s: Span) -> Self {
        (s.start, s.end.saturating_sub(s.start)).into()
    }
}

/// A value with its span.
#[derive(Clone, Debug, PartialEq)]
pub struct Spanned<T> {
    pub node: T,
    pub span: Span,
}

impl<T> Spanned<T> {
    /// `node` at `span`.
    pub const fn new(node: T, span: Span) -> Self {
        Self { node, span }
    }
}

/// A text with the name it is shown under.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// The file's name as given, `-` for standard input.
    pub name: String,
    pub text: String,
    /// The number of lines before it, if it is a part of a file.
    pub lines_before: usize,
}

impl Source {
    /// A text under a name.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self { name: name.into(), text: text.into(), lines_before: 0 }
    }

    /// A line of a text, counted from 1.
    pub fn line(name: impl Into<String>, text: impl Into<String>, line: usize) -> Self {
        Self { lines_before: line.saturating_sub(1), ..Self::new(name, text) }
    }
}
