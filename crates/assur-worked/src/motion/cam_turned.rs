//! Designed cams that their followers turn: the law read backwards, ω = ṡ/s′, ε = (s̈ − s″ ω²)/s′ for the cam's angle.

use super::cam::{CamLaw, lifts_clockwise};
use super::{Stage, of};
use crate::angle::Angle;
use crate::course::{Body, Course};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_position::plan::CamStep;

impl Course<'_> {
    /// A cam on the ground that its follower turns. Whether it is such a one.
    pub(super) fn cam_turned(&mut self, stage: Stage, index: usize, step: &CamStep) -> bool {
        let contact = &step.contact;
        if contact.frame.index() != 0 {
            return false;
        }
        let disk = contact.disk.index();
        // small `s` is how far the follower has moved along its guide
        let law = self.law_of_cam(step, "S");
        match stage {
            Stage::Positions => self.turned_to(index, step, &law),
            Stage::Velocities => {
                let turning = self.rate_of_lift(0, step, &law) / self.derivative(&law, 1);
                self.rate_of_disk(0, disk, if step.cam.ccw { turning } else { -turning });
                self.rates_of_blocks(0, index, disk);
            }
            Stage::Accelerations => {
                let turning = self.bodies[disk].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
                let (first, second) = (self.derivative(&law, 1), self.derivative(&law, 2));
                let turning = (self.rate_of_lift(1, step, &law) - second * turning.squared()) / first;
                self.rate_of_disk(1, disk, if step.cam.ccw { turning } else { -turning });
                self.rates_of_blocks(1, index, disk);
            }
        }
        true
    }

    /// The cam where its law has the lift.
    fn turned_to(&mut self, index: usize, step: &CamStep, law: &CamLaw) {
        let contact = &step.contact;
        let disk = contact.disk.index();
        let cam = self.scene.mechanism().cams[contact.cam].name.clone();
        if law.turns {
            self.lift(law, step);
        } else {
            self.lift_of_way(step, law);
        }
        self.say(Message::CamTurnedBy, &[vec![text(cam)], of(&law.turned), of(&law.lift)]);
        let turned = self.stated(law.turned.clone(), law.angle.to_degrees(), Unit::Angle);
        let label = self.label(disk);
        let towards = self.direction_given(contact.towards, || Name::new("λ", &label)).whole();
        let sum = if step.cam.ccw { towards + turned } else { towards - turned };
        let phi = self.angle_sum(Name::new("φ", &label), sum);
        self.bodies[disk] =
            Some(Body { reference: contact.centre, angle: Angle::of(phi), rates: [Expr::ZERO, Expr::ZERO] });
        for body in self.structure().motion[index].bodies.iter().map(|b| b.0).filter(|b| *b != disk) {
            let u = self.moved(body).u;
            self.optional.insert(self.blocks.len());
            let degrees = libm::atan2(u.y, u.x).to_degrees();
            let angle = Angle::of(self.stated(Name::new("φ", &self.label(body)), degrees, Unit::Angle));
            self.bodies[body] =
                Some(Body { reference: Vec2::zero(), angle, rates: [Expr::ZERO, Expr::ZERO] });
        }
    }

    /// The lift is how far the follower is from where it begins.
    fn lift_of_way(&mut self, step: &CamStep, law: &CamLaw) {
        let contact = &step.contact;
        let slot = contact.follower.index();
        let end = self.position(slot, contact.point);
        let centre = self.position(contact.frame.index(), contact.frame_centre);
        let way = [end[0].clone() - centre[0].clone(), end[1].clone() - centre[1].clone()];
        let way = self.direction_given(contact.towards, || Name::new("λ", &self.label(slot))).along(&way);
        let begin = Name { letter: "d".into(), ..law.lift.clone() };
        self.say(Message::LiftBegins, &[of(&begin)]);
        let begin = self.given(begin, way.value() - law.values[0], Unit::Length);
        self.equate(law.lift.clone(), law.values[0], Unit::Length, way - begin);
    }

    /// How fast the lift grows (0), and how its rate does (1): from the follower, which moves as something else has it.
    fn rate_of_lift(&mut self, order: usize, step: &CamStep, law: &CamLaw) -> Expr {
        let contact = &step.contact;
        let slot = contact.follower.index();
        if law.turns {
            let rate = self.bodies[slot].as_ref().map_or(Expr::ZERO, |b| b.rates[order].clone());
            return if lifts_clockwise(step) { -rate } else { rate };
        }
        let parts = match order {
            0 => self.velocity(slot, contact.point),
            _ => self.acceleration(slot, contact.point),
        };
        self.direction_given(contact.towards, || Name::new("λ", &self.label(slot))).along(&parts)
    }

    fn rate_of_disk(&mut self, order: usize, disk: usize, right: Expr) {
        let moved = *self.moved(disk);
        let value = [moved.omega, moved.alpha][order];
        let unit = [Unit::AngularVelocity, Unit::AngularAcceleration][order];
        let name = Name::new(["ω", "α"][order], &self.label(disk));
        let found = self.equate(name, value, unit, right);
        self.set_rate(disk, order, found);
        if order == 0 {
            self.senses(&[disk]);
        }
    }
}
