//! Contacts that part: how far apart the profiles are, and how that changes.
//!
//! The gap of a designed cam is measured along the way of its follower (`cam_gap`).

use super::body::BodyState;
use super::model::Model;
use super::state::State;
use crate::math::{Vec2, acceleration_at};
use crate::model::{PairId, PairKind, ProfileShape, Stop};
use crate::plan::CamStep;

/// A contact that parts, with its place among the stops of the mechanism.
#[derive(Clone, Copy, Debug)]
pub struct PartingContact<'p> {
    first: (usize, ProfileShape),
    second: (usize, ProfileShape),
    internal: bool,
    stop: usize,
    /// Of a designed cam.
    cam: Option<&'p CamStep>,
}

/// A round profile at its centre and what it is seen from: a line on another body, or the centre of another round one.
struct Centre {
    body: usize,
    at: Vec2,
    radius: f64,
}

impl<'p> PartingContact<'p> {
    /// The contact that a stop of a mechanism is.
    #[must_use]
    pub fn of_stop(model: &Model<'p>, stop: usize) -> Option<Self> {
        let PairKind::Contact { first, second, internal, parts: true } =
            &model.mechanism.pair(model.mechanism.stops.get(stop)?.pair).kind
        else {
            return None;
        };
        let side = |profile: &crate::model::Profile| (profile.link.index(), profile.shape);
        let rim = [first.shape, second.shape].into_iter().find_map(|shape| match shape {
            ProfileShape::Rim(contact) => Some(contact),
            _ => None,
        });
        let cam = rim.and_then(|index| model.plan.parting_cams.iter().find(|step| step.index == index));
        Some(Self { first: side(first), second: side(second), internal: *internal, stop, cam })
    }

    /// The same by its pair; nothing for another pair.
    #[must_use]
    pub fn of_pair(model: &Model<'p>, pair: PairId) -> Option<Self> {
        if !matches!(model.mechanism.pair(pair).kind, PairKind::Contact { parts: true, .. }) {
            return None;
        }
        let own = |stop: &Stop| stop.pair == pair;
        model.mechanism.stops.iter().position(own).and_then(|stop| Self::of_stop(model, stop))
    }

    /// Its bodies, the first profile's first.
    #[must_use]
    pub const fn bodies(&self) -> [usize; 2] {
        [self.first.0, self.second.0]
    }

    const fn round((body, shape): (usize, ProfileShape)) -> Option<Centre> {
        match shape {
            ProfileShape::Point(at) => Some(Centre { body, at, radius: 0.0 }),
            ProfileShape::Circle(at, radius) => Some(Centre { body, at, radius }),
            ProfileShape::Line(..) | ProfileShape::Rim(_) => None,
        }
    }
}

impl Centre {
    fn of<'s>(&self, state: &'s State) -> (&'s BodyState, Vec2) {
        let body = &state.motion.bodies[self.body];
        (body, body.position(self.at))
    }
}

impl State {
    /// The place of a contact that parts, on its round profile, and the unit normal into the first.
    #[must_use]
    pub fn parting_touch(&self, contact: &PartingContact<'_>) -> Option<(Vec2, Vec2)> {
        if let Some(step) = contact.cam {
            let (place, normal) = self.cam_place(step);
            let rim_first = matches!(contact.first.1, ProfileShape::Rim(_));
            return Some((place, if rim_first { -normal } else { normal }));
        }
        let on = self.motion.sides.get(contact.stop).copied().unwrap_or(0.0);
        self.touch_on(on, contact.first, contact.second, contact.internal)
    }

    /// How far apart the profiles are, m: negative where they would lie in each other.
    #[must_use]
    pub fn gap(&self, contact: &PartingContact<'_>) -> f64 {
        if let Some(step) = contact.cam {
            return self.cam_opening(step)[0];
        }
        let (round, straight) = Self::parts_of(contact);
        match (round, straight) {
            ([Some(round), None] | [None, Some(round)], Some((body, through))) => {
                let Some((_, n)) = self.normal_into_round(contact) else { return f64::NAN };
                let (_, c) = round.of(self);
                n.dot(c - self.motion.bodies[body].position(through)) - round.radius
            }
            ([Some(one), Some(other)], _) => {
                let apart = (one.of(self).1 - other.of(self).1).norm();
                if contact.internal {
                    (one.radius - other.radius).abs() - apart
                } else {
                    apart - one.radius - other.radius
                }
            }
            _ => f64::NAN,
        }
    }

