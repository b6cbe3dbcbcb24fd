//! What expressions are read in: the document, its names and values, what is made of them, and what is wrong.

use crate::expr::results::Results;
use crate::names::declared::Names;
use crate::output::builder::Builder;
use crate::output::problems::Problems;
use crate::values::store::Values;
use assur_model::model::Mechanism;
use assur_syntax::document::Document;
use assur_text::diagnostic::{self, Problem};

/// The parts of the stage, for what needs more than one of them.
pub struct Context<'a> {
    pub doc: &'a Document,
    /// All names declared in the document.
    pub names: Names<'a>,
    /// Definitions and what they come to.
    pub values: Values<'a>,
    /// The mechanism that is being made.
    pub builder: Builder,
    /// All that was found wrong.
    pub problems: Problems,
    /// The functions of results.
    pub results: Results,
}

impl<'a> Context<'a> {
    /// The state at the start.
    pub fn new(doc: &'a Document, values: Values<'a>, results: Results) -> Self {
        let (names, builder, problems) = (Names::default(), Builder::default(), Problems::default());
        Self { doc, names, values, builder, problems, results }
    }

    /// Reports an error or a warning.
    pub fn error(&mut self, problem: impl Problem) {
        self.problems.error(problem);
    }

    /// What `look` finds, with nothing reported.
    pub fn quietly<T>(&mut self, look: impl FnOnce(&mut Self) -> T) -> T {
        let (before, uses) = (self.problems.start_trial(), self.names.uses.len());
        let found = look(self);
        self.problems = before;
        self.names.uses.truncate(uses);
        found
    }

    /// The mechanism, if nothing is wrong with it, and all that was found.
    pub fn finish(mut self) -> (Option<Mechanism>, diagnostic::Problems) {
        self.builder.mech.displays = self.values.displays();
        let fine = !self.problems.has_errors();
        (fine.then_some(self.builder.mech), self.problems.into_found())
    }
}
