//! Points of bodies whose motion is known: position, velocity, acceleration, each found where it is first needed.

use crate::angle::Angle;
use crate::course::{Body, Derivation, joined};
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;

/// The letters of vectors, and of their parts.
const LETTERS: [&str; 3] = ["", "v", "a"];

/// A point relative to the reference of its body.
pub struct Arm {
    pub point: String,
    pub reference: String,
    pub at: (usize, Vec2),
    pub length: Expr,
    pub angle: Angle,
    pub rates: [Expr; 2],
}

impl Derivation<'_> {
    /// Where a point of a body is, m.
    pub fn position(&mut self, body: usize, at: Vec2) -> [Expr; 2] {
        if let Some((_, place)) = self.touched(body, at) {
            return place;
        }
        let name = self.point_name(body, at);
        if let Some(at) = self.on_base(body, at) {
            return self.on_ground(&name, at);
        }
        if let Some(known) = self.points[0].get(&name) {
            return known.clone();
        }
        let value = self.moved(body).position(at);
        let found = match self.arm(body, at, false) {
            Some(arm) => {
                let from = self.position(arm.at.0, arm.at.1);
                let [x, y] = from;
                let right = [x + arm.length.clone() * arm.angle.cos(), y + arm.length * arm.angle.sin()];
                self.coordinates(&name, value, right)
            }
            None => self.stated_place((body, at), &name, value),
        };
        self.points[0].insert(name, found.clone());
        found
    }

    /// The coordinates of a point from what they are.
    pub fn coordinates(&mut self, name: &str, value: Vec2, [x, y]: [Expr; 2]) -> [Expr; 2] {
        let found = [
            self.equate(Name::new("x", name), value.x, Unit::Length, x),
            self.equate(Name::new("y", name), value.y, Unit::Length, y),
        ];
        self.points[0].insert(name.to_owned(), found.clone());
        found
    }

    /// Keeps the position (0), velocity (1) or acceleration (2) of a point.
    pub fn keep(&mut self, order: usize, name: &str, found: [Expr; 2]) {
        self.points[order].insert(name.to_owned(), found);
    }

    fn on_ground(&mut self, name: &str, at: Vec2) -> [Expr; 2] {
        let known = |v: f64| if v.abs() <= self.tiny { 0.0 } else { v };
        let (x, y) = (known(at.x), known(at.y));
        [self.given(Name::new("x", name), x, Unit::Length), self.given(Name::new("y", name), y, Unit::Length)]
    }

    /// The velocity of a point, m/s.
    pub fn velocity(&mut self, body: usize, at: Vec2) -> [Expr; 2] {
        if self.on_base(body, at).is_some() {
            return [Expr::ZERO, Expr::ZERO];
        }
        if let Some((name, place)) = self.touched(body, at) {
            return self.under(1, body, &name, &place);
        }
        let name = self.point_name(body, at);
        if let Some(known) = self.points[1].get(&name) {
            return known.clone();
        }
        let value = self.moved(body).velocity(at);
        if self.carrier_of_planets(body).is_some() && value.norm() == 0.0 {
            return [Expr::ZERO, Expr::ZERO];
        }
        let found = match self.arm(body, at, true) {
            Some(arm) if !arm.rates[0].is_zero() => {
                let from = self.velocity(arm.at.0, arm.at.1);
                let fixed = from.iter().all(Expr::is_zero);
                let index = if fixed { name.clone() } else { joined(&arm.point, &arm.reference) };
                let size = self.moved(arm.at.0).omega * arm.length.value();
                let part = self.equate(
                    Name::new("v", &index),
                    size,
                    Unit::Velocity,
                    arm.rates[0].clone() * arm.length.clone(),
                );
                let [x, y] = from;
                let right = [x - part.clone() * arm.angle.sin(), y + part * arm.angle.cos()];
                self.components(1, &name, value, right)
            }
            Some(arm) => self.velocity(arm.at.0, arm.at.1),
            None => self.stated_vector(1, (body, at), &name, value),
        };
        self.points[1].insert(name, found.clone());
        found
    }

    /// The acceleration of a point, m/s².
    pub fn acceleration(&mut self, body: usize, at: Vec2) -> [Expr; 2] {
        if self.on_base(body, at).is_some() {
            return [Expr::ZERO, Expr::ZERO];
        }
        let name = self.point_name(body, at);
        if let Some(known) = self.points[2].get(&name) {
            return known.clone();
        }
        let value = self.moved(body).acceleration(at);
        if self.carrier_of_planets(body).is_some() && value.norm() == 0.0 {
            return [Expr::ZERO, Expr::ZERO];
        }
        let found = match self.arm(body, at, true) {
            Some(arm) if !(arm.rates[0].is_zero() && arm.rates[1].is_zero()) => {
                let from = self.acceleration(arm.at.0, arm.at.1);
                let fixed = from.iter().all(Expr::is_zero);
                let index = if fixed { name.clone() } else { joined(&arm.point, &arm.reference) };
                let [normal, tangential] = self.parts_of_acceleration(&index, &arm);
                let [x, y] = from;
                let right = [
                    x - normal.clone() * arm.angle.cos() - tangential.clone() * arm.angle.sin(),
                    y - normal * arm.angle.sin() + tangential * arm.angle.cos(),
                ];
                self.components(2, &name, value, right)
            }
            Some(arm) => self.acceleration(arm.at.0, arm.at.1),
            None => self.stated_vector(2, (body, at), &name, value),
        };
        self.points[2].insert(name, found.clone());
        found
    }

    fn parts_of_acceleration(&mut self, index: &str, arm: &Arm) -> [Expr; 2] {
        let moved = self.moved(arm.at.0);
        let length = arm.length.value();
        let normal = self.equate(
            Name::new("a", index).marked("n"),
            moved.omega * moved.omega * length,
            Unit::Acceleration,
            arm.rates[0].clone().squared() * arm.length.clone(),
        );
        let tangential = self.equate(
            Name::new("a", index).marked(self.language.letters().tangential),
            moved.alpha * length,
            Unit::Acceleration,
            arm.rates[1].clone() * arm.length.clone(),
        );
        [normal, tangential]
    }

    /// The components of a velocity (1) or an acceleration (2) from what they are.
    pub fn components(&mut self, order: usize, name: &str, value: Vec2, [x, y]: [Expr; 2]) -> [Expr; 2] {
        let unit = if order == 1 { Unit::Velocity } else { Unit::Acceleration };
        let letter = LETTERS[order];
        let found = [
            self.component(Name::new(letter, name).and("x"), value.x, unit, x),
            self.component(Name::new(letter, name).and("y"), value.y, unit, y),
        ];
        self.points[order].insert(name.to_owned(), found.clone());
        found
    }

    /// A component; where it is one quantity, or its opposite, that is taken.
    pub fn component(&mut self, name: Name, value: f64, unit: Unit, right: Expr) -> Expr {
        let same = (right.value() - value).abs() <= 1e-9 * right.scale();
        match &right {
            Expr::Leaf(_) if same => right,
            Expr::Neg(x) if same && matches!(**x, Expr::Leaf(_)) => right,
            _ => self.equate(name, value, unit, right),
        }
    }

    /// A place from outside: of a driven point that of the drive.
    fn stated_place(&mut self, (body, at): (usize, Vec2), name: &str, value: Vec2) -> [Expr; 2] {
        let parts = [(Name::new("x", name), value.x), (Name::new("y", name), value.y)];
        if self.is_driven_point(body, at) {
            let clear = |v: f64| if v.abs() <= self.tiny { 0.0 } else { v };
            return parts.map(|(name, v)| self.given(name, clear(v), Unit::Length));
        }
        parts.map(|(name, v)| self.stated_of(name, v, Unit::Length, self.tiny / 1e-9))
    }

    fn stated_vector(
        &mut self,
        order: usize,
        (body, at): (usize, Vec2),
        name: &str,
        value: Vec2,
    ) -> [Expr; 2] {
        let unit = if order == 1 { Unit::Velocity } else { Unit::Acceleration };
        let letter = Name::new(LETTERS[order], name);
        let parts = [(letter.and("x"), value.x), (letter.and("y"), value.y)];
        if self.is_driven_point(body, at) {
            return parts.map(|(name, v)| self.given(name, v, unit));
        }
        parts.map(|(name, v)| self.stated(name, v, unit))
    }

    /// Whether the file gives how a point moves: no step has found it, and a drive moves a body at it.
    fn is_driven_point(&self, body: usize, at: Vec2) -> bool {
        let bodies = &self.structure().replaced.bodies;
        let is_part = |b: usize| self.body_of(b) != b;
        self.at_hinge(body, at).into_iter().any(|(b, _)| b != 0 && bodies[b].known && !is_part(b))
    }

    /// The point relative to the reference of a body that carries it; none where it is that reference, or nothing is known.
    pub fn arm(&self, body: usize, at: Vec2, fixed_first: bool) -> Option<Arm> {
        let mut hosts: Vec<(usize, Vec2, &Body)> = self
            .at_hinge(body, at)
            .into_iter()
            .filter_map(|(b, p)| Some((b, p, self.bodies[b].as_ref().filter(|_| b != 0)?)))
            .filter(|(b, p, known)| (*p - known.reference).norm() > self.tiny || *b == 0)
            .collect();
        if fixed_first {
            hosts.sort_by_key(|(b, _, known)| !self.on_ground_at(*b, known.reference));
        }
        let (host, p, known) = hosts.first()?;
        let d = *p - known.reference;
        let (point, reference) = (self.point_name(*host, *p), self.point_name(*host, known.reference));
        let index = joined(&reference, &point);
        let turn = self.direction_given(d, || Name::new("γ", &index));
        Some(Arm {
            length: self.length(&reference, &point, d.norm()),
            angle: known.angle.plus(&turn),
            rates: known.rates.clone(),
            at: (*host, known.reference),
            point,
            reference,
        })
    }

    /// Whether a point of a body is one of the ground.
    pub fn on_ground_at(&self, body: usize, at: Vec2) -> bool {
        self.on_base(body, at).is_some()
    }

    /// The place of the same point in the frame of the ground, where it is a point of it.
    fn on_base(&self, body: usize, at: Vec2) -> Option<Vec2> {
        self.at_hinge(body, at).into_iter().find(|(b, _)| *b == 0).map(|(_, p)| p)
    }
}
