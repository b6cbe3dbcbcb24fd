//! A document that is checked again and again, with one row of variants after another.
//!
//! Names, the order of the definitions and the units of the file depend on no value: they are found once. All else is
//! checked by the same code as ever, so that a row comes out as the file with these values would.

use crate::expr::context::Context;
use crate::names::declared::Names;
use crate::requests::query::RESULTS;
use crate::row_patch::RowPatches;
use crate::values::{
    definition::Definitions,
    row::Row,
    store::{Overrides, Values},
    unit_use::{self, UnitUse},
};
use crate::{definitions, meaning};
use assur_model::model::{Display, Mechanism};
use assur_syntax::document::Document;
use assur_text::diagnostic::Problems;
use indexmap::IndexMap;

/// A document with its names found.
pub struct Template<'a> {
    doc: &'a Document,
    overrides: &'a Overrides,
    names: Names<'a>,
    units: UnitUse,
    order: Vec<String>,
    results: IndexMap<String, String>,
    /// The common start of all rows.
    mech: Mechanism,
    displays: Vec<Display>,
    links: usize,
    inside: usize,
    bad: usize,
}

impl<'a> Template<'a> {
    /// Finds the names of a document; `None` where something is to be said of them: then every row is checked as a
    /// whole.
    #[must_use]
    pub fn new(document: &'a Document, overrides: &'a Overrides) -> Option<Self> {
        let values = Values::new(overrides, unit_use::count(document));
        let mut cx = Context::new(document, values, RESULTS);
        definitions(&mut cx);
        let quiet = cx.problems.is_empty();
        let displays = cx.values.displays();
        let Context { names, values: Values { units, definitions, .. }, builder, .. } = cx;
        let mech = builder.mech;
        let (order, results) = definitions.into_names();
        let (links, inside, bad) = (names.links.len(), names.inside.len(), names.bad.len());
        let (doc, overrides) = (document, overrides);
        quiet.then_some(Self {
            doc,
            overrides,
            names,
            units,
            order,
            results,
            mech,
            displays,
            links,
            inside,
            bad,
        })
    }

    /// As [`crate::check`] with this row.
    pub fn check(&mut self, row: &Row) -> (Option<Mechanism>, Problems) {
        let displays = self.displays.clone();
        self.within(row, |cx| {
            let (mech, problems) = (std::mem::take(&mut cx.builder.mech), std::mem::take(&mut cx.problems));
            let mechanism = Mechanism { displays, ..mech };
            ((!problems.has_errors()).then_some(mechanism), problems.into_found())
        })
    }

    /// What is to be done for other rows with the columns of this one; `None` where each of them is to be checked as a whole.
    pub fn patches(&mut self, row: &Row) -> Option<RowPatches> {
        RowPatches::of(self, row)
    }

    /// Looks at what was found with this row.
    pub(crate) fn within<T>(&mut self, row: &Row, look: impl FnOnce(&mut Context<'a>) -> T) -> T {
        use std::mem::take;
        let mut values = Values::new(self.overrides, take(&mut self.units));
        values.outside.row = row.clone();
        values.definitions = Definitions::of_names(take(&mut self.order), take(&mut self.results));
        let mut cx = Context::new(self.doc, values, RESULTS);
        cx.names = take(&mut self.names);
        cx.builder.mech = self.mech.clone();
        meaning(&mut cx);
        let found = look(&mut cx);
        let Context { names, values: Values { units, definitions, .. }, .. } = cx;
        (self.names, self.units) = (names, units);
        (self.order, self.results) = definitions.into_names();
        // what pairs have added
        self.names.pairs.clear();
        self.names.links.truncate(self.links);
        self.names.inside.truncate(self.inside);
        // an error of this row is not one of the next
        self.names.bad.truncate(self.bad);
        found
    }
}
