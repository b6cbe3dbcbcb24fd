//! Angles of wheels and coordinates of what ropes, racks and screws move: the laws of their transmissions, from one place to the other.

use super::{of, pin};
use crate::angle::Angle;
use crate::course::{Body, Derivation};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::structure::{BodyRate, JointId, JointKind};
use assur_position::plan::{Slide, TrainMember};

/// Coordinates that are found: angles in degrees with their whole turns, distances in m.
type Places = Vec<(BodyRate, Expr)>;

impl Derivation<'_> {
    /// The members of a train where something needs their places.
    pub(super) fn train_places(&mut self, index: usize, train: usize) {
        self.say_once(Message::TrainPlaces);
        let before = self.blocks.len();
        let members = self.scene.model.plan.trains[train].members.clone();
        let laws = self.structure().motion[index].laws.clone();
        let places = self.places_by_laws(&laws, &members);
        for member in &members {
            match member {
                TrainMember::Turn { body, pin: arm, .. } => self.turned_member(*body, pin(arm), &places),
                TrainMember::Shift(slide) => self.shifted_member(slide, &places),
            }
        }
        self.optional.extend(before..self.blocks.len());
    }

    fn turned_member(&mut self, body: usize, reference: Vec2, places: &Places) {
        let found = places.iter().find(|(rate, _)| matches!(rate, BodyRate::Turn(b) if b.0 == body));
        let angle = match found {
            Some((_, angle)) => angle.clone(),
            None => {
                let u = self.moved(body).u;
                let degrees = libm::atan2(u.y, u.x).to_degrees();
                self.stated(Name::new("φ", &self.label(body)), degrees, Unit::Angle)
            }
        };
        let rates = [Expr::ZERO, Expr::ZERO];
        self.bodies[body] = Some(Body { reference, angle: Angle::of(angle), rates });
    }

    fn shifted_member(&mut self, slide: &Slide, places: &Places) {
        let moves = |joint: &JointId| {
            self.structure().replaced.joint(*joint).bodies().iter().any(|b| b.0 == slide.body)
        };
        let found = places.iter().find(|(rate, _)| matches!(rate, BodyRate::Slide(joint) if moves(joint)));
        if let Some((_, along)) = found {
            let along = if slide.sense < 0.0 { -along.clone() } else { along.clone() };
            let guide = self.guide(slide);
            let [x, y] = self.position(slide.base, slide.origin);
            let right = [x + along.clone() * guide.cos(), y + along * guide.sin()];
            let point = self.point_name(slide.body, slide.point);
            let value = self.moved(slide.body).position(slide.point);
            self.coordinates(&point, value, right);
        }
        self.slider(slide, slide.point);
    }

    /// Law by law, and pairs of laws by elimination.
    fn places_by_laws(&mut self, laws: &[JointId], members: &[TrainMember]) -> Places {
        let mut places = Places::new();
        let mut sought = self.sought_by(laws, members);
        let mut open = laws.to_vec();
        loop {
            if let Some(at) = open.iter().position(|law| self.sought_in(*law, &sought).len() == 1) {
                let law = open.remove(at);
                let Some(rate) = self.sought_in(law, &sought).pop() else { break };
                let found = self.place_by_law(law, rate, &places);
                sought.retain(|r| *r != rate);
                places.push((rate, found));
            } else if let Some((pair, rates)) = self.two_laws(&open, &sought) {
                let Some(found) = self.place_by_two(pair, rates, &places) else { break };
                open.retain(|law| *law != pair[1]);
                sought.retain(|r| *r != rates[1]);
                places.push((rates[1], found));
            } else {
                break;
            }
        }
        places
    }

    fn place_by_law(&mut self, law: JointId, rate: BodyRate, places: &Places) -> Expr {
        let terms = self.terms_of(law);
        let Some(own) = terms.iter().position(|(r, _)| *r == rate) else { return Expr::ZERO };
        let rest = self.rest_of_law(law, &[rate], places);
        let factor = self.factors(law)[own].clone();
        let turns = matches!(rate, BodyRate::Turn(_));
        let right = if turns && self.has_ways(law) {
            -(Expr::Int(180) * rest / (Expr::Pi * factor))
        } else {
            -(rest / factor)
        };
        let name = self.pair_name(law);
        self.place(rate, right, Message::LawOf, &name, None)
    }

    /// The second of two angles of two laws.
    fn place_by_two(&mut self, laws: [JointId; 2], rates: [BodyRate; 2], places: &Places) -> Option<Expr> {
        if laws.iter().any(|law| self.has_ways(*law)) {
            return None;
        }
        let rests = laws.map(|law| self.rest_of_law(law, &rates, places));
        let right = self.without_first(laws, rates, rests).unwrap_or(Expr::ZERO);
        let names = laws.map(|law| self.pair_name(law)).join(", ");
        let without = self.named_place(rates[0]).0;
        Some(self.place(rates[1], right, Message::Eliminated, &names, Some(&without)))
    }

    /// Writes a place; the sentence stays where the equation does.
    fn place(
        &mut self,
        rate: BodyRate,
        right: Expr,
        said: Message,
        by: &str,
        without: Option<&Name>,
    ) -> Expr {
        if right.is_zero() {
            return Expr::ZERO;
        }
        let (name, value, unit) = self.named_place(rate);
        self.lines.push((self.blocks.len(), name.clone()));
        let mut parts = vec![vec![text(by)]];
        parts.extend(without.map(of));
        parts.push(of(&name));
        self.say(said, &parts);
        self.equate(name, value, unit, right)
    }

    /// What a law's other coordinates and its phase add up to.
    fn rest_of_law(&mut self, law: JointId, without: &[BodyRate], places: &Places) -> Expr {
        let (factors, mixed) = (self.factors(law), self.has_ways(law));
        let mut rest = Expr::ZERO;
        for ((rate, _), factor) in self.terms_of(law).into_iter().zip(&factors) {
            if without.contains(&rate) {
                continue;
            }
            let mut place = match places.iter().find(|(r, _)| *r == rate) {
                Some((_, found)) => found.clone(),
                None => self.known_place(rate),
            };
            if mixed && matches!(rate, BodyRate::Turn(_)) {
                place = Expr::Pi * place / Expr::Int(180);
            }
            rest = rest + factor.clone() * place;
        }
        let before = &self.structure().replaced.joints[..law.0];
        let slot = before.iter().filter(|j| matches!(j.kind, JointKind::Law(_))).count();
        let constant = self.scene.model.plan.laws[slot].constant;
        if let (Some(factor), Some((_, c))) = (factors.get(1), self.terms_of(law).get(1)) {
            let phase = (constant / c).to_degrees();
            rest = rest - factor.clone() * self.given(self.phase_name(law), phase, Unit::Angle);
        }
        rest
    }

    fn phase_name(&self, law: JointId) -> Name {
        Name::new("φ", &format!("0,{}", self.pair_name(law)))
    }

    /// The place of what is not of the train, with its whole turns.
    fn known_place(&mut self, rate: BodyRate) -> Expr {
        match rate {
            BodyRate::Turn(body) if body.0 == 0 => Expr::ZERO,
            BodyRate::Turn(body) => {
                let angle = self.bodies[body.0].as_ref().map_or(Expr::ZERO, |b| b.angle.whole());
                let turns = ((self.moved(body.0).turned.to_degrees() - angle.value()) / 360.0).round();
                angle + Expr::Degrees(360 * turns as i64)
            }
            BodyRate::Slide(_) => {
                let (name, value, unit) = self.named_place(rate);
                match self.found.get(&name) {
                    Some(found) => found.clone(),
                    None => self.stated(name, value, unit),
                }
            }
        }
    }

    /// The letters, value and unit of a coordinate.
    fn named_place(&self, rate: BodyRate) -> (Name, f64, Unit) {
        match rate {
            BodyRate::Turn(body) => {
                let name = Name::new("φ", &self.label(body.0));
                (name, self.moved(body.0).turned.to_degrees(), Unit::Angle)
            }
            BodyRate::Slide(joint) => {
                let name = Name::new("s", &self.slide_index(joint));
                let value = match self.structure().replaced.joint(joint).kind {
                    JointKind::Prismatic { slider, point, guide, through, along, .. } => {
                        let base = self.moved(guide.0);
                        let from = self.moved(slider.0).position(point) - base.position(through);
                        from.dot(along.turned(base.u))
                    }
                    _ => f64::NAN,
                };
                (name, value, Unit::Length)
            }
        }
    }

    /// Whether a law has distances beside angles.
    fn has_ways(&self, law: JointId) -> bool {
        self.terms_of(law).iter().any(|(rate, _)| matches!(rate, BodyRate::Slide(_)))
    }

    fn pair_name(&self, law: JointId) -> String {
        let pair = self.structure().replaced.joint(law).pair;
        self.scene.mechanism().pair(pair).name.clone()
    }
}
