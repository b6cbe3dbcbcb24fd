//! Document → Mechanism: names, units, expressions, geometry, requests.
//!
//! Every mistake of a file is reported in one run. What contains a mistake is left out of the mechanism, and what refers
//! to something left out is skipped in silence. No mechanism comes out where there is an error.

mod alike;
mod amount;
mod assemble;
mod balance;
mod contact;
mod context;
mod definition;
mod drive;
mod drive_kind;
pub mod error;
mod expect;
mod expected_list;
pub mod expr;
mod flywheel;
mod friction;
mod gear;
mod gravity;
mod head;
mod hinges;
mod link;
mod load;
mod load_cycle;
mod lookup;
mod machine;
mod mass;
mod names;
#[doc(hidden)]
pub mod overrides;
mod pair;
mod pair_meant;
mod pair_property;
mod plate;
mod plate_contact;
mod plate_fault;
mod point;
mod pose;
mod prismatic;
mod property;
mod query;
mod request;
mod resident;
mod row;
mod simulation;
mod spring;
mod taken;
#[doc(hidden)]
pub mod tolerance;
mod too_wide;
mod train;
mod unit_choice;
mod unknown;
mod value;
mod variants;
mod walk;

pub use overrides::Overrides;
pub use resident::Resident;
pub use row::{ColumnUse, Row, RowCell, RowColumn};
pub use variants::{FileRow, file_rows, table};

use assur_math::{element, math};
use assur_model::model;
use assur_text::{diagnostic, source, units};

use assur_syntax as syntax;
use context::Context;
use diagnostic::Problems;
use model::Mechanism;
use syntax::document::{Document, Variants};

/// Checks a document. The mechanism is absent where the problems hold an error.
#[must_use]
pub fn check(document: &Document, overrides: &Overrides) -> (Option<Mechanism>, Problems) {
    run(Context::new(document, overrides))
}

/// As [`check`], with one `given` that has this SI value whatever the document and the overrides say.
#[must_use]
pub fn check_at(
    document: &Document,
    overrides: &Overrides,
    name: &str,
    value: f64,
) -> (Option<Mechanism>, Problems) {
    run(Context { fixed: Some((name, value)), ..Context::new(document, overrides) })
}

/// As [`check`], with another size assumed of a wheel whose own the document leaves open.
#[must_use]
pub fn check_stretched(
    document: &Document,
    overrides: &Overrides,
    wheel: &str,
) -> (Option<Mechanism>, Problems) {
    run(Context { stretched: Some(wheel), ..Context::new(document, overrides) })
}

/// The columns of a table of variants for a document: its own, or one beside it, whose spans are those of the table's
/// text. Nothing comes out where one of them has an error, or the `given` that it replaces.
#[must_use]
pub fn columns(
    document: &Document,
    overrides: &Overrides,
    table: &Variants,
) -> (Option<Vec<RowColumn>>, Problems) {
    let mut cx = Context::new(document, overrides);
    definitions(&mut cx);
    value::constants(&mut cx);
    // those are told by `check`
    cx.problems = Problems::new();
    let columns = variants::columns(&mut cx, table);
    if variants::table(document) != Some(table) {
        variants::missing_keys(&mut cx, table);
    }
    variants::rows(&mut cx, table);
    (columns.filter(|_| !cx.problems.has_errors()), cx.problems)
}

/// What is left of a document's mechanism without all that contains an error.
#[must_use]
pub fn sound_part(document: &Document, overrides: &Overrides) -> Mechanism {
    let mut cx = Context::new(document, overrides);
    definitions(&mut cx);
    meaning(&mut cx);
    cx.mech
}

fn run(mut cx: Context<'_>) -> (Option<Mechanism>, Problems) {
    definitions(&mut cx);
    meaning(&mut cx);
    cx.finish()
}

/// What hangs on no value.
fn definitions(cx: &mut Context<'_>) {
    names::declare(cx);
    alike::look_alikes(cx);
    head::head(cx);
    definition::order(cx);
}

/// All else.
fn meaning(cx: &mut Context<'_>) {
    value::constants(cx);
    machine::machine(cx);
    request::finds(cx);
    expect::expects(cx);
    train::at_rest(cx);
    variants::variants(cx);
    load_cycle::load_cycles(cx);
}
