//! Reactions of a dyad RPP: the second body along and across its guides, the first about its hinge.

use super::sums::axes_of;
use crate::course::Derivation;
use crate::document::text;
use crate::motion::{of, pin};
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_position::plan::{Guide, Hinge};
use assur_position::position::{Action, Origin};

impl Derivation<'_> {
    pub(super) fn force_rpp(&mut self, outer: &Hinge, inner: &Guide, guide: &Guide) {
        [outer.body, guide.body].into_iter().for_each(|b| self.complete(b));
        let (one, two) = (outer.body, guide.body);
        let hinge = pin(&outer.pin);
        let (line, d_1) = self.way(inner);
        let (way, d_2) = self.way(guide);
        let at = (self.moved(guide.slider).position(guide.point) - self.moved(two).p)
            .turned_back(self.moved(two).u);
        self.say_once(Message::Determinate);
        let sums = self.sum_of(&[two]);
        let sine = way.minus(&line).sin();
        let sign = if inner.body == two { 1.0 } else { -1.0 };
        let between = self.state().forces.reactions[inner.slot];
        let name = self.reaction_name(one, two);
        self.say(Message::SumAlongGuide, &[]);
        let value = sign * d_1.perp().dot(between.force);
        let at_sum = self.blocks.len();
        let loads = way.along(&sums);
        let normal = self.equate(name.clone(), value, Unit::Force, -(loads.clone() / sine.clone()));
        self.balanced(at_sum, &Name::new("ΣF", axes_of(&way)[0]), &(loads + normal.clone() * sine));
        let point = self.point_name(one, hinge);
        let begun = self.blocks.len();
        let moment = self.moment_about(one, hinge);
        let place = self.moved(one).position(hinge);
        let reference = self.moved(inner.slider).position(inner.point);
        let about = sign * (between.couple + (reference - place).cross(between.force));
        let couple = if moment.is_zero() {
            self.say(Message::ThroughPoint, &[vec![text(self.label(one))], vec![text(point)], of(&name)]);
            Expr::ZERO
        } else {
            let letters = Name::new("M", &name.sub);
            self.couple_of_guide(begun, &letters, (one, hinge), two);
            let at = self.blocks.len();
            let found = self.equate(letters, about, Unit::Torque, moment.clone());
            self.balanced(at, &Name::new("ΣM", &point), &(moment - found.clone()));
            found
        };
        self.free.reactions[inner.slot] = Some(name);
        let parts = [-(normal.clone() * line.sin()), normal * line.cos()];
        // on the second body: through the hinge of the first
        let (from, force) = (Origin::Reaction(inner.slot), between.force);
        let action = Action { from, on: two, by: None, at: place, force, couple: between.couple };
        let name = self.reaction_name(one, two);
        self.put_force(&action, &name, &parts, &[Vec::new(), Vec::new()]);
        if !couple.is_zero() {
            self.put_couple(&action, &couple);
        }
        self.say(Message::SumAcrossGuide, &[]);
        let total = [sums[0].clone() + parts[0].clone(), sums[1].clone() + parts[1].clone()];
        let (across, turned) = self.guide_reaction(guide, -way.across(&total), d_2, at);
        self.carry_guide(guide, &way, &across, &turned, at);
        self.say(Message::SumOfLink, &[vec![text(self.label(one))]]);
        let value = self.state().forces.reactions[outer.slot].force;
        let right = [0, 1]
            .map(|i| parts[i].clone() - Expr::sum(self.free.forces[one].iter().map(|f| f.parts[i].clone())));
        let found = self.reaction_in_sums([outer.base, one], value, right, one);
        self.carry(outer.slot, &found, &Expr::ZERO);
    }
}
