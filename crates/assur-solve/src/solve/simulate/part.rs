//! Parts of a run over which functions are taken.

use crate::model::{Bound, Cycle, Part};

/// The part of the run over which a function is taken, s, as far as it is known.
pub(super) fn part(cycle: &Cycle, times: &[Vec<f64>]) -> (f64, f64) {
    let instant = |bound: Bound| match bound {
        Bound::At(t) => t,
        Bound::Event(event, which) => times[event].get(which - 1).copied().unwrap_or(f64::INFINITY),
    };
    let Part { after, before } = cycle.part;
    (after.map_or(f64::NEG_INFINITY, instant), before.map_or(f64::INFINITY, instant))
}

/// Whether this part has an end that was reached, and a length.
pub(super) fn is_known(cycle: &Cycle, times: &[Vec<f64>]) -> bool {
    let happened = |bound: Option<Bound>| match bound {
        Some(Bound::Event(event, which)) => times[event].len() >= which,
        Some(Bound::At(_)) | None => true,
    };
    let (after, before) = part(cycle, times);
    happened(cycle.part.after) && happened(cycle.part.before) && after < before
}
