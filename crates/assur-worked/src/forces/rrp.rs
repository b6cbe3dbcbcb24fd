//! Reactions of a dyad RRP: the link about its inner hinge, the group along the guide, then across it.

use super::sums::axes_of;
use crate::angle::Angle;
use crate::course::{Derivation, joined};
use crate::document::{Block, text};
use crate::motion::{across, of, pin, unknown};
use crate::words::{Message, say};
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::{FindKind, Query};
use assur_position::plan::{Guide, Hinge, Inner};

impl Derivation<'_> {
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
        self.say_once(Message::Determinate);
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
        let at_sum = self.blocks.len();
        let normal = self.equate(name.marked("n"), value, Unit::Force, top.clone() / lean.cos());
        let sum = normal.clone() * lean.cos() - top;
        self.balanced(at_sum, &Name::new("ΣF", axes_of(&way)[0]), &sum);
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
        self.carry(outer.slot, &parts, &Expr::ZERO);
        self.carry_guide(guide, &way, &across, &couple, at);
    }

    /// The normal force of a guide and its couple about a point of the body, from the moments about it.
    pub(super) fn guide_reaction(&mut self, guide: &Guide, normal: Expr, d: Vec2, at: Vec2) -> (Expr, Expr) {
        let name = self.reaction_name(guide.base, guide.body);
        let reaction = self.state().forces.reactions[guide.slot];
        let value = d.perp().dot(reaction.force);
        let begun = self.blocks.len();
        let across = self.equate_or_nothing(&name, value, Unit::Force, normal.clone());
        let axis = axes_of(&self.way(guide).0)[1];
        self.balanced(begun, &Name::new("ΣF", axis), &(across.clone() - normal));
        let begun = self.blocks.len();
        let moment = self.moment_about(guide.body, at);
        let couple = -moment.clone();
        let point = self.point_name(guide.body, at);
        let reference = self.moved(guide.slider).position(guide.point);
        let place = self.moved(guide.body).position(at);
        let about = reaction.couple + (reference - place).cross(reaction.force);
        if couple.is_zero() {
            if !across.is_zero() {
                let label = self.label(guide.body);
                self.say(Message::ThroughPoint, &[vec![text(label)], vec![text(point)], of(&name)]);
            }
            return (across, Expr::ZERO);
        }
        let letters = Name::new("M", &name.sub);
        self.couple_of_guide(begun, &letters, (guide.body, at), guide.body);
        let begun = self.blocks.len();
        let couple = self.equate(letters, about, Unit::Torque, couple);
        self.balanced(begun, &Name::new("ΣM", &point), &(moment + couple.clone()));
        self.line_of_guide(&name, &across, &couple, &point);
        let own = (across.clone(), couple.clone());
        self.couple_at_slider(guide, &name, &own, (guide.body, at), reaction.couple);
        (across, couple)
    }

    /// Says that a guide holds a link by a couple, before the moments about a point of a body which give it.
    pub(super) fn couple_of_guide(
        &mut self,
        before: usize,
        letters: &Name,
        (body, at): (usize, Vec2),
        held: usize,
    ) {
        let [point, held, freed] = [self.point_name(body, at), self.label(held), self.label(body)];
        let parts = [vec![text(point)], of(letters), vec![text(held)], vec![text(freed)]];
        let line = say(self.language, Message::CoupleOfGuide, &parts);
        self.insert(before, vec![Block::Paragraph(line)]);
    }

    /// Force and couple of a guide as one force at a distance from a point.
    fn line_of_guide(&mut self, name: &Name, normal: &Expr, couple: &Expr, point: &str) {
        let nothing = |x: &Expr| matches!(x, Expr::Leaf(q) if q.is_nothing());
        if normal.is_zero() || nothing(normal) || nothing(couple) {
            return;
        }
        self.say(Message::InertiaArm, &[of(name), vec![text(point)]]);
        let right = couple.clone().abs() / normal.clone().abs();
        let value = right.value();
        self.equate(Name::new("h", &name.sub), value, Unit::Length, right);
    }

    /// The couple of a guide about the point of its slider, from that about another point: where the file asks for reactions or for it.
    pub(super) fn couple_at_slider(
        &mut self,
        guide: &Guide,
        name: &Name,
        (normal, couple): &(Expr, Expr),
        (body, at): (usize, Vec2),
        value: f64,
    ) {
        let place = self.moved(guide.slider).position(guide.point);
        let from = self.moved(body).position(at);
        if (place - from).norm() <= self.tiny || !self.asks_for_couple(guide) {
            return;
        }
        let (point, other) = (self.point_name(guide.slider, guide.point), self.point_name(body, at));
        let (way, d) = self.way(guide);
        self.say(Message::CoupleAtSlider, &[vec![text(&*point)]]);
        let (a, b) = (self.position(body, at), self.position(guide.slider, guide.point));
        let right = way.along(&[b[0].clone() - a[0].clone(), b[1].clone() - a[1].clone()]);
        let along = Name::new("s", &joined(&other, &point));
        let along = self.component(along, d.dot(place - from), Unit::Length, right);
        let right = couple.clone() - along * normal.clone();
        self.equate(Name::new("M", &name.sub).marked(&point), value, Unit::Torque, right);
    }

    /// Whether the file asks for all reactions or for the couple of a guide.
    fn asks_for_couple(&self, guide: &Guide) -> bool {
        let mechanism = self.scene.mechanism();
        let joint = self.scene.model.plan.reactions[guide.slot].joint;
        let pair = self.structure().replaced.joint(joint).pair;
        let mut asked = false;
        for find in &mechanism.finds {
            match &find.kind {
                FindKind::Reactions => return true,
                FindKind::Value { expr, .. } => mechanism.each_query(expr, &mut |query| {
                    asked |=
                        matches!(query, Query::Moment(own, _) | Query::ContactForce(own, _) if *own == pair);
                }),
                FindKind::Table(_) => {}
            }
        }
        asked
    }

    /// Keeps the reaction of a guide at a point of the body that it acts on.
    pub(super) fn carry_guide(&mut self, guide: &Guide, way: &Angle, normal: &Expr, couple: &Expr, at: Vec2) {
        let parts = [-(normal.clone() * way.sin()), normal.clone() * way.cos()];
        self.carry_at(self.moved(guide.body).position(at), guide.slot, &parts, couple);
    }
}
