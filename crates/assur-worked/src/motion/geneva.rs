//! Geneva wheels: with the pin in a slot a dyad RPR, else held by the locking arc.

use super::{Stage, of};
use crate::angle::Angle;
use crate::course::{Body, Derivation};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_position::plan::{Anchor, GenevaStep, Slide};

impl Derivation<'_> {
    /// A wheel with slots.
    pub(super) fn geneva(&mut self, stage: Stage, branch: usize, step: &GenevaStep) {
        let pair = &step.pair;
        if !self.state().is_in_slot(step) {
            self.held_wheel(stage, step);
            return;
        }
        let wheel = pair.wheel.index();
        let bases = [
            Anchor { body: pair.frame.index(), at: pair.frame_hub },
            Anchor { body: pair.crank.index(), at: pair.pin },
        ];
        // the slot that the pin is in, not the one that is named
        let along = self.moved(step.block).u.turned_back(self.moved(wheel).u);
        let slide = Slide {
            base: wheel,
            origin: pair.hub,
            along,
            body: step.block,
            point: Vec2::zero(),
            direction: Vec2::new(1.0, 0.0),
            turn: along,
            radius: 0.0,
            sense: 1.0,
        };
        self.rpr(stage, branch, &bases, [Some(pair.hub), None], &slide);
    }

    /// A wheel that does not turn against its frame while the pin is out of its slots.
    fn held_wheel(&mut self, stage: Stage, step: &GenevaStep) {
        let (wheel, frame) = (step.pair.wheel.index(), step.pair.frame.index());
        let label = self.label(wheel);
        let order = match stage {
            Stage::Positions => {
                self.held_at(step);
                self.block_of_arc(step);
                return;
            }
            Stage::Velocities => 0,
            Stage::Accelerations => 1,
        };
        if frame == 0 {
            self.say(Message::Rests, &[vec![text(label)]]);
        } else {
            self.say(Message::TurnsWith, &[label, self.label(frame)].map(|l| vec![text(l)]));
        }
        for body in [wheel, step.block] {
            let rate = self.rate_of_body(frame, order);
            self.set_rate(body, order, rate);
        }
    }

    /// The angle at which the arc holds a wheel in its frame.
    fn held_at(&mut self, step: &GenevaStep) {
        let (wheel, frame) = (step.pair.wheel.index(), step.pair.frame.index());
        let label = self.label(wheel);
        let phi = Name::new("φ", &label);
        let u = self.moved(wheel).u.turned_back(self.moved(frame).u);
        let degrees = libm::atan2(u.y, u.x).to_degrees();
        let held = if frame == 0 { phi.clone() } else { phi.and(&format!(",{}", self.label(frame))) };
        self.say(Message::HeldByArc, &[vec![text(label)], of(&held)]);
        let right = self.between_slots(step, degrees);
        let own = self.angle_sum(held, right);
        let angle = match self.bodies[frame].as_ref().filter(|_| frame != 0).map(|b| b.angle.whole()) {
            Some(base) => self.angle_sum(phi, base + own),
            None => own,
        };
        let rates = [Expr::ZERO, Expr::ZERO];
        self.bodies[wheel] = Some(Body { reference: step.pair.hub, angle: Angle::of(angle), rates });
    }

    /// The angle of a wheel in its frame with the crank's centre in the middle between two slots: δ − λ and an odd multiple of 180°/z.
    fn between_slots(&self, step: &GenevaStep, degrees: f64) -> Expr {
        let pair = &step.pair;
        let words = self.scene.mechanism().pair(pair.pair).name.clone();
        let back = self.direction_given(-pair.towards, || Name::new("δ", &words));
        let slot = self.direction_given(pair.slot, || Name::new("λ", &self.label(pair.wheel.index())));
        let line = back.minus(&slot).whole();
        let half = 180.0 / f64::from(pair.law.slots);
        let count = ((degrees - line.value()) / half).round() as i64;
        let slots = self.given(Name::new("z", &words), f64::from(pair.law.slots), Unit::One);
        line + Expr::Degrees(180 * count) / slots
    }

    /// What stands for the arc: it is at the crank's centre and points along the line of centres.
    fn block_of_arc(&mut self, step: &GenevaStep) {
        let centre = self.position(step.pair.crank.index(), step.pair.crank_centre);
        let name = self.point_name(step.block, Vec2::zero());
        self.keep(0, &name, centre);
        let u = self.moved(step.block).u;
        let degrees = libm::atan2(u.y, u.x).to_degrees();
        let name = Name::new("φ", &self.label(step.block));
        let angle = Angle::whole_degrees(u).unwrap_or_else(|_| {
            self.optional.insert(self.blocks.len());
            Angle::of(self.stated(name, degrees, Unit::Angle))
        });
        let rates = [Expr::ZERO, Expr::ZERO];
        self.bodies[step.block] = Some(Body { reference: Vec2::zero(), angle, rates });
    }
}
