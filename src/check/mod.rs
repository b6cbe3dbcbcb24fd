//! Document → Mechanism: names, units, expressions, geometry, requests.
//!
//! Every mistake of a file is reported in one run. What contains a mistake is left out of the mechanism, and what refers
//! to something left out is skipped in silence. No mechanism comes out where there is an error.

mod alike;
mod amount;
mod assemble;
mod balance;
mod cam;
mod contact;
mod context;
mod definition;
mod drive;
pub mod error;
mod expect;
pub mod expr;
mod friction;
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
mod overrides;
mod pair;
mod pair_property;
mod point;
mod pose;
mod prismatic;
mod property;
mod query;
mod request;
mod simulation;
mod spring;
mod tolerance;
mod train;
mod unit_choice;
mod value;
mod variants;
mod walk;

pub use overrides::Overrides;

use crate::diagnostic::Problems;
use crate::model::Mechanism;
use crate::syntax::document::Document;
use context::Context;

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

fn run(mut cx: Context<'_>) -> (Option<Mechanism>, Problems) {
    names::declare(&mut cx);
    alike::look_alikes(&mut cx);
    head::head(&mut cx);
    definition::order(&mut cx);
    value::constants(&mut cx);
    machine::machine(&mut cx);
    request::finds(&mut cx);
    expect::expects(&mut cx);
    variants::variants(&mut cx);
    load_cycle::load_cycles(&mut cx);
    cx.finish()
}
