//! Designed cams that their followers turn: the law read backwards, ω = ṡ/s′, ε = (s̈ − s″ ω²)/s′ for the cam's angle.

use super::cam::{CamLaw, lifts_clockwise};
use super::{Stage, of};
use crate::angle::Angle;
use crate::course::{Body, Derivation};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_position::plan::CamStep;

impl Derivation<'_> {
    /// A cam that its follower turns.
    pub(super) fn cam_turned(&mut self, stage: Stage, step: &CamStep) {
        let (disk, frame) = (step.contact.disk.index(), step.contact.frame.index());
        // small `s` is how far the follower has moved along its guide
        let law = self.law_of_cam(step, "S");
        match stage {
            Stage::Positions => {
                self.turned_to(step, &law);
                self.block_placed(stage, step, &law);
            }
            Stage::Velocities => {
                let turning = self.rate_of_lift(0, step, &law) / self.derivative(&law, step, 1);
                let base = self.rate_of_body(frame, 0);
                self.rate_of_disk(0, disk, if step.cam.ccw { base + turning } else { base - turning });
                self.block_placed(stage, step, &law);
            }
            Stage::Accelerations => {
                let turning = self.rate_of_body(disk, 0) - self.rate_of_body(frame, 0);
                let (first, second) = (self.derivative(&law, step, 1), self.derivative(&law, step, 2));
                let turning = (self.rate_of_lift(1, step, &law) - second * turning.squared()) / first;
                let base = self.rate_of_body(frame, 1);
                self.rate_of_disk(1, disk, if step.cam.ccw { base + turning } else { base - turning });
            }
        }
    }

    /// The cam where its law has the lift.
    fn turned_to(&mut self, step: &CamStep, law: &CamLaw) {
        let contact = &step.contact;
        let disk = contact.disk.index();
        let cam = self.scene.mechanism().cams[contact.cam].name.clone();
        if law.turns {
            self.lift_of_lever(step, law);
        } else {
            self.lift_of_way(step, law);
        }
        self.say(Message::CamTurnedBy, &[vec![text(cam)], of(&law.turned), of(&law.lift)]);
        let degrees = law.angle.to_degrees();
        let turned = match self.angle_by_stage(step, law) {
            Some(right) => self.equate(law.turned.clone(), degrees, Unit::Angle, right),
            None => {
                // the law with this angle in it follows
                self.solutions.insert(law.turned.clone());
                self.say(Message::RootOfLaw, &[of(&law.turned)]);
                self.stated(law.turned.clone(), degrees, Unit::Angle)
            }
        };
        let looks = self.cam_looks(step, disk).whole();
        let sum = if step.cam.ccw { looks + turned } else { looks - turned };
        let phi = self.angle_sum(Name::new("φ", &self.label(disk)), sum);
        self.bodies[disk] =
            Some(Body { reference: contact.centre, angle: Angle::of(phi), rates: [Expr::ZERO, Expr::ZERO] });
        self.lift_holds(step, law);
    }

    /// The law at the angle found has the lift.
    fn lift_holds(&mut self, step: &CamStep, law: &CamLaw) {
        if let Some([right, ..]) = self.lift_by_stage(step, law) {
            let (value, unit) = law.lifted();
            self.confirm(law.lift.clone(), value, unit, right);
        }
    }

    /// The lift is how far the follower is from where it begins.
    fn lift_of_way(&mut self, step: &CamStep, law: &CamLaw) {
        let contact = &step.contact;
        let slot = contact.follower.index();
        let end = self.position(slot, contact.point);
        let centre = self.position(contact.frame.index(), contact.frame_centre);
        let way = [end[0].clone() - centre[0].clone(), end[1].clone() - centre[1].clone()];
        let way = self.cam_looks(step, slot).along(&way);
        let begin = Name { letter: "d".into(), ..law.lift.clone() };
        self.say(Message::LiftBegins, &[of(&begin)]);
        let begin = self.given(begin, way.value() - law.values[0], Unit::Length);
        self.equate(law.lift.clone(), law.values[0], Unit::Length, way - begin);
    }

    /// How fast the lift grows (0), and how its rate does (1): from the follower, which moves as something else has it.
    fn rate_of_lift(&mut self, order: usize, step: &CamStep, law: &CamLaw) -> Expr {
        let contact = &step.contact;
        let slot = contact.follower.index();
        let frame = contact.frame.index();
        if law.turns {
            let rate = self.rate_of_body(slot, order) - self.rate_of_body(frame, order);
            return if lifts_clockwise(step) { -rate } else { rate };
        }
        let [x, y] = match order {
            0 => self.velocity(slot, contact.point),
            _ => self.acceleration(slot, contact.point),
        };
        let here = self.position(slot, contact.point);
        let point = self.point_name(slot, contact.point);
        // it moves along the way in the frame: Coriolis' acceleration is across
        let [u, w] = self.under(order + 1, frame, &point, &here);
        self.cam_looks(step, slot).along(&[x - u, y - w])
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
