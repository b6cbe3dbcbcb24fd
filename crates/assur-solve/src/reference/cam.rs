//! The follower of a designed cam: the lift of its law, and where it touches the profile.
//!
//! φ = ±(θ_e − θ_cam), e the direction from the cam's centre towards the follower, + for a cam that turns clockwise. With
//! the lift s(φ), start d₀ or ψ₀ (see [`crate::element::cam`]),
//!
//! ```text
//! translating:   (P − C)·e = d₀ + s,
//! oscillating:   θ_follower = θ_e + π ∓ (ψ₀ + s).
//! ```
//!
//! Where they touch, follower and cam move against each other along the tangent. Let the frame rest and φ grow: the cam
//! turns by −i (P − C) dφ for φ̇ = 1 and + above, the follower by e s′ or by i (P − P_pivot) times its turn.

use super::jet::{Jet, Moving, unit};
use crate::element::cam::{Follower, Shape};
use crate::math::{Angular, Double, Scalar, V2, Vec2};
use crate::plan::CamStep;
use crate::position::BodyState;

type D = Double;

/// A cam with its follower.
pub(super) struct CamLaw<'a> {
    step: &'a CamStep,
    /// +1 for a cam that turns clockwise.
    sense: D,
    /// Where the follower stands at lift zero, m or rad.
    start: D,
}

/// Where a follower touches.
pub(super) struct Touch {
    pub place: V2<D>,
    /// Unit common normal into the follower.
    pub normal: V2<D>,
}

impl<'a> CamLaw<'a> {
    pub(crate) fn new(step: &'a CamStep) -> Self {
        let sense = D::of(if step.cam.ccw { -1.0 } else { 1.0 });
        Self { step, sense, start: start(step) }
    }

    pub(super) fn bodies(&self) -> Vec<usize> {
        let contact = &self.step.contact;
        let mut bodies = vec![contact.frame.index(), contact.disk.index(), contact.follower.index()];
        bodies.dedup();
        bodies
    }

    /// Index of the contact.
    pub(super) fn index(&self) -> usize {
        self.step.index
    }

    /// Direction towards the follower in ground axes, the cam's angle, the lift with its derivatives by it.
    fn lift(&self, bodies: &[BodyState<D>]) -> (V2<D>, [D; 4]) {
        let contact = &self.step.contact;
        let e = unit(contact.towards).turned(bodies[contact.frame.index()].u);
        let phi = self.sense * D::angle_of(e.turned_back(bodies[contact.disk.index()].u));
        (e, self.step.cam.program.precise_at(phi))
    }

    /// ψ of an oscillating follower turns against the ground by this times ψ̇.
    fn side(&self, with_cam: bool) -> D {
        if with_cam { -self.sense } else { self.sense }
    }

    pub(super) fn jet(&self, bodies: &[BodyState<D>]) -> Jet {
        let contact = &self.step.contact;
        let [frame, disk, follower] =
            [contact.frame, contact.disk, contact.follower].map(|link| &bodies[link.index()]);
        let (e, [s, s_1, s_2, _]) = self.lift(bodies);
        let turning = self.sense * (frame.omega - disk.omega);
        let rate = s_1 * turning;
        let second = s_2 * turning * turning + s_1 * self.sense * (frame.alpha - disk.alpha);
        let lift = Jet { value: self.start + s, rate, second };
        match self.step.cam.follower {
            Follower::Translating { .. } => {
                let apart =
                    Moving::point(follower, contact.point).less(Moving::point(frame, contact.frame_centre));
                apart.dot(Moving::turning(e, frame.omega, frame.alpha)).less(lift)
            }
            Follower::Oscillating { with_cam, .. } => {
                let side = self.side(with_cam);
                let (sin, cos) = lift.value.sine_cosine();
                let target = V2::new(-cos, -side * sin).turned(e);
                let (omega, alpha) = (frame.omega + side * rate, frame.alpha + side * second);
                Moving::turning(target, omega, alpha).cross(Moving::axis(follower, unit(contact.direction)))
            }
        }
    }

