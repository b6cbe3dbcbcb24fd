//! Losses of transmissions: the direction of the power decides on which side the efficiency stands.

use super::train::{body_of, scale_of};
use crate::course::Derivation;
use crate::document::{Line, text};
use crate::motion::of;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_position::plan::{LawSite, PlannedLaw, TrainSupport};

impl Derivation<'_> {
    /// What is left of the force of a transmission on one of its sides.
    pub(crate) fn side(&self, slot: usize, term: usize) -> Expr {
        let sides = self.state().forces.law_forces[slot].sides;
        let part = sides.get(term).copied().unwrap_or(1.0);
        if part == 1.0 {
            return Expr::Int(1);
        }
        let law = &self.scene.model.plan.laws[slot];
        // power that flows back has an efficiency of its own
        let back = term == 0 && law.efficiency.is_some_and(|[there, back]| there != back);
        let pair = &self.scene.mechanism().pair(law.pair).name;
        self.given(Name::new(if back { "η′" } else { "η" }, pair), part, Unit::One)
    }

    /// The coefficient of the force of a transmission in the equation of a member.
    pub(super) fn coefficient(
        &self,
        slot: usize,
        law: &PlannedLaw,
        member: &TrainSupport,
        plain: f64,
        turns: bool,
    ) -> Expr {
        let pair = &self.scene.mechanism().pair(law.pair).name;
        let body = body_of(member);
        let label = self.label(body);
        let scale = scale_of(law.force);
        let acts = |site: &LawSite| match (site, member) {
            (LawSite::Turn(own), TrainSupport::Turn(..)) => *own == body,
            (LawSite::Slide(guide), TrainSupport::Shift(..)) => guide.body == body || guide.slider == body,
            _ => false,
        };
        let term = law.terms.iter().position(|(site, _)| acts(site));
        let sides = self.state().forces.law_forces[slot].sides;
        if sides == [1.0, 1.0] || term.is_none() {
            return self.lever(plain / scale, pair, &label, turns);
        }
        let on_side = |i: usize| {
            let body = match &law.terms[i].0 {
                LawSite::Turn(body) => *body,
                LawSite::Slide(guide) => guide.slider,
            };
            let turns = matches!(law.terms[i].0, LawSite::Turn(_));
            self.side(slot, i) * self.lever(law.terms[i].1 / scale, pair, &self.label(body), turns)
        };
        match term {
            Some(2) if !law.counts_from_carrier(1) => -on_side(0),
            Some(2) => -(on_side(0) + on_side(1)),
            Some(term) => on_side(term),
            None => Expr::ZERO,
        }
    }

    /// In which direction power flows through transmissions with losses.
    pub(super) fn directions(&mut self, laws: &[usize]) {
        for &slot in laws {
            let law = self.scene.model.plan.laws[slot].clone();
            let sides = self.state().forces.law_forces[slot].sides;
            if sides == [1.0, 1.0] {
                continue;
            }
            let (from, to) = if sides[1] == 1.0 { (1, 0) } else { (0, 1) };
            let label = |i: usize| -> Line {
                let body = match &law.terms[i].0 {
                    LawSite::Turn(body) => *body,
                    LawSite::Slide(guide) => guide.slider,
                };
                // a wheel that stands on the ground has no member of its own
                vec![text(self.label(body))]
            };
            let pair = vec![text(self.scene.mechanism().pair(law.pair).name.clone())];
            let part = self.side(slot, to);
            let Expr::Leaf(q) = &part else { continue };
            self.say(Message::PowerFlows, &[pair, label(from), label(to), of(&q.name)]);
        }
    }

    /// Power that passes through every transmission, and what is lost of it.
    pub(super) fn lost_in_trains(&mut self) -> Vec<Expr> {
        let mut lost = Vec::new();
        for slot in 0..self.scene.model.plan.laws.len() {
            let law = self.scene.model.plan.laws[slot].clone();
            let sides = self.state().forces.law_forces[slot].sides;
            let pair = self.scene.mechanism().pair(law.pair).name.clone();
            let name = self.law_name(slot).0;
            let index = name.sub.clone();
            let Some(force) = self.found.get(&name).cloned() else { continue };
            let from = usize::from(sides[0] != 1.0);
            let mut right = self.power_into(&law, from, &force, &pair);
            if sides == [1.0, 1.0] && right.value() < 0.0 {
                right = self.power_into(&law, 1, &force, &pair);
            }
            let value = right.value();
            let power = self.equate(Name::new("P", &index), value, Unit::Power, right);
            if sides == [1.0, 1.0] {
                continue;
            }
            let part = self.side(slot, 1 - from);
            let right = (Expr::Int(1) - part) * power;
            let value = right.value();
            lost.push(self.equate(Name::new("P", &format!("L,{index}")), value, Unit::Power, right));
        }
        lost
    }

    /// The power that a law takes from one of its sides.
    fn power_into(&self, law: &PlannedLaw, side: usize, force: &Expr, pair: &str) -> Expr {
        let scale = scale_of(law.force);
        let body = match &law.terms[side].0 {
            LawSite::Turn(body) => *body,
            LawSite::Slide(guide) => guide.slider,
        };
        let turns = matches!(law.terms[side].0, LawSite::Turn(_));
        let lever = self.lever(law.terms[side].1 / scale, pair, &self.label(body), turns);
        // the transmission takes from the side that drives it
        -(force.clone() * lever * self.rate_from_carrier(law, side))
    }

    /// The rate of a side of a law, seen from the carrier.
    fn rate_from_carrier(&self, law: &PlannedLaw, term: usize) -> Expr {
        let rate = |i: usize| match law.terms.get(i).map(|t| &t.0) {
            Some(LawSite::Turn(body)) => {
                self.bodies[*body].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone())
            }
            Some(LawSite::Slide(guide)) => {
                let point = self.point_name(guide.slider, guide.point);
                let name = if guide.base == 0 {
                    Name::new("v", &point)
                } else {
                    Name::new("v", &format!("{point},{}", self.label(guide.base)))
                };
                self.found.get(&name).cloned().unwrap_or(Expr::ZERO)
            }
            None => Expr::ZERO,
        };
        if law.counts_from_carrier(term) { rate(term) - rate(2) } else { rate(term) }
    }
}
