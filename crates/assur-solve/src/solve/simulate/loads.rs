//! What loads depend on, and how they are taken.

use super::acting::all_parts;
use crate::answer::Switch;
use crate::model::Expr;
use crate::position::Model;

/// The sides on which loads are taken, where they are held there.
pub(super) fn sides<'s, 'm>(held: bool, switches: &'s [Switch<'m>]) -> &'s [Switch<'m>] {
    if held { switches } else { &[] }
}

/// Whether the value of a load depends on an angle that is followed.
pub(super) fn loads_need_angles(model: &Model<'_>) -> bool {
    let loads = model.mechanism.loads.iter().flat_map(crate::model::Load::expressions);
    let mut needed = false;
    all_parts(model.mechanism, loads, |part| {
        needed |= matches!(part, Expr::Query(query) if query.facts().continuous.is_some());
    });
    needed
}
