//! Diagnostics for machines.

use super::Problems;
use super::problems::is_error;
use crate::source::Source;
use miette::{Diagnostic, LabeledSpan, Severity};
use serde::Serialize;

/// A diagnostic as it stands in JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DiagnosticView {
    /// `mech::<stage>::<what_is_wrong>`
    #[serde(skip_serializing_if = "Option::is_none")]
    pub code: Option<String>,
    /// `error`, `warning` or `advice`
    pub severity: &'static str,
    pub message: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub help: Option<String>,
    /// The places it is about, the primary one first.
    pub spans: Vec<SpanView>,
}

/// A place in the text with what is said of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SpanView {
    pub file: String,
    pub start: Place,
    /// One past its last.
    pub end: Place,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub label: Option<String>,
}

/// A place between characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Place {
    /// From 1.
    pub line: usize,
    /// From 1, in characters.
    pub column: usize,
    /// From 0.
    pub byte: usize,
}

/// Line and column of a byte; a byte past the end is the end, one within a character is that character's first.
#[must_use]
pub fn place(text: &str, byte: usize) -> Place {
    Places::of(text).of_byte(byte)
}

/// Where the lines of a text begin.
struct Places<'a> {
    text: &'a str,
    starts: Vec<usize>,
}

impl<'a> Places<'a> {
    fn of(text: &'a str) -> Self {
        let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(i, _)| i + 1)).collect();
        Self { text, starts }
    }

    fn of_byte(&self, byte: usize) -> Place {
        let byte = self.text.floor_char_boundary(byte.min(self.text.len()));
        let line = self.starts.partition_point(|&start| start <= byte);
        let before = &self.text[self.starts[line - 1]..byte];
        Place { line, column: before.chars().count() + 1, byte }
    }
}

impl Problems {
    /// All of them as they stand in JSON, sorted by place.
    #[must_use]
    pub fn views(&self, source: &Source) -> Vec<DiagnosticView> {
        let places = Places::of(&source.text);
        self.sorted().into_iter().map(|p| view(p, source, &places)).collect()
    }
}

fn view(problem: &dyn Diagnostic, source: &Source, places: &Places<'_>) -> DiagnosticView {
    let mut labels = problem.labels().map(Iterator::collect::<Vec<_>>).unwrap_or_default();
    labels.sort_by_key(|l| !l.primary());
    DiagnosticView {
        code: problem.code().map(|c| c.to_string()),
        severity: match problem.severity() {
            Some(Severity::Advice) => "advice",
            _ if is_error(problem) => "error",
            _ => "warning",
        },
        message: problem.to_string(),
        help: problem.help().map(|h| h.to_string()),
        spans: labels.iter().map(|l| span_view(l, source, places)).collect(),
    }
}

fn span_view(label: &LabeledSpan, source: &Source, places: &Places<'_>) -> SpanView {
    // the lines of its file that stand before the text
    let in_file = |byte: usize| {
        let place = places.of_byte(byte);
        Place { line: place.line + source.lines_before, ..place }
    };
    SpanView {
        file: source.name.clone(),
        start: in_file(label.offset()),
        end: in_file(label.offset() + label.len()),
        label: label.label().map(str::to_owned),
    }
}
