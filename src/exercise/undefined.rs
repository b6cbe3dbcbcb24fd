//! Why a value does not exist.

use crate::model::{Expr, Query};
use crate::solve::{Scene, Solution};

/// Why an expression has no value, where the structure says so.
#[must_use]
pub fn why_undefined(scene: &Scene<'_>, expr: &Expr) -> Option<String> {
    if let Expr::Quantity(id) = expr {
        return why_undefined(scene, &scene.mechanism.quantities.get(id.index())?.expr);
    }
    let mut why = None;
    expr.queries(&mut |query| {
        if let Query::Critical(index) = query
            && let Some(name) = scene.mechanism.criticals.get(*index)
        {
            why = Some(format!("locking neither begins nor ends at any value of `{name}` within reach"));
        }
        let (Query::Moment(pair, _) | Query::ContactForce(pair, _) | Query::LineOffset(pair)) = query else {
            return;
        };
        if scene.structure.undetermined_couples.contains(pair) {
            let name = &scene.mechanism.pair(*pair).name;
            why = Some(format!(
                "the couple in `{name}` is not determined: it closes a chain of prismatic pairs"
            ));
        }
    });
    why
}

/// Why a function over the sweep in an expression has no value.
pub(super) fn without_cycle(scene: &Scene<'_>, solution: &Solution, expr: &Expr) -> Option<String> {
    let mut why = None;
    expr.parts(&mut |part| {
        let found = match part {
            Expr::Quantity(id) => {
                let quantity = scene.mechanism.quantities.get(id.index());
                quantity.and_then(|q| without_cycle(scene, solution, &q.expr))
            }
            Expr::Query(Query::Cycle(index)) => {
                solution.statics.cycles.get(*index).and_then(|c| c.why.clone())
            }
            _ => None,
        };
        why = why.take().or(found);
    });
    why
}
