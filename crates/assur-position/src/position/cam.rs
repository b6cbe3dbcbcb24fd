//! A designed cam and its follower: its lift is the law at the cam's angle, its rates follow by the chain rule,
//! ṡ = s′ φ̇, s̈ = s″ φ̇² + s′ φ̈, whatever the curvature of the profile, which the law may make jump.
//!
//! φ is the angle by which the cam has turned against the frame since its x axis pointed towards the follower. The block
//! that stands for the contact on the side of forces slides along the common tangent.
//!
//! Where the follower turns the cam, φ is the angle of the chosen flank at its lift, φ̇ = ṡ/s′, φ̈ = (s̈ − s″ φ̇²)/s′. The
//! condition figure is the sine of the angle at which the common normal passes the cam's centre: zero with s′.

use super::motion::{CLOSURE, Point, place, under};
use super::state::State;
use crate::element::cam::{CamPoint, Follower, Law, Reached};
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
        let at = self.cam_point(step, sense * e.turned_back(disk.u).angle());
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
        self.motion.conditions[branch] = libm::cos(at.pressure_angle);
        self.cam_touches(step, &at);
    }

    /// Turns a cam by its follower, on the flank that the branch says.
    #[inline(never)]
    pub(super) fn cam_turned<const LEVEL: u8>(&mut self, branch: usize, step: &CamStep) {
        let (cam, contact) = (&step.cam, &step.contact);
        let frame = self.motion.bodies[contact.frame.index()];
        let sense = if cam.ccw { -1.0 } else { 1.0 };
        let e = contact.towards.turned(frame.u);
        let (lift, size) = self.cam_lift(step);
        let near = CLOSURE * f64::EPSILON * size;
        let flank = step.flanks.get(self.branches[branch].general_sides as usize);
        let reached = flank.map_or(Reached::Beyond, |flank| flank.reached(&cam.program, lift, near));
        let Reached::At(phi) = reached else {
            self.motion.open.get_or_insert(branch);
            return;
        };
        let at = self.cam_point(step, phi);
        let [_, s_1, s_2, _] = at.lift;
        let (mut turning, mut second) = (0.0, 0.0);
        if LEVEL > 0 {
            let [rate, acceleration] = self.cam_lift_rates::<LEVEL>(step);
            turning = rate / s_1;
            second = (acceleration - s_2 * turning * turning) / s_1;
        }
        let centre = frame.position(contact.frame_centre);
        let hub = under::<_, LEVEL>(&self.motion.bodies, contact.frame.index(), centre);
        let u = e.turned(Vec2::direction(-sense * phi));
        let (omega, alpha) = (frame.omega - sense * turning, frame.alpha - sense * second);
        let disk = &mut self.motion.bodies[contact.disk.index()];
        place::<_, LEVEL>(disk, &Some(contact.centre), hub, u, omega, alpha);
        self.motion.conditions[branch] = at.normal.cross(at.contact) / at.contact.norm();
        self.cam_touches(step, &at);
    }

    /// All that belongs to a cam angle, rad, by the part of the law that is held, if one is.
    pub(super) fn cam_point(&self, step: &CamStep, phi: f64) -> CamPoint {
        let part = self.motion.laws.get(step.index).and_then(Option::as_ref);
        part.map_or_else(|| step.cam.at(phi), |part| step.cam.beyond(part, phi))
    }

    /// The angle by which a cam has turned against its frame since its x axis pointed towards the follower, rad, and its rate.
    #[must_use]
    pub fn cam_angle(&self, step: &CamStep) -> (f64, f64) {
        let frame = &self.motion.bodies[step.contact.frame.index()];
        let disk = &self.motion.bodies[step.contact.disk.index()];
        let sense = if step.cam.ccw { -1.0 } else { 1.0 };
        let e = step.contact.towards.turned(frame.u);
        (sense * e.turned_back(disk.u).angle(), sense * (frame.omega - disk.omega))
    }

    /// The second derivative in time of the same angle, rad/s².
    #[must_use]
    pub fn cam_acceleration(&self, step: &CamStep) -> f64 {
        let [frame, disk] =
            [step.contact.frame, step.contact.disk].map(|link| self.motion.bodies[link.index()].alpha);
        if step.cam.ccw { disk - frame } else { frame - disk }
    }

    /// The lift at which the follower of a cam stands, m or rad, and the magnitude of what it is the difference of.
    #[must_use]
    pub fn cam_lift(&self, step: &CamStep) -> (f64, f64) {
        let (cam, contact) = (&step.cam, &step.contact);
        let frame = &self.motion.bodies[contact.frame.index()];
        let follower = &self.motion.bodies[contact.follower.index()];
        let e = contact.towards.turned(frame.u);
        match cam.follower {
            Follower::Translating { .. } => {
                let (p, centre) = (follower.position(contact.point), frame.position(contact.frame_centre));
                ((p - centre).dot(e) - cam.start(), p.norm() + centre.norm() + cam.start())
            }
            Follower::Oscillating { with_cam, .. } => {
                let side = if with_cam != cam.ccw { 1.0 } else { -1.0 };
                let arm = contact.direction.turned(follower.u).turned_back(e);
                (libm::atan2(side * arm.y, -arm.x) - cam.start(), 1.0)
            }
        }
    }

    /// The lift of the dwell in which the follower of a cam stands, m or rad, and the cam angles at its ends, rad.
    #[must_use]
    pub fn cam_dwell(&self, step: &CamStep) -> Option<(f64, [f64; 2])> {
        let (lift, size) = self.cam_lift(step);
        let near = CLOSURE * f64::EPSILON * size;
        let mut phases = step.cam.program.phases().iter();
        let dwell = phases.find(|p| p.law == Law::Dwell && (p.from - lift).abs() <= near)?;
        Some((dwell.from, [dwell.start, dwell.start + dwell.angle]))
    }

    /// Its derivatives by time.
    pub(super) fn cam_lift_rates<const LEVEL: u8>(&self, step: &CamStep) -> [f64; 2] {
        let (cam, contact) = (&step.cam, &step.contact);
        let frame = &self.motion.bodies[contact.frame.index()];
        let follower = &self.motion.bodies[contact.follower.index()];
        match cam.follower {
            Follower::Translating { .. } => {
                let e = contact.towards.turned(frame.u);
                let p = follower.position(contact.point);
                let moved = under::<_, LEVEL>(&self.motion.bodies, contact.follower.index(), p);
                let base = under::<_, LEVEL>(&self.motion.bodies, contact.frame.index(), p);
                // it moves along e in the frame: Coriolis' acceleration is across
                [(moved.v - base.v).dot(e), (moved.a - base.a).dot(e)]
            }
            Follower::Oscillating { with_cam, .. } => {
                let side = if with_cam != cam.ccw { 1.0 } else { -1.0 };
                [side * (frame.omega - follower.omega), side * (frame.alpha - follower.alpha)]
            }
        }
    }

    /// Where they touch, and the block there.
    fn cam_touches(&mut self, step: &CamStep, at: &CamPoint) {
        let frame = &self.motion.bodies[step.contact.frame.index()];
        let e = step.contact.towards.turned(frame.u);
        let centre = frame.position(step.contact.frame_centre);
        self.motion.touches[step.index] = (centre + at.contact.turned(e), at.normal.turned(e));
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
        let (phi, _) = self.cam_angle(step);
        let rim = disk.position(contact.centre + cam.in_cam(cam.at(phi).contact, phi));
        let apart = match contact.face {
            Some((at, along)) => (place - follower.position(at)).dot(along.turned(follower.u).perp()).abs(),
            None => (follower.position(contact.tip) - normal * cam.follower.shape().radius() - place).norm(),
        };
        apart.max((rim - place).norm())
    }
}
