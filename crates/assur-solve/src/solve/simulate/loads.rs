//! What loads depend on, and how they are taken.

use super::acting::all_parts;
use crate::answer::Switch;
use crate::model::{Expr, Mechanism};

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
