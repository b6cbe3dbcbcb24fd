//! A position too far from the one before.

use super::error::{SolveError, label};
use super::format::place;
use crate::position::{Model, Wanted};

/// The way to a position is too long to be followed.
pub(crate) fn too_far(model: &Model<'_>, pose: &Wanted) -> SolveError {
    let labels = model.mechanism.drives.iter().map(|d| label("driven that far", d.span)).collect();
    SolveError::WayTooLong { pose: place(model, pose), labels }
}
