//! Dyad RRR: two links joined by a hinge C, hung by hinges A and B.

use super::triangle::Triangle;
use super::{Stage, across, end, formula, pin, towards, unknown};
use crate::angle::Angle;
use crate::course::{Body, Derivation, joined};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_position::plan::Leg;

/// A dyad in letters.
struct Letters {
    /// Outer, outer, inner.
    points: [String; 3],
    lengths: [Expr; 2],
    angles: [Angle; 2],
    labels: [String; 2],
}

impl Derivation<'_> {
    pub(super) fn rrr(&mut self, stage: Stage, legs: &[Leg; 2]) {
        match stage {
            Stage::Positions => self.rrr_position(legs),
            Stage::Velocities => self.rrr_velocity(legs),
            Stage::Accelerations => self.rrr_acceleration(legs),
        }
    }

    /// The name of the angle of a leg: that of its body, or of the line where they differ.
    pub(super) fn leg_angle_name(&self, leg: &Leg) -> Name {
        let label = self.label(leg.body);
        if (leg.direction.y.abs() <= 1e-12) && leg.direction.x > 0.0 {
            return Name::new("φ", &label);
        }
        let (from, to) = (self.point_name(leg.body, pin(&leg.pin)), self.point_name(leg.body, end(leg)));
        Name::new("φ", &joined(&from, &to))
    }

    /// Keeps the direction of a leg's body, which is that of the leg less a constant angle.
    pub(super) fn hang(&mut self, leg: &Leg, line: Expr) {
        let reference = pin(&leg.pin);
        let label = self.label(leg.body);
        let index = joined(&self.point_name(leg.body, reference), &self.point_name(leg.body, end(leg)));
        let own = self.direction_given(leg.direction, || Name::new("γ", &index));
        let line = Angle::of(line);
        let angle = line.minus(&own);
        let angle = if own.part.is_none() && own.quarters == 0 {
            angle
        } else {
            Angle::of(self.angle_sum(Name::new("φ", &label), angle.whole()))
        };
        self.bodies[leg.body] = Some(Body { reference, angle, rates: [Expr::ZERO, Expr::ZERO] });
    }

    /// The direction of a leg.
    pub(super) fn leg_angle(&self, leg: &Leg) -> Angle {
        let name = self.leg_angle_name(leg);
        if let Some(found) = self.found.get(&name) {
            return Angle::of(found.clone());
        }
        let index = name.sub;
        let own = self.direction_given(leg.direction, || Name::new("γ", &index));
        self.bodies[leg.body].as_ref().map_or(own.clone(), |body| body.angle.plus(&own))
    }

    /// The length of a leg.
    pub(super) fn leg_length(&self, leg: &Leg) -> Expr {
        let (from, to) = (self.point_name(leg.body, pin(&leg.pin)), self.point_name(leg.body, end(leg)));
        self.length(&from, &to, leg.length)
    }

    fn rrr_letters(&self, legs: &[Leg; 2]) -> Letters {
        let outer = |leg: &Leg| self.point_name(leg.body, pin(&leg.pin));
        Letters {
            points: [outer(&legs[0]), outer(&legs[1]), self.point_name(legs[0].body, end(&legs[0]))],
            lengths: [self.leg_length(&legs[0]), self.leg_length(&legs[1])],
            angles: [self.leg_angle(&legs[0]), self.leg_angle(&legs[1])],
            labels: [self.label(legs[0].body), self.label(legs[1].body)],
        }
    }

    fn rrr_position(&mut self, legs: &[Leg; 2]) {
        let l = self.rrr_letters(legs);
        let [a, b] = [self.anchor(&legs[0].base), self.anchor(&legs[1].base)];
        let [one, two, inner] = l.points.clone();
        let [l1, l2] = l.lengths.clone();
        // a motion may have come here by other coordinates: the places say it
        let [p, q] = [0, 1].map(|i| self.moved(legs[i].body).position(pin(&legs[i].pin)));
        let left = (q - p).cross(self.moved(legs[0].body).position(end(&legs[0])) - p) > 0.0;
        let corners = [&*one, &*two, &*inner];
        let sum = self.side_of_triangle(&Triangle { corners, outer: [&a, &b], sides: [&l1, &l2], left });
        let name = self.leg_angle_name(&legs[0]);
        let line = self.angle_sum(name, sum);
        self.hang(&legs[0], line.clone());
        let value = self.moved(legs[0].body).position(end(&legs[0]));
        let along = Angle::of(line);
        let right = [a[0].clone() + l1.clone() * along.cos(), a[1].clone() + l1 * along.sin()];
        let c = self.coordinates(&inner, value, right);
        let d = [c[0].clone() - b[0].clone(), c[1].clone() - b[1].clone()];
        let name = self.leg_angle_name(&legs[1]);
        let line = self.direction_of(name, &d, &joined(&two, &inner));
        self.hang(&legs[1], line);
    }

    fn rrr_velocity(&mut self, legs: &[Leg; 2]) {
        let l = self.rrr_letters(legs);
        let [one, two, inner] = l.points.clone();
        let [a, b] = [0, 1].map(|i| self.velocity(legs[i].base.body, legs[i].base.at));
        self.relative_velocities(&inner, legs, &l);
        let d = [b[0].clone() - a[0].clone(), b[1].clone() - a[1].clone()];
        let [p, q] = l.angles.clone();
        let across_two = q.minus(&p).sin();
        let across_one = p.minus(&q).sin();
        let moved = [0, 1].map(|i| self.moved(legs[i].body).omega);
        self.say(Message::Projected, &[vec![text(joined(&two, &inner))]]);
        let right = q.along(&d) / (l.lengths[0].clone() * across_two);
        let w1 = self.equate(Name::new("ω", &l.labels[0]), moved[0], Unit::AngularVelocity, right);
        self.set_rate(legs[0].body, 0, w1);
        self.say(Message::Projected, &[vec![text(joined(&one, &inner))]]);
        let opposite = [a[0].clone() - b[0].clone(), a[1].clone() - b[1].clone()];
        let right = p.along(&opposite) / (l.lengths[1].clone() * across_one);
        let w2 = self.equate(Name::new("ω", &l.labels[1]), moved[1], Unit::AngularVelocity, right);
        self.set_rate(legs[1].body, 0, w2);
        self.senses(&[legs[0].body, legs[1].body]);
        self.velocity(legs[0].body, end(&legs[0]));
    }

    /// v_C = v_A + v_CA = v_B + v_CB
    fn relative_velocities(&mut self, inner: &str, legs: &[Leg; 2], l: &Letters) {
        let [one, two, _] = &l.points;
        let c = Name::new("v", inner);
        let mut terms = vec![self.term("", c, unknown(), unknown())];
        for (leg, outer) in legs.iter().zip([one, two]) {
            let absolute = self.absolute(Stage::Velocities, "=", &leg.base);
            let sign = if absolute.is_some() { "+" } else { "=" };
            terms.extend(absolute);
            let name = Name::new("v", &joined(inner, outer));
            terms.push(self.term(sign, name, unknown(), across(inner, outer)));
        }
        self.vectors(terms);
    }

    fn rrr_acceleration(&mut self, legs: &[Leg; 2]) {
        let l = self.rrr_letters(legs);
        let [one, two, inner] = l.points.clone();
        let [a, b] = [0, 1].map(|i| self.acceleration(legs[i].base.body, legs[i].base.at));
        self.relative_accelerations(&inner, legs, &l);
        let normal = [0, 1].map(|i| self.normal_part(&legs[i], &inner, &l.points[i], &l.lengths[i]));
        let d = [b[0].clone() - a[0].clone(), b[1].clone() - a[1].clone()];
        let [p, q] = l.angles.clone();
        let between = p.minus(&q).cos();
        let moved = [0, 1].map(|i| self.moved(legs[i].body).alpha);
        self.say(Message::Projected, &[vec![text(joined(&two, &inner))]]);
        let top = q.along(&d) + normal[0].clone() * between.clone() - normal[1].clone();
        let right = top / (l.lengths[0].clone() * q.minus(&p).sin());
        let e1 = self.equate(Name::new("α", &l.labels[0]), moved[0], Unit::AngularAcceleration, right);
        self.set_rate(legs[0].body, 1, e1);
        self.say(Message::Projected, &[vec![text(joined(&one, &inner))]]);
        let opposite = [a[0].clone() - b[0].clone(), a[1].clone() - b[1].clone()];
        let top = p.along(&opposite) + normal[1].clone() * between - normal[0].clone();
        let right = top / (l.lengths[1].clone() * p.minus(&q).sin());
        let e2 = self.equate(Name::new("α", &l.labels[1]), moved[1], Unit::AngularAcceleration, right);
        self.set_rate(legs[1].body, 1, e2);
        self.acceleration(legs[0].body, end(&legs[0]));
    }

    /// The normal part of the acceleration of the inner pin against the outer one.
    pub(super) fn normal_part(&mut self, leg: &Leg, inner: &str, outer: &str, length: &Expr) -> Expr {
        let omega = self.bodies[leg.body].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
        let fixed = self.on_ground_at(leg.body, pin(&leg.pin));
        let index = if fixed { inner.to_owned() } else { joined(inner, outer) };
        let moved = self.moved(leg.body).omega;
        let value = moved * moved * leg.length;
        self.equate(
            Name::new("a", &index).marked("n"),
            value,
            Unit::Acceleration,
            omega.squared() * length.clone(),
        )
    }

    /// a_C = a_A + a_CAⁿ + a_CAᵗ = a_B + a_CBⁿ + a_CBᵗ
    fn relative_accelerations(&mut self, inner: &str, legs: &[Leg; 2], l: &Letters) {
        let [one, two, _] = &l.points;
        let mut terms = vec![self.term("", Name::new("a", inner), unknown(), unknown())];
        for (i, (leg, outer)) in legs.iter().zip([one, two]).enumerate() {
            let absolute = self.absolute(Stage::Accelerations, "=", &leg.base);
            let mut sign = if absolute.is_some() { "+" } else { "=" };
            let fixed = absolute.is_none();
            terms.extend(absolute);
            let index = if fixed { inner.to_owned() } else { joined(inner, outer) };
            let name = Name::new("a", &index);
            let omega = self.bodies[leg.body].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
            if !omega.is_zero() {
                let size = formula(&(omega.squared() * l.lengths[i].clone()));
                terms.push(self.term(sign, name.marked("n"), size, towards(inner, outer)));
                sign = "+";
            }
            terms.push(self.term(
                sign,
                name.marked(self.language.letters().tangential),
                unknown(),
                across(inner, outer),
            ));
        }
        self.vectors(terms);
    }
}
