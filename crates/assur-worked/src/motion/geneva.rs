//! Geneva wheels: with the pin in a slot a dyad RPR, else held by the locking arc.

use super::{Stage, of};
use crate::angle::Angle;
use crate::course::{Body, Course};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_position::plan::{Anchor, GenevaStep, Slide};

impl Course<'_> {
    /// A wheel on the ground. Whether it is such a one.
    pub(super) fn geneva(&mut self, stage: Stage, branch: usize, step: &GenevaStep) -> bool {
        let pair = &step.pair;
        if pair.frame.index() != 0 {
            return false;
        }
        if !self.state().is_in_slot(step) {
            self.held_wheel(stage, step);
            return true;
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
        true
    }

    /// A wheel that rests while the pin is out of its slots.
    fn held_wheel(&mut self, stage: Stage, step: &GenevaStep) {
        let wheel = step.pair.wheel.index();
        let label = self.label(wheel);
        let order = match stage {
            Stage::Positions => {
                let u = self.moved(wheel).u;
                let phi = Name::new("φ", &label);
                self.say(Message::HeldByArc, &[vec![text(label)], of(&phi)]);
                let degrees = libm::atan2(u.y, u.x).to_degrees();
                let angle = Angle::of(self.stated(phi, degrees, Unit::Angle));
                let rates = [Expr::ZERO, Expr::ZERO];
                self.bodies[wheel] = Some(Body { reference: step.pair.hub, angle, rates });
                self.block_of_arc(step);
                return;
            }
            Stage::Velocities => 0,
            Stage::Accelerations => 1,
        };
        self.say(Message::Rests, &[vec![text(label)]]);
        for body in [wheel, step.block] {
            self.set_rate(body, order, Expr::ZERO);
        }
    }

    /// What stands for the arc: it points along the line of centres.
    fn block_of_arc(&mut self, step: &GenevaStep) {
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
