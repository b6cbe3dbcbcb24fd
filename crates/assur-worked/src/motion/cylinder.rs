//! A link on a cylinder: at one position the cylinder is a bar of known length, so that three sides of the triangle are known.

use super::pin;
use crate::angle::Angle;
use crate::course::{Body, Course, joined};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Function, Name, Unit};
use assur_math::math::Vec2;
use assur_model::structure::JointKind;
use assur_position::plan::{DrivenJoint, DrivenLeg, Slide};

/// A cylinder whose line passes this near to both of its hinges, over its length, is a bar.
const STRAIGHT: f64 = 1e-9;

impl Course<'_> {
    /// The position of a link hung by a hinge and held by a cylinder. Whether it is such a group.
    pub(super) fn on_cylinder(&mut self, legs: &[DrivenLeg; 2]) -> bool {
        let (plain, driven, slide) = match legs {
            [plain, driven] | [driven, plain] if plain.joint.is_none() => match &driven.joint {
                Some(DrivenJoint::Shift { slide, .. }) => (plain, driven, *slide),
                _ => return false,
            },
            _ => return false,
        };
        let Some([at, on_rod]) = self.shared_hinge(plain.body, slide.body) else { return false };
        let (inner, outer) =
            (self.moved(plain.body).position(at), self.moved(driven.body).position(pin(&driven.pin)));
        let along = slide.along.turned(self.moved(driven.body).u);
        let bar = inner - outer;
        if along.cross(bar).abs() > STRAIGHT * bar.norm() {
            return false;
        }
        let hinge = pin(&plain.pin);
        let one = self.point_name(plain.body, hinge);
        let two = self.point_name(driven.body, pin(&driven.pin));
        let name = self.point_name(plain.body, at);
        let a = self.position(plain.base.body, plain.base.at);
        let b = self.position(driven.base.body, driven.base.at);
        let length = Name::new("l", &joined(&two, &name));
        self.say(Message::CylinderLength, &[super::of(&length)]);
        let l_2 = self.given(length, bar.norm(), Unit::Length);
        let l_1 = self.length(&one, &name, (at - hinge).norm());
        self.say(Message::Triangle, &[vec![text([&*one, &*name, &*two].join(", "))]]);
        let d = [b[0].clone() - a[0].clone(), b[1].clone() - a[1].clone()];
        let third = joined(&one, &two);
        let base = self.distance(Name::new("l", &third), &d);
        let delta = self.direction_of(Name::new("δ", &third), &d, &third);
        let cosine = (l_1.clone().squared() + base.clone().squared() - l_2.clone().squared())
            / (Expr::Int(2) * l_1.clone() * base);
        let right = cosine.of(Function::Arccos);
        let value = right.value();
        let beta = self.equate(Name::new("β", &one), value, Unit::Angle, right);
        let from = self.moved(plain.body).position(hinge);
        let left = (outer - from).cross(inner - from) > 0.0;
        let message = if left { Message::LeftOf } else { Message::RightOf };
        self.say(message, &[&*name, &*one, &*two].map(|w| vec![text(w)]));
        let sum = if left { delta + beta } else { delta - beta };
        let line = self.line_and_body(plain.body, hinge, at, sum);
        let right = [a[0].clone() + l_1.clone() * line.cos(), a[1].clone() + l_1 * line.sin()];
        let c = self.coordinates(&name, inner, right);
        let d = [c[0].clone() - b[0].clone(), c[1].clone() - b[1].clone()];
        let direction = self.direction_of(Name::new("δ", &joined(&two, &name)), &d, &joined(&two, &name));
        self.barrel_and_rod(driven, &slide, on_rod, direction, along.dot(bar) < 0.0);
        true
    }

    /// The direction of a line of a body, and that of the body.
    fn line_and_body(&mut self, body: usize, from: Vec2, to: Vec2, sum: Expr) -> Angle {
        let index = joined(&self.point_name(body, from), &self.point_name(body, to));
        let own = self.direction_given(to - from, || Name::new("γ", &index));
        let straight = own.part.is_none() && own.quarters == 0;
        let name = if straight { Name::new("φ", &self.label(body)) } else { Name::new("φ", &index) };
        let line = Angle::of(self.angle_sum(name, sum));
        let angle = if straight {
            line.clone()
        } else {
            let right = line.minus(&own).whole();
            Angle::of(self.angle_sum(Name::new("φ", &self.label(body)), right))
        };
        self.bodies[body] = Some(Body { reference: from, angle, rates: [Expr::ZERO, Expr::ZERO] });
        line
    }

    /// Barrel and rod lie along the line of the two hinges.
    fn barrel_and_rod(&mut self, driven: &DrivenLeg, slide: &Slide, on_rod: Vec2, line: Expr, against: bool) {
        let own = self.direction_given(slide.along, || Name::new("λ", &self.label(driven.body)));
        let line = Angle::of(line);
        let line = if against { Angle { quarters: (line.quarters + 2) % 4, ..line } } else { line };
        let right = line.minus(&own).whole();
        let angle = self.angle_sum(Name::new("φ", &self.label(driven.body)), right);
        let rates = [Expr::ZERO, Expr::ZERO];
        let reference = pin(&driven.pin);
        self.bodies[driven.body] = Some(Body { reference, angle: Angle::of(angle), rates });
        self.slider(slide, on_rod);
    }

    /// The places of a hinge of two bodies in their frames.
    fn shared_hinge(&self, one: usize, two: usize) -> Option<[Vec2; 2]> {
        self.structure().replaced.joints.iter().find_map(|joint| {
            let JointKind::Revolute(members) = &joint.kind else { return None };
            let at = |body: usize| members.iter().find(|(b, _)| b.0 == body).map(|(_, at)| *at);
            Some([at(one)?, at(two)?])
        })
    }
}
