//! The definitions that need no results.

use crate::expr::context::Context;
use crate::expr::read::TOO_LARGE;
use crate::names::declared::QuantityKind;
use crate::values::definition::Settled;
use crate::values::replace;
use crate::values::unit_use::display_in;
use assur_model::model::{Display, NamedValue};
use assur_syntax::document::{Expr, ExprKind};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;

/// Reads the definitions that need no results, and the values from outside.
pub fn constants(cx: &mut Context<'_>) {
    replace::unknown_names(&cx.names, cx.values.outside.overrides, &mut cx.problems);
    for name in cx.values.definitions.order.clone() {
        let Some(kind) = cx.names.quantities.get(&name).map(|d| d.what) else { continue };
        if cx.values.definitions.settled.contains_key(&name) {
            continue;
        }
        let results = cx.values.definitions.results.contains_key(&name);
        let settled = match kind {
            QuantityKind::Given(expr) if results => {
                let result = cx.values.definitions.first_result(&cx.names, expr);
                if let Some((span, result)) = result {
                    cx.error(not_constant(&format!("`given {name}`"), &result, span));
                }
                Settled::Failed
            }
            QuantityKind::Given(expr) | QuantityKind::Let(expr) if !results => match cx.read(expr) {
                Some(t) if t.pending => Settled::Pending(t.ty),
                Some(t) => replace::replaced(&cx.names, &cx.values, &mut cx.problems, &name, t)
                    .and_then(|t| cx.finite(t, TOO_LARGE, expr.span))
                    .map_or(Settled::Failed, Settled::Constant),
                None => Settled::Failed,
            },
            _ => continue,
        };
        cx.values.definitions.settled.insert(name, settled);
    }
    list(cx);
}

/// Enters the values into the mechanism, in the order of the file.
fn list(cx: &mut Context<'_>) {
    for (name, declared) in &cx.names.quantities {
        let (QuantityKind::Given(expr) | QuantityKind::Let(expr)) = declared.what else { continue };
        let given = matches!(declared.what, QuantityKind::Given(_));
        let Some(Settled::Constant(t)) = cx.values.definitions.settled.get(name) else { continue };
        let Some(value) = t.value() else { continue };
        let display = own_unit(cx, expr).unwrap_or_else(|| cx.values.display(t.ty.dimension()));
        cx.builder.mech.values.push(NamedValue { name: name.clone(), value, display, given });
    }
}

/// The unit of a value that is a number as written.
fn own_unit(cx: &Context<'_>, expr: &Expr) -> Option<Display> {
    match &expr.kind {
        ExprKind::Number(n) => cx.values.units.get(&n.unit.as_ref()?.node).map(|(unit, _)| display_in(unit)),
        ExprKind::Unary(_, inner) => own_unit(cx, inner),
        _ => None,
    }
}

/// A value that must be known beforehand depends on results.
pub fn not_constant(what: &str, result: &str, span: Span) -> Diagnosis {
    Diagnosis::error(
        "mech::request::not_constant",
        format!("{what} must be a constant, but it depends on {result}"),
    )
    .primary(span, "known only once the mechanism is solved")
    .help("use numbers, `given` and those `let` that depend only on them")
}
