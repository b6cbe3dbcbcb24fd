//! Why a value does not exist.

use crate::model::{Expr, Query};
use crate::solve::Scene;

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
