//! Dyad PRP: two sliders on guides, joined by a hinge C; a body that slides on two guides.

use super::{Stage, pin};
use crate::course::Derivation;
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_position::plan::{Arm, Slide};

impl Derivation<'_> {
    pub(super) fn prp(&mut self, stage: Stage, branch: usize, slides: &[Slide; 2], pins: [Arm; 2]) {
        match stage {
            Stage::Positions => self.prp_position(branch, slides, pins.map(|p| pin(&p))),
            Stage::Velocities => self.prp_rates(1, slides, pins.map(|p| pin(&p))),
            Stage::Accelerations => self.prp_rates(2, slides, pins.map(|p| pin(&p))),
        }
    }

    /// A body between two guides that fix its angle alike: a point of it is on both paths.
    pub(super) fn translation(&mut self, stage: Stage, branch: usize, slides: &[Slide; 2]) {
        let pins = [slides[0].point; 2];
        match stage {
            Stage::Positions => {
                let label = self.label(slides[0].body);
                self.say(Message::BetweenGuides, &[vec![text(label)]]);
                self.prp_position(branch, slides, pins);
            }
            Stage::Velocities => self.prp_rates(1, slides, pins),
            Stage::Accelerations => self.prp_rates(2, slides, pins),
        }
    }

    /// The index of the coordinate along one of the guides: the point, and the slider; of one slider on both the guide's body.
    fn way_index(&self, slides: &[Slide; 2], pins: [Vec2; 2], which: usize) -> String {
        let one = slides[0].body == slides[1].body;
        let body = if one { slides[which].base } else { slides[which].body };
        let apart = if one && slides[0].base == slides[1].base { "′".repeat(which) } else { String::new() };
        format!("{},{}{apart}", self.point_name(slides[0].body, pins[0]), self.label(body))
    }

    /// C is where two lines meet: its coordinate along the first.
    fn prp_position(&mut self, branch: usize, slides: &[Slide; 2], pins: [Vec2; 2]) {
        let inner = self.point_name(slides[0].body, pins[0]);
        let guides = [self.guide(&slides[0]), self.guide(&slides[1])];
        let mut origins = Vec::new();
        for i in 0..2 {
            let h = self.offset(branch, i, &slides[i], pins[i]);
            let [x, y] = self.position(slides[i].base, slides[i].origin);
            origins.push([x - h.clone() * guides[i].sin(), y + h * guides[i].cos()]);
        }
        let d =
            [origins[1][0].clone() - origins[0][0].clone(), origins[1][1].clone() - origins[0][1].clone()];
        self.say(Message::TwoGuides, &[vec![text(&*inner)]]);
        // s_1 d_1 − s_2 d_2 = d, across the second guide
        let right = -guides[1].across(&d) / guides[1].minus(&guides[0]).sin();
        let value = right.value();
        let name = Name::new("s", &self.way_index(slides, pins, 0));
        let along = if right.is_zero() { Expr::ZERO } else { self.equate(name, value, Unit::Length, right) };
        let value = self.moved(slides[0].body).position(pins[0]);
        let right = [
            origins[0][0].clone() + along.clone() * guides[0].cos(),
            origins[0][1].clone() + along * guides[0].sin(),
        ];
        self.coordinates(&inner, value, right);
        for i in 0..2 {
            self.slider(&slides[i], pins[i]);
        }
    }

    /// Velocities (1) or accelerations (2).
    fn prp_rates(&mut self, order: usize, slides: &[Slide; 2], pins: [Vec2; 2]) {
        let inner = self.point_name(slides[0].body, pins[0]);
        let here = self.position(slides[0].body, pins[0]);
        let guides = [self.guide(&slides[0]), self.guide(&slides[1])];
        let mut under = Vec::new();
        for i in 0..2 {
            self.set_slider_rate(&slides[i], order - 1);
            let [mut x, mut y] = self.under(order, slides[i].base, &inner, &here);
            if order == 2 {
                let index = self.way_index(slides, pins, i);
                let coriolis = self.coriolis_along(&slides[i], &index);
                x = x - coriolis.clone() * guides[i].sin();
                y = y + coriolis * guides[i].cos();
            }
            under.push([x, y]);
        }
        let d = [under[1][0].clone() - under[0][0].clone(), under[1][1].clone() - under[0][1].clone()];
        let unit = if order == 1 { Unit::Velocity } else { Unit::Acceleration };
        let letter = ["", "v", "a"][order];
        let mut found = Vec::new();
        for i in 0..2 {
            let other = &guides[1 - i];
            let right = if i == 0 { -other.across(&d) } else { other.across(&d) };
            let right = right / other.minus(&guides[i]).sin();
            let name = Name::new(letter, &self.way_index(slides, pins, i));
            let value = right.value();
            let along = if right.is_zero() { Expr::ZERO } else { self.equate(name, value, unit, right) };
            found.push(along);
        }
        let moved = self.moved(slides[0].body);
        let value = if order == 1 { moved.velocity(pins[0]) } else { moved.acceleration(pins[0]) };
        let [x, y] = under[0].clone();
        let right = [x + found[0].clone() * guides[0].cos(), y + found[0].clone() * guides[0].sin()];
        self.components(order, &inner, value, right);
    }

    /// The Coriolis acceleration of the slider of a pair of guides.
    fn coriolis_along(&mut self, slide: &Slide, index: &str) -> Expr {
        let omega = self.bodies[slide.base].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
        if omega.is_zero() {
            return Expr::ZERO;
        }
        let speed = self.found.get(&Name::new("v", index)).cloned().unwrap_or(Expr::ZERO);
        self.coriolis(index, &omega, &speed)
    }
}
