//! What a reader sees.

use super::Problems;
use crate::source::Source;
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError};
use miette::{MietteSpanContents, NarratableReportHandler, ReportHandler, Severity, SourceCode};
use miette::{SourceSpan, SpanContents};
use std::fmt::{self, Display, Write};

/// How diagnostics are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// With the lines of the text and marks below them.
    Graphical {
        /// With colours.
        colour: bool,
        /// Columns to fill.
        width: usize,
    },
    /// In words alone, for screen readers.
    Narrated,
}

impl Style {
    /// What tests compare: no colour, 100 columns.
    pub const PLAIN: Self = Self::Graphical { colour: false, width: 100 };
}

/// All problems of a text, sorted by place, one below the other.
#[must_use]
pub fn render(problems: &Problems, source: &Source, style: Style) -> String {
    if problems.is_empty() {
        return String::new();
    }
    let text = Text { text: showable(&source.text), source };
    let mut out = String::new();
    for problem in problems.sorted() {
        if !out.is_empty() {
            out.push('\n');
        }
        let shown = Shown { problem: Located { inner: problem, source: &text }, style };
        // Writing to a String fails only if a diagnostic's own Display does.
        if write!(out, "{shown}").is_err() {
            out.push_str(&problem.to_string());
        }
        if !out.ends_with('\n') {
            out.push('\n');
        }
    }
    out
}

/// The text with the same length and lines, without what would disturb a terminal.
fn showable(text: &str) -> String {
    let mut chars = text.chars().peekable();
    let mut shown = String::with_capacity(text.len());
    while let Some(c) = chars.next() {
        match c {
            '\r' if chars.peek() != Some(&'\n') => shown.push('\n'),
            c if c.is_control() && !matches!(c, '\n' | '\r' | '\t') => {
                shown.extend(std::iter::repeat_n(' ', c.len_utf8()));
            }
            c => shown.push(c),
        }
    }
    shown
}

struct Shown<'a> {
    problem: Located<'a>,
    style: Style,
}

impl fmt::Debug for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.style {
            Style::Graphical { colour, width } => {
                let theme =
                    if colour { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
                GraphicalReportHandler::new_themed(theme)
                    .with_width(width)
                    .with_links(false)
                    .debug(&self.problem, f)
            }
            Style::Narrated => NarratableReportHandler::new().debug(&self.problem, f),
        }
    }
}

impl Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, f)
    }
}

/// A diagnostic with the text it speaks of.
struct Located<'a> {
    inner: &'a (dyn Diagnostic + Send + Sync + 'static),
    source: &'a Text<'a>,
}

/// A text under its name, with the lines counted from the beginning of its file.
struct Text<'a> {
    text: String,
    source: &'a Source,
}

impl SourceCode for Text<'_> {
    fn read_span<'b>(
        &'b self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'b> + 'b>, MietteError> {
        let inner = self.text.read_span(span, before, after)?;
        Ok(Box::new(MietteSpanContents::new_named(
            self.source.name.clone(),
            inner.data(),
            *inner.span(),
            inner.line() + self.source.lines_before,
            inner.column(),
            inner.line_count(),
        )))
    }
}

impl fmt::Debug for Located<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self.inner, f)
    }
}

impl Display for Located<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Display::fmt(self.inner, f)
    }
}

impl std::error::Error for Located<'_> {}

impl Diagnostic for Located<'_> {
    fn code<'b>(&'b self) -> Option<Box<dyn Display + 'b>> {
        self.inner.code()
    }

    fn severity(&self) -> Option<Severity> {
        self.inner.severity()
    }

    fn help<'b>(&'b self) -> Option<Box<dyn Display + 'b>> {
        self.inner.help()
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        self.inner.labels()
    }

    fn related<'b>(&'b self) -> Option<Box<dyn Iterator<Item = &'b dyn Diagnostic> + 'b>> {
        self.inner.related()
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(self.source)
    }
}
