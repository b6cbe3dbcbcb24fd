//! What acts on the bodies at a position, as the balance of the bodies has it.

use super::pose_answers::PoseAnswers;
use crate::model::{CamContact, LinkId, PairId, Query};
use crate::position::{Act, Cause, Model};

impl PoseAnswers<'_> {
    /// All that acts on bodies: loads, those of the file first, and what bodies do to each other. A cam that touches a roller presses on the roller, and this on
    /// its pin.
    #[must_use]
    pub fn acts(&self) -> Vec<Act> {
        let mut acts = Vec::new();
        let model = Model { mechanism: self.mechanism, structure: self.structure, plan: self.plan };
        self.state.loads_act(&model, &|load| self.query(&Query::Load(load)), &mut |act| acts.push(act));
        acts.sort_by_key(|act| !matches!(act.cause, Cause::Load(_)));
        self.state.acts(self.plan, &mut |act| acts.push(act));
        for contact in &self.mechanism.cam_contacts {
            if let Some((roller, hinge)) = contact.roller {
                self.by_roller(contact, roller, hinge, &mut acts);
            }
        }
        acts
    }

    /// Puts what a cam does to its follower on the roller, and what the roller then does on the follower.
    fn by_roller(&self, contact: &CamContact, roller: LinkId, hinge: PairId, acts: &mut Vec<Act>) {
        let Some(&pin) = self.plan.reactions_of.places(hinge).first() else { return };
        let (roller, follower) = (roller.index(), contact.follower.index());
        let place = acts.iter().find(|act| act.cause == Cause::Reaction(pin)).map(|act| act.place);
        let Some(place) = place else { return };
        let mut passed = Vec::new();
        for act in acts.iter_mut().filter(|act| self.pair_of(act.cause) == Some(contact.pair)) {
            let sign = match (act.on == follower, act.from == Some(follower)) {
                (true, _) => 1.0,
                (_, true) => -1.0,
                _ => continue,
            };
            if act.on == follower {
                act.on = roller;
            } else {
                act.from = Some(roller);
            }
            let force = act.force * sign;
            let couple = (act.place - place).cross(force) + act.couple * sign;
            let (cause, from) = (Cause::Reaction(pin), Some(roller));
            passed.push(Act { cause, on: follower, from, place, force, couple });
        }
        acts.extend(passed);
    }

    /// The pair in which something acts.
    #[must_use]
    pub fn pair_of(&self, cause: Cause) -> Option<PairId> {
        match cause {
            Cause::Reaction(slot) => {
                let joint = self.plan.reactions.get(slot)?.joint;
                Some(self.structure.replaced.joint(joint).pair)
            }
            Cause::Law(slot) => self.plan.laws.get(slot).map(|law| law.pair),
            Cause::Friction(i) => self.plan.friction.get(i).map(|element| element.pair),
            Cause::Load(_) | Cause::Weight | Cause::Inertia | Cause::Spring(_) | Cause::Effort(_) => None,
        }
    }
}
