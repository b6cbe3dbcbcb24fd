//! Changes that are offered at a place, beside those that mend a problem.

mod declare;
mod rewrite;

use super::{Analysis, Results};
use assur_text::source::{Edit, Source, Span, edited};

/// What a change is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChangeKind {
    /// A name is declared.
    Declare,
    /// A number becomes a `given`.
    Extract,
    /// Other words for the same, or an answer as an `expect`.
    Rewrite,
}

/// A change that is offered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    pub title: String,
    pub edits: Vec<Edit>,
    /// What it is for.
    pub kind: ChangeKind,
}

impl Analysis {
    /// The changes that are offered at a place; each leaves the text with no error that is new.
    #[must_use]
    pub fn changes_at(&self, at: Span, results: Option<&Results>) -> Vec<Change> {
        let mut found = self.declarations(at);
        found.extend(self.number_as_given(at.start));
        found.extend(self.points_written_out(at));
        found.extend(self.other_units(at.start));
        found.extend(results.map(|results| self.answers_as_keys(at, results)).unwrap_or_default());
        found
    }

    fn line_start(&self, byte: usize) -> usize {
        let before = self.source.text.get(..byte).unwrap_or_default();
        before.rfind('\n').map_or(0, |newline| newline + 1)
    }

    fn errors(&self) -> usize {
        self.problems.errors()
    }

    /// How many errors the text has with edits made.
    fn errors_with(&self, edits: &[Edit]) -> usize {
        let text = edited(&self.source.text, edits);
        Self::of(Source::new(self.source.name.as_str(), text)).errors()
    }
}
