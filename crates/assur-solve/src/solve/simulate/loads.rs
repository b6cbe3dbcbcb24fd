//! What loads depend on, and how they are taken.

use crate::answer::Switch;
use crate::model::{BinaryOp, Expr, LoadKind, Mechanism, Query, Value};
use crate::plan::LoadStep;
use crate::position::Model;

/// The sides on which loads are taken, where they are held there.
pub(super) fn sides<'s, 'm>(held: bool, switches: &'s [Switch<'m>]) -> &'s [Switch<'m>] {
    if held { switches } else { &[] }
}

/// Whether one of these expressions of loads depends on an angle that is followed.
pub(super) fn loads_need_angles<'m>(mechanism: &'m Mechanism, loads: impl Iterator<Item = &'m Expr>) -> bool {
    let mut needed = false;
    all_parts(mechanism, loads, |part| {
        needed |= matches!(part, Expr::Query(query) if query.facts().continuous.is_some());
    });
    needed
}

/// Which loads are the efforts of stops; and whether these alone are evaluated at every position.
pub(super) fn efforts_of_stops(model: &Model<'_>) -> (Vec<bool>, bool) {
    let of_stop =
        |kind: &LoadKind| matches!(kind, LoadKind::InPair { value: Expr::Query(Query::StopEffort(_)), .. });
    let all: Vec<bool> = model.mechanism.loads.iter().map(|load| of_stop(&load.kind)).collect();
    let evaluated = |load: &LoadStep| match load {
        LoadStep::Evaluated(id) => Some(all[id.index()]),
        _ => None,
    };
    let alone = model.plan.loads.iter().filter_map(evaluated).all(|stop| stop);
    (all, alone)
}

/// Calls `look` on all parts of some expressions, through the quantities that they name, each of which is gone through once.
pub(super) fn all_parts<'m>(
    mechanism: &'m Mechanism,
    exprs: impl Iterator<Item = &'m Expr>,
    mut look: impl FnMut(&'m Expr),
) {
    let mut waiting: Vec<&Expr> = exprs.collect();
    let mut named = vec![false; mechanism.quantities.len()];
    while let Some(expr) = waiting.pop() {
        look(expr);
        match expr {
            _ if is_zero(mechanism, expr) => continue,
            Expr::Quantity(id) if !std::mem::replace(&mut named[id.index()], true) => {
                waiting.push(&mechanism.quantities[id.index()].expr);
            }
            _ => {}
        }
        expr.children(&mut |part| waiting.push(part));
    }
}

/// Whether a value is zero by a factor that is.
pub(super) fn is_zero(mechanism: &Mechanism, expr: &Expr) -> bool {
    match expr {
        Expr::Constant(Value::Scalar(x)) => *x == 0.0,
        Expr::Negate(a) | Expr::Binary(BinaryOp::Div, a, _) => is_zero(mechanism, a),
        Expr::Binary(BinaryOp::Mul, a, b) => is_zero(mechanism, a) || is_zero(mechanism, b),
        Expr::Vector(a, b) => is_zero(mechanism, a) && is_zero(mechanism, b),
        Expr::Quantity(id) => is_zero(mechanism, &mechanism.quantities[id.index()].expr),
        _ => false,
    }
}
