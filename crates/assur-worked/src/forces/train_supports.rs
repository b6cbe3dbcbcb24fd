//! What transmissions do to other bodies, and the reactions of the bearings of a train.

use super::Couple;
use super::train::{body_of, scale_of};
use crate::angle::Angle;
use crate::course::{Derivation, joined};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Function, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::Meeting;
use assur_position::plan::{Guide, LawSite, PlannedLaw, TrainSupport};
use assur_position::position::{Action, Origin};

impl Derivation<'_> {
    /// What a transmission does: couples on bodies of other groups, forces on all whose place is known.
    pub(super) fn pass_on(&mut self, slot: usize, force: &Expr, members: &[TrainSupport]) {
        let law = self.scene.model.plan.laws[slot].clone();
        let pair = self.scene.mechanism().pair(law.pair).name.clone();
        let outside = |body: usize| body != 0 && !members.iter().any(|m| body_of(m) == body);
        if let Some(meeting) = law.meeting {
            self.teeth(slot, &law, &meeting, force, &outside);
            return;
        }
        for (term, (site, c)) in law.terms.iter().enumerate() {
            let value = c / scale_of(law.force);
            match site {
                LawSite::Turn(body) if outside(*body) => {
                    let lever = self.side_lever(slot, &law, term, *body);
                    let (value, from) = (force.clone() * lever, Some(Origin::Law(slot)));
                    self.free.couples[*body].push(Couple { value, from });
                }
                LawSite::Slide(guide) => {
                    let lever = self.lever(value, &pair, &self.label(guide.slider), false);
                    let size = force.clone() * self.side(slot, term) * lever;
                    self.along_slide(slot, &Name::new("F", &pair), guide, &size);
                }
                LawSite::Turn(_) => {}
            }
        }
    }

    /// The couple of a transmission on one of its shafts.
    pub(crate) fn couple_of_law(&mut self, slot: usize, body: usize) -> Option<Expr> {
        let law = self.scene.model.plan.laws[slot].clone();
        let force = self.found.get(&self.law_name(slot).0).cloned()?;
        let is_there = |(site, _): &(LawSite, f64)| matches!(site, LawSite::Turn(b) if *b == body);
        let term = law.terms.iter().position(is_there)?;
        Some(force * self.side_lever(slot, &law, term, body))
    }

    /// The lever of a side of a law with what is left of its force; of the carrier that of both sides.
    fn side_lever(&self, slot: usize, law: &PlannedLaw, term: usize, body: usize) -> Expr {
        let pair = &self.scene.mechanism().pair(law.pair).name;
        let scale = scale_of(law.force);
        let sides = self.state().forces.law_forces[slot].sides;
        if term < 2 || sides == [1.0, 1.0] {
            let plain = self.lever(law.terms[term].1 / scale, pair, &self.label(body), true);
            return if term < 2 { self.side(slot, term) * plain } else { plain };
        }
        let both = [0, 1].map(|i| {
            let body = match &law.terms[i].0 {
                LawSite::Turn(body) => *body,
                LawSite::Slide(guide) => guide.slider,
            };
            let turns = matches!(law.terms[i].0, LawSite::Turn(_));
            self.side(slot, i) * self.lever(law.terms[i].1 / scale, pair, &self.label(body), turns)
        });
        let [a, b] = both;
        if law.counts_from_carrier(1) { -(a + b) } else { -a }
    }

    /// A force along a guide, on its slider and back on its base.
    pub(super) fn along_slide(&mut self, slot: usize, name: &Name, guide: &Guide, size: &Expr) {
        let (way, _) = self.way(guide);
        let at = self.moved(guide.slider).position(guide.point);
        let other = if guide.slider == guide.body { guide.base } else { guide.body };
        let parts = [size.clone() * way.cos(), size.clone() * way.sin()];
        self.push_pair(slot, [guide.slider, other], at, name, &parts);
    }

    /// The force of a law on one body by another.
    fn push_pair(&mut self, slot: usize, [on, by]: [usize; 2], at: Vec2, name: &Name, parts: &[Expr; 2]) {
        if !parts.iter().all(Expr::is_zero) {
            let (from, force) = (Origin::Law(slot), Vec2::zero());
            let action = Action { from, on, by: Some(by), at, force, couple: 0.0 };
            self.put_force(&action, name, parts, &[Vec::new(), Vec::new()]);
        }
    }

    /// The force between teeth whose place is known: tangential at the pitch point, and the part that presses the wheels apart.
    fn teeth(
        &mut self,
        slot: usize,
        law: &PlannedLaw,
        meeting: &Meeting,
        force: &Expr,
        outside: &dyn Fn(usize) -> bool,
    ) {
        let pair = self.scene.mechanism().pair(law.pair).name.clone();
        let slots = meeting.links.map(|l| l.index());
        let (place, value) = self.state().meeting_force(law, slot, meeting);
        let sides = self.state().forces.law_forces[slot].sides;
        let through = usize::from(sides[1].abs() < sides[0].abs());
        let tangential = force.clone() * self.side(slot, through);
        let [one, two] = [0, 1].map(|i| self.moved(slots[i]).position(meeting.centres[i]));
        let between = two - one;
        let [r_1, r_2] = meeting.radii;
        let inside = meeting.internal && r_1 < r_2;
        let towards = between * (if inside { -1.0 } else { 1.0 } / between.norm());
        let fixed = slots.iter().enumerate().all(|(i, body)| self.on_ground_at(*body, meeting.centres[i]));
        let direction = if fixed {
            self.direction_given(towards, || Name::new("δ", &pair))
        } else {
            let [a, b] = [0, 1].map(|i| self.position(slots[i], meeting.centres[i]));
            let [a, b] = if inside { [b, a] } else { [a, b] };
            let [x, y] = a;
            let d = [b[0].clone() - x, b[1].clone() - y];
            let names = [0, 1].map(|i| self.point_name(slots[i], meeting.centres[i]));
            Angle::of(self.direction_of(Name::new("δ", &pair), &d, &joined(&names[0], &names[1])))
        };
        let mut parts = [-(tangential.clone() * direction.sin()), tangential.clone() * direction.cos()];
        if meeting.tangent != 0.0 {
            self.say(Message::TeethPress, &[vec![text(pair.clone())]]);
            let name = Name::new("F", &format!("r,{pair}"));
            let angle =
                self.given(Name::new("α", &pair), libm::atan(meeting.tangent).to_degrees(), Unit::Angle);
            let radial = value.dot(towards);
            let right = tangential.clone() * angle.of(Function::Tan);
            let right = if radial * right.value() < 0.0 { -right } else { right };
            let radial = self.equate(name, radial, Unit::Force, right);
            let [x, y] = parts;
            parts = [x + radial.clone() * direction.cos(), y + radial * direction.sin()];
        }
        let parts = [
            self.component(Name::new("F", &format!("{pair}x")), value.x, Unit::Force, parts[0].clone()),
            self.component(Name::new("F", &format!("{pair}y")), value.y, Unit::Force, parts[1].clone()),
        ];
        let name = Name::new("F", &pair);
        self.push_pair(slot, slots, place, &name, &parts);
        self.lost_in_teeth(slot, law, force, through, outside);
    }

    /// Losses act as couples in the bearings of the side that drives.
    fn lost_in_teeth(
        &mut self,
        slot: usize,
        law: &PlannedLaw,
        force: &Expr,
        through: usize,
        outside: &dyn Fn(usize) -> bool,
    ) {
        if self.state().forces.law_forces[slot].sides == [1.0, 1.0] {
            return;
        }
        let mut back = Expr::ZERO;
        for term in [0, 1] {
            let LawSite::Turn(body) = law.terms[term].0 else { continue };
            let more = self.side(slot, term) - self.side(slot, through);
            if more.is_zero() {
                continue;
            }
            let pair = &self.scene.mechanism().pair(law.pair).name;
            let lever = self.lever(law.terms[term].1 / scale_of(law.force), pair, &self.label(body), true);
            let value = force.clone() * lever * more;
            back = back - value.clone();
            if outside(body) {
                self.free.couples[body].push(Couple { value, from: Some(Origin::Law(slot)) });
            }
        }
        if let Some((LawSite::Turn(carrier), _)) = law.terms.get(2)
            && outside(*carrier)
        {
            self.free.couples[*carrier].push(Couple { value: back, from: Some(Origin::Law(slot)) });
        }
    }

    /// The reactions of bearings, the last of the members first: all forces on a member together with it are nothing.
    pub(super) fn supports(&mut self, members: &[TrainSupport]) {
        let mut said = false;
        for member in members.iter().rev() {
            let (body, base, slot) = match member {
                TrainSupport::Turn(hinge, _) => (hinge.body, hinge.base, hinge.slot),
                TrainSupport::Shift(guide, _) => (guide.body, guide.base, guide.slot),
            };
            let reaction = self.state().forces.reactions[slot];
            let parts = [0, 1].map(|i| Expr::sum(self.free.forces[body].iter().map(|f| f.parts[i].clone())));
            if parts.iter().all(Expr::is_zero) {
                continue;
            }
            if let TrainSupport::Shift(guide, _) = member {
                let (way, d) = self.way(guide);
                let across = way.across(&parts);
                if !across.is_zero() {
                    let place = self.moved(guide.slider).position(guide.point);
                    let moved = self.moved(body);
                    let at = (place - moved.p).turned_back(moved.u);
                    let (normal, couple) = self.guide_reaction(guide, -across, d, at);
                    self.carry_guide(guide, &way, &normal, &couple, at);
                }
                continue;
            }
            let pair = self.structure().replaced.joint(self.scene.model.plan.reactions[slot].joint).pair;
            if self.unplaced[pair.index()] && base == 0 {
                // where its bearing stands is not known, and nothing else depends on it
                continue;
            }
            if !said {
                self.say(Message::BearingsOf, &[]);
                said = true;
            }
            let found = self.reaction_in_sums([base, body], reaction.force, parts.map(|p| -p), body);
            self.carry(slot, &found, &Expr::ZERO);
        }
    }
}
