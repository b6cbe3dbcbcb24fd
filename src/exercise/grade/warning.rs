//! What is left out of the marking, as a warning.

use crate::exercise::table::TableError;
use assur_text::diagnostic::Problem;
use miette::{Diagnostic, LabeledSpan, Severity};
use std::fmt::{self, Display};

/// An error of one column or line of answers, the rest of which is marked.
#[derive(Clone, Debug)]
pub struct LeftOut(pub TableError);

impl LeftOut {
    /// Whether it is a column, not a line.
    #[must_use]
    pub const fn is_column(error: &TableError) -> bool {
        matches!(error, TableError::Header { .. } | TableError::UnknownColumn { .. })
    }

    /// What is wrong, with the line: `line 7: the key has no row 99`.
    #[must_use]
    pub fn words(error: &TableError) -> String {
        match error {
            TableError::UnknownColumn { .. } => format!("header: {error}"),
            _ => error.to_string(),
        }
    }
}

impl Display for LeftOut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl std::error::Error for LeftOut {}

impl Problem for LeftOut {}

impl Diagnostic for LeftOut {
    fn code<'b>(&'b self) -> Option<Box<dyn Display + 'b>> {
        self.0.code()
    }

    fn severity(&self) -> Option<Severity> {
        Some(Severity::Warning)
    }

    fn help<'b>(&'b self) -> Option<Box<dyn Display + 'b>> {
        self.0.help()
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        self.0.labels()
    }
}
