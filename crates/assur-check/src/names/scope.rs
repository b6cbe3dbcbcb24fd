//! What declaring works on.

use crate::names::declared::Names;
use crate::output::builder::Builder;
use crate::output::problems::Problems;
use assur_syntax::document::Document;
use assur_text::diagnostic::Problem;

/// A document, and where its names, its links and what is wrong with them go.
pub struct Scope<'s, 'a> {
    pub doc: &'a Document,
    /// All names declared in the document.
    pub names: &'s mut Names<'a>,
    /// The mechanism that is being made.
    pub builder: &'s mut Builder,
    /// All that was found wrong.
    pub problems: &'s mut Problems,
}

impl Scope<'_, '_> {
    /// Reports an error or a warning.
    pub fn error(&mut self, problem: impl Problem) {
        self.problems.error(problem);
    }
}
