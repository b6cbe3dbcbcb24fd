//! Dyad RRP: a link hung by a hinge A, joined by a hinge C to a slider.

use super::{Stage, across, end, formula, pin, towards, unknown};
use crate::angle::Angle;
use crate::course::{Derivation, joined};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Function, Name, Unit};
use assur_math::math::Vec2;
use assur_position::plan::{Arm, Leg, Slide};

/// A line of known length that ends on a guide.
pub(super) struct Reached {
    pub angle: Expr,
    /// The guide, a point of it, and how far to its left the line ends.
    pub guide: Angle,
    pub origin: [Expr; 2],
    pub offset: Expr,
}

impl Derivation<'_> {
    pub(super) fn rrp(&mut self, stage: Stage, branch: usize, leg: &Leg, slide: &Slide, inner: Arm) {
        match stage {
            Stage::Positions => self.rrp_position(branch, leg, slide, inner),
            Stage::Velocities => self.rrp_velocity(leg, slide, inner),
            Stage::Accelerations => self.rrp_acceleration(leg, slide, inner),
        }
    }

    /// The distance of a point of a slider from its guide, to the left, m.
    pub(super) fn offset(&mut self, branch: usize, which: usize, slide: &Slide, at: Vec2) -> Expr {
        let side = self.state().branches[branch].sides[which];
        let own = (at - slide.point).turned_back(slide.direction);
        let value = own.y + side * slide.radius;
        let value = if value.abs() <= self.tiny { 0.0 } else { value };
        let name = self.point_name(slide.body, at);
        self.given(Name::new("h", &name), value, Unit::Length)
    }

    fn rrp_position(&mut self, branch: usize, leg: &Leg, slide: &Slide, arm: Arm) {
        let inner = self.point_name(slide.body, pin(&arm));
        let length = self.leg_length(leg);
        let a = self.anchor(&leg.base);
        let moved = self.moved(leg.body);
        let from_outer = moved.position(end(leg)) - moved.position(pin(&leg.pin));
        let Reached { angle, guide, origin: q, offset } =
            self.reaches_guide(branch, (slide, pin(&arm)), &a, &length, from_outer);
        let name = self.leg_angle_name(leg);
        let line = self.angle_sum(name, angle);
        self.hang(leg, line.clone());
        let along = Angle::of(line);
        let value = self.moved(leg.body).position(end(leg));
        let right = [a[0].clone() + length.clone() * along.cos(), a[1].clone() + length * along.sin()];
        self.on_guide(&inner, value, right, &guide, &q, &offset);
        self.slider(slide, pin(&arm));
    }

    /// The direction of a line of known length from a known point to a point that slides on a guide.
    pub(super) fn reaches_guide(
        &mut self,
        branch: usize,
        (slide, at): (&Slide, Vec2),
        a: &[Expr; 2],
        length: &Expr,
        from_outer: Vec2,
    ) -> Reached {
        let inner = self.point_name(slide.body, at);
        let guide = self.guide(slide);
        let origin = self.position(slide.base, slide.origin);
        let offset = self.offset(branch, 0, slide, at);
        let d = [origin[0].clone() - a[0].clone(), origin[1].clone() - a[1].clone()];
        let mut across = offset.clone() + guide.across(&d);
        self.say(Message::OnGuide, &[vec![text(&*inner)]]);
        if guide.part.is_some() {
            let value = across.value();
            across = self.equate(Name::new("e", &inner), value, Unit::Length, across);
        }
        let slope = (across / length.clone()).of(Function::Arcsin);
        let ahead = from_outer.dot(slide.along.turned(self.moved(slide.base).u)) > 0.0;
        let own = guide.whole();
        let angle = if ahead { own + slope } else { own + Expr::Degrees(180) - slope };
        Reached { angle, guide, origin, offset }
    }

    fn rrp_velocity(&mut self, leg: &Leg, slide: &Slide, arm: Arm) {
        let (outer, inner) =
            (self.point_name(leg.body, pin(&leg.pin)), self.point_name(slide.body, pin(&arm)));
        let guide = self.guide(slide);
        let psi = self.leg_angle(leg);
        let length = self.leg_length(leg);
        self.set_slider_rate(slide, 0);
        let a = self.velocity(leg.base.body, leg.base.at);
        let here = self.position(slide.body, pin(&arm));
        let g = self.under(1, slide.base, &inner, &here);
        self.slider_vectors(Stage::Velocities, leg, slide, arm);
        let d = [g[0].clone() - a[0].clone(), g[1].clone() - a[1].clone()];
        let lean = psi.minus(&guide);
        self.say(Message::AcrossGuide, &[]);
        let right = guide.across(&d) / (length.clone() * lean.cos());
        let label = self.label(leg.body);
        let value = self.moved(leg.body).omega;
        let omega = self.equate(Name::new("ω", &label), value, Unit::AngularVelocity, right);
        self.set_rate(leg.body, 0, omega.clone());
        self.say(Message::AlongGuide, &[]);
        let opposite = [a[0].clone() - g[0].clone(), a[1].clone() - g[1].clone()];
        let right = guide.along(&opposite) - omega * length * lean.sin();
        let name = self.sliding_name("v", slide, pin(&arm));
        let value = self.slid_value(1, slide, pin(&arm), &g);
        let along = self.equate(name, value, Unit::Velocity, right);
        self.slid(1, slide, pin(&arm), &along);
        let _ = outer;
        self.senses(&[leg.body]);
    }

    /// What the state says of the velocity (1) or acceleration (2) along a guide.
    pub(super) fn slid_value(&self, order: usize, slide: &Slide, at: Vec2, under: &[Expr; 2]) -> f64 {
        let moved = self.moved(slide.body);
        let whole = if order == 1 { moved.velocity(at) } else { moved.acceleration(at) };
        let d = slide.along.turned(self.moved(slide.base).u);
        (whole - Vec2::new(under[0].value(), under[1].value())).dot(d)
    }

    fn rrp_acceleration(&mut self, leg: &Leg, slide: &Slide, arm: Arm) {
        let (outer, inner) =
            (self.point_name(leg.body, pin(&leg.pin)), self.point_name(slide.body, pin(&arm)));
        let guide = self.guide(slide);
        let psi = self.leg_angle(leg);
        let length = self.leg_length(leg);
        self.set_slider_rate(slide, 1);
        let a = self.acceleration(leg.base.body, leg.base.at);
        let here = self.position(slide.body, pin(&arm));
        let g = self.under(2, slide.base, &inner, &here);
        self.slider_vectors(Stage::Accelerations, leg, slide, arm);
        let normal = self.normal_part(leg, &inner, &outer, &length);
        let coriolis = self.slider_coriolis(slide, pin(&arm));
        let lean = psi.minus(&guide);
        let d = [g[0].clone() - a[0].clone(), g[1].clone() - a[1].clone()];
        self.say(Message::AcrossGuide, &[]);
        let top = guide.across(&d) + coriolis + normal.clone() * lean.sin();
        let right = top / (length.clone() * lean.cos());
        let label = self.label(leg.body);
        let value = self.moved(leg.body).alpha;
        let alpha = self.equate(Name::new("α", &label), value, Unit::AngularAcceleration, right);
        self.set_rate(leg.body, 1, alpha.clone());
        self.say(Message::AlongGuide, &[]);
        let opposite = [a[0].clone() - g[0].clone(), a[1].clone() - g[1].clone()];
        let right = guide.along(&opposite) - normal * lean.cos() - alpha * length * lean.sin();
        let name = self.sliding_name("a", slide, pin(&arm));
        let value = self.slid_value(2, slide, pin(&arm), &g);
        let along = self.equate(name, value, Unit::Acceleration, right);
        self.slid(2, slide, pin(&arm), &along);
    }

    /// The Coriolis acceleration of a slider; nothing on a guide that does not turn.
    pub(super) fn slider_coriolis(&mut self, slide: &Slide, at: Vec2) -> Expr {
        let omega = self.bodies[slide.base].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
        let speed = self.sliding_name("v", slide, at);
        let speed = self.found.get(&speed).cloned().unwrap_or(Expr::ZERO);
        let point = self.point_name(slide.body, at);
        self.coriolis(&point, &omega, &speed)
    }

    /// v_C = v_A + v_CA, along the guide.
    fn slider_vectors(&mut self, stage: Stage, leg: &Leg, slide: &Slide, arm: Arm) {
        let (outer, inner) =
            (self.point_name(leg.body, pin(&leg.pin)), self.point_name(slide.body, pin(&arm)));
        let letter = if stage == Stage::Velocities { "v" } else { "a" };
        let along = vec![text(format!("∥ {}", self.words(Message::Guide)))];
        let mut terms = Vec::new();
        if slide.base == 0 {
            terms.push(self.term("", Name::new(letter, &inner), unknown(), along));
        } else {
            let under = format!("{inner},{}", self.label(slide.base));
            let is_found = |x: &str| self.found.contains_key(&Name::new(letter, &under).and(x));
            let known =
                if is_found("x") || is_found("y") { self.words(Message::Found) } else { "0".to_owned() };
            terms.push(self.term("", Name::new(letter, &under), vec![text(&*known)], vec![text("–")]));
            if stage == Stage::Accelerations {
                let size = vec![text("2 ω v")];
                let across = vec![text(format!("⊥ {}", self.words(Message::Guide)))];
                terms.push(self.term("+", Name::new("a", &inner).marked("k"), size, across));
            }
            let name = self.sliding_name(letter, slide, pin(&arm));
            terms.push(self.term("+", name, unknown(), along));
        }
        let absolute = self.absolute(stage, "=", &leg.base);
        let mut sign = if absolute.is_some() { "+" } else { "=" };
        terms.extend(absolute);
        let name = Name::new(letter, &joined(&inner, &outer));
        if stage == Stage::Accelerations {
            let omega = self.bodies[leg.body].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
            if !omega.is_zero() {
                let size = formula(&(omega.squared() * self.leg_length(leg)));
                terms.push(self.term(sign, name.marked("n"), size, towards(&inner, &outer)));
                sign = "+";
            }
            terms.push(self.term(
                sign,
                name.marked(self.language.letters().tangential),
                unknown(),
                across(&inner, &outer),
            ));
        } else {
            terms.push(self.term(sign, name, unknown(), across(&inner, &outer)));
        }
        self.vectors(terms);
    }
}
