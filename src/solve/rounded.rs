//! A position with twice the digits put, rounded, into a state.

use super::reference::Reference;
use super::solution::Scene;
use super::state::{BodyState, State};
use crate::math::{Double, V2};
use crate::structure::JointKind;

impl Reference {
    /// Puts the motion into a state.
    pub(super) fn round_motion(&self, state: &mut State) {
        for (out, b) in state.bodies.iter_mut().zip(&self.bodies) {
            *out = BodyState {
                p: rounded(b.p),
                u: rounded(b.u),
                v: rounded(b.v),
                omega: b.omega.rounded(),
                a: rounded(b.a),
                alpha: b.alpha.rounded(),
                way: out.way,
            };
        }
    }

    /// Puts reactions and efforts into a state.
    pub(super) fn round_forces(&self, scene: &Scene<'_>, state: &mut State) {
        for (i, (out, r)) in state.reactions.iter_mut().zip(&self.reactions).enumerate() {
            out.force = rounded(r.force);
            if knows_couple(scene, i) {
                out.couple = r.couple.rounded();
            }
        }
        for (out, e) in state.efforts.iter_mut().zip(&self.efforts) {
            *out = e.rounded();
        }
        for (out, e) in state.frictions.iter_mut().zip(&self.frictions) {
            *out = e.rounded();
        }
    }
}

/// Whether the couple of a reaction is determined: those of a chain of guides are shared as one likes.
#[must_use]
pub fn knows_couple(scene: &Scene<'_>, reaction: usize) -> bool {
    let joint = scene.plan.reactions.get(reaction);
    let kind = joint.map(|joint| &scene.structure.replaced.joint(joint.joint).kind);
    !matches!(kind, Some(JointKind::Prismatic { in_chain: true, .. }))
}

fn rounded(v: V2<Double>) -> V2<f64> {
    V2::new(v.x.rounded(), v.y.rounded())
}
