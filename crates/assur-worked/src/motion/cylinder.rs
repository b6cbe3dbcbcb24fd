//! A link on a cylinder: at one position the cylinder is a bar of known length, so that three sides of the triangle are known.

use super::driven_legs::hinge_of;
use super::pin;
use super::triangle::Triangle;
use crate::angle::Angle;
use crate::course::{Body, Derivation, joined};
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_position::plan::{DrivenJoint, DrivenLeg, Slide};

/// A cylinder whose line passes this near to both of its hinges, over its length, is a bar.
const STRAIGHT: f64 = 1e-9;

impl Derivation<'_> {
    /// The position of a link hung by a hinge and held by a cylinder. Whether it is such a group.
    pub(super) fn on_cylinder(&mut self, legs: &[DrivenLeg; 2]) -> bool {
        let (plain, driven, slide) = match legs {
            [plain, driven] | [driven, plain] if plain.joint.is_none() => match &driven.joint {
                Some(DrivenJoint::Shift { slide, .. }) => (plain, driven, *slide),
                _ => return false,
            },
            _ => return false,
        };
        let Some([at, on_rod]) = hinge_of(self.structure(), [plain.body, slide.body]) else { return false };
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
        let from = self.moved(plain.body).position(hinge);
        let left = (outer - from).cross(inner - from) > 0.0;
        let corners = [&*one, &*two, &*name];
        let sum = self.side_of_triangle(&Triangle { corners, outer: [&a, &b], sides: [&l_1, &l_2], left });
        let index = joined(&one, &name);
        let own = self.direction_given(at - hinge, || Name::new("γ", &index));
        let line = self.line_and_body(plain.body, hinge, &own, &index, sum);
        let right = [a[0].clone() + l_1.clone() * line.cos(), a[1].clone() + l_1 * line.sin()];
        let c = self.coordinates(&name, inner, right);
        let d = [c[0].clone() - b[0].clone(), c[1].clone() - b[1].clone()];
        let direction = self.direction_of(Name::new("δ", &joined(&two, &name)), &d, &joined(&two, &name));
        self.barrel_and_rod(driven, &slide, on_rod, direction, along.dot(bar) < 0.0);
        true
    }

    /// The direction of a line of a body, whose own direction in its frame is known, and that of the body.
    pub(super) fn line_and_body(
        &mut self,
        body: usize,
        from: Vec2,
        own: &Angle,
        index: &str,
        sum: Expr,
    ) -> Angle {
        let straight = own.part.is_none() && own.quarters == 0;
        let name = if straight { Name::new("φ", &self.label(body)) } else { Name::new("φ", index) };
        let line = Angle::of(self.angle_sum(name, sum));
        let angle = if straight {
            line.clone()
        } else {
            let right = line.minus(own).whole();
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
}
