//! Guides: their direction, and the motion of what slides along them.

use crate::angle::Angle;
use crate::course::{Body, Derivation};
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_position::plan::Slide;

impl Derivation<'_> {
    /// The direction of a guide.
    pub(super) fn guide(&self, slide: &Slide) -> Angle {
        let own = self.direction_given(slide.along, || Name::new("λ", &self.label(slide.body)));
        self.bodies[slide.base].as_ref().map_or(own.clone(), |base| base.angle.plus(&own))
    }

    /// A body that slides: it turns with its guide; its reference is this point.
    pub(super) fn slider(&mut self, slide: &Slide, reference: Vec2) {
        let own = self.direction_given(slide.direction, || Name::new("λ′", &self.label(slide.body)));
        let angle = self.guide(slide).minus(&own);
        let (u, degrees) = (self.moved(slide.body).u, angle.whole().value().to_radians());
        if (u - Vec2::new(libm::cos(degrees), libm::sin(degrees))).norm() > 1e-6 {
            self.disagreements.push(format!("the direction of {}", self.label(slide.body)));
        }
        self.bodies[slide.body] = Some(Body { reference, angle, rates: [Expr::ZERO, Expr::ZERO] });
    }

    /// It turns with its guide.
    pub(super) fn set_slider_rate(&mut self, slide: &Slide, order: usize) {
        let rate = self.bodies[slide.base].as_ref().map_or(Expr::ZERO, |b| b.rates[order].clone());
        self.set_rate(slide.body, order, rate);
    }

    /// The velocity (1) or acceleration (2) of the point of a body that is under a place at this instant.
    pub(crate) fn under(&mut self, order: usize, base: usize, place: &str, here: &[Expr; 2]) -> [Expr; 2] {
        let Some(known) = self.bodies[base].clone().filter(|_| base != 0) else {
            return [Expr::ZERO, Expr::ZERO];
        };
        let rates = known.rates;
        let from = self.position(base, known.reference);
        let [dx, dy] = [here[0].clone() - from[0].clone(), here[1].clone() - from[1].clone()];
        let name = format!("{place},{}", self.label(base));
        let moved = *self.moved(base);
        let at = Vec2::new(here[0].value(), here[1].value());
        let r = at - moved.p;
        if order == 1 {
            let [x, y] = self.velocity(base, known.reference);
            let value = moved.v + r.perp() * moved.omega;
            return self.components(1, &name, value, [x - rates[0].clone() * dy, y + rates[0].clone() * dx]);
        }
        let [x, y] = self.acceleration(base, known.reference);
        let value = moved.a + r.perp() * moved.alpha - r * (moved.omega * moved.omega);
        let square = rates[0].clone().squared();
        let right = [
            x - rates[1].clone() * dy.clone() - square.clone() * dx.clone(),
            y + rates[1].clone() * dx - square * dy,
        ];
        self.components(2, &name, value, right)
    }

    /// The coordinates of a point on a guide; along an axis one of them is that of the guide.
    pub(super) fn on_guide(
        &mut self,
        name: &str,
        value: Vec2,
        right: [Expr; 2],
        guide: &Angle,
        origin: &[Expr; 2],
        offset: &Expr,
    ) -> [Expr; 2] {
        if guide.part.is_some() {
            return self.coordinates(name, value, right);
        }
        let [mut x, mut y] = right;
        if guide.quarters.rem_euclid(2) == 0 {
            y = origin[1].clone() + offset.clone() * guide.cos();
        } else {
            x = origin[0].clone() - offset.clone() * guide.sin();
        }
        let found = [
            self.component(Name::new("x", name), value.x, Unit::Length, x),
            self.component(Name::new("y", name), value.y, Unit::Length, y),
        ];
        self.keep(0, name, found.clone());
        found
    }

    /// The Coriolis acceleration of what slides along a guide that turns, to the left of the guide.
    pub(super) fn coriolis(&mut self, point: &str, omega: &Expr, along: &Expr) -> Expr {
        let right = Expr::Int(2) * omega.clone() * along.clone();
        let value = right.value();
        self.equate(Name::new("a", point).marked("k"), value, Unit::Acceleration, right)
    }

    /// Keeps the velocity (1) or acceleration (2) of a point of a slider, given the part along the guide.
    pub(super) fn slid(&mut self, order: usize, slide: &Slide, at: Vec2, along: &Expr) -> [Expr; 2] {
        let point = self.point_name(slide.body, at);
        let guide = self.guide(slide);
        let here = self.position(slide.body, at);
        let [mut x, mut y] = self.under(order, slide.base, &point, &here);
        if order == 2 && slide.base != 0 {
            let omega = self.bodies[slide.base].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
            let speed = self.sliding_name("v", slide, at);
            let speed = self.found.get(&speed).cloned().unwrap_or(Expr::ZERO);
            let coriolis = self.coriolis(&point, &omega, &speed);
            x = x - coriolis.clone() * guide.sin();
            y = y + coriolis * guide.cos();
        }
        let right = [x + along.clone() * guide.cos(), y + along.clone() * guide.sin()];
        let moved = self.moved(slide.body);
        let value = if order == 1 { moved.velocity(at) } else { moved.acceleration(at) };
        self.components(order, &point, value, right)
    }
}
