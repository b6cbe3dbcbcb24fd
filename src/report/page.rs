//! A report written for people, in one of several forms.

use super::document::Report;
use super::text::Look;
use super::{latex, markdown, text};

/// The form of a page.
#[derive(Clone, Copy, Debug)]
pub enum Page {
    /// Tables to read on a screen.
    Text(Look),
    /// GitHub's Markdown.
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
            Self::Markdown => markdown::render(report),
            Self::Latex => latex::render(report),
        }
    }
}
