//! Reactions of a dyad RPR: the slider about its hinge, both links about the other hinge.

use crate::course::{Derivation, joined};
use crate::document::text;
use crate::motion::pin;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_position::plan::{Guide, Hinge};

impl Derivation<'_> {
    pub(super) fn force_rpr(&mut self, outer: &[Hinge; 2], guide: &Guide) {
        [outer[0].body, outer[1].body].into_iter().for_each(|b| self.complete(b));
        let [one, two] = outer;
        let pins = [pin(&one.pin), pin(&two.pin)];
        let labels = [self.label(one.body), self.label(two.body)];
        let (way, d) = self.way(guide);
        self.say_once(Message::Determinate);
        let point = self.point_name(two.body, pins[1]);
        let begun = self.blocks.len();
        let second = self.moment_about(two.body, pins[1]);
        let sign = if guide.body == two.body { 1.0 } else { -1.0 };
        let reaction = self.state().forces.reactions[guide.slot];
        let b = self.moved(two.body).position(pins[1]);
        let reference = self.moved(guide.slider).position(guide.point);
        let about = sign * (reaction.couple + (reference - b).cross(reaction.force));
        let name = self.reaction_name(one.body, two.body);
        let couple = if second.is_zero() {
            self.say(
                Message::ThroughPoint,
                &[vec![text(&*labels[1])], vec![text(&*point)], crate::motion::of(&name)],
            );
            Expr::ZERO
        } else {
            let letters = Name::new("M", &name.sub);
            self.couple_of_guide(begun, &letters, (two.body, pins[1]), two.body);
            let at = self.blocks.len();
            let found = self.equate(letters, about, Unit::Torque, -second.clone());
            self.balanced(at, &Name::new("ΣM", &point), &(second + found.clone()));
            found
        };
        let hinge = self.point_name(one.body, pins[0]);
        self.say(Message::MomentsOfLink, &[vec![text(&*labels[0])], vec![text(&*hinge)]]);
        let first = self.moment_about(one.body, pins[0]);
        let distance = Name::new("s", &joined(&hinge, &point));
        let reverse = Name::new("s", &joined(&point, &hinge));
        let along = match self.found.get(&distance).or_else(|| self.found.get(&reverse)) {
            Some(along) => along.clone(),
            None => {
                let (a, b) = (self.position(one.body, pins[0]), self.position(two.body, pins[1]));
                let r = [b[0].clone() - a[0].clone(), b[1].clone() - a[1].clone()];
                let right = way.along(&r);
                let value = right.value();
                self.equate(distance, value, Unit::Length, right)
            }
        };
        // the guide's direction may be opposite to that in which the distance was counted
        let a = self.moved(one.body).position(pins[0]);
        let along = if (b - a).dot(d) * along.value() < 0.0 { -along } else { along };
        let value = sign * d.perp().dot(reaction.force);
        let at = self.blocks.len();
        let rest = first.clone() - couple.clone();
        let normal = self.equate(name, value, Unit::Force, rest.clone() / along.clone());
        self.balanced(at, &Name::new("ΣM", &hinge), &(rest - normal.clone() * along));
        let parts = [-(normal.clone() * way.sin()), normal.clone() * way.cos()];
        if (reference - a).norm() > self.tiny || !first.is_zero() {
            let name = self.reaction_name(one.body, two.body);
            self.couple_at_slider(
                guide,
                &name,
                &(normal, couple),
                (two.body, pins[1]),
                sign * reaction.couple,
            );
        }
        let named = [
            self.component(
                self.reaction_name(one.body, two.body).and("x"),
                sign * reaction.force.x,
                Unit::Force,
                parts[0].clone(),
            ),
            self.component(
                self.reaction_name(one.body, two.body).and("y"),
                sign * reaction.force.y,
                Unit::Force,
                parts[1].clone(),
            ),
        ];
        self.free.reactions[guide.slot] = Some(self.reaction_name(one.body, two.body));
        let mut found = Vec::new();
        for (hinge, of_guide) in [(one, named.clone()), (two, named.map(|p| -p))] {
            let message = [vec![text(self.label(hinge.body))]];
            self.say(Message::SumOfLink, &message);
            let value = self.state().forces.reactions[hinge.slot].force;
            let of = |i: usize| {
                let loads = Expr::sum(self.free.forces[hinge.body].iter().map(|f| f.parts[i].clone()));
                of_guide[i].clone() - loads
            };
            let right = [of(0), of(1)];
            found.push(self.reaction_in_sums([hinge.base, hinge.body], value, right, hinge.body));
        }
        for (hinge, parts) in [one, two].into_iter().zip(&found) {
            self.carry(hinge.slot, parts, &Expr::ZERO);
        }
    }
}