    /// Where the follower touches the cam.
    pub(super) fn touch(&self, bodies: &[BodyState<D>]) -> Touch {
        let contact = &self.step.contact;
        let frame = &bodies[contact.frame.index()];
        let (e, [_, s_1, ..]) = self.lift(bodies);
        let centre = frame.position(contact.frame_centre);
        let follower = &bodies[contact.follower.index()];
        // the follower's turn by the cam's angle
        let turn = match self.step.cam.follower {
            Follower::Translating { .. } => None,
            Follower::Oscillating { with_cam, .. } => Some(self.side(with_cam) * s_1),
        };
        let outwards =
            |normal: V2<D>, p: V2<D>| if normal.dot(p - centre).lt(D::zero()) { -normal } else { normal };
        match self.step.cam.follower.shape() {
            Shape::Flat => {
                let (at, along) = contact.face.unwrap_or((Vec2::zero(), Vec2::new(1.0, 0.0)));
                let face = follower.position(at);
                let normal = outwards(unit(along).turned(follower.u).perp(), face);
                // at the distance y along the face from the foot of the perpendicular the speeds along the normal agree
                let y = match turn {
                    None => s_1 * normal.dot(e) * self.sense,
                    Some(turn) => {
                        let from_pivot = centre - follower.position(contact.point);
                        turn * normal.dot(from_pivot.perp()) / (turn + self.sense)
                    }
                };
                let foot = centre + normal * normal.dot(face - centre);
                Touch { place: foot + normal.perp() * y, normal }
            }
            Shape::Knife | Shape::Roller(_) => {
                let tip = follower.position(contact.tip);
                let moved = match turn {
                    None => e * s_1,
                    Some(turn) => (tip - follower.position(contact.point)).perp() * turn,
                };
                let tangent = moved + (tip - centre).perp() * self.sense;
                let normal = outwards(tangent.perp() / tangent.norm(), tip);
                Touch { place: tip - normal * D::of(self.step.cam.follower.shape().radius()), normal }
            }
        }
    }

    /// Places the block that stands for the contact: on the tip it moves with the follower, under a face with the cam.
    pub(super) fn place_block(&self, bodies: &mut [BodyState<D>]) {
        let contact = &self.step.contact;
        let touch = self.touch(bodies);
        let follower = bodies[contact.follower.index()];
        let (carrier, p, u) = match contact.face {
            Some((_, along)) => (contact.disk, touch.place, unit(along).turned(follower.u)),
            None => (contact.follower, follower.position(contact.tip), -touch.normal.perp()),
        };
        let carrier = bodies[carrier.index()];
        let r = p - carrier.p;
        bodies[self.step.block] = BodyState {
            p,
            u,
            v: carrier.v + r.perp() * carrier.omega,
            omega: follower.omega,
            a: carrier.a + r.perp() * carrier.alpha - r * (carrier.omega * carrier.omega),
            alpha: follower.alpha,
            turned: D::zero(),
        };
    }
}

/// Where the follower stands at lift zero: distance, m, or angle, rad.
fn start(step: &CamStep) -> D {
    let (of, r) = (D::of, D::of(step.cam.base_radius));
    match step.cam.follower {
        Follower::Translating { shape: Shape::Flat, .. } => r,
        Follower::Translating { offset, .. } => ((r - of(offset)) * (r + of(offset))).sqrt(),
        Follower::Oscillating { shape: Shape::Flat, pivot_distance, offset, .. } => {
            let sin = (r + of(offset)) / of(pivot_distance);
            D::angle_of(V2::new((D::one() - sin * sin).sqrt(), sin))
        }
        Follower::Oscillating { arm, pivot_distance, .. } => {
            let (l, a) = (of(arm), of(pivot_distance));
            let cos = (l * l + a * a - r * r) / (of(2.0) * l * a);
            D::angle_of(V2::new(cos, (D::one() - cos * cos).sqrt()))
        }
    }
}
