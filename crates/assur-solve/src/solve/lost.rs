//! Results of which no digit is left.

use super::failure::Lost;
use crate::position::{Model, Residuals, State};
use crate::structure::BodyId;

/// Pairs that miss each other by more than this share of the mechanism's size do not meet: even a dead position leaves
/// the root of the unit roundoff.
const MEETS: f64 = 1e-6;

/// Products and sums of numbers below this are finite.
const MODERATE: f64 = 1e100;

/// Whether all results are finite, and so far from the ends of what `f64` holds that their residuals are numbers too.
pub(super) fn is_moderate(state: &State) -> bool {
    // in the order of their bits magnitudes are in the order of their values, and what is no number is beyond all
    let mut most = 0;
    let mut add = |x: f64| most = x.abs().to_bits().max(most);
    for b in &state.motion.bodies {
        [b.p.x, b.p.y, b.u.x, b.u.y, b.v.x, b.v.y, b.omega, b.a.x, b.a.y, b.alpha]
            .into_iter()
            .for_each(&mut add);
    }
    for r in &state.forces.reactions {
        [r.force.x, r.force.y, r.couple].into_iter().for_each(&mut add);
    }
    state.forces.efforts.iter().copied().for_each(add);
    most < MODERATE.to_bits()
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
