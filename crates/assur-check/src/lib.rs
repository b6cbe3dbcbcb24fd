//! Document → Mechanism: names, units, expressions, geometry, requests.
//!
//! Every mistake of a file is reported in one run. Parts with a mistake are left out of the mechanism, and references
//! to them are skipped without a message. There is no mechanism if there is an error.

mod elements;
mod expr;
mod links;
mod loads;
mod machine;
mod motion;
mod names;
mod notes;
mod output;
mod pairs;
mod requests;
mod row_patch;
mod row_places;
mod row_program;
mod statements;
mod template;
mod trains;
mod values;

pub use names::uses::Use;
pub use requests::variants::{FileRow, file_rows, table};
pub use row_patch::RowPatches;
pub use statements::walk::{expressions, parts as parts_of};
pub use template::Template;
use values::format_value;
pub use values::format_value::with_names;
pub use values::row::{ColumnUse, Row, RowCell, RowColumn};
pub use values::store::Overrides;

/// Parts that the tests look at alone.
#[doc(hidden)]
pub mod parts {
    pub use crate::requests::tolerance::digit_of;
    pub use crate::values::replace::value;
    pub use crate::values::typed::{Type, Typed};
}

use assur_model::model::Mechanism;
use assur_syntax::document::{Document, Variants};
use assur_text::diagnostic::Problems;
use expr::context::{Context, constants};
use expr::curve::curves;
use loads::load_cycle;
use machine::machine;
use motion::equilibrium;
use names::declare;
use names::lookalikes::{self, Scope};
use requests::query::RESULTS;
use requests::{bars, expect, find, internal, variants};
use trains::at_rest::at_rest;
use values::order::order;
use values::store::Values;
use values::unit_use;

/// Checks a document. The mechanism is absent if the problems contain an error.
#[must_use]
pub fn check(document: &Document, overrides: &Overrides) -> (Option<Mechanism>, Problems) {
    run(start(document, overrides))
}

/// What a check finds for an editor.
#[derive(Debug)]
pub struct CheckFindings {
    /// The mechanism, if nothing is wrong.
    pub mechanism: Option<Mechanism>,
    /// All that was found wrong.
    pub problems: Problems,
    /// Where names are used, in a text with errors too.
    pub uses: Vec<Use>,
    /// The definitions that are constant numbers, in the units of the text.
    pub constants: Vec<(String, String)>,
}

/// As [`check`], with the uses of all names.
#[must_use]
pub fn analyze(document: &Document, overrides: &Overrides) -> CheckFindings {
    let mut cx = start(document, overrides);
    cx.names.uses.keep();
    definitions(&mut cx);
    meaning(&mut cx);
    let uses = std::mem::take(&mut cx.names.uses).into_sorted();
    let constants = format_value::constants(&cx.names, &cx.values.definitions);
    let (mechanism, problems) = cx.finish();
    CheckFindings { mechanism, problems, uses, constants }
}

/// As [`check`], with one `given` that has this SI value for any document and overrides.
#[must_use]
pub fn check_at(
    document: &Document,
    overrides: &Overrides,
    name: &str,
    value: f64,
) -> (Option<Mechanism>, Problems) {
    let mut cx = start(document, overrides);
    cx.values.outside.fixed = Some((name, value));
    run(cx)
}

/// As [`check`], with another assumed size of a wheel that the document leaves open.
#[must_use]
pub fn check_with_other_size(
    document: &Document,
    overrides: &Overrides,
    wheel: &str,
) -> (Option<Mechanism>, Problems) {
    let mut cx = start(document, overrides);
    cx.values.outside.other_size = Some(wheel);
    run(cx)
}

/// The columns of a table of variants for a document: its own, or a separate one, whose spans are those of the table's
/// text. There is no result if one of them, or the `given` that it replaces, has an error.
#[must_use]
pub fn columns(
    document: &Document,
    overrides: &Overrides,
    table: &Variants,
) -> (Option<Vec<RowColumn>>, Problems) {
    let mut cx = start(document, overrides);
    definitions(&mut cx);
    curves(&mut cx);
    constants(&mut cx);
    // those are reported by `check`
    cx.problems.clear_found();
    let columns = variants::columns(&mut cx, table);
    if variants::table(document) != Some(table) {
        variants::missing_keys(&mut cx, table);
    }
    variants::rows(&mut cx, table);
    (columns.filter(|_| !cx.problems.has_errors()), cx.problems.into_found())
}

/// The mechanism of a document without the parts that contain an error.
#[must_use]
pub fn sound_part(document: &Document, overrides: &Overrides) -> Mechanism {
    let mut cx = start(document, overrides);
    definitions(&mut cx);
    meaning(&mut cx);
    cx.builder.mech
}

fn run(mut cx: Context<'_>) -> (Option<Mechanism>, Problems) {
    definitions(&mut cx);
    meaning(&mut cx);
    cx.finish()
}

/// The state at the start.
fn start<'a>(document: &'a Document, overrides: &'a Overrides) -> Context<'a> {
    Context::new(document, Values::new(overrides, unit_use::count(document)), RESULTS)
}

/// The state that depends on no value.
fn definitions(cx: &mut Context<'_>) {
    let Context { doc, names, values, builder, problems, .. } = cx;
    let mut scope = Scope { doc, names, builder, problems };
    declare::declare(&mut scope);
    lookalikes::look_alikes(&mut scope);
    lookalikes::head(&mut scope);
    order(names, &mut values.definitions, problems);
}

/// Puts values into the title and the problem's text.
fn fill_texts(cx: &mut Context<'_>) {
    let Context { doc, names, values, builder, .. } = cx;
    let mech = &mut builder.mech;
    let title = doc.title().map(|title| (&mut mech.title, title.span));
    let notes = mech.notes.iter_mut().zip(doc.notes.iter().map(|note| note.span));
    for (text, at) in title.into_iter().chain(notes) {
        if text.contains('{') {
            *text = format_value::filled(text, at, names, &values.definitions);
            // of the file as written no row is meant
            let label = values.outside.row.label.as_deref().unwrap_or("…");
            *text = text.replace("{variant}", label);
        }
    }
}

fn meaning(cx: &mut Context<'_>) {
    curves(cx);
    constants(cx);
    fill_texts(cx);
    machine(cx);
    find::finds(cx);
    expect::expects(cx);
    equilibrium::allowed(cx);
    bars::bars(cx);
    bars::load_at_pin(cx);
    internal::inside(cx);
    at_rest(cx);
    variants::variants(cx);
    load_cycle::load_cycles(cx);
    notes::notes(cx);
    cx.keep_gears();
}
