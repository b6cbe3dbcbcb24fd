//! A body between two guides that fix its angle alike.

use super::Stage;
use crate::course::Course;
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_position::plan::Slide;

impl Course<'_> {
    pub(super) fn translation(&mut self, stage: Stage, slides: &[Slide; 2]) {
        let order = match stage {
            Stage::Positions => 0,
            Stage::Velocities => 1,
            Stage::Accelerations => 2,
        };
        let [one, two] = slides;
        let guides = [self.guide(one), self.guide(two)];
        let reference = if self.moves(one) == one.body { one.point } else { one.origin };
        let body = if self.moves(one) == one.body { one.body } else { one.base };
        let point = self.point_name(body, reference);
        let label = self.label(body);
        if order == 0 {
            self.say(Message::BetweenGuides, &[vec![text(&*label)]]);
        }
        let moved = *self.moved(body);
        if order == 0 {
            self.stated_between(body, reference);
            return;
        }
        // of points of the guides' bodies under it
        let here = self.position(body, reference);
        let under = slides.each_ref().map(|s| {
            let base = if s.body == body { s.base } else { s.body };
            self.under(order, base, &point, &here)
        });
        let d = [under[1][0].clone() - under[0][0].clone(), under[1][1].clone() - under[0][1].clone()];
        let right = -guides[1].across(&d) / guides[1].minus(&guides[0]).sin();
        let (letter, unit) = if order == 1 { ("v", Unit::Velocity) } else { ("a", Unit::Acceleration) };
        let value = right.value();
        let name = Name::new(
            letter,
            &format!("{label},{}", self.label(if one.body == body { one.base } else { one.body })),
        );
        let along = if right.is_zero() { Expr::ZERO } else { self.equate(name, value, unit, right) };
        self.set_rate(body, order - 1, Expr::ZERO);
        let value = if order == 1 { moved.velocity(reference) } else { moved.acceleration(reference) };
        let [x, y] = under[0].clone();
        let right = [x + along.clone() * guides[0].cos(), y + along * guides[0].sin()];
        self.components(order, &point, value, right);
    }

    /// Whether the guides do not turn at any time.
    pub(super) fn guides_rest(&self, slides: &[Slide; 2]) -> bool {
        slides.iter().flat_map(|s| [s.base, s.body]).all(|b| {
            self.bodies[b].as_ref().is_none_or(|b| b.rates.iter().all(Expr::is_zero) && b.angle.is_constant())
        })
    }

    /// The body of a slide whose motion is sought.
    fn moves(&self, slide: &Slide) -> usize {
        if self.bodies[slide.body].is_none() || self.bodies[slide.base].is_some() {
            slide.body
        } else {
            slide.base
        }
    }

    fn stated_between(&mut self, body: usize, reference: assur_math::math::Vec2) {
        let moved = *self.moved(body);
        let degrees = libm::atan2(moved.u.y, moved.u.x).to_degrees();
        let angle = self.direction_given(moved.u, || Name::new("φ", &self.label(body)));
        let _ = degrees;
        self.bodies[body] = Some(crate::course::Body { reference, angle, rates: [Expr::ZERO, Expr::ZERO] });
        self.position(body, reference);
    }
}
