//! What expressions depend on.

use crate::answer::{every_expr, every_query};
use crate::model::{About, Expr, Mechanism, PairKind, Query};

/// Calls `visit` on all parts of an expression, and of the quantities and the loads that it names.
pub(super) fn every_part(mechanism: &Mechanism, expr: &Expr, visit: &mut impl FnMut(&Expr)) {
    let mut quantities = vec![false; mechanism.quantities.len()];
    let mut loads = vec![false; mechanism.loads.len()];
    let mut waiting = vec![expr];
    let is_new = |seen: &mut Vec<bool>, index: usize| {
        seen.get_mut(index).is_some_and(|seen| !std::mem::replace(seen, true))
    };
    while let Some(expr) = waiting.pop() {
        visit(expr);
        match expr {
            Expr::Quantity(id) if is_new(&mut quantities, id.index()) => {
                waiting.push(&mechanism.quantities[id.index()].expr);
            }
            Expr::Query(Query::Load(id) | Query::LoadPower(id)) if is_new(&mut loads, id.index()) => {
                waiting.extend(mechanism.loads[id.index()].expressions());
            }
            _ => expr.children(&mut |part| waiting.push(part)),
        }
    }
}

/// Whether a part of an expression, or of what it names, is of a kind.
fn any(mechanism: &Mechanism, expr: &Expr, is: impl Fn(&Expr) -> bool) -> bool {
    let mut found = false;
    every_part(mechanism, expr, &mut |part| found |= is(part));
    found
}

/// Whether an expression can be computed before any function over the sweep and any flywheel is known. Quantities may
/// depend on them.
pub(super) fn depends_on_nothing_else(mechanism: &Mechanism, expr: &Expr) -> bool {
    !any(mechanism, expr, |part| {
        matches!(part, Expr::Query(Query::Cycle(_) | Query::Flywheel(..)) | Expr::Quantity(_))
    })
}

/// Whether an expression depends on forces, also through other functions over the sweep.
pub(super) fn depends_on_forces(mechanism: &Mechanism, expr: &Expr) -> bool {
    any(mechanism, expr, |part| match part {
        Expr::Query(Query::Cycle(index)) => {
            mechanism.cycles.get(*index).is_some_and(|c| depends_on_forces(mechanism, &c.expr))
        }
        Expr::Query(query) => query.facts().forces,
        _ => false,
    })
}

/// Whether an expression asks for angles, which are continuous over the sweep.
pub(super) fn counts_turns(mechanism: &Mechanism, expr: &Expr) -> bool {
    any(mechanism, expr, |part| matches!(part, Expr::Query(query) if query.facts().continuous.is_some()))
}

/// Whether an expression, or a load that it names, depends on quantities of the file.
pub(super) fn names_quantity(mechanism: &Mechanism, expr: &Expr) -> bool {
    any(mechanism, expr, |part| matches!(part, Expr::Quantity(_)))
}

/// Whether a load depends on quantities of the file.
pub(crate) fn loads_name_quantities(mechanism: &Mechanism) -> bool {
    mechanism.loads.iter().any(|load| load.expressions().any(|expr| names_quantity(mechanism, expr)))
}

/// Whether the file asks anywhere for angles, which are carried on from place to place.
pub(super) fn asks_for_angles(mechanism: &Mechanism) -> bool {
    let mut asked = false;
    every_query(mechanism, &mut |query, _| {
        asked |= match query.facts().continuous {
            Some(About::Pair(pair)) => matches!(mechanism.pair(pair).kind, PairKind::Revolute(_)),
            about => about.is_some(),
        };
    });
    asked
}

/// Whether the file asks anywhere for what it would be without friction.
pub(super) fn asks_for_ideal(mechanism: &Mechanism) -> bool {
    let mut exprs =
        mechanism.quantities.iter().map(|q| &q.expr).chain(mechanism.cycles.iter().map(|c| &c.expr));
    asks_for_ideal_flywheels(mechanism) || exprs.any(|expr| is_ideal(mechanism, expr))
}

/// Whether an expression asks for that.
pub(super) fn is_ideal(mechanism: &Mechanism, expr: &Expr) -> bool {
    any(mechanism, expr, |part| {
        matches!(part, Expr::Frictionless(_) | Expr::Query(Query::Efficiency | Query::Locked))
    })
}

/// Whether it asks for a flywheel as it would be without friction.
pub(super) fn asks_for_ideal_flywheels(mechanism: &Mechanism) -> bool {
    let mut asked = false;
    every_expr(mechanism, &mut |expr, _| {
        expr.parts(&mut |part| {
            if let Expr::Frictionless(ideal) = part {
                ideal.queries(&mut |query| asked |= matches!(query, Query::Flywheel(..)));
            }
        });
    });
    asked
}
