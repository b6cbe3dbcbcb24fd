//! The definitions that need results.

use crate::expr::context::Context;
use crate::names::declared::QuantityKind;
use crate::values::definition::Settled;
use crate::values::typed::Typed;
use assur_model::model::{Display, Quantity, QuantityId};
use assur_text::source::Span;

/// Reads the definitions that hang on results. Only once the pairs are in the mechanism.
pub fn results(cx: &mut Context<'_>) {
    for name in cx.values.definitions.order.clone() {
        let Some((kind, span)) = cx.names.quantities.get(&name).map(|d| (d.what, d.span)) else { continue };
        if cx.values.definitions.settled.contains_key(&name) {
            continue;
        }
        let settled = match kind {
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
