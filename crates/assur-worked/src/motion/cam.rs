//! Followers of designed cams: the law of the cam at its angle, and the rates by the chain rule.

use super::{Stage, of};
use crate::angle::Angle;
use crate::course::{Body, Course};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::element::cam::Follower;
use assur_model::structure::BodyOrigin;
use assur_position::plan::CamStep;

impl Course<'_> {
    /// A follower that its cam moves, on the ground. Whether it is such a one.
    pub(super) fn cam(&mut self, stage: Stage, index: usize, step: &CamStep) -> bool {
        let contact = &step.contact;
        if contact.frame.index() != 0 {
            return false;
        }
        let disk = contact.disk.index();
        let sense = if step.cam.ccw { -1.0 } else { 1.0 };
        let phi = sense * contact.towards.turned_back(self.moved(disk).u).angle();
        let [s, first, second, _] = step.cam.at(phi).lift;
        let turns = matches!(step.cam.follower, Follower::Oscillating { .. });
        let pair = self.scene.mechanism().pair(contact.pair).name.clone();
        let rate = |course: &Self, order: usize| {
            let rate = course.bodies[disk].as_ref().map_or(Expr::ZERO, |b| b.rates[order].clone());
            if sense > 0.0 { -rate } else { rate }
        };
        let (letters, scale, unit) = if turns {
            (Name::new("ψ", &pair), 180.0 / std::f64::consts::PI, [Unit::Angle, Unit::One])
        } else {
            (Name::new("s", &pair), 1.0, [Unit::Length, Unit::Length])
        };
        let primed = |marks: &str| Name { letter: format!("{}{marks}", letters.letter), ..letters.clone() };
        match stage {
            Stage::Positions => {
                let cam = self.scene.mechanism().cams[contact.cam].name.clone();
                let turned = Name::new("θ", &pair);
                self.say(Message::CamTurned, &[vec![text(cam)], of(&turned), of(&letters)]);
                self.stated(turned, phi.to_degrees(), Unit::Angle);
                self.stated_of(letters, scale * s, unit[0], scale * step.cam.program.greatest_lift());
                self.bodies_of_cam(index, step);
            }
            Stage::Velocities => {
                let turning = rate(self, 0);
                let v = self.stated(primed("′"), first, unit[1]);
                let right = v * turning;
                self.rate_of_follower(0, index, step, turns, right);
            }
            Stage::Accelerations => {
                let (turning, more) = (rate(self, 0), rate(self, 1));
                let v = self.stated(primed("′"), first, unit[1]);
                let a = self.stated(primed("″"), second, unit[1]);
                let right = a * turning.squared() + v * more;
                self.rate_of_follower(1, index, step, turns, right);
            }
        }
        true
    }

    /// Where the follower is; the block of the contact only where something needs it.
    fn bodies_of_cam(&mut self, index: usize, step: &CamStep) {
        for body in self.structure().motion[index].bodies.iter().map(|b| b.0) {
            let moved = *self.moved(body);
            let degrees = libm::atan2(moved.u.y, moved.u.x).to_degrees();
            let name = Name::new("φ", &self.label(body));
            let block = matches!(self.structure().replaced.bodies[body].origin, BodyOrigin::Imaginary(_));
            let whole = (degrees - degrees.round()).abs() < 1e-9 && degrees.round() % 90.0 == 0.0;
            let angle = if whole && !block {
                Angle::whole_degrees(moved.u).unwrap_or(Angle::ZERO)
            } else {
                if block {
                    self.optional.insert(self.blocks.len());
                }
                Angle::of(self.stated(name, degrees, Unit::Angle))
            };
            let follower = body == step.contact.follower.index();
            let reference = if follower { step.contact.point } else { assur_math::math::Vec2::zero() };
            self.bodies[body] = Some(Body { reference, angle, rates: [Expr::ZERO, Expr::ZERO] });
        }
    }

    /// The velocity (0) or acceleration (1) of the follower from that of its lift.
    fn rate_of_follower(&mut self, order: usize, index: usize, step: &CamStep, turns: bool, right: Expr) {
        let contact = &step.contact;
        let slot = contact.follower.index();
        let moved = *self.moved(slot);
        if turns {
            let with_cam = matches!(step.cam.follower, Follower::Oscillating { with_cam: true, .. });
            // as the lift counts, and counter-clockwise
            let against = with_cam != step.cam.ccw;
            let value = [moved.omega, moved.alpha][order];
            let name = Name::new(["ω", "α"][order], &self.label(slot));
            let unit = [Unit::AngularVelocity, Unit::AngularAcceleration][order];
            let found = self.equate(name, value, unit, if against { -right } else { right });
            self.set_rate(slot, order, found);
        } else {
            let direction = self.direction_given(contact.towards, || Name::new("λ", &self.label(slot)));
            let point = self.point_name(slot, contact.point);
            let value = [moved.velocity(contact.point), moved.acceleration(contact.point)][order];
            let unit = [Unit::Velocity, Unit::Acceleration][order];
            let name = Name::new(["v", "a"][order], &point);
            let found = self.equate(name, value.dot(contact.towards), unit, right);
            let parts = [found.clone() * direction.cos(), found * direction.sin()];
            self.keep(order + 1, &point, parts);
        }
        for body in self.structure().motion[index].bodies.iter().map(|b| b.0).filter(|b| *b != slot) {
            let moved = *self.moved(body);
            let value = [moved.omega, moved.alpha][order];
            let name = Name::new(["ω", "α"][order], &self.label(body));
            let unit = [Unit::AngularVelocity, Unit::AngularAcceleration][order];
            self.optional.insert(self.blocks.len());
            let found = self.stated(name, value, unit);
            self.set_rate(body, order, found);
        }
    }
}
