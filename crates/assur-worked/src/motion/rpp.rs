//! Dyad RPP: a link hung by a hinge A slides along a line of a body that slides on a guide.

use super::{Stage, pin};
use crate::course::Derivation;
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_position::plan::{Anchor, Arm, Slide};

impl Derivation<'_> {
    pub(super) fn rpp(
        &mut self,
        stage: Stage,
        branch: usize,
        base: &Anchor,
        arm: Arm,
        [inner, outer]: [&Slide; 2],
    ) {
        match stage {
            Stage::Positions => self.rpp_position(branch, base, arm, inner, outer),
            Stage::Velocities => self.rpp_rates(1, base, arm, inner, outer),
            Stage::Accelerations => self.rpp_rates(2, base, arm, inner, outer),
        }
    }

    /// R = Q + s d, where A is at a known distance from the line through R.
    fn rpp_position(&mut self, branch: usize, base: &Anchor, arm: Arm, inner: &Slide, outer: &Slide) {
        let at = inner.origin;
        self.slider(outer, at);
        let guide = self.guide(outer);
        let line = self.guide(inner);
        let (point, label) = (self.point_name(outer.body, at), self.label(inner.body));
        let a = self.anchor(base);
        let q = self.position(outer.base, outer.origin);
        // of A from the line, and of R from the guide
        let sides = self.state().branches[branch].sides;
        let value = (pin(&arm) - inner.point).turned_back(inner.direction).y + sides[0] * inner.radius;
        let value = if value.abs() <= self.tiny { 0.0 } else { value };
        let h = self.given(Name::new("h", &label), value, Unit::Length);
        let offset = self.offset(branch, 1, outer, at);
        let q = [q[0].clone() - offset.clone() * guide.sin(), q[1].clone() + offset * guide.cos()];
        let d = [a[0].clone() - q[0].clone(), a[1].clone() - q[1].clone()];
        self.say(Message::TwoSlides, &[vec![text(&*point)]]);
        let right = (line.across(&d) - h) / guide.minus(&line).sin();
        let (value, name) = (right.value(), Name::new("s", &point));
        let along = if right.is_zero() { Expr::ZERO } else { self.equate(name, value, Unit::Length, right) };
        let value = self.moved(outer.body).position(at);
        let right = [q[0].clone() + along.clone() * guide.cos(), q[1].clone() + along * guide.sin()];
        self.coordinates(&point, value, right);
        self.slider(inner, pin(&arm));
    }

    fn rpp_rates(&mut self, order: usize, base: &Anchor, arm: Arm, inner: &Slide, outer: &Slide) {
        let (guide, line) = (self.guide(outer), self.guide(inner));
        let point = self.point_name(outer.body, inner.origin);
        let hinge = self.point_name(inner.body, pin(&arm));
        self.set_slider_rate(outer, order - 1);
        self.set_slider_rate(inner, order - 1);
        let a = match order {
            1 => self.velocity(base.body, base.at),
            _ => self.acceleration(base.body, base.at),
        };
        let here = self.position(inner.body, pin(&arm));
        let under = self.under(order, outer.base, &hinge, &here);
        let mut d = [a[0].clone() - under[0].clone(), a[1].clone() - under[1].clone()];
        let unit = if order == 1 { Unit::Velocity } else { Unit::Acceleration };
        let letter = ["", "v", "a"][order];
        let names = [format!("{hinge},{}", self.label(outer.body)), point.clone()];
        if order == 2 {
            let omega = self.bodies[outer.base].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
            for (name, way) in names.iter().zip([&line, &guide]) {
                let speed = self.found.get(&Name::new("v", name)).cloned().unwrap_or(Expr::ZERO);
                let coriolis = self.coriolis(name, &omega, &speed);
                d = [d[0].clone() + coriolis.clone() * way.sin(), d[1].clone() - coriolis * way.cos()];
            }
        }
        let mut found = Vec::new();
        for (name, (way, other)) in names.iter().zip([(&line, &guide), (&guide, &line)]) {
            let right = other.across(&d) / way.minus(other).sin();
            let value = right.value();
            let along = if right.is_zero() {
                Expr::ZERO
            } else {
                self.equate(Name::new(letter, name), value, unit, right)
            };
            found.push(along);
        }
        let name = self.sliding_name(letter, outer, inner.origin);
        self.found.insert(name, found[1].clone());
        self.slid(order, outer, inner.origin, &found[1]);
    }
}
