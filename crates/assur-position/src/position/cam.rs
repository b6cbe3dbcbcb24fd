//! The follower of a designed cam: its lift is the law at the cam's angle, its rates follow by the chain rule,
//! ṡ = s′ φ̇, s̈ = s″ φ̇² + s′ φ̈, whatever the curvature of the profile, which the law may make jump.
//!
//! φ is the angle by which the cam has turned against the frame since its x axis pointed towards the follower. The block
//! that stands for the contact on the side of forces slides along the common tangent.

use super::motion::{Point, place, under};
use super::state::State;
use crate::element::cam::Follower;
use crate::math::Vec2;
use crate::plan::CamStep;

impl State {
    #[inline(never)]
    pub(super) fn cam<const LEVEL: u8>(&mut self, branch: usize, step: &CamStep) {
        let (cam, contact) = (&step.cam, &step.contact);
        let frame = self.motion.bodies[contact.frame.index()];
        let disk = self.motion.bodies[contact.disk.index()];
        let sense = if cam.ccw { -1.0 } else { 1.0 };
        let e = contact.towards.turned(frame.u);
        let phi = sense * e.turned_back(disk.u).angle();
        let at = cam.at(phi);
        let [s, s_1, s_2, _] = at.lift;
        let (mut rate, mut second) = (0.0, 0.0);
        if LEVEL > 0 {
            let turning = sense * (frame.omega - disk.omega);
            rate = s_1 * turning;
            if LEVEL > 1 {
                second = s_2 * turning * turning + s_1 * sense * (frame.alpha - disk.alpha);
            }
        }
        let centre = frame.position(contact.frame_centre);
        let (slot, pin) = (contact.follower.index(), Some(contact.point));
        match cam.follower {
            Follower::Translating { .. } => {
                let p = centre + e * (cam.start() + s) + e.perp() * contact.beside;
                let base = under::<_, LEVEL>(&self.motion.bodies, contact.frame.index(), p);
                let moved = Point {
                    p,
                    v: base.v + e * rate,
                    a: base.a + e * second + e.perp() * (2.0 * frame.omega * rate),
                };
                let u = e.turned_back(contact.direction);
                place::<_, LEVEL>(&mut self.motion.bodies[slot], &pin, moved, u, frame.omega, frame.alpha);
            }
            Follower::Oscillating { pivot_distance, with_cam, .. } => {
                let side = if with_cam { sense } else { -sense };
                let (sin, cos) = libm::sincos(cam.start() + s);
                let u = Vec2::new(-cos, side * sin).turned(e).turned_back(contact.direction);
                let pivot = under::<_, LEVEL>(
                    &self.motion.bodies,
                    contact.frame.index(),
                    centre + e * pivot_distance,
                );
                let (omega, alpha) = (frame.omega - side * rate, frame.alpha - side * second);
                place::<_, LEVEL>(&mut self.motion.bodies[slot], &pin, pivot, u, omega, alpha);
            }
        }
        let (place, normal) = (centre + at.contact.turned(e), at.normal.turned(e));
        self.motion.touches[step.index] = (place, normal);
        self.motion.conditions[branch] = libm::cos(at.pressure_angle);
        self.cam_block(step);
    }

    /// The block: on the tip it moves with the follower, under a face with the cam's profile.
    fn cam_block(&mut self, step: &CamStep) {
        let contact = &step.contact;
        let (place, normal) = self.motion.touches[step.index];
        let follower = self.motion.bodies[contact.follower.index()];
        let carrier = if contact.face.is_some() { contact.disk } else { contact.follower };
        let (p, u) = match contact.face {
            Some((_, along)) => (place, along.turned(follower.u)),
            None => (follower.position(contact.tip), -normal.perp()),
        };
        let moved = under::<_, 2>(&self.motion.bodies, carrier.index(), p);
        let block = &mut self.motion.bodies[step.block];
        (block.p, block.u, block.v, block.a) = (p, u, moved.v, moved.a);
        (block.omega, block.alpha) = (follower.omega, follower.alpha);
    }

    /// How far the follower of a designed cam is from the cam's profile, m: seen from both sides.
    pub(super) fn cam_gap(&self, step: &CamStep) -> f64 {
        let (cam, contact) = (&step.cam, &step.contact);
        let disk = &self.motion.bodies[contact.disk.index()];
        let follower = &self.motion.bodies[contact.follower.index()];
        let (place, normal) = self.motion.touches[step.index];
        let frame = &self.motion.bodies[contact.frame.index()];
        let sense = if cam.ccw { -1.0 } else { 1.0 };
        let phi = sense * contact.towards.turned(frame.u).turned_back(disk.u).angle();
        let rim = disk.position(contact.centre + cam.in_cam(cam.at(phi).contact, phi));
        let apart = match contact.face {
            Some((at, along)) => (place - follower.position(at)).dot(along.turned(follower.u).perp()).abs(),
            None => (follower.position(contact.tip) - normal * cam.follower.shape().radius() - place).norm(),
        };
        apart.max((rim - place).norm())
    }
}
