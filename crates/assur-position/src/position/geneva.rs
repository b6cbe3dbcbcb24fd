//! A Geneva wheel: while the pin is in a slot it turns by the law of the slot, else the locking arc holds it.
//!
//! The block that stands for the pin slides along the slot. While the arc holds the wheel, the block is in the crank's
//! centre and slides along the line of centres: the arc lies about that centre, so that its force passes through it and the
//! crank turns without effort. What the arc presses along the line of centres is not determined, and left at zero.
//!
//! All slots are alike; which of them the pin is in follows from where the wheel was before.

use super::kinematics::Motion;
use super::motion::{place, under};
use super::state::State;
use crate::math::Vec2;
use crate::plan::GenevaStep;

impl Motion {
    /// Whether the pin of a wheel is in a slot.
    pub(super) fn is_in_slot(&self, step: &GenevaStep) -> bool {
        let pin = self.bodies[step.pair.crank.index()].position(step.pair.pin);
        let centre = self.bodies[step.pair.crank.index()].position(step.pair.crank_centre);
        let block = self.bodies[step.block].p;
        (block - pin).norm() < (block - centre).norm()
    }
}

impl State {
    #[inline(never)]
    pub(super) fn geneva<const LEVEL: u8>(&mut self, branch: usize, step: &GenevaStep) {
        let pair = &step.pair;
        let frame = self.motion.bodies[pair.frame.index()];
        let crank = self.motion.bodies[pair.crank.index()];
        let towards = pair.towards.turned(frame.u);
        let phi = pair.arm.turned(crank.u).turned_back(towards).angle();
        let at = pair.law.at(phi);
        let [delta, first, second] = at.slot;
        let back = -towards;
        let slot = back.turned(Vec2::direction(delta));
        // the named slot is the one that the pin is in at first, and afterwards the one that goes on from where it was
        let before = self.motion.bodies[pair.wheel.index()].u;
        let passed = if before.norm() > 0.5 {
            let was = pair.slot.turned(before).turned_back(back).angle();
            ((delta - was) / pair.law.pitch()).round() * pair.law.pitch()
        } else {
            0.0
        };
        let named = slot.turned(Vec2::direction(-passed));
        let turning = crank.omega - frame.omega;
        let rate = first * turning;
        let acceleration = second * turning * turning + first * (crank.alpha - frame.alpha);
        let centre = frame.position(pair.frame_hub);
        let hub = under::<_, LEVEL>(&self.motion.bodies, pair.frame.index(), centre);
        let (omega, alpha) = (frame.omega + rate, frame.alpha + acceleration);
        let u = named.turned_back(pair.slot);
        let wheel = &mut self.motion.bodies[pair.wheel.index()];
        place::<_, LEVEL>(wheel, &Some(pair.hub), hub, u, omega, alpha);
        self.motion.conditions[branch] = 1.0;
        let (p, along) = if at.engaged {
            (crank.position(pair.pin), slot)
        } else {
            (crank.position(pair.crank_centre), back)
        };
        let moved = under::<_, 2>(&self.motion.bodies, pair.crank.index(), p);
        let block = &mut self.motion.bodies[step.block];
        (block.p, block.u, block.v, block.a) = (p, along, moved.v, moved.a);
        (block.omega, block.alpha) = (omega, alpha);
    }

    /// Whether the pin of a wheel is in a slot.
    #[must_use]
    pub fn is_in_slot(&self, step: &GenevaStep) -> bool {
        self.motion.is_in_slot(step)
    }

    /// How far a pin in a slot is from the line of that slot, m: the slots lie about the wheel's centre.
    pub(super) fn geneva_gap(&self, step: &GenevaStep) -> f64 {
        let pair = &step.pair;
        let wheel = &self.motion.bodies[pair.wheel.index()];
        let hub = wheel.position(pair.hub);
        let apart = (hub - self.motion.bodies[pair.frame.index()].position(pair.frame_hub)).norm();
        if !self.is_in_slot(step) {
            return apart;
        }
        let pin = self.motion.bodies[pair.crank.index()].position(pair.pin) - hub;
        let slot = pair.slot.turned(wheel.u);
        let pitch = pair.law.pitch();
        let nearest = (pin.turned_back(slot).angle() / pitch).round() * pitch;
        apart.max(pin.cross(slot.turned(Vec2::direction(nearest))).abs())
    }
}
