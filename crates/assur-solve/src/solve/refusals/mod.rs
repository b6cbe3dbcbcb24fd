//! What cannot be answered at any position, and is refused before one is looked at.

mod free_rotation;
mod friction;
mod open_places;
mod speeds;
mod unsupported;

pub use open_places::unplaced_reactions;
pub(super) use speeds::{missing_speeds, unit_speeds};
pub(super) use unsupported::not_supported;

use super::failure::Failure;
use crate::position::Model;

/// What cannot be answered at any position, and is refused before one is looked at.
#[must_use]
pub fn refusals(model: &Model<'_>) -> Vec<Failure> {
    let mut found = not_supported(model.mechanism);
    found.extend(unsupported::cams(model));
    found.extend(unsupported::genevas(model));
    found.extend(missing_speeds(model));
    found.extend(free_rotation::free_rollers(model));
    found.extend(open_places::without_position(model));
    found.extend(open_places::without_place(model));
    found.extend(friction::without_place(model));
    found.extend(friction::open_couples(model));
    found.into_iter().map(Failure::from).collect()
}
