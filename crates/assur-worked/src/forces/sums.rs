//! Sums of forces and moments on bodies.

use crate::angle::Angle;
use crate::course::{Derivation, joined};
use crate::document::{Block, Term};
use crate::motion::unknown;
use assur_formula::{Expr, Lines, Name, Unit};
use assur_math::math::Vec2;

/// A sum of forces or moments below this part of its terms is zero.
const BALANCED: f64 = 1e-9;

/// The indices of sums of forces along a guide and across it.
pub(super) const fn axes_of(way: &Angle) -> [&'static str; 2] {
    if way.part.is_none() && way.quarters == 0 { ["x", "y"] } else { ["∥", "⊥"] }
}

impl Derivation<'_> {
    /// Writes an equation of equilibrium before what follows from it and begins at this place; where nothing follows, it is not
    /// written, nor is one that the state does not fulfil.
    pub(super) fn balanced(&mut self, at: usize, name: &Name, sum: &Expr) {
        let block = Block::Equation(Lines::zero(name, sum));
        if self.blocks.len() == at || sum.is_zero() || self.blocks.contains(&block) {
            return;
        }
        let off = sum.value().abs() / sum.scale();
        if off <= BALANCED {
            self.insert(at, vec![block]);
        } else {
            self.disagreements.push(format!("{name:?} is not zero (off by {off:e})"));
        }
    }

    /// The moment of all that is known on a body about a point of it, without reactions still sought.
    pub fn moment_about(&mut self, body: usize, at: Vec2) -> Expr {
        let place = self.moved(body).position(at);
        let point = self.point_name(body, at);
        let mut terms = Vec::new();
        for force in self.free.forces[body].clone() {
            let from = self.moved(body).position(force.at);
            if (from - place).norm() <= self.tiny {
                continue;
            }
            let here = self.position(body, at);
            let there = self.position(body, force.at);
            let [fx, fy] = force.parts.clone();
            let right = (there[0].clone() - here[0].clone()) * fy - (there[1].clone() - here[1].clone()) * fx;
            let value = (from - place).cross(Vec2::new(force.parts[0].value(), force.parts[1].value()));
            let name = Name::new("M", &point).marked(&format!("{}{}", force.name.letter, force.name.sub));
            terms.push(self.equate(name, value, Unit::Torque, right));
        }
        terms.extend(self.free.couples[body].iter().map(|c| c.value.clone()));
        Expr::sum(terms)
    }

    /// The sum of all that is known on bodies.
    pub fn sum_of(&mut self, bodies: &[usize]) -> [Expr; 2] {
        let labels: Vec<String> = bodies.iter().map(|b| self.label(*b)).collect();
        let name = Name::new(
            "Q",
            joined(&labels[0], labels.get(1).map_or("", String::as_str)).trim_end_matches(','),
        );
        let of = |i: usize| {
            let forces = bodies.iter().flat_map(|b| self.free.forces[*b].iter());
            Expr::sum(forces.map(|f| f.parts[i].clone()))
        };
        let (x, y) = (of(0), of(1));
        let (vx, vy) = (x.value(), y.value());
        [self.component(name.and("x"), vx, Unit::Force, x), self.component(name.and("y"), vy, Unit::Force, y)]
    }

    /// Whether nothing is known to act on a body but at its pins.
    pub fn is_unloaded(&self, body: usize) -> bool {
        self.free.forces[body].is_empty() && self.free.couples[body].is_empty()
    }

    /// Length and direction of a line of a body.
    pub fn line_of(&self, body: usize, from: Vec2, to: Vec2) -> (Expr, Angle) {
        let index = joined(&self.point_name(body, from), &self.point_name(body, to));
        let length =
            self.length(&self.point_name(body, from), &self.point_name(body, to), (to - from).norm());
        if let Some(angle) = self.found.get(&Name::new("φ", &index)) {
            return (length, Angle::of(angle.clone()));
        }
        let own = self.direction_given(to - from, || Name::new("γ", &index));
        let angle = self.bodies[body].as_ref().map_or(own.clone(), |b| b.angle.plus(&own));
        (length, angle)
    }

    /// Known forces on bodies as terms of a vector equation; the first has this sign.
    pub fn known_terms(&self, bodies: &[usize]) -> Vec<Term> {
        let forces = bodies.iter().flat_map(|b| self.free.forces[*b].iter());
        forces
            .map(|f| {
                let [magnitude, direction] = f.known.clone();
                let magnitude = if magnitude.is_empty() { unknown() } else { magnitude };
                self.term("+", f.name.clone(), magnitude, direction)
            })
            .collect()
    }

    /// Ends a vector equation with "= 0".
    pub fn closed(&mut self, mut terms: Vec<Term>) {
        if let Some(first) = terms.first_mut() {
            first.sign = "";
        }
        let zero = Name::new("0", "");
        terms.push(Term { sign: "=", name: zero, magnitude: Vec::new(), direction: Vec::new() });
        self.vectors(terms);
    }
}
