//! The gap between a designed cam and a follower that leaves it: what the follower is lifted more than the law says at the cam's angle,
//! along the way of a translating follower, or along the arc of its tip.

use super::body::BodyState;
use super::state::State;
use crate::element::cam::Follower;
use crate::math::Vec2;
use crate::plan::CamStep;
use std::f64::consts::{FRAC_PI_2, TAU};

impl State {
    /// The gap, m, with its first two derivatives by time.
    pub(super) fn cam_opening(&self, step: &CamStep) -> [f64; 3] {
        let (phi, turning) = self.cam_angle(step);
        let [s, s_1, s_2, _] = self.cam_point(step, phi).lift;
        let (lift, _) = self.cam_lift(step);
        let [rate, second] = self.cam_lift_rates::<2>(step);
        let along = arm(step);
        // a lever that has gone round the other way is far
        let swings = matches!(step.cam.follower, Follower::Oscillating { .. });
        let lift = if swings && lift - s < -FRAC_PI_2 { lift + TAU } else { lift };
        let of_law = [s, s_1 * turning, s_2 * turning * turning + s_1 * self.cam_acceleration(step)];
        [along * (lift - of_law[0]), along * (rate - of_law[1]), along * (second - of_law[2])]
    }

    /// Where the follower touches, and the unit normal into it, at the cam's angle.
    pub(super) fn cam_place(&self, step: &CamStep) -> (Vec2, Vec2) {
        let frame = &self.motion.bodies[step.contact.frame.index()];
        let e = step.contact.towards.turned(frame.u);
        let at = self.cam_point(step, self.cam_angle(step).0);
        let (centre, normal) = (frame.position(step.contact.frame_centre), at.normal.turned(e));
        if step.contact.face.is_some() {
            return (centre + at.contact.turned(e), normal);
        }
        // the force has no moment about a tip
        let follower = &self.motion.bodies[step.contact.follower.index()];
        (follower.position(step.contact.tip) - normal * step.cam.follower.shape().radius(), normal)
    }

    /// The distance of the profiles over the gap, where that is small: how the normal lies to the way of the follower.
    pub(super) fn cam_steepness(&self, step: &CamStep) -> f64 {
        let (contact, (place, normal)) = (&step.contact, self.cam_place(step));
        let frame = &self.motion.bodies[contact.frame.index()];
        match step.cam.follower {
            Follower::Translating { .. } => normal.dot(contact.towards.turned(frame.u)),
            Follower::Oscillating { .. } => {
                let follower: &BodyState = &self.motion.bodies[contact.follower.index()];
                let across = (place - follower.position(contact.point)).perp();
                (normal.dot(across) / arm(step)).abs()
            }
        }
    }
}

/// What a lift is multiplied by, m/m or m/rad.
fn arm(step: &CamStep) -> f64 {
    match step.cam.follower {
        Follower::Translating { .. } => 1.0,
        Follower::Oscillating { pivot_distance, .. } => match step.contact.face {
            Some(_) => pivot_distance,
            None => (step.contact.tip - step.contact.point).norm(),
        },
    }
}
