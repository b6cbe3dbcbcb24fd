//! Dyad RPR: a link hung by a hinge A carries a guide, along which a body hung by a hinge B slides. B is compared with the point of the
//! guide's link that it covers at this instant.

use super::{Stage, of, pin, unknown};
use crate::angle::Angle;
use crate::course::{Body, Derivation, joined};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Function, Name, Unit};
use assur_math::math::Vec2;
use assur_model::structure::JointKind;
use assur_position::plan::{Anchor, Arm, Slide};

/// A dyad in letters.
struct Letters {
    points: [String; 2],
    label: String,
    /// The point of the guide's link that B covers; its motion against B.
    covered: String,
    relative: String,
    /// The guide, the distance along it, the offset.
    guide: Angle,
    along: Expr,
    offset: Expr,
}

impl Derivation<'_> {
    pub(super) fn rpr(
        &mut self,
        stage: Stage,
        branch: usize,
        bases: &[Anchor; 2],
        pins: [Arm; 2],
        slide: &Slide,
    ) {
        let (mut bases, mut pins, mut slide) = (*bases, pins, *slide);
        if self.has_guide_on_slider(&slide) {
            (bases, pins, slide) = ([bases[1], bases[0]], [pins[1], pins[0]], seen_from_slider(&slide));
        }
        match stage {
            Stage::Positions => self.rpr_position(branch, &bases, pins, &slide),
            Stage::Velocities => self.rpr_rates(1, branch, &bases, pins, &slide),
            Stage::Accelerations => self.rpr_rates(2, branch, &bases, pins, &slide),
        }
    }

    /// Whether the file has the guide on the link that slides in the plan.
    fn has_guide_on_slider(&self, slide: &Slide) -> bool {
        slide.radius == 0.0
            && self.structure().replaced.joints.iter().any(|joint| match joint.kind {
                JointKind::Prismatic { slider, guide, .. } => (slider.0, guide.0) == (slide.base, slide.body),
                _ => false,
            })
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
        let mut parts = vec![vec![text(self.label(slide.base))], vec![text(&*one)], vec![text(&*two)]];
        let message = if h.is_zero() { Message::SlottedThrough } else { Message::Slotted };
        if !h.is_zero() {
            parts.push(of(&Name::new("h", &two)));
        }
        self.say(message, &parts);
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
        let covered = self.covered_point(&points[1], slide.base);
        let relative = self.against_slider(&points[1], slide.base, slide.body);
        let (label, guide) = (self.label(slide.base), self.guide(slide));
        Letters { points, label, covered, relative, guide, along, offset }
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
        let back = d.clone().map(|part| -part);
        self.say(Message::AcrossGuide, &[]);
        let value = -self.rpr_sliding(order, slide, pin(&pins[1]));
        let sliding = |letter| Name::new(letter, &l.relative);
        if order == 1 {
            let omega = self.moved(body).omega;
            let right = l.guide.across(&d) / l.along.clone();
            let omega = self.equate(Name::new("ω", &l.label), omega, Unit::AngularVelocity, right);
            self.set_rate(body, 0, omega.clone());
            self.say(Message::AlongGuide, &[]);
            let right = l.guide.along(&back) - omega * l.offset.clone();
            self.equate(sliding("v"), value, Unit::Velocity, right);
            self.senses(&[body]);
        } else {
            let omega = self.bodies[body].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
            let speed = self.found.get(&sliding("v")).cloned().unwrap_or(Expr::ZERO);
            let right = Expr::Int(2) * omega.clone() * speed;
            let coriolis = right.value();
            let coriolis = self.equate(sliding("a").marked("k"), coriolis, Unit::Acceleration, right);
            let alpha = self.moved(body).alpha;
            let top = l.guide.across(&d) + coriolis + omega.clone().squared() * l.offset.clone();
            let right = top / l.along.clone();
            let alpha = self.equate(Name::new("α", &l.label), alpha, Unit::AngularAcceleration, right);
            self.set_rate(body, 1, alpha.clone());
            self.say(Message::AlongGuide, &[]);
            let right = l.guide.along(&back) - alpha * l.offset.clone() - omega.squared() * l.along.clone();
            self.equate(sliding("a").marked("r"), value, Unit::Acceleration, right);
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

    /// v_B3 = v_B + v_B3B2, where B3 is the point of the guide's link that B covers.
    fn rpr_vectors(&mut self, order: usize, bases: &[Anchor; 2], slide: &Slide, l: &Letters) {
        let letter = ["", "v", "a"][order];
        let [one, two] = &l.points;
        let stage = if order == 1 { Stage::Velocities } else { Stage::Accelerations };
        if order == 1 {
            let parts = [&l.covered, &l.label, two].map(|words| vec![text(&**words)]);
            self.say(Message::Covered, &parts);
        }
        let mut terms = Vec::new();
        let base = self.absolute(stage, "", &bases[0]);
        let mut sign = if base.is_some() { "+" } else { "" };
        let index = if base.is_some() { joined(&l.covered, one) } else { l.covered.clone() };
        terms.extend(base);
        let turned = Name::new(letter, &index);
        if order == 2 {
            let size = super::formula(&self.rpr_normal(slide, l));
            terms.push(self.term(sign, turned.marked("n"), size, super::towards(two, one)));
            let tangential = turned.marked(self.language.letters().tangential);
            terms.push(self.term("+", tangential, unknown(), super::across(one, two)));
        } else {
            terms.push(self.term(sign, turned, unknown(), super::across(one, two)));
        }
        let slider = self.absolute(stage, "=", &bases[1]);
        sign = if slider.is_some() { "+" } else { "=" };
        terms.extend(slider);
        let relative = Name::new(letter, &l.relative);
        let guide = self.words(Message::Guide);
        if order == 2 {
            let across = vec![text(format!("⊥ {guide}"))];
            terms.push(self.term(sign, relative.marked("k"), vec![text("2 ω v")], across));
            terms.push(self.term("+", relative.marked("r"), unknown(), vec![text(format!("∥ {guide}"))]));
        } else {
            terms.push(self.term(sign, relative, unknown(), vec![text(format!("∥ {guide}"))]));
        }
        self.vectors(terms);
    }

    /// ω² times the distance of B from A.
    fn rpr_normal(&self, slide: &Slide, l: &Letters) -> Expr {
        let letter = if l.offset.is_zero() { "s" } else { "l" };
        let length = Name::new(letter, &joined(&l.points[0], &l.points[1]));
        let length = self.found.get(&length).cloned().unwrap_or(Expr::ZERO);
        let length = if length.value() < 0.0 { length.abs() } else { length };
        let omega = self.bodies[slide.base].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
        omega.squared() * length
    }

    /// The index of a point of a link that another point covers: A4.
    fn covered_point(&self, point: &str, body: usize) -> String {
        let label = self.label(body);
        let short =
            !point.ends_with(|c: char| c.is_ascii_digit()) && label.chars().all(|c| c.is_ascii_digit());
        if short { format!("{point}{label}") } else { format!("{point},{label}") }
    }

    /// The index of the motion of a link against a slider at the slider's point: A4A3.
    pub(crate) fn against_slider(&self, point: &str, carrier: usize, slider: usize) -> String {
        let [of, against] = [carrier, slider].map(|body| self.covered_point(point, body));
        if of.contains(',') { format!("{of},{}", self.label(slider)) } else { format!("{of}{against}") }
    }
}

/// The same guide with the line on the body that slides, and the other sliding along it.
fn seen_from_slider(slide: &Slide) -> Slide {
    Slide {
        base: slide.body,
        origin: slide.point,
        along: slide.direction,
        body: slide.base,
        point: slide.origin,
        direction: slide.along,
        turn: Vec2::new(slide.turn.x, -slide.turn.y),
        ..*slide
    }
}
