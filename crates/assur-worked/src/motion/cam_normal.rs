//! The block that stands for the contact of a designed cam: it slides along the common tangent. The common normal of a tip passes
//! through the relative instant centre of cam and follower, which is s′ from the cam’s centre across the way of a follower that slides, and
//! on the line of centres of one that turns; a face has its normal with it.

use super::Stage;
use super::cam::CamLaw;
use crate::angle::Angle;
use crate::course::{Body, Derivation, joined};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::element::cam::Follower;
use assur_math::math::Vec2;
use assur_model::model::Level;
use assur_position::plan::CamStep;

impl Derivation<'_> {
    /// The block of a contact, behind the derivatives of the lift, where something needs it.
    pub(super) fn block_placed(&mut self, stage: Stage, step: &CamStep, law: &CamLaw) {
        let moves = self.scene.model.plan.effects.level >= Level::Velocities;
        if moves != (stage == Stage::Velocities) {
            return;
        }
        let before = self.blocks.len();
        let angle = match step.contact.face {
            Some((_, along)) => self.along_face(step, along),
            None => self.across_normal(step, law),
        };
        self.optional.extend(before..self.blocks.len());
        let rates = [0, 1].map(|order| self.rate_of_body(step.contact.follower.index(), order));
        self.bodies[step.block] = Some(Body { reference: Vec2::zero(), angle, rates });
    }

    /// Along the face of a follower.
    fn along_face(&self, step: &CamStep, along: Vec2) -> Angle {
        let slot = step.contact.follower.index();
        let own = self.direction_given(along, || Name::new("λ″", &self.label(slot)));
        self.bodies[slot].as_ref().map_or(own.clone(), |body| body.angle.plus(&own))
    }

    /// Across the common normal at a knife edge or a roller.
    fn across_normal(&mut self, step: &CamStep, law: &CamLaw) -> Angle {
        let contact = &step.contact;
        let slot = contact.follower.index();
        let block = self.label(step.block);
        let tip = self.position(slot, contact.tip);
        let name = self.point_name(slot, contact.tip);
        let pole = format!("P{block}");
        let normal = Name::new("δ", &joined(&pole, &name));
        self.lines.push((self.blocks.len(), normal.clone()));
        self.say(Message::CommonNormal, &[vec![text(&*pole)], vec![text(&*name)]]);
        let (place, offset) = self.instant_centre_of_cam(step, law);
        let [x, y] = offset;
        let at = [
            self.equate(Name::new("x", &pole), place.x, Unit::Length, x),
            self.equate(Name::new("y", &pole), place.y, Unit::Length, y),
        ];
        let d = [tip[0].clone() - at[0].clone(), tip[1].clone() - at[1].clone()];
        let towards = Vec2::new(d[0].value(), d[1].value());
        let delta = self.direction_of(normal, &d, &joined(&pole, &name));
        let into = self.moved(step.block).u.perp();
        Angle { quarters: if into.dot(towards) > 0.0 { 3 } else { 1 }, ..Angle::of(delta) }
    }

    /// Where cam and follower move alike, in numbers and as it is found.
    fn instant_centre_of_cam(&mut self, step: &CamStep, law: &CamLaw) -> (Vec2, [Expr; 2]) {
        let contact = &step.contact;
        let looks = self.cam_looks(step, contact.follower.index());
        let centre = self.position(contact.frame.index(), contact.frame_centre);
        let frame = self.moved(contact.frame.index());
        let (from, towards) = (frame.position(contact.frame_centre), contact.towards.turned(frame.u));
        let first = match self.lift_by_stage(step, law) {
            Some(_) => self.derivative(law, step, 1),
            None => Expr::ZERO,
        };
        let (direction, angle, along, value) = match step.cam.follower {
            Follower::Translating { .. } => {
                let across = Angle { quarters: looks.quarters + 1, ..looks };
                let (along, value) =
                    if step.cam.ccw { (-first, -law.values[1]) } else { (first, law.values[1]) };
                (towards.perp(), across, along, value)
            }
            Follower::Oscillating { pivot_distance, with_cam, .. } => {
                let cams = &self.scene.mechanism().cams;
                let of = if cams.len() > 1 { cams[contact.cam].name.clone() } else { String::new() };
                let base = self.given(Name::new("a", &of), pivot_distance, Unit::Length);
                let one = Expr::Int(1);
                let slope = law.values[1];
                let (along, value) = if with_cam {
                    (-(base * first.clone() / (one - first)), -pivot_distance * slope / (1.0 - slope))
                } else {
                    (base * first.clone() / (one + first), pivot_distance * slope / (1.0 + slope))
                };
                (towards, looks, along, value)
            }
        };
        let [x, y] = centre;
        let right = [x + along.clone() * angle.cos(), y + along * angle.sin()];
        (from + direction * value, right)
    }
}
