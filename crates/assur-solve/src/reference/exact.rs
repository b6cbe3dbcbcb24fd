//! A position with twice the digits: by the quickest way there is, and put, rounded, into a state.

use super::reference;
use crate::math::{Double, V2};
use crate::model::{LoadId, Value};
use crate::position::{BodyState, Model, Reaction, State, precise};
use crate::structure::JointKind;

/// One position with twice the digits; without forces the lists of forces are empty.
#[derive(Clone, Debug)]
pub struct Exact {
    pub bodies: Vec<BodyState<Double>>,
    pub reactions: Vec<Reaction<Double>>,
    pub efforts: Vec<Double>,
    /// Efforts of friction, by element.
    pub frictions: Vec<Double>,
}

/// The position in which a solved state stands with twice the digits: by [`precise`] where all groups have closed forms, else
/// by [`reference()`], which agrees with it and takes many times as long.
/// # Given
/// `evaluated` values of the loads that are expressions.
#[must_use]
pub fn exact(model: &Model<'_>, state: &State, evaluated: &[(LoadId, Value)]) -> Option<Exact> {
    if let Some(found) = precise(model.plan, state) {
        let closed = Exact {
            bodies: found.motion.bodies,
            reactions: found.forces.reactions,
            efforts: found.forces.efforts,
            frictions: Vec::new(),
        };
        return found.motion.open.is_none().then_some(closed);
    }
    let found = reference(model, state, evaluated)?;
    Some(Exact {
        bodies: found.bodies,
        reactions: found.reactions,
        efforts: found.efforts,
        frictions: found.frictions,
    })
}

impl Exact {
    /// Puts the motion into a state.
    pub(crate) fn round_motion(&self, state: &mut State) {
        for (out, b) in state.motion.bodies.iter_mut().zip(&self.bodies) {
            *out = BodyState { turned: out.turned, ..b.map(Double::rounded) };
        }
    }

    /// Puts reactions and efforts into a state.
    pub(crate) fn round_forces(&self, model: &Model<'_>, state: &mut State) {
        for (i, (out, r)) in state.forces.reactions.iter_mut().zip(&self.reactions).enumerate() {
            out.force = rounded(r.force);
            if knows_couple(model, i) {
                out.couple = r.couple.rounded();
            }
        }
        for (out, e) in state.forces.efforts.iter_mut().zip(&self.efforts) {
            *out = e.rounded();
        }
        for (out, e) in state.forces.frictions.iter_mut().zip(&self.frictions) {
            *out = e.rounded();
        }
    }
}

/// Whether the couple of a reaction is determined: those of a chain of guides are shared as one likes.
#[must_use]
pub fn knows_couple(model: &Model<'_>, reaction: usize) -> bool {
    let joint = model.plan.reactions.get(reaction);
    let kind = joint.map(|joint| &model.structure.replaced.joint(joint.joint).kind);
    !matches!(kind, Some(JointKind::Prismatic { in_chain: true, .. }))
}

fn rounded(v: V2<Double>) -> V2<f64> {
    V2::new(v.x.rounded(), v.y.rounded())
}
