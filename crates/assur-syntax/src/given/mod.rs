//! What a document gives: its data, statement by statement, as they are written.
//!
//! The list is a walk over the document: a new statement does not compile without its data. A datum is never left out because of its
//! number, only because nothing that is asked for can depend on its statement (`Given::of`).

mod datum;
mod kinds;
mod level;
mod members;
mod reach;
mod requests;
mod walk;

pub use datum::{Datum, GivenLine, GivenValue, Shown};
pub use kinds::{GivenKind, GivenLevel, KINDS};
pub use reach::{Given, names_of};

use crate::document::Document;

/// The data of all statements, whatever is asked for: a line per statement, in the order of the document.
#[must_use]
pub fn lines(document: &Document) -> Vec<GivenLine<'_>> {
    document.statements.iter().enumerate().map(|(i, s)| walk::line(i, &s.node)).collect()
}
