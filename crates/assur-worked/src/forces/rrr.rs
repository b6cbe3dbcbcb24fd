//! Reactions of a dyad RRR: moments of each link about the inner hinge, then the sum of forces of the group.

use crate::course::{Derivation, joined};
use crate::document::{Line, text};
use crate::motion::{across, of, pin, unknown};
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_position::plan::{Hinge, Inner};

impl Derivation<'_> {
    /// The part of the reaction at an outer hinge across the link, from moments about the inner hinge.
    pub(super) fn tangential(&mut self, hinge: &Hinge, inner: Vec2) -> (Name, Expr) {
        let outer = pin(&hinge.pin);
        let (length, angle) = self.line_of(hinge.body, outer, inner);
        let name = self.reaction_name(hinge.base, hinge.body);
        let label: Line = vec![text(self.label(hinge.body))];
        if self.is_unloaded(hinge.body) {
            let line = joined(&self.point_name(hinge.body, outer), &self.point_name(hinge.body, inner));
            self.free.lines.insert(name.clone(), vec![text(format!("∥ {line}"))]);
            self.say(Message::TwoForces, &[label, of(&name), vec![text(line)]]);
            return (name, Expr::ZERO);
        }
        let point = self.point_name(hinge.body, inner);
        self.say(Message::MomentsOfLink, &[label, vec![text(point)]]);
        let moment = self.moment_about(hinge.body, inner);
        let force = self.state().forces.reactions[hinge.slot].force;
        let _ = &angle;
        let along = (inner - outer).turned(self.moved(hinge.body).u);
        let value = along.perp().dot(force) / along.norm();
        let at = self.blocks.len();
        let marked = name.marked(self.language.letters().tangential);
        let part = self.equate(marked, value, Unit::Force, moment.clone() / length.clone());
        let sum = moment - part.clone() * length;
        self.balanced(at, &Name::new("ΣM", &self.point_name(hinge.body, inner)), &sum);
        (name, part)
    }

    pub(super) fn force_rrr(&mut self, outer: &[Hinge; 2], inner: &Inner) {
        [outer[0].body, outer[1].body].into_iter().for_each(|b| self.complete(b));
        let [one, two] = outer;
        let bodies = [one.body, two.body];
        let pins = [pin(&one.pin), pin(&two.pin)];
        let ends = [inner.pin, pin(&inner.second_pin)];
        self.say_once(Message::Determinate);
        let (n1, t1) = self.tangential(one, ends[0]);
        let (n2, t2) = self.tangential(two, ends[1]);
        let lines = [0, 1].map(|i| self.line_of(bodies[i], pins[i], ends[i]).1);
        let names = [0, 1].map(|i| self.points_of(bodies[i], pins[i], ends[i]));
        let terms = self.group_terms(&bodies, [(&n1, &t1, &names[0]), (&n2, &t2, &names[1])]);
        self.polygon_closes(terms);
        let [qx, qy] = self.sum_of(&bodies);
        let [p, q] = lines;
        let between = p.minus(&q);
        let f = [0, 1].map(|i| {
            let slot = outer[i].slot;
            let along = (ends[i] - pins[i]).turned(self.moved(bodies[i]).u);
            self.state().forces.reactions[slot].force.dot(along) / along.norm()
        });
        let q_parts = [qx.clone(), qy.clone()];
        let top = t1.clone() * between.cos() + t2.clone() + q.across(&q_parts);
        let along = |sign: &str| Name::new("ΣF", &format!("{sign}{}", joined(&names[1][0], &names[1][1])));
        let at = self.blocks.len();
        let r1 = self.equate(n1.marked("n"), f[0], Unit::Force, -(top.clone() / between.sin()));
        self.balanced(at, &along("⊥"), &(r1.clone() * between.sin() + top));
        let right = t1.clone() * between.sin() - r1.clone() * between.cos() - q.along(&q_parts);
        let at = self.blocks.len();
        let r2 = self.equate(n2.marked("n"), f[1], Unit::Force, right.clone());
        self.balanced(at, &along("∥"), &(r2.clone() - right));
        let parts = [(one, &p, &r1, &t1), (two, &q, &r2, &t2)];
        let mut found = Vec::new();
        for (hinge, angle, n, t) in parts {
            let value = self.state().forces.reactions[hinge.slot].force;
            let right = [
                n.clone() * angle.cos() - t.clone() * angle.sin(),
                n.clone() * angle.sin() + t.clone() * angle.cos(),
            ];
            found.push(self.reaction(hinge.base, hinge.body, value, right));
        }
        self.inner_pair(inner, bodies, &found[0]);
        for (hinge, parts) in [one, two].into_iter().zip(&found) {
            self.carry(hinge.slot, parts, &Expr::ZERO);
        }
    }

    /// The reaction between the links of a dyad, from the first alone.
    pub(super) fn inner_pair(&mut self, inner: &Inner, bodies: [usize; 2], outer: &[Expr; 2]) {
        let pair = self.hinge_pair_name(bodies[0], inner.pin);
        let label: Line = vec![text(self.label(bodies[0]))];
        self.say(Message::InnerPair, &[vec![text(pair)], label]);
        let value = self.state().forces.reactions[inner.slot].force * inner.sign;
        let of = |i: usize| {
            let loads = self.free.forces[bodies[0]].iter().map(|f| f.parts[i].clone());
            Expr::sum(std::iter::once(outer[i].clone()).chain(loads))
        };
        let right = [of(0), of(1)];
        self.reaction_in_sums(bodies, value, right, bodies[0]);
        let name = self.reaction_name(bodies[0], bodies[1]);
        if let Some(kept) = self.free.reactions.get_mut(inner.slot) {
            *kept = Some(name);
        }
    }

    fn points_of(&self, body: usize, from: Vec2, to: Vec2) -> [String; 2] {
        [self.point_name(body, from), self.point_name(body, to)]
    }

    /// Rⁿ + Rᵗ + loads + Rᵗ + Rⁿ
    fn group_terms(
        &self,
        bodies: &[usize; 2],
        [one, two]: [(&Name, &Expr, &[String; 2]); 2],
    ) -> Vec<crate::document::Term> {
        let mut terms = Vec::new();
        let tangential = self.language.letters().tangential;
        let part = |kind: &str, name: &Name, points: &[String; 2], size: Line| {
            let [a, b] = points;
            let direction =
                if kind != "n" { across(a, b) } else { vec![text(format!("∥ {}", joined(a, b)))] };
            self.term("+", name.marked(kind), size, direction)
        };
        terms.push(part("n", one.0, one.2, unknown()));
        if !one.1.is_zero() {
            terms.push(part(tangential, one.0, one.2, crate::course::cell(one.1)));
        }
        terms.extend(self.known_terms(bodies));
        if !two.1.is_zero() {
            terms.push(part(tangential, two.0, two.2, crate::course::cell(two.1)));
        }
        terms.push(part("n", two.0, two.2, unknown()));
        terms
    }
}
