//! Reactions of a dyad RRP: the link about its inner hinge, the group along the guide, then across it.

use crate::angle::Angle;
use crate::course::{Course, joined};
use crate::document::text;
use crate::motion::{across, pin, unknown};
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_position::plan::{Guide, Hinge, Inner};

impl Course<'_> {
    /// The direction of a guide of forces, and the unit vector.
    pub(super) fn way(&self, guide: &Guide) -> (Angle, Vec2) {
        let own = self.direction_given(guide.direction, || Name::new("λ′", &self.label(guide.slider)));
        let angle = self.bodies[guide.slider].as_ref().map_or(own.clone(), |b| b.angle.plus(&own));
        (angle, guide.direction.turned(self.moved(guide.slider).u))
    }

    pub(super) fn force_rrp(&mut self, outer: &Hinge, inner: &Inner, guide: &Guide) {
        [outer.body, guide.body].into_iter().for_each(|b| self.complete(b));
        let bodies = [outer.body, guide.body];
        let (from, end) = (pin(&outer.pin), inner.pin);
        let at = pin(&inner.second_pin);
        self.say(Message::Determinate, &[]);
        let (name, tangential) = self.tangential(outer, end);
        let psi = self.line_of(outer.body, from, end).1;
        let (way, d) = self.way(guide);
        let points = [self.point_name(outer.body, from), self.point_name(outer.body, end)];
        let normal_name = self.reaction_name(guide.base, guide.body);
        let mut terms = Vec::new();
        let line = vec![text(format!("∥ {}", joined(&points[0], &points[1])))];
        terms.push(self.term("", name.marked("n"), unknown(), line));
        if !tangential.is_zero() {
            let size = crate::course::cell(&tangential);
            terms.push(self.term(
                "+",
                name.marked(self.language.letters().tangential),
                size,
                across(&points[0], &points[1]),
            ));
        }
        terms.extend(self.known_terms(&bodies));
        let perpendicular = vec![text(format!("⊥ {}", self.words(Message::Guide)))];
        terms.push(self.term("+", normal_name.clone(), unknown(), perpendicular));
        self.polygon_closes(terms);
        let q = self.sum_of(&bodies);
        let lean = psi.minus(&way);
        let along = (end - from).turned(self.moved(outer.body).u);
        let value = self.state().forces.reactions[outer.slot].force.dot(along) / along.norm();
        self.say(Message::SumAlongGuide, &[]);
        let top = tangential.clone() * lean.sin() - way.along(&q);
        let normal = self.equate(name.marked("n"), value, Unit::Force, top / lean.cos());
        let value = self.state().forces.reactions[outer.slot].force;
        let right = [
            normal.clone() * psi.cos() - tangential.clone() * psi.sin(),
            normal.clone() * psi.sin() + tangential.clone() * psi.cos(),
        ];
        let parts = self.reaction(outer.base, outer.body, value, right);
        self.say(Message::SumAcrossGuide, &[]);
        let right = -(normal * lean.sin() + tangential * lean.cos() + way.across(&q));
        let (across, couple) = self.guide_reaction(guide, right, d, at);
        self.inner_pair(inner, bodies, &parts);
        let place = self.moved(outer.body).position(from);
        self.carry(outer.base, outer.body, place, &parts, &Expr::ZERO, outer.slot);
        self.carry_guide(guide, &way, &across, &couple, at);
    }

    /// The normal force of a guide and its couple about a point of the body, from the moments about it.
    pub(super) fn guide_reaction(&mut self, guide: &Guide, normal: Expr, d: Vec2, at: Vec2) -> (Expr, Expr) {
        let name = self.reaction_name(guide.base, guide.body);
        let reaction = self.state().forces.reactions[guide.slot];
        let value = d.perp().dot(reaction.force);
        let across = self.equate(name.clone(), value, Unit::Force, normal);
        let moment = self.moment_about(guide.body, at);
        let couple = -moment;
        let point = self.point_name(guide.body, at);
        let reference = self.moved(guide.slider).position(guide.point);
        let place = self.moved(guide.body).position(at);
        let about = reaction.couple + (reference - place).cross(reaction.force);
        if couple.is_zero() {
            self.say(Message::ThroughPoint, &[vec![text(point)], crate::motion::of(&name)]);
            return (across, Expr::ZERO);
        }
        let letters = Name::new("M", &name.sub);
        self.say(Message::CoupleOfGuide, &[vec![text(point)], crate::motion::of(&letters)]);
        let couple = self.equate(letters, about, Unit::Torque, couple);
        (across, couple)
    }

    /// Keeps the reaction of a guide at a point of the body that it acts on.
    pub(super) fn carry_guide(&mut self, guide: &Guide, way: &Angle, normal: &Expr, couple: &Expr, at: Vec2) {
        let place = self.moved(guide.body).position(at);
        let parts = [-(normal.clone() * way.sin()), normal.clone() * way.cos()];
        self.carry(guide.base, guide.body, place, &parts, couple, guide.slot);
    }
}
