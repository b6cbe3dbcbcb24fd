//! Groups whose motion is stated, not derived; senses of rotation in words.

use super::{Stage, of};
use crate::angle::Angle;
use crate::course::{Body, Derivation};
use crate::document::{Line, text};
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::structure::JointKind;

impl Derivation<'_> {
    /// The bodies of a group with what the solver found for them.
    pub(super) fn stated_motion(&mut self, stage: Stage, index: usize) {
        let group = &self.structure().motion[index];
        let kind: Line = vec![text(self.group_kind(group))];
        if stage == Stage::Positions {
            self.say(Message::MotionStated, &[kind]);
        }
        for body in group.bodies.iter().map(|b| b.0) {
            self.stated_body(stage, body);
        }
    }

    fn stated_body(&mut self, stage: Stage, body: usize) {
        let label = self.label(body);
        let moved = *self.moved(body);
        match stage {
            Stage::Positions => {
                let degrees = libm::atan2(moved.u.y, moved.u.x).to_degrees();
                let angle = Angle::of(self.stated(Name::new("φ", &label), degrees, Unit::Angle));
                let reference = self.some_point(body);
                self.bodies[body] = Some(Body { reference, angle, rates: [Expr::ZERO, Expr::ZERO] });
                self.position(body, reference);
            }
            Stage::Velocities => {
                let omega = self.stated(Name::new("ω", &label), moved.omega, Unit::AngularVelocity);
                self.set_rate(body, 0, omega);
            }
            Stage::Accelerations => {
                let alpha = self.stated(Name::new("α", &label), moved.alpha, Unit::AngularAcceleration);
                self.set_rate(body, 1, alpha);
            }
        }
    }

    /// A hinge of a body, of those that others know where there are some.
    pub(super) fn some_point(&self, body: usize) -> Vec2 {
        let hinges = self.structure().replaced.joints.iter().filter_map(|joint| match &joint.kind {
            JointKind::Revolute(members) => {
                let own = members.iter().find(|(b, _)| b.0 == body)?.1;
                let known = members.iter().any(|(b, _)| b.0 != body && self.bodies[b.0].is_some());
                Some((!known, own))
            }
            _ => None,
        });
        hinges.min_by_key(|h| h.0).map_or_else(Vec2::zero, |h| h.1)
    }

    /// In which senses links turn.
    pub(super) fn senses(&mut self, bodies: &[usize]) {
        for &body in bodies {
            let omega = self.bodies[body].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
            let Expr::Leaf(q) = &omega else { continue };
            let label: Line = vec![text(self.label(body))];
            let name = of(&q.name);
            let message = match q.value {
                _ if q.is_nothing() => Message::DoesNotTurn,
                w if w > 0.0 => Message::TurnsCounterClockwise,
                _ => Message::TurnsClockwise,
            };
            self.say(message, &[label, name]);
        }
    }
}
