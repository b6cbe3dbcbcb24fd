//! Results of which no digit is left.

use super::failure::Lost;
use crate::position::{Model, Residuals, State};
use crate::structure::BodyId;

/// Pairs that miss each other by more than this share of the mechanism's size do not meet: even a dead position leaves
/// the root of the unit roundoff.
pub(super) const MEETS: f64 = 1e-6;

/// Products and sums of numbers below this are finite.
pub(super) const MODERATE: f64 = 1e100;

/// Whether all results are finite, and so far from the ends of what `f64` holds that their residuals are numbers too.
pub(super) fn is_moderate(state: &State) -> bool {
    // what is no number, or beyond all, is in the sum too
    let mut sum = 0.0;
    for b in &state.motion.bodies {
        let place = b.p.x.abs() + b.p.y.abs() + b.u.x.abs() + b.u.y.abs();
        let rates = b.v.x.abs() + b.v.y.abs() + b.omega.abs();
        sum += place + rates + (b.a.x.abs() + b.a.y.abs() + b.alpha.abs());
    }
    for r in &state.forces.reactions {
        sum += r.force.x.abs() + r.force.y.abs() + r.couple.abs();
    }
    sum += state.forces.efforts.iter().map(|x| x.abs()).sum::<f64>();
    sum < MODERATE
}

/// The first result that is not finite.
pub(super) fn not_finite(model: &Model<'_>, state: &State) -> Option<Lost> {
    let reactions = || model.plan.reactions.iter().zip(&state.forces.reactions);
    let bodies = || state.motion.bodies.iter().enumerate();
    let mut position = bodies().filter(|(_, b)| !(b.p.x + b.p.y + b.u.x + b.u.y).is_finite());
    let mut velocity = bodies().filter(|(_, b)| !(b.v.x + b.v.y + b.omega).is_finite());
    let mut acceleration = bodies().filter(|(_, b)| !(b.a.x + b.a.y + b.alpha).is_finite());
    let mut reaction = reactions().filter(|(_, r)| !(r.force.x + r.force.y + r.couple).is_finite());
    let pair = |joint| model.structure.replaced.joint(joint).pair;
    let first = position.next().map(|(i, _)| Lost::Position(BodyId(i)));
    first
        .or_else(|| velocity.next().map(|(i, _)| Lost::Velocity(BodyId(i))))
        .or_else(|| acceleration.next().map(|(i, _)| Lost::Acceleration(BodyId(i))))
        .or_else(|| reaction.next().map(|(joint, _)| Lost::Reaction(pair(joint.joint))))
        .or_else(|| state.forces.efforts.iter().any(|e| !e.is_finite()).then_some(Lost::Effort))
}

/// Numbers so far apart that the small ones are lost beside the great: the pairs do not meet, or a residual is not a
/// number.
pub(super) fn out_of_scale(residuals: &Residuals) -> Option<Lost> {
    let numbers = [residuals.equilibrium, residuals.power].into_iter().flatten().all(|x| !x.is_nan());
    match (residuals.closure <= MEETS, numbers) {
        (true, true) => None,
        (true, false) => Some(Lost::Equilibrium),
        (false, _) => Some(Lost::Closure),
    }
}