    /// The rate of the gap, m/s.
    #[must_use]
    pub fn gap_rate(&self, contact: &PartingContact<'_>) -> f64 {
        if let Some(step) = contact.cam {
            return self.cam_opening(step)[1];
        }
        let Some((p, n)) = self.parting_touch(contact) else { return f64::NAN };
        let at = |body: usize| {
            let body = &self.motion.bodies[body];
            body.v + (p - body.p).perp() * body.omega
        };
        (at(contact.first.0) - at(contact.second.0)).dot(n)
    }

    /// The second derivative of the gap, m/s².
    #[must_use]
    pub fn gap_acceleration(&self, contact: &PartingContact<'_>) -> f64 {
        if let Some(step) = contact.cam {
            return self.cam_opening(step)[2];
        }
        let (round, straight) = Self::parts_of(contact);
        match (round, straight) {
            ([Some(round), None] | [None, Some(round)], Some((base, _))) => {
                let Some((_, n)) = self.normal_into_round(contact) else { return f64::NAN };
                let ((body, c), base) = (round.of(self), &self.motion.bodies[base]);
                let a = |b: &BodyState| acceleration_at(b.a, b.omega, b.alpha, c - b.p);
                let v = body.velocity(round.at) - base.v - (c - base.p).perp() * base.omega;
                n.dot(a(body) - a(base) - v.perp() * (2.0 * base.omega))
            }
            ([Some(one), Some(other)], _) => {
                let moves = |centre: &Centre| {
                    let body = &self.motion.bodies[centre.body];
                    (body.position(centre.at), body.velocity(centre.at), body.acceleration(centre.at))
                };
                let ((p_1, v_1, a_1), (p_2, v_2, a_2)) = (moves(&one), moves(&other));
                let (p, v, a) = (p_1 - p_2, v_1 - v_2, a_1 - a_2);
                let apart = p.norm();
                let along = p.dot(v) / apart;
                let second = p.dot(a) / apart + (v.dot(v) - along * along) / apart;
                if contact.internal { -second } else { second }
            }
            _ => f64::NAN,
        }
    }

    /// The normal force over the effort that belongs to the gap: 1 but for designed cams, whose gap is not along the normal.
    #[must_use]
    pub fn pressed_by_effort(&self, contact: &PartingContact<'_>) -> f64 {
        contact.cam.map_or(1.0, |step| 1.0 / self.cam_steepness(step))
    }

    /// Takes the sides on which contacts that part stand: at a line that of the profile, or of the mass centre of its link.
    pub fn take_parting_sides(&mut self, model: &Model<'_>) {
        self.motion.sides.clear();
        for stop in 0..model.mechanism.stops.len() {
            let side = PartingContact::of_stop(model, stop).map_or(0.0, |c| self.side_now(model, &c));
            self.motion.sides.push(side);
        }
    }

    fn side_now(&self, model: &Model<'_>, contact: &PartingContact<'_>) -> f64 {
        let ([round, other], Some((base, through))) = Self::parts_of(contact) else { return 0.0 };
        let Some(round) = round.or(other) else { return 0.0 };
        let line = if contact.first.0 == base { contact.first.1 } else { contact.second.1 };
        let ProfileShape::Line(_, along) = line else { return 0.0 };
        let base = &self.motion.bodies[base];
        let n = along.turned(base.u).perp();
        let height = |p: Vec2| n.dot(p - base.position(through));
        let (body, c) = round.of(self);
        let mass = model.mechanism.links.get(round.body).and_then(|link| link.mass.as_ref());
        let centre = mass.map_or(body.p, |mass| body.position(mass.centre));
        let size = (c - base.position(through)).norm() + (centre - c).norm();
        let tells = [height(c), height(centre)].into_iter().find(|h| h.abs() > NEAR * size);
        if tells.is_some_and(|height| height < 0.0) { -1.0 } else { 1.0 }
    }

    /// Its round profiles, and its line by body and a point of it.
    fn parts_of(contact: &PartingContact<'_>) -> ([Option<Centre>; 2], Option<(usize, Vec2)>) {
        let straight = |(body, shape): (usize, ProfileShape)| match shape {
            ProfileShape::Line(through, _) => Some((body, through)),
            _ => None,
        };
        let round = [contact.first, contact.second].map(PartingContact::round);
        (round, straight(contact.first).or_else(|| straight(contact.second)))
    }

    /// The normal of its line into the round profile.
    fn normal_into_round(&self, contact: &PartingContact<'_>) -> Option<(Vec2, Vec2)> {
        let (p, n) = self.parting_touch(contact)?;
        Some((p, if matches!(contact.first.1, ProfileShape::Line(..)) { -n } else { n }))
    }
}

/// A profile that is nearer to a line than this part of what it is measured by stands on it.
const NEAR: f64 = 1e-9;
