//! The definitions that need results.

use crate::expr::context::Context;
use crate::names::declared::QuantityKind;
use crate::statements::walk;
use crate::values::definition::Settled;
use crate::values::typed::Typed;
use assur_model::model::{Display, Quantity, QuantityId};
use assur_syntax::document::{Expr, ExprKind, Statement};
use assur_text::source::Span;
use std::collections::HashSet;

/// Reads the definitions that depend on results. Only once the pairs are in the mechanism.
pub fn results(cx: &mut Context<'_>) {
    let used = used(cx);
    for name in cx.values.definitions.order.clone() {
        let Some((kind, span)) = cx.names.quantities.get(&name).map(|d| (d.what, d.span)) else { continue };
        if cx.values.definitions.settled.contains_key(&name) {
            continue;
        }
        let settled = match kind {
            QuantityKind::Let(expr) if !used.contains(name.as_str()) => unused(cx, expr),
            QuantityKind::Let(expr) => {
                let read = cx.read(expr);
                let read = read.map(|t| {
                    let display = cx.values.display(t.ty.dimension());
                    (t, display)
                });
                keep(cx, name.clone(), span, read)
            }
            QuantityKind::Find(item) => {
                let read = cx.read_item(item);
                keep(cx, name.clone(), span, read)
            }
            _ => continue,
        };
        cx.values.definitions.settled.insert(name, settled);
    }
}

/// A definition that nothing uses is read for its mistakes, and asks for nothing.
fn unused(cx: &mut Context<'_>, expr: &Expr) -> Settled {
    let mech = &cx.builder.mech;
    let asked = [mech.cycles.len(), mech.works.len(), mech.criticals.len()];
    let read = cx.read(expr);
    let mech = &mut cx.builder.mech;
    mech.cycles.truncate(asked[0]);
    mech.works.truncate(asked[1]);
    mech.criticals.truncate(asked[2]);
    read.map_or(Settled::Failed, |t| Settled::Pending(t.ty))
}

/// The names that stand in statements other than definitions, and in the definitions that these use.
fn used<'a>(cx: &Context<'a>) -> HashSet<&'a str> {
    let mut found = HashSet::new();
    for statement in cx.doc.statements.iter().map(|s| &s.node) {
        if !matches!(statement, Statement::Given(_) | Statement::Let(_)) {
            walk::expressions(statement, &mut |expr| names_in(expr, &mut found));
        }
    }
    for name in cx.values.definitions.order.iter().rev() {
        if let Some(QuantityKind::Let(expr)) = cx.names.quantities.get(name).map(|d| d.what)
            && found.contains(name.as_str())
        {
            names_in(expr, &mut found);
        }
    }
    found
}

fn names_in<'a>(expr: &'a Expr, found: &mut HashSet<&'a str>) {
    walk::parts(expr, &mut |part| {
        if let ExprKind::Name(name) = &part.kind {
            found.insert(name.as_str());
        }
    });
}

fn keep(cx: &mut Context<'_>, name: String, span: Span, read: Option<(Typed, Display)>) -> Settled {
    let Some((t, display)) = read else { return Settled::Failed };
    if t.pending {
        return Settled::Pending(t.ty);
    }
    let id = QuantityId::at(cx.builder.mech.quantities.len());
    let kept = (cx.values.definitions.is_poseless(&t.expr), cx.values.definitions.size(&t.expr));
    cx.values.definitions.kept.push(kept);
    cx.builder.mech.quantities.push(Quantity { name, span, expr: t.expr, display });
    Settled::Result(id, t.ty)
}
