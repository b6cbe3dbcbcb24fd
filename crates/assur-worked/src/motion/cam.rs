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

/// The law of a cam at its angle.
pub(super) struct CamLaw {
    /// The letters of the cam's angle and of the lift.
    pub turned: Name,
    /// The lift of the follower.
    pub lift: Name,
    /// The angle of the cam, rad.
    pub angle: f64,
    /// Lift, first and second derivative: m, or rad where the follower turns.
    pub values: [f64; 3],
    /// The follower turns.
    pub turns: bool,
}

impl Course<'_> {
    /// A follower that its cam moves, on the ground. Whether it is such a one.
    pub(super) fn cam(&mut self, stage: Stage, index: usize, step: &CamStep) -> bool {
        let contact = &step.contact;
        if contact.frame.index() != 0 {
            return false;
        }
        let disk = contact.disk.index();
        let law = self.law_of_cam(step, "s");
        let rate = |course: &Self, order: usize| {
            let rate = course.bodies[disk].as_ref().map_or(Expr::ZERO, |b| b.rates[order].clone());
            if step.cam.ccw { rate } else { -rate }
        };
        match stage {
            Stage::Positions => {
                let cam = self.scene.mechanism().cams[contact.cam].name.clone();
                self.say(Message::CamTurned, &[vec![text(cam)], of(&law.turned), of(&law.lift)]);
                self.stated(law.turned.clone(), law.angle.to_degrees(), Unit::Angle);
                self.lift(&law, step);
                self.bodies_of_cam(index, step);
            }
            Stage::Velocities => {
                let right = self.derivative(&law, 1) * rate(self, 0);
                self.rate_of_follower(0, index, step, law.turns, right);
            }
            Stage::Accelerations => {
                let (first, second) = (self.derivative(&law, 1), self.derivative(&law, 2));
                let right = second * rate(self, 0).squared() + first * rate(self, 1);
                self.rate_of_follower(1, index, step, law.turns, right);
            }
        }
        true
    }

    /// The law of a cam where it stands now, with the letter of a lift that is a shift.
    pub(super) fn law_of_cam(&self, step: &CamStep, shift: &'static str) -> CamLaw {
        let contact = &step.contact;
        let sense = if step.cam.ccw { -1.0 } else { 1.0 };
        let angle = sense * contact.towards.turned_back(self.moved(contact.disk.index()).u).angle();
        let [s, first, second, _] = step.cam.at(angle).lift;
        let turns = matches!(step.cam.follower, Follower::Oscillating { .. });
        let pair = self.scene.mechanism().pair(contact.pair).name.clone();
        let lift = Name::new(if turns { "ψ" } else { shift }, &pair);
        CamLaw { turned: Name::new("θ", &pair), lift, angle, values: [s, first, second], turns }
    }

    /// The lift as the law has it.
    pub(super) fn lift(&mut self, law: &CamLaw, step: &CamStep) {
        let (scale, unit) =
            if law.turns { (180.0 / std::f64::consts::PI, Unit::Angle) } else { (1.0, Unit::Length) };
        self.stated_of(
            law.lift.clone(),
            scale * law.values[0],
            unit,
            scale * step.cam.program.greatest_lift(),
        );
    }

    /// A derivative of the lift by the angle of the cam.
    pub(super) fn derivative(&mut self, law: &CamLaw, order: usize) -> Expr {
        let marks = ["", "′", "″"][order];
        let name = Name { letter: format!("{}{marks}", law.lift.letter), ..law.lift.clone() };
        let unit = if law.turns { Unit::One } else { Unit::Length };
        self.stated(name, law.values[order], unit)
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
            let against = lifts_clockwise(step);
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
        self.rates_of_blocks(order, index, slot);
    }

    /// What turns with the contact, only where something needs it.
    pub(super) fn rates_of_blocks(&mut self, order: usize, index: usize, link: usize) {
        for body in self.structure().motion[index].bodies.iter().map(|b| b.0).filter(|b| *b != link) {
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

/// Whether the lift of a lever counts clockwise.
pub(super) fn lifts_clockwise(step: &CamStep) -> bool {
    let with_cam = matches!(step.cam.follower, Follower::Oscillating { with_cam: true, .. });
    with_cam != step.cam.ccw
}
