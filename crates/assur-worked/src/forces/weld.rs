//! Welded links: bodies bear what acts on their parts, and each weld follows from the equilibrium of the part that it carries.

use super::free_body::{Couple, Force, is_load};
use crate::course::{Derivation, cell};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Name, Unit};
use assur_math::math::Vec2;
use assur_model::structure::Group;
use assur_position::plan::PlannedWeld;
use assur_position::position::{Action, Origin};

impl Derivation<'_> {
    /// Does something while the bodies of a group have the forces and couples of their parts.
    pub(super) fn with_parts<T>(&mut self, group: &Group, work: impl FnOnce(&mut Self) -> T) -> T {
        let mut borne = Vec::new();
        for &body in &group.bodies {
            let before = [self.free.forces[body.0].len(), self.free.couples[body.0].len()];
            for part in self.structure().replaced.links_of(body).into_iter().skip(1) {
                self.bear(part.index(), body.0);
            }
            borne.push((body.0, before, [self.free.forces[body.0].len(), self.free.couples[body.0].len()]));
        }
        let done = work(self);
        for (body, before, after) in borne {
            self.free.forces[body].drain(before[0]..after[0]);
            self.free.couples[body].drain(before[1]..after[1]);
        }
        done
    }

    fn bear(&mut self, part: usize, body: usize) {
        let (there, here) = (*self.moved(part), *self.moved(body));
        for force in self.free.forces[part].clone() {
            let at = (there.position(force.at) - here.p).turned_back(here.u);
            self.free.forces[body].push(Force { at, ..force });
        }
        let couples = self.free.couples[part].clone();
        self.free.couples[body].extend(couples);
    }

    /// The force and the couple of every weld, those first on which nothing hangs any more.
    pub(super) fn welds(&mut self) {
        let welds = self.scene.model.plan.welds.iter().rev();
        welds.for_each(|weld| self.weld(weld));
    }

    fn weld(&mut self, weld: &PlannedWeld) {
        let (body, at) = (weld.part.body, weld.part.at);
        let label = self.label(body);
        let words = crate::words::say(self.language, Message::LinkOf, &[vec![text(&*label)]]);
        self.heading(3, crate::course::plain(&words));
        self.complete(body);
        let pair = self.structure().replaced.joint(self.scene.model.plan.reactions[weld.slot].joint).pair;
        let point = self.scene.mechanism().pair(pair).name.clone();
        self.say(Message::WeldHolds, &[vec![text(&*label)], vec![text(point)]]);
        for action in self.scene.view().actions(&[body]) {
            if action.from != Origin::Reaction(weld.slot) {
                self.known_on(body, &action);
            }
        }
        let [x, y] = self.sum_of(&[body]);
        let moment = self.moment_about(body, at);
        let found = self.state().forces.reactions[weld.slot];
        let parts = self.reaction_in_sums([weld.base, body], found.force, [-x, -y], body);
        let name = self.reaction_name(weld.base, body);
        let begun = self.blocks.len();
        let couple = self.equate(Name::new("M", &name.sub), found.couple, Unit::Torque, -moment.clone());
        self.balanced(begun, &Name::new("ΣM", &self.point_name(body, at)), &(moment + couple.clone()));
        self.carry(weld.slot, &parts, &couple);
    }

    /// Puts what is found to act on a part among its forces and couples, unless it is there.
    fn known_on(&mut self, body: usize, action: &Action) {
        let listed = |from: Option<Origin>| from == Some(action.from);
        let there = self.free.forces[body].iter().any(|f| listed(f.from))
            || self.free.couples[body].iter().any(|c| listed(c.from));
        if there || is_load(Some(action.from), false) {
            return;
        }
        let (force, couple, back) = match action.from {
            Origin::Effort(slot) => {
                let name = self.effort_name(slot, action.force != Vec2::zero());
                (name.clone(), name, None)
            }
            _ => {
                let by = action.by.map_or(0, |by| self.body_of(by));
                let name = self.reaction_name(by, self.body_of(body));
                (name.clone(), Name::new("M", &name.sub), Some(self.reaction_name(self.body_of(body), by)))
            }
        };
        let from = Some(action.from);
        if action.force != Vec2::zero() {
            let parts = [(action.force.x, "x"), (action.force.y, "y")].map(|(value, axis)| {
                let opposite = back.as_ref().and_then(|back| self.found.get(&back.and(axis))).cloned();
                let small = 1e-9 * action.force.norm();
                match opposite.filter(|found| (found.value() + value).abs() <= small) {
                    Some(found) => -found,
                    None => self.stated_of(force.and(axis), value, Unit::Force, action.force.norm()),
                }
            });
            let moved = self.moved(body);
            let at = (action.at - moved.p).turned_back(moved.u);
            let size = self.found.get(&force).map(cell).unwrap_or_default();
            let known = [size, vec![text("–")]];
            self.free.forces[body].push(Force { name: force, at, parts, known, from });
        }
        if action.couple != 0.0 {
            let value = self.stated(couple, action.couple, Unit::Torque);
            self.free.couples[body].push(Couple { value, from });
        }
    }
}
