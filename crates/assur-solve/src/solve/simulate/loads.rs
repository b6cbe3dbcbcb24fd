//! What loads depend on, and how they are taken.

use crate::answer::Switch;
use crate::model::Expr;
use crate::position::Model;

/// The sides on which loads are taken, where they are held there.
pub(super) fn sides<'s, 'm>(held: bool, switches: &'s [Switch<'m>]) -> &'s [Switch<'m>] {
    if held { switches } else { &[] }
}

/// Whether the value of a load depends on an angle that is followed.
pub(super) fn loads_need_angles(model: &Model<'_>) -> bool {
    let mechanism = model.mechanism;
    let mut needed = false;
    let mut look = |expr: &Expr| {
        expr.queries(&mut |query| needed |= query.facts().continuous.is_some());
    };
    mechanism.loads.iter().flat_map(crate::model::Load::expressions).for_each(&mut look);
    mechanism.quantities.iter().for_each(|quantity| look(&quantity.expr));
    needed
}
