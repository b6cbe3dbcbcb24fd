//! What the laws of designed cams and Geneva wheels say of a position, for every number.
//!
//! φ = ±(θ_e − θ_cam), e the direction from the cam's centre towards the follower, + for a cam that turns clockwise. With
//! the lift s(φ), start d₀ or ψ₀ (see [`crate::element::cam`]),
//!
//! ```text
//! translating:   (P − C)·e = d₀ + s,
//! oscillating:   θ_follower = θ_e + π ∓ (ψ₀ + s).
//! ```

use super::body::BodyState;
use super::kinematics::Motion;
use crate::element::cam::{Follower, Shape};
use crate::math::{Angular, V2};
use crate::plan::step::unit;
use crate::plan::{CamStep, GenevaStep};

impl CamStep {
    /// +1 for a cam that turns clockwise.
    #[must_use]
    pub fn sense<S: Angular>(&self) -> S {
        S::of(if self.cam.ccw { -1.0 } else { 1.0 })
    }

    /// ψ of an oscillating follower turns against the ground by this times ψ̇.
    #[must_use]
    pub fn side<S: Angular>(&self, with_cam: bool) -> S {
        if with_cam { -self.sense::<S>() } else { self.sense() }
    }

    /// Direction towards the follower in ground axes, and the lift with its derivatives by the cam's angle.
    #[must_use]
    pub fn lift<S: Angular>(&self, bodies: &[BodyState<S>]) -> (V2<S>, [S; 4]) {
        let e = unit::<S>(self.contact.towards).turned(bodies[self.contact.frame.index()].u);
        let turned = S::angle_of(e.turned_back(bodies[self.contact.disk.index()].u));
        (e, self.cam.program.at_any(self.sense::<S>() * turned))
    }

    /// Where the follower is at lift zero: distance, m, or angle, rad.
    #[must_use]
    pub fn start<S: Angular>(&self) -> S {
        let (of, r) = (S::of, S::of(self.cam.base_radius));
        match self.cam.follower {
            Follower::Translating { shape: Shape::Flat, .. } => r,
            Follower::Translating { offset, .. } => ((r - of(offset)) * (r + of(offset))).sqrt(),
            Follower::Oscillating { shape: Shape::Flat, pivot_distance, offset, .. } => {
                let sin = (r + of(offset)) / of(pivot_distance);
                S::angle_of(V2::new((S::one() - sin * sin).sqrt(), sin))
            }
            Follower::Oscillating { arm, pivot_distance, .. } => {
                let (l, a) = (of(arm), of(pivot_distance));
                let cos = (l * l + a * a - r * r) / (of(2.0) * l * a);
                S::angle_of(V2::new(cos, (S::one() - cos * cos).sqrt()))
            }
        }
    }
}

impl GenevaStep {
    /// The direction at a number of halves of the angle between two slots.
    pub(super) fn halves<S: Angular>(&self, count: f64) -> V2<S> {
        let angle = S::pi() * S::of(count) / S::of(f64::from(self.pair.law.slots));
        let (sine, cosine) = angle.sine_cosine();
        V2::new(cosine, sine)
    }

    /// Direction of the slot in which the pin is, in the wheel's frame; `None` where it is in none.
    #[must_use]
    pub fn slot<S: Angular>(&self, at: &Motion) -> Option<V2<S>> {
        if !at.is_in_slot(self) {
            return None;
        }
        let pair = &self.pair;
        let wheel = &at.bodies[pair.wheel.index()];
        let pin = at.bodies[pair.crank.index()].position(pair.pin) - wheel.position(pair.hub);
        let passed = (pin.turned_back(pair.slot.turned(wheel.u)).angle() / pair.law.pitch()).round();
        Some(self.halves::<S>(2.0 * passed).turned(unit(pair.slot)))
    }
}
