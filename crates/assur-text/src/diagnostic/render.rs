//! Rendering of diagnostics.

use super::excerpt::{Excerpt, Lines};
use super::problems::is_error;
use super::{Problem, Problems};
use crate::source::{Source, shown};
use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, NarratableReportHandler, ReportHandler,
    Severity, SourceCode,
};
use std::fmt::{self, Display, Write};

/// How diagnostics are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// With the lines of the text and marks below them.
    Graphical { colour: bool, width: usize },
    /// In words alone, for screen readers.
    Narrated,
}

impl Style {
    /// For tests: no colour, 100 columns.
    pub const PLAIN: Self = Self::Graphical { colour: false, width: 100 };
}

/// All problems of a text, sorted by place, one below the other.
#[must_use]
pub fn render(problems: &Problems, source: &Source, style: Style) -> String {
    render_most(problems, source, style, usize::MAX)
}

/// As [`render`], but no more than `most`: errors before what is none. A last line counts the others.
#[must_use]
pub fn render_most(problems: &Problems, source: &Source, style: Style, most: usize) -> String {
    if problems.is_empty() {
        return String::new();
    }
    let lines = Lines::of_text(&source.text);
    let mut out = String::new();
    let chosen = chosen(problems, most);
    let more = problems.len() - chosen.len();
    for problem in chosen {
        if !out.is_empty() {
            out.push('\n');
        }
        let labels = problem.labels().map(Iterator::collect).unwrap_or_default();
        let (excerpt, labels) = Excerpt::of(source, &lines, labels);
        let drawn = Rendered { problem: Located { inner: problem, labels, excerpt }, style };
        // Writing to a String fails only if a diagnostic's own Display does.
        if write!(out, "{drawn}").is_err() {
            out.push_str(&shown(&problem.to_string()));
        }
        if !out.ends_with('\n') {
            out.push('\n');
        }
    }
    if more > 0 {
        out += &format!("\nand {} more\n", grouped(more));
    }
    out
}

/// The problems that are drawn, by place.
fn chosen(problems: &Problems, most: usize) -> Vec<&dyn Problem> {
    let mut all = problems.sorted();
    let kept = all.iter().filter(|p| is_error(**p)).count().min(most);
    let (mut errors, mut others) = (kept, most - kept);
    all.retain(|problem| {
        let left = if is_error(*problem) { &mut errors } else { &mut others };
        let taken = *left > 0;
        *left -= usize::from(taken);
        taken
    });
    all
}

/// `7,950`
fn grouped(n: usize) -> String {
    let digits = n.to_string();
    let parts: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().filter_map(|c| str::from_utf8(c).ok()).collect();
    parts.join(",")
}

struct Rendered<'a> {
    problem: Located<'a>,
    style: Style,
}

impl fmt::Debug for Rendered<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.style {
            Style::Graphical { colour, width } => {
                let theme =
                    if colour { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
                GraphicalReportHandler::new_themed(theme)
                    .with_width(width)
                    .with_links(false)
                    // no name, number or unit is broken
                    .with_break_words(false)
                    .with_word_separator(textwrap::WordSeparator::AsciiSpace)
                    .with_word_splitter(textwrap::WordSplitter::NoHyphenation)
                    .debug(&self.problem, f)
            }
            Style::Narrated => NarratableReportHandler::new().debug(&self.problem, f),
        }
    }
}

impl Display for Rendered<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, f)
    }
}

/// A diagnostic with the lines it speaks of. What comes from the text is shown without commands to the terminal.
struct Located<'a> {
    inner: &'a dyn Problem,
    labels: Vec<LabeledSpan>,
    excerpt: Excerpt,
}

impl fmt::Debug for Located<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self.inner, f)
    }
}

impl Display for Located<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&shown(&self.inner.to_string()))
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
        let help = self.inner.help()?.to_string();
        Some(Box::new(shown(&help).into_owned()))
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        (!self.labels.is_empty()).then(|| Box::new(self.labels.iter().cloned()) as _)
    }

    fn related<'b>(&'b self) -> Option<Box<dyn Iterator<Item = &'b dyn Diagnostic> + 'b>> {
        self.inner.related()
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(&self.excerpt)
    }
}
