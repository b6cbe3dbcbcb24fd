//! A link on three legs: its three pins are where its legs hold them.

use super::whole::Row;
use super::{end, pin};
use crate::angle::Angle;
use crate::course::{Body, Derivation, joined};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::group::general::Pose;
use assur_position::plan::{Leg, TriadLeg, TriadMotion};
use assur_solve::solve::Iteration;

impl Derivation<'_> {
    /// The position of a link on three legs. Whether it closes with what is written.
    pub(super) fn on_three_legs(&mut self, triad: &TriadMotion, found: &Iteration) -> bool {
        let (body, label) = (triad.body, self.label(triad.body));
        let moved = *self.moved(body);
        let mean = self.point_name(body, triad.mean);
        let pins = triad.plate.arms.map(|arm| triad.mean + arm);
        let names = pins.map(|at| self.point_name(body, at));
        self.say(
            Message::ThreeLegs,
            &[vec![text(&*label)], vec![text(&*mean)], vec![text(names.join(", "))]],
        );
        let unknowns = [Name::new("x", &mean), Name::new("y", &mean), Name::new("φ", &label)];
        let rows = names.clone().map(|name| Name::new("Δ", &name));
        let stands = Pose { p: moved.position(triad.mean), u: moved.u };
        let Some([x, y, phi]) = self.newton(found, &[unknowns], &rows, &[stands]).pop() else { return false };
        self.keep(0, &mean, [x.clone(), y.clone()]);
        let reference = self.some_point(body);
        let rates = [Expr::ZERO, Expr::ZERO];
        self.bodies[body] = Some(Body { reference: triad.mean, angle: Angle::of(phi), rates: rates.clone() });
        let mut left: Vec<Row> = Vec::new();
        for ((leg, at), name) in triad.legs.iter().zip(pins).zip(&names) {
            let (length, line) = self.line_of(body, triad.mean, at);
            let right = [x.clone() + length.clone() * line.cos(), y.clone() + length * line.sin()];
            let a = self.coordinates(name, moved.position(at), right);
            left.push((Name::new("Δ", name), Unit::Length, self.left_of_leg(leg, name, &a)));
        }
        let closes = self.left_with(left);
        if let Some(plate) = &mut self.bodies[body] {
            plate.reference = reference;
        }
        for ((leg, at), name) in triad.legs.iter().zip(pins).zip(&names) {
            let a = self.position(body, at);
            match leg {
                TriadLeg::Link(leg) => self.towards_pin(leg, name, &a),
                TriadLeg::Slider { slide, pin: at, .. } => self.slider(slide, pin(at)),
            }
        }
        closes
    }

    /// What a leg leaves open: (r² − l²) / 2l of a link, the distance from the line of a guide.
    fn left_of_leg(&mut self, leg: &TriadLeg, name: &str, a: &[Expr; 2]) -> Expr {
        let from = |o: [Expr; 2]| {
            let [x, y] = o;
            [a[0].clone() - x, a[1].clone() - y]
        };
        match leg {
            TriadLeg::Link(leg) => {
                let outer = self.point_name(leg.body, pin(&leg.pin));
                let base = self.anchor(&leg.base);
                let [dx, dy] = from(base);
                let length = self.length(&outer, name, leg.length);
                (dx.squared() + dy.squared() - length.clone().squared()) / (Expr::Int(2) * length)
            }
            TriadLeg::Slider { slide, offset, .. } => {
                let guide = self.guide(slide);
                let origin = self.position(slide.base, slide.origin);
                let value = if offset.abs() <= self.tiny { 0.0 } else { *offset };
                guide.across(&from(origin)) - self.given(Name::new("h", name), value, Unit::Length)
            }
        }
    }

    /// The direction of a leg whose ends are known.
    fn towards_pin(&mut self, leg: &Leg, name: &str, a: &[Expr; 2]) {
        let (from, to) = (pin(&leg.pin), end(leg));
        let outer = self.point_name(leg.body, from);
        let base = self.anchor(&leg.base);
        let d = [a[0].clone() - base[0].clone(), a[1].clone() - base[1].clone()];
        let line = joined(&outer, name);
        let own = self.direction_given(to - from, || Name::new("γ", &line));
        let label = self.label(leg.body);
        let angle = if own.part.is_none() && own.quarters == 0 {
            self.direction_of(Name::new("φ", &label), &d, &line)
        } else {
            let delta = self.direction_of(Name::new("δ", &line), &d, &line);
            self.angle_sum(Name::new("φ", &label), delta - own.whole())
        };
        let rates = [Expr::ZERO, Expr::ZERO];
        self.bodies[leg.body] = Some(Body { reference: from, angle: Angle::of(angle), rates });
    }
}
