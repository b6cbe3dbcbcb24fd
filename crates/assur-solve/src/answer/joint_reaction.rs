//! The reaction on a link in a pair that one or several joints stand for, found without a search at every position.

use super::pose_answers::PoseAnswers;
use crate::math::Vec2;
use crate::model::{LinkId, PairId, PairKind};
use crate::position::State;

/// Slots of reactions whose sum acts on a link in a pair, with their signs.
#[derive(Clone, Debug)]
pub struct JointReaction(Vec<(usize, f64)>);

impl JointReaction {
    /// As any position of a mechanism shows it: of a pair without friction that is no transmission, not the contact or the hinge of a cam's roller, and no pin with a load on its first link; else `None`. In a motion stops may press in a pair, and others may share what holds it.
    #[must_use]
    pub fn of(view: &PoseAnswers<'_>, pair: PairId, link: LinkId) -> Option<Self> {
        let plain = view.mechanism.simulation.is_none()
            && !matches!(view.mechanism.pair(pair).kind, PairKind::Transmission(_))
            && view.roller_of(pair).is_none()
            && view.on_pin(pair, link).next().is_none()
            && view.plan.friction_of.places(pair).is_empty();
        plain.then(|| Self(view.slots(pair, link).collect()))
    }

    /// The force on the link, N, as [`PoseAnswers::reaction`] has it.
    #[inline]
    #[must_use]
    pub fn force(&self, state: &State) -> Vec2 {
        self.0.iter().fold(Vec2::zero(), |sum, &(slot, sign)| sum + state.forces.reactions[slot].force * sign)
    }

    /// The couple on the link, N m, as [`PoseAnswers::moment`] has it where it is determined.
    #[inline]
    #[must_use]
    pub fn couple(&self, state: &State) -> f64 {
        self.0.iter().fold(0.0, |sum, &(slot, sign)| sum + state.forces.reactions[slot].couple * sign)
    }
}
