//! The messages about a text.

use assur_text::diagnostic::{DiagnosticView, Problems, Style, render};
use assur_text::source::Source;
use std::fmt;

/// Errors and warnings about a text, by position in the text. Printed, they look as on the command line, without
/// colour and 100 columns wide.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    views: Vec<DiagnosticView>,
    text: String,
}

impl Diagnostics {
    pub(super) fn of(problems: &Problems, source: &Source) -> Self {
        Self { views: problems.views(source), text: render(problems, source, Style::PLAIN) }
    }

    /// Whether there is nothing to report.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.views.is_empty()
    }

    /// Whether one of them is an error.
    #[must_use]
    pub fn has_errors(&self) -> bool {
        self.views.iter().any(|d| d.severity == "error")
    }

    /// One after another: code, severity, message, spans, help.
    pub fn iter(&self) -> impl Iterator<Item = &DiagnosticView> {
        self.views.iter()
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl std::error::Error for Diagnostics {}
