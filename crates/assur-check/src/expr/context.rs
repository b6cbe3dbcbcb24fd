//! What the parts of the stage share: the document, the names, the mechanism under construction, the problems.

use crate::links::hinges::Hinges;
use crate::names::declare::Names;
use crate::trains::gear::Gears;
use crate::trains::size::Sizes;
use crate::values::definition::Definitions;
use crate::values::overrides::Overrides;
use crate::values::row::Row;
use crate::values::unit_choice;
use crate::values::unit_choice::UnitUse;
use assur_model::model::{Mechanism, Unsupported};
use assur_syntax::document::Document;
use assur_text::diagnostic::Problems;
use assur_text::source::Span;
use indexmap::IndexSet;
use miette::Diagnostic;

/// The state of the stage.
pub struct Context<'a> {
    /// What is checked.
    pub doc: &'a Document,
    /// Values from outside.
    pub overrides: &'a Overrides,
    /// The row of variants that is checked.
    pub row: Row,
    /// A `given` with the SI value it has instead of any other.
    pub fixed: Option<(&'a str, f64)>,
    /// All that was found wrong.
    pub problems: Problems,
    /// The mechanism so far. `names::declare` enters every link (name, number, span; ground first), so that link ids are
    /// known from the start. All other tables are filled in the order of the file; what has an error is left out.
    pub mech: Mechanism,
    /// All names declared in the document.
    pub names: Names<'a>,
    /// Where the hinges stand.
    pub(crate) hinges: Hinges,
    /// The units of the document's numbers, and how often each is used.
    pub(crate) units: UnitUse,
    /// What `given`, `let` and `find NAME =` are.
    pub(crate) definitions: Definitions,
    /// The sizes of wheels.
    pub(crate) sizes: Sizes<'a>,
    /// A wheel whose size is left open, of which another is assumed than usual.
    pub stretched: Option<&'a str>,
    /// The gear pairs whose geometry was asked for.
    pub(crate) gears: Gears,
    /// Names reported as unknown already, with the list they were looked for in.
    pub(crate) reported: IndexSet<(&'static str, String)>,
}

impl<'a> Context<'a> {
    /// The state at the start.
    pub fn new(doc: &'a Document, overrides: &'a Overrides) -> Self {
        Self::with_units(doc, overrides, unit_choice::count(doc))
    }

    /// As [`Context::new`], where the units are counted already.
    pub(crate) fn with_units(doc: &'a Document, overrides: &'a Overrides, units: UnitUse) -> Self {
        Self {
            doc,
            overrides,
            row: overrides.row.clone(),
            fixed: None,
            problems: Problems::new(),
            mech: Mechanism::default(),
            names: Names::default(),
            hinges: Hinges::default(),
            units,
            definitions: Definitions::default(),
            sizes: Sizes::default(),
            stretched: None,
            gears: Gears::new(),
            reported: IndexSet::new(),
        }
    }

    /// Reports an error or a warning.
    pub fn error(&mut self, problem: impl Diagnostic + Send + Sync + 'static) {
        self.problems.push(problem);
    }

    /// What `look` finds, with nothing reported.
    pub(crate) fn quietly<T>(&mut self, look: impl FnOnce(&mut Self) -> T) -> T {
        let problems = std::mem::take(&mut self.problems);
        let reported = self.reported.clone();
        let found = look(self);
        (self.problems, self.reported) = (problems, reported);
        found
    }

    /// Notes a construct that is understood but cannot be solved yet.
    pub fn unsupported(&mut self, what: impl Into<String>, span: Span) {
        let noted = Unsupported { what: what.into(), span };
        let again = self.mech.unsupported.iter().any(|u| u.span == span && u.what == noted.what);
        if !again {
            self.mech.unsupported.push(noted);
        }
    }

    /// The mechanism, if nothing is wrong with it, and all that was found.
    pub fn finish(mut self) -> (Option<Mechanism>, Problems) {
        self.mech.displays = self.displays();
        let fine = !self.problems.has_errors();
        (fine.then_some(self.mech), self.problems)
    }
}
