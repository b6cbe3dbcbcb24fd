//! Where the follower of a designed cam touches the profile.
//!
//! Where they touch, follower and cam move against each other along the tangent. Let the frame rest and φ grow: the cam
//! turns by −i (P − C) dφ for φ̇ = 1 and + above, the follower by e s′ or by i (P − P_pivot) times its turn. φ, s and e as in
//! `position::step_laws`.

use super::unit;
use crate::element::cam::{Follower, Shape};
use crate::math::{Double, Scalar, V2, Vec2};
use crate::plan::CamStep;
use crate::position::BodyState;

type D = Double;

/// Where a follower touches.
pub(super) struct Touch {
    pub place: V2<D>,
    /// Unit common normal into the follower.
    pub normal: V2<D>,
}

/// Where the follower touches the cam.
pub(super) fn touch(step: &CamStep, bodies: &[BodyState<D>]) -> Touch {
    let (contact, sense) = (&step.contact, step.sense::<D>());
    let frame = &bodies[contact.frame.index()];
    let (e, [_, s_1, ..]) = step.lift(bodies);
    let centre = frame.position(contact.frame_centre);
    let follower = &bodies[contact.follower.index()];
    // the follower's turn by the cam's angle
    let turn = match step.cam.follower {
        Follower::Translating { .. } => None,
        Follower::Oscillating { with_cam, .. } => Some(step.side::<D>(with_cam) * s_1),
    };
    let outwards =
        |normal: V2<D>, p: V2<D>| if normal.dot(p - centre).lt(D::zero()) { -normal } else { normal };
    match step.cam.follower.shape() {
        Shape::Flat => {
            let (at, along) = contact.face.unwrap_or((Vec2::zero(), Vec2::new(1.0, 0.0)));
            let face = follower.position(at);
            let normal = outwards(unit(along).turned(follower.u).perp(), face);
            // at the distance y along the face from the foot of the perpendicular the speeds along the normal agree
            let y = match turn {
                None => s_1 * normal.dot(e) * sense,
                Some(turn) => {
                    let from_pivot = centre - follower.position(contact.point);
                    turn * normal.dot(from_pivot.perp()) / (turn + sense)
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
            let tangent = moved + (tip - centre).perp() * sense;
            let normal = outwards(tangent.perp() / tangent.norm(), tip);
            Touch { place: tip - normal * D::of(step.cam.follower.shape().radius()), normal }
        }
    }
}

/// Places the block that stands for the contact: on the tip it moves with the follower, under a face with the cam.
pub(super) fn place_block(step: &CamStep, bodies: &mut [BodyState<D>]) {
    let contact = &step.contact;
    let touch = touch(step, bodies);
    let follower = bodies[contact.follower.index()];
    let (carrier, p, u) = match contact.face {
        Some((_, along)) => (contact.disk, touch.place, unit(along).turned(follower.u)),
        None => (contact.follower, follower.position(contact.tip), -touch.normal.perp()),
    };
    let carrier = bodies[carrier.index()];
    let r = p - carrier.p;
    bodies[step.block] = BodyState {
        p,
        u,
        v: carrier.v + r.perp() * carrier.omega,
        omega: follower.omega,
        a: carrier.a + r.perp() * carrier.alpha - r * (carrier.omega * carrier.omega),
        alpha: follower.alpha,
        ..BodyState::rest()
    };
}
