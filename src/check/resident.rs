//! A document that is checked again and again, with one row of variants after another.
//!
//! Names, the order of the definitions and the units of the file hang on no value: they are found once. All else is
//! checked by the same code as ever, so that a row comes out as the file with these values would.

use super::context::Context;
use super::definition::Definitions;
use super::hinges::Hinges;
use super::row::Row;
use super::{Overrides, definitions, meaning};
use crate::diagnostic::Problems;
use crate::model::{Display, Mechanism};
use crate::syntax::document::Document;

/// A document with its names found.
pub struct Resident<'a> {
    cx: Context<'a>,
    fresh: Fresh,
}

/// What every row starts from.
struct Fresh {
    mech: Mechanism,
    links: usize,
    inside: usize,
    displays: Vec<Display>,
}

impl<'a> Resident<'a> {
    /// Finds the names of a document; `None` where something is to be said of them: then every row is checked as a
    /// whole.
    #[must_use]
    pub fn new(document: &'a Document, overrides: &'a Overrides) -> Option<Self> {
        let mut cx = Context::new(document, overrides);
        definitions(&mut cx);
        let quiet = cx.problems.is_empty() && cx.reported.is_empty();
        let fresh = Fresh {
            mech: cx.mech.clone(),
            links: cx.names.links.len(),
            inside: cx.names.inside.len(),
            displays: cx.displays(),
        };
        quiet.then_some(Self { cx, fresh })
    }

    /// As [`super::check`] with this row.
    pub fn check(&mut self, row: &Row) -> (Option<Mechanism>, Problems) {
        let cx = &mut self.cx;
        cx.row.clone_from(row);
        cx.mech.clone_from(&self.fresh.mech);
        cx.names.pairs.clear();
        cx.names.links.truncate(self.fresh.links);
        cx.names.inside.truncate(self.fresh.inside);
        cx.hinges = Hinges::default();
        cx.reported.clear();
        cx.gears.clear();
        let (order, results) = std::mem::take(&mut cx.definitions).into_names();
        cx.definitions = Definitions::of_names(order, results);
        meaning(cx);
        let problems = std::mem::replace(&mut cx.problems, Problems::new());
        let mut mechanism = std::mem::take(&mut cx.mech);
        mechanism.displays.clone_from(&self.fresh.displays);
        ((!problems.has_errors()).then_some(mechanism), problems)
    }
}
