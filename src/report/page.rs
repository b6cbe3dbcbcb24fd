//! A report in one of several forms.

use super::document::Report;
use super::text::Look;
use super::{latex, markdown, sections, text};

/// The form of a page.
#[derive(Clone, Copy, Debug)]
pub enum Page {
    /// Tables to read on a screen.
    Text(Look),
    /// One object, on a line of its own.
    Json,
    /// Comma-separated values, table below table.
    Csv,
    Markdown,
    /// Sections and tables of a LaTeX document, for `\input`.
    Latex,
}

impl Page {
    /// The report in this form.
    #[must_use]
    pub fn render(self, report: &Report) -> String {
        match self {
            Self::Text(look) => text::render(report, look),
            Self::Json => sections::json(report),
            Self::Csv => sections::csv(report),
            Self::Markdown => markdown::render(report),
            Self::Latex => latex::render(report),
        }
    }
}
