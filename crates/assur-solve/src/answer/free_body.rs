//! What acts on the bodies at a position, as the balance of the bodies has it.

use super::pose_answers::PoseAnswers;
use crate::model::{CamContact, LinkId, LoadId, PairId, Query};
use crate::position::{Action, Model, Origin};

impl PoseAnswers<'_> {
    /// All that acts on some bodies from outside.
    #[must_use]
    pub fn actions(&self, bodies: &[usize]) -> Vec<Action> {
        let all = self.all_actions().into_iter().flat_map(|action| [Some(action), action.opposite()]);
        let mut own: Vec<Action> = all.flatten().collect();
        own.retain(|action| bodies.contains(&action.on) && action.by.is_none_or(|by| !bodies.contains(&by)));
        own
    }

    /// All that acts on bodies: loads, those of the file first, and what bodies do to each other. A cam that touches a roller presses on the roller, and this on
    /// its pin.
    #[must_use]
    pub fn all_actions(&self) -> Vec<Action> {
        let mut actions = self.in_balance();
        for contact in &self.mechanism.cam_contacts {
            if let Some((roller, hinge)) = contact.roller {
                self.by_roller(contact, roller, hinge, &mut actions);
            }
        }
        actions
    }

    /// What comes from this in the balance of bodies, in which a cam presses on the follower itself.
    #[must_use]
    pub fn actions_from(&self, from: Origin) -> Vec<Action> {
        let mut actions = self.in_balance();
        actions.retain(|action| action.from == from);
        actions
    }

    fn in_balance(&self) -> Vec<Action> {
        let mut actions = Vec::new();
        let value = |load| self.first_way().query(&Query::Load(load));
        self.state.loads_act(&self.model(), &value, &mut |action| actions.push(action));
        actions.sort_by_key(|action| !matches!(action.from, Origin::Load(_)));
        self.state.acts(self.plan, &mut |action| actions.push(action));
        actions
    }

    /// What a load of the file does; none where it has no value.
    #[must_use]
    pub fn load_action(&self, load: LoadId) -> Option<Action> {
        self.state.load_act(&self.model(), load, self.first_way().query(&Query::Load(load)))
    }

    pub(super) const fn model(&self) -> Model<'_> {
        Model { mechanism: self.mechanism, structure: self.structure, plan: self.plan }
    }

    /// Puts what a cam does to its follower on the roller, and what the roller then does on the follower.
    fn by_roller(&self, contact: &CamContact, roller: LinkId, hinge: PairId, actions: &mut Vec<Action>) {
        let Some(&pin) = self.plan.reactions_of.places(hinge).first() else { return };
        let (roller, follower) = (roller.index(), contact.follower.index());
        let at = actions.iter().find(|action| action.from == Origin::Reaction(pin)).map(|action| action.at);
        let Some(at) = at else { return };
        let mut passed = Vec::new();
        for action in actions.iter_mut().filter(|action| self.pair_of(action.from) == Some(contact.pair)) {
            let sign = match (action.on == follower, action.by == Some(follower)) {
                (true, _) => 1.0,
                (_, true) => -1.0,
                _ => continue,
            };
            if action.on == follower {
                action.on = roller;
            } else {
                action.by = Some(roller);
            }
            let force = action.force * sign;
            let couple = (action.at - at).cross(force) + action.couple * sign;
            let (from, by) = (Origin::Reaction(pin), Some(roller));
            passed.push(Action { from, on: follower, by, at, force, couple });
        }
        actions.extend(passed);
    }

    /// The pair in which something acts.
    #[must_use]
    pub fn pair_of(&self, from: Origin) -> Option<PairId> {
        match from {
            Origin::Reaction(slot) => {
                let joint = self.plan.reactions.get(slot)?.joint;
                Some(self.structure.replaced.joint(joint).pair)
            }
            Origin::Law(slot) => self.plan.laws.get(slot).map(|law| law.pair),
            Origin::Friction(i) => self.plan.friction.get(i).map(|element| element.pair),
            // the efforts of stops are the last loads
            Origin::Load(load) => {
                let stops = &self.mechanism.stops;
                let first = self.mechanism.loads.len() - stops.len();
                load.index().checked_sub(first).map(|stop| stops[stop].pair)
            }
            Origin::Weight | Origin::Inertia | Origin::Spring(_) | Origin::Effort(_) => None,
        }
    }
}
