//! Numbers so far apart that no answer is left.

use super::error::{SolveError, label};
use super::format::place;
use crate::position::{Model, Residuals, Wanted};

/// Pairs that miss each other by more than this share of the mechanism's size do not meet: even a dead position leaves
/// the root of the unit roundoff.
const MEETS: f64 = 1e-6;

/// Numbers so far apart that the small ones are lost beside the great: the pairs do not meet, or a residual is no number.
pub(crate) fn out_of_scale(model: &Model<'_>, residuals: &Residuals, pose: &Wanted) -> Option<SolveError> {
    let numbers = [residuals.equilibrium, residuals.power].into_iter().flatten().all(|x| !x.is_nan());
    if residuals.closure <= MEETS && numbers {
        return None;
    }
    let what = if residuals.closure <= MEETS { "the balance of forces" } else { "the position of the links" };
    let labels = model.mechanism.drives.iter().map(|d| label("at this position", d.span)).collect();
    Some(SolveError::NotFinite { pose: place(model, pose), what: what.to_owned(), labels })
}
