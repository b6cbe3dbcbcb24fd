//! Trains: every law between rates with one unknown gives that; what several laws give together is stated, and each law checked.

use super::{Stage, of};
use crate::course::Derivation;
use crate::document::text;
use crate::letters::teeth_name;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_model::model::{PairKind, Query, TransmissionKind, Value, Wheel, counts_from_carrier};
use assur_model::structure::{BodyRate, JointId, JointKind};
use assur_position::plan::TrainMember;

impl Derivation<'_> {
    pub(super) fn train(&mut self, stage: Stage, index: usize, train: usize) {
        match stage {
            Stage::Positions => self.train_places(index, train),
            Stage::Velocities => self.train_rates(0, index, train),
            Stage::Accelerations => self.train_rates(1, index, train),
        }
    }

    fn train_rates(&mut self, order: usize, index: usize, train: usize) {
        let members = self.scene.model.plan.trains[train].members.clone();
        let laws = self.structure().motion[index].laws.clone();
        let mut unknown: Vec<Expr> = Vec::new();
        let mut sought = self.sought_by(&laws, &members);
        let before = self.blocks.len();
        self.say_once(Message::LawsOfTrain);
        let mut open = laws.clone();
        self.laws_one_by_one(order, &mut open, &mut sought);
        // two laws with the same two unknowns: one is eliminated
        while let Some((pair, rates)) = self.two_laws(&open, &sought) {
            let found = self.eliminated(order, pair, rates);
            self.keep_rate(order, rates[1], found);
            open.retain(|law| *law != pair[1]);
            sought.retain(|r| *r != rates[1]);
            self.laws_one_by_one(order, &mut open, &mut sought);
        }
        if !sought.is_empty() {
            self.say(Message::LawsTogether, &[]);
            for rate in sought {
                let (name, value, unit) = self.named_rate(order, rate);
                let found = self.stated(name, value, unit);
                self.keep_rate(order, rate, found.clone());
                unknown.push(found);
            }
            for law in open {
                let sum = self.law_sum(order, law, &[]);
                let pair = self.structure().replaced.joint(law).pair;
                let name = Name::new("ε", &self.scene.mechanism().pair(pair).name).marked(if order == 1 {
                    "a"
                } else {
                    ""
                });
                if !sum.is_zero() {
                    self.equate(name, 0.0, Unit::One, sum);
                }
            }
        }
        if order == 0 {
            self.willis(index);
        }
        // at constant speed nothing follows from the laws
        if order == 1 && self.blocks.len() <= before + 1 {
            self.blocks.truncate(before);
        }
        for member in &members {
            if let TrainMember::Shift(slide) = member {
                let name = self.sliding_name(["v", "a"][order], slide, slide.point);
                let along = self.found.get(&name).cloned().unwrap_or(Expr::ZERO);
                self.set_slider_rate(slide, order);
                self.slid(order + 1, slide, slide.point, &along);
            }
        }
    }

    /// The rates of members in these laws.
    pub(super) fn sought_by(&self, laws: &[JointId], members: &[TrainMember]) -> Vec<BodyRate> {
        let mut sought = Vec::new();
        for (rate, _) in laws.iter().flat_map(|law| self.terms_of(*law)) {
            if self.is_sought(&rate, members) && !sought.contains(&rate) {
                sought.push(rate);
            }
        }
        sought
    }

    /// Each law with one unknown gives it.
    fn laws_one_by_one(&mut self, order: usize, open: &mut Vec<JointId>, sought: &mut Vec<BodyRate>) {
        while let Some(at) = open.iter().position(|law| self.sought_in(*law, sought).len() == 1) {
            let law = open.remove(at);
            let Some(rate) = self.sought_in(law, sought).pop() else { break };
            let found = self.solved_law(order, law, rate);
            self.keep_rate(order, rate, found);
            sought.retain(|r| *r != rate);
        }
    }

    /// Two laws with the same two unknowns; the first unknown is that of the link that stands on the other.
    pub(super) fn two_laws(
        &self,
        open: &[JointId],
        sought: &[BodyRate],
    ) -> Option<([JointId; 2], [BodyRate; 2])> {
        for (i, one) in open.iter().enumerate() {
            for two in &open[i + 1..] {
                let (a, b) = (self.sought_in(*one, sought), self.sought_in(*two, sought));
                if let [p, q] = a.as_slice()
                    && b.len() == 2
                    && b.contains(p)
                    && b.contains(q)
                {
                    // the carrier is the third of a law
                    let terms = self.terms_of(*one);
                    let place = |r: &BodyRate| terms.iter().position(|(t, _)| t == r);
                    let rates = if place(p) <= place(q) { [*p, *q] } else { [*q, *p] };
                    return Some(([*one, *two], rates));
                }
            }
        }
        None
    }

    /// The second of two unknowns of two laws, without the first.
    fn eliminated(&mut self, order: usize, laws: [JointId; 2], [first, second]: [BodyRate; 2]) -> Expr {
        let rests = laws.map(|law| self.law_sum(order, law, &[first, second]));
        let Some(right) = self.without_first(laws, [first, second], rests) else { return Expr::ZERO };
        let (name, value, unit) = self.named_rate(order, second);
        let names = laws.map(|law| {
            let pair = self.structure().replaced.joint(law).pair;
            self.scene.mechanism().pair(pair).name.clone()
        });
        let without = self.named_rate(order, first).0;
        self.say(Message::Eliminated, &[vec![text(names.join(", "))], of(&without), of(&name)]);
        self.equate(name, value, unit, right)
    }

    /// The second of two unknowns of two laws by the rest of each law; none where it is nothing.
    pub(super) fn without_first(
        &self,
        laws: [JointId; 2],
        [first, second]: [BodyRate; 2],
        rests: [Expr; 2],
    ) -> Option<Expr> {
        let factor = |law: JointId, rate: BodyRate| {
            let at = self.terms_of(law).iter().position(|(r, _)| *r == rate);
            at.and_then(|at| self.factors(law).into_iter().nth(at)).unwrap_or(Expr::ZERO)
        };
        let firsts = laws.map(|law| factor(law, first));
        let seconds = laws.map(|law| factor(law, second));
        let [f, g] = if firsts[0] == firsts[1] {
            [Expr::Int(1), Expr::Int(1)]
        } else if firsts[0] == -firsts[1].clone() {
            [Expr::Int(1), Expr::Int(-1)]
        } else {
            [firsts[1].clone(), firsts[0].clone()]
        };
        let [rest_1, rest_2] = rests;
        let [own_1, own_2] = seconds;
        let rest = f.clone() * rest_1 - g.clone() * rest_2;
        (!rest.is_zero()).then(|| -(rest / (f * own_1 - g * own_2)))
    }

    pub(super) fn terms_of(&self, law: JointId) -> Vec<(BodyRate, f64)> {
        match &self.structure().replaced.joint(law).kind {
            JointKind::Law(terms) => terms.iter().map(|(rate, c)| (*rate, *c)).collect(),
            _ => Vec::new(),
        }
    }

    fn is_sought(&self, rate: &BodyRate, members: &[TrainMember]) -> bool {
        members.iter().any(|member| match (member, rate) {
            (TrainMember::Turn { body, .. }, BodyRate::Turn(b)) => b.0 == *body,
            (TrainMember::Shift(slide), BodyRate::Slide(joint)) => {
                self.structure().replaced.joint(*joint).bodies().iter().any(|b| b.0 == slide.body)
            }
            _ => false,
        })
    }

    pub(super) fn sought_in(&self, law: JointId, sought: &[BodyRate]) -> Vec<BodyRate> {
        self.terms_of(law).into_iter().map(|t| t.0).filter(|r| sought.contains(r)).collect()
    }

    /// The letters, value and unit of a rate.
    fn named_rate(&self, order: usize, rate: BodyRate) -> (Name, f64, Unit) {
        match rate {
            BodyRate::Turn(body) => {
                let moved = self.moved(body.0);
                let (letter, value, unit) = [
                    ("ω", moved.omega, Unit::AngularVelocity),
                    ("α", moved.alpha, Unit::AngularAcceleration),
                ][order];
                (Name::new(letter, &self.label(body.0)), value, unit)
            }
            BodyRate::Slide(joint) => {
                let pair = self.structure().replaced.joint(joint).pair;
                let query = if order == 0 {
                    Query::RelativeVelocity(pair)
                } else {
                    Query::RelativeAcceleration(pair)
                };
                let value = match self.scene.view().query(&query) {
                    Value::Scalar(x) => x,
                    _ => f64::NAN,
                };
                let (letter, unit) = [("v", Unit::Velocity), ("a", Unit::Acceleration)][order];
                (Name::new(letter, &self.slide_index(joint)), value, unit)
            }
        }
    }

    /// The index of the speed of a slider.
    pub(super) fn slide_index(&self, joint: JointId) -> String {
        match &self.structure().replaced.joint(joint).kind {
            JointKind::Prismatic { slider, point, guide, .. } => {
                let point = self.point_name(slider.0, *point);
                if guide.0 == 0 { point } else { format!("{point},{}", self.label(guide.0)) }
            }
            _ => String::new(),
        }
    }

    fn rate_of(&self, order: usize, rate: BodyRate) -> Expr {
        match rate {
            BodyRate::Turn(body) => {
                self.bodies[body.0].as_ref().map_or(Expr::ZERO, |b| b.rates[order].clone())
            }
            BodyRate::Slide(_) => {
                let (name, value, unit) = self.named_rate(order, rate);
                self.found.get(&name).cloned().unwrap_or_else(|| self.given(name, value, unit))
            }
        }
    }

    fn keep_rate(&mut self, order: usize, rate: BodyRate, found: Expr) {
        match rate {
            BodyRate::Turn(body) => self.set_rate(body.0, order, found),
            BodyRate::Slide(_) => {
                let name = self.named_rate(order, rate).0;
                self.found.insert(name, found);
            }
        }
    }

    /// Σ coefficient × rate of a law, without some of its rates.
    pub(super) fn law_sum(&self, order: usize, law: JointId, without: &[BodyRate]) -> Expr {
        let factors = self.factors(law);
        let terms = self.terms_of(law).into_iter().zip(factors);
        let kept = terms.filter(|((rate, _), _)| !without.contains(rate));
        Expr::sum(kept.map(|((rate, _), factor)| factor * self.rate_of(order, rate)))
    }

    fn solved_law(&mut self, order: usize, law: JointId, rate: BodyRate) -> Expr {
        let factors = self.factors(law);
        let terms = self.terms_of(law);
        let Some(own) = terms.iter().position(|(r, _)| *r == rate) else { return Expr::ZERO };
        let rest = self.law_sum(order, law, &[rate]);
        let (name, value, unit) = self.named_rate(order, rate);
        let pair = self.structure().replaced.joint(law).pair;
        let words = self.scene.mechanism().pair(pair).name.clone();
        if rest.is_zero() {
            return Expr::ZERO;
        }
        self.say(Message::LawOf, &[vec![text(words)], of(&name)]);
        self.equate(name, value, unit, -(rest / factors[own].clone()))
    }

    /// The coefficients of a law: numbers of teeth of two wheels that mesh, radii, or plain factors. Teeth and radii of the
    /// carrier's term are their sum.
    pub(super) fn factors(&self, law: JointId) -> Vec<Expr> {
        let terms = self.terms_of(law);
        let pair = self.structure().replaced.joint(law).pair;
        let mechanism = self.scene.mechanism();
        let PairKind::Transmission(transmission) = &mechanism.pair(pair).kind else { return Vec::new() };
        let wheels: Vec<_> = transmission
            .ends
            .iter()
            .filter_map(|end| mechanism.wheels.iter().find(|w| w.name == *end))
            .collect();
        let toothed = matches!(transmission.kind, TransmissionKind::Mesh | TransmissionKind::Chain);
        if let ([a, b], true) = (wheels.as_slice(), terms.len() >= 2)
            && let (Some(z_a), Some(z_b), true) = (a.teeth, b.teeth, toothed)
        {
            let z = |name: &str, teeth: f64| self.given(teeth_name(name), teeth, Unit::One);
            let ratio = (terms[0].1 / terms[1].1).abs() * z_b / z_a;
            if (ratio - 1.0).abs() < 1e-9 {
                return self.shared(&terms, z(&a.name, z_a), z(&b.name, z_b));
            }
        }
        let plain = |(i, (rate, c)): (usize, &(BodyRate, f64))| {
            let size = c.abs();
            let turned = |w: &Wheel| matches!(rate, BodyRate::Turn(body) if body.0 == w.link.index());
            let radius = wheels.iter().find(|w| (w.radius - size).abs() <= 1e-12 * size);
            let worm = transmission.kind == TransmissionKind::Worm;
            let toothed = wheels.iter().find(|w| w.teeth == Some(size));
            let factor = match radius {
                _ if worm => {
                    let name = toothed.map_or(&mechanism.pair(pair).name, |w| &w.name);
                    self.given(teeth_name(name), size, Unit::One)
                }
                _ if (size - 1.0).abs() < 1e-12 && !radius.is_some_and(|w| turned(w)) => Expr::Int(1),
                Some(wheel) => self.given(Name::new("r", &wheel.name), size, Unit::Length),
                None => self.given(
                    Name::new("k", &format!("{},{}", mechanism.pair(pair).name, i + 1)),
                    size,
                    Unit::One,
                ),
            };
            if *c < 0.0 { -factor } else { factor }
        };
        terms.iter().enumerate().map(plain).collect()
    }

    /// Two factors with the signs of a law; the third is what the carrier takes of both.
    fn shared(&self, terms: &[(BodyRate, f64)], a: Expr, b: Expr) -> Vec<Expr> {
        let signed = |x: Expr, c: f64| if c < 0.0 { -x } else { x };
        let (a, b) = (signed(a, terms[0].1), signed(b, terms[1].1));
        let both = counts_from_carrier(terms, 1);
        let carrier = if both { -(a.clone() + b.clone()) } else { -a.clone() };
        let rest = terms.iter().skip(2).map(|_| carrier.clone());
        [a.clone(), b.clone()].into_iter().chain(rest).collect()
    }
}
