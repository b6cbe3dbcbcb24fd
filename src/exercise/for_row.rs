//! Messages about a file with a row of variants.

use assur_text::diagnostic::{AnyDiagnostic, Problem, Problems};
use assur_text::source::Span;
use miette::{Diagnostic, LabeledSpan, Severity};
use std::fmt::{self, Display};

/// A diagnostic of a file, with the row of variants for which it holds.
#[derive(Debug)]
pub struct ForRow {
    inner: AnyDiagnostic,
    row: String,
    span: Option<Span>,
}

impl ForRow {
    /// All problems of a row: `row` is it in words, `span` its place in the file's own table.
    #[must_use]
    pub fn all(problems: Problems, row: &str, span: Option<Span>) -> Problems {
        let mut all = Problems::new();
        all.extend(problems.into_iter().map(|inner| Self { inner, row: row.to_owned(), span }));
        all
    }
}

impl Display for ForRow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.row, self.inner)
    }
}

impl std::error::Error for ForRow {}

impl Problem for ForRow {}

impl Diagnostic for ForRow {
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
        let label = |s: Span| LabeledSpan::at(s.start..s.end, "with this row");
        let own = self.inner.labels().into_iter().flatten();
        Some(Box::new(own.chain(self.span.map(label))))
    }

    fn related<'b>(&'b self) -> Option<Box<dyn Iterator<Item = &'b dyn Diagnostic> + 'b>> {
        self.inner.related()
    }
}
