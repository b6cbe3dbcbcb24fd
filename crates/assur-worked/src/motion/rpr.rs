//! Dyad RPR: a link hung by a hinge A carries a guide, along which a body hung by a hinge B slides.

use super::{Stage, pin, unknown};
use crate::angle::Angle;
use crate::course::{Body, Course, joined};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Function, Name, Unit};
use assur_math::math::Vec2;
use assur_position::plan::{Anchor, Arm, Slide};

/// A dyad in letters.
struct Letters {
    points: [String; 2],
    label: String,
    /// The guide, the distance along it, the offset.
    guide: Angle,
    along: Expr,
    offset: Expr,
}

impl Course<'_> {
    pub(super) fn rpr(
        &mut self,
        stage: Stage,
        branch: usize,
        bases: &[Anchor; 2],
        pins: [Arm; 2],
        slide: &Slide,
    ) {
        match stage {
            Stage::Positions => self.rpr_position(branch, bases, pins, slide),
            Stage::Velocities => self.rpr_rates(1, branch, bases, pins, slide),
            Stage::Accelerations => self.rpr_rates(2, branch, bases, pins, slide),
        }
    }

    /// How far B is to the left of the parallel to the guide through A, m.
    fn rpr_offset(&mut self, branch: usize, pins: [Arm; 2], slide: &Slide) -> Expr {
        let side = self.state().branches[branch].sides[0];
        let a = (pin(&pins[0]) - slide.origin).turned_back(slide.along).y;
        let b = (pin(&pins[1]) - slide.point).turned_back(slide.direction).y + side * slide.radius;
        let value = if (b - a).abs() <= self.tiny { 0.0 } else { b - a };
        let name = self.point_name(slide.body, pin(&pins[1]));
        self.given(Name::new("h", &name), value, Unit::Length)
    }

    fn rpr_position(&mut self, branch: usize, bases: &[Anchor; 2], pins: [Arm; 2], slide: &Slide) {
        let [one, two] =
            [self.point_name(slide.base, pin(&pins[0])), self.point_name(slide.body, pin(&pins[1]))];
        let [a, b] = [self.anchor(&bases[0]), self.anchor(&bases[1])];
        let d = [b[0].clone() - a[0].clone(), b[1].clone() - a[1].clone()];
        let third = joined(&one, &two);
        let h = self.rpr_offset(branch, pins, slide);
        self.say(Message::Slotted, &[vec![text(&*two)], vec![text(&*one)]]);
        let length = self.distance(Name::new("l", &third), &d);
        let delta = self.direction_of(Name::new("δ", &third), &d, &third);
        let places = [0, 1].map(|i| self.moved([slide.base, slide.body][i]).position(pin(&pins[i])));
        let ahead = (places[1] - places[0]).dot(slide.along.turned(self.moved(slide.base).u)) > 0.0;
        let lean = (h.clone() / length.clone()).of(Function::Arcsin);
        let angle = if ahead { delta - lean } else { delta + Expr::Degrees(180) + lean };
        let own = self.direction_given(slide.along, || Name::new("λ", &self.label(slide.base)));
        let own = own.whole();
        let label = self.label(slide.base);
        let phi = self.angle_sum(Name::new("φ", &label), angle - own);
        self.bodies[slide.base] =
            Some(Body { reference: pin(&pins[0]), angle: Angle::of(phi), rates: [Expr::ZERO, Expr::ZERO] });
        let along = if h.is_zero() { length } else { (length.squared() - h.squared()).root() };
        let along = if ahead { along } else { -along };
        let value = along.value();
        self.equate(Name::new("s", &third), value, Unit::Length, along);
        self.slider(slide, pin(&pins[1]));
    }

    fn rpr_letters(&mut self, branch: usize, pins: [Arm; 2], slide: &Slide) -> Letters {
        let points = [self.point_name(slide.base, pin(&pins[0])), self.point_name(slide.body, pin(&pins[1]))];
        let name = Name::new("s", &joined(&points[0], &points[1]));
        let along = self.found.get(&name).cloned().unwrap_or(Expr::ZERO);
        let offset = self.rpr_offset(branch, pins, slide);
        Letters { label: self.label(slide.base), guide: self.guide(slide), along, offset, points }
    }

    /// Velocities (1) or accelerations (2).
    fn rpr_rates(&mut self, order: usize, branch: usize, bases: &[Anchor; 2], pins: [Arm; 2], slide: &Slide) {
        let l = self.rpr_letters(branch, pins, slide);
        let both = bases.map(|base| match order {
            1 => self.velocity(base.body, base.at),
            _ => self.acceleration(base.body, base.at),
        });
        let [a, b] = both;
        let d = [b[0].clone() - a[0].clone(), b[1].clone() - a[1].clone()];
        self.rpr_vectors(order, bases, slide, &l);
        let body = slide.base;
        let name = self.sliding_name(["", "v", "a"][order], slide, pin(&pins[1]));
        self.say(Message::AcrossGuide, &[]);
        if order == 1 {
            let value = self.moved(body).omega;
            let right = l.guide.across(&d) / l.along.clone();
            let omega = self.equate(Name::new("ω", &l.label), value, Unit::AngularVelocity, right);
            self.set_rate(body, 0, omega.clone());
            self.say(Message::AlongGuide, &[]);
            let right = l.guide.along(&d) + omega * l.offset.clone();
            let value = self.rpr_sliding(1, slide, pin(&pins[1]));
            self.equate(name, value, Unit::Velocity, right);
            self.senses(&[body]);
        } else {
            let omega = self.bodies[body].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
            let speed = self.sliding_name("v", slide, pin(&pins[1]));
            let speed = self.found.get(&speed).cloned().unwrap_or(Expr::ZERO);
            let coriolis = self.coriolis(&l.points[1], &omega, &speed);
            let value = self.moved(body).alpha;
            let top = l.guide.across(&d) - coriolis + omega.clone().squared() * l.offset.clone();
            let right = top / l.along.clone();
            let alpha = self.equate(Name::new("α", &l.label), value, Unit::AngularAcceleration, right);
            self.set_rate(body, 1, alpha.clone());
            self.say(Message::AlongGuide, &[]);
            let right = l.guide.along(&d) + alpha * l.offset.clone() + omega.squared() * l.along.clone();
            let value = self.rpr_sliding(2, slide, pin(&pins[1]));
            self.equate(name, value, Unit::Acceleration, right);
        }
        self.set_slider_rate(slide, order - 1);
    }

    /// What the state says of the speed, or the acceleration, along the guide.
    pub(super) fn rpr_sliding(&self, order: usize, slide: &Slide, at: Vec2) -> f64 {
        let (base, body) = (self.moved(slide.base), self.moved(slide.body));
        let d = slide.along.turned(base.u);
        let r = body.position(at) - base.p;
        let under = base.v + r.perp() * base.omega;
        let speed = (body.velocity(at) - under).dot(d);
        if order == 1 {
            return speed;
        }
        let under = base.a + r.perp() * base.alpha - r * (base.omega * base.omega);
        (body.acceleration(at) - under).dot(d)
    }

    /// v_B2 = v_B1 + v_B2B1
    fn rpr_vectors(&mut self, order: usize, bases: &[Anchor; 2], slide: &Slide, l: &Letters) {
        let letter = ["", "v", "a"][order];
        let [one, two] = &l.points;
        let stage = if order == 1 { Stage::Velocities } else { Stage::Accelerations };
        let mut terms = Vec::new();
        let left = self.absolute(stage, "", &bases[1]);
        match left {
            Some(term) => terms.push(term),
            None => {
                let zero = vec![text("0")];
                terms.push(self.term("", Name::new(letter, two), zero, vec![text("–")]));
            }
        }
        let absolute = self.absolute(stage, "=", &bases[0]);
        let mut sign = if absolute.is_some() { "+" } else { "=" };
        terms.extend(absolute);
        let turned = Name::new(letter, &joined(&format!("{two}{}", l.label), one));
        if order == 2 {
            let omega = self.bodies[slide.base].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
            let length = Name::new("s", &joined(one, two));
            let size = self.found.get(&length).cloned().unwrap_or(Expr::ZERO);
            let size = super::formula(&(omega.squared() * size));
            terms.push(self.term(sign, turned.marked("n"), size, super::towards(two, one)));
            terms.push(self.term(
                "+",
                turned.marked(self.language.letters().tangential),
                unknown(),
                super::across(two, one),
            ));
            let across = vec![text(format!("⊥ {}", self.words(Message::Guide)))];
            terms.push(self.term("+", Name::new("a", two).marked("k"), vec![text("2 ω v")], across));
            sign = "+";
        } else {
            terms.push(self.term(sign, turned, unknown(), super::across(two, one)));
            sign = "+";
        }
        let along = vec![text(format!("∥ {}", self.words(Message::Guide)))];
        let name = Name::new(letter, &format!("{two},{}", l.label));
        terms.push(self.term(sign, name, unknown(), along));
        self.vectors(terms);
    }
}
