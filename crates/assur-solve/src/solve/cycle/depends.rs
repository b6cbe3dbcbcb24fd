//! What expressions depend on.

use crate::answer::{every_expr, every_query};
use crate::model::{About, Expr, Mechanism, PairKind, Query};

/// Whether an expression can be computed before any function over the sweep and any flywheel is known. Quantities may
/// depend on them.
pub(super) fn depends_on_nothing_else(expr: &Expr) -> bool {
    let mut found = false;
    expr.parts(&mut |part| {
        found |= matches!(part, Expr::Query(Query::Cycle(_) | Query::Flywheel(..)) | Expr::Quantity(_));
    });
    !found
}

/// Whether an expression depends on forces, through quantities and other functions over the sweep too.
pub(super) fn depends_on_forces(mechanism: &Mechanism, expr: &Expr) -> bool {
    let mut found = false;
    expr.parts(&mut |part| {
        found |= match part {
            Expr::Quantity(id) => {
                mechanism.quantities.get(id.index()).is_some_and(|q| depends_on_forces(mechanism, &q.expr))
            }
            Expr::Query(Query::Cycle(index)) => {
                mechanism.cycles.get(*index).is_some_and(|c| depends_on_forces(mechanism, &c.expr))
            }
            Expr::Query(query) => query.facts().forces,
            _ => false,
        };
    });
    found
}

/// Whether an expression asks for angles, which are continuous over the sweep.
pub(super) fn counts_turns(mechanism: &Mechanism, expr: &Expr) -> bool {
    let mut found = false;
    expr.parts(&mut |part| {
        found |= match part {
            Expr::Quantity(id) => {
                mechanism.quantities.get(id.index()).is_some_and(|q| counts_turns(mechanism, &q.expr))
            }
            Expr::Query(query) => query.facts().continuous.is_some(),
            _ => false,
        };
    });
    found
}

pub(super) fn names_quantity(expr: &Expr) -> bool {
    let mut found = false;
    expr.parts(&mut |part| found |= matches!(part, Expr::Quantity(_)));
    found
}

/// Whether a load depends on quantities of the file.
pub(crate) fn loads_name_quantities(mechanism: &Mechanism) -> bool {
    mechanism.loads.iter().any(|load| load.expressions().any(names_quantity))
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
    let exprs = mechanism.quantities.iter().map(|q| &q.expr).chain(mechanism.cycles.iter().map(|c| &c.expr));
    let mut asked = asks_for_ideal_flywheels(mechanism);
    for expr in exprs {
        expr.parts(&mut |part| {
            asked |= matches!(part, Expr::Frictionless(_) | Expr::Query(Query::Efficiency | Query::Locked));
        });
    }
    asked
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
