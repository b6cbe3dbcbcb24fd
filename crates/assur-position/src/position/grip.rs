//! Friction in a motion under loads, where the run and not the velocity says how a pair moves, and what its friction is: it slides
//! in a sense, or is held at rest by an effort that no law of sliding gives.

use super::body::BodyState;
use super::consistent::Consistent;
use super::state::State;
use crate::math::{Vec2, acceleration_at};
use crate::model::ProfileShape;
use crate::plan::{FrictionElement, FrictionLaw, Plan};

/// The velocity of the place where two profiles touch: it turns about the centre of a round one.
fn contact_velocity(
    p: Vec2,
    (body, first): (&BodyState, ProfileShape),
    (base, second): (&BodyState, ProfileShape),
) -> Vec2 {
    let about = |of: &BodyState, centre: Vec2, omega: f64| {
        of.velocity(centre) + (p - of.position(centre)).perp() * omega
    };
    match (centre(first), centre(second)) {
        (Some(one), Some(other)) => {
            let apart = base.position(other) - body.position(one);
            let rate = base.velocity(other) - body.velocity(one);
            about(body, one, apart.cross(rate) / apart.dot(apart))
        }
        (Some(one), None) => about(body, one, base.omega),
        (None, Some(other)) => about(base, other, body.omega),
        (None, None) => Vec2::new(f64::NAN, f64::NAN),
    }
}

/// The centre of a round profile.
fn centre(shape: ProfileShape) -> Option<Vec2> {
    match shape {
        ProfileShape::Point(at) | ProfileShape::Circle(at, _) => Some(at),
        ProfileShape::Line(..) | ProfileShape::Rim(_) => None,
    }
}

/// How an element of friction moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactMode {
    /// The sense of its relative motion, ±1, or 0 where it is held.
    pub sense: f64,
    /// The torque or force of friction on the element's body.
    pub effort: f64,
    /// Of a force at a point in the plane that begins to slide: against this velocity it acts while the point is slower, m/s.
    pub along: Vec2,
}

impl State {
    /// Whether several pairs share by friction what one of them could hold: some forces are not determined.
    #[must_use]
    pub const fn friction_shares(&self) -> bool {
        self.other.is_some()
    }

    /// Whether the run says what friction and losses are.
    pub(super) const fn is_gripped(&self) -> bool {
        !self.motion.grips.is_empty()
    }

    /// The forces with the friction and the losses that the run says: linear in the loads.
    pub(super) fn run_gripped_forces(&mut self, plan: &Plan) {
        (self.forces.locked, self.forces.consistent) = (false, Consistent::One);
        for (index, element) in plan.friction.iter().enumerate() {
            let ContactMode { sense, effort, .. } = self.motion.grips[index];
            (self.forces.senses[index], self.forces.frictions[index]) = (sense, effort);
            if effort != 0.0 {
                self.apply_rub(element, effort);
            }
        }
        self.apply_law_grips(plan);
        self.run_forces_without_friction(plan);
        self.take_sides(plan);
    }

    /// Acceleration of an element's body against its base where they do not move against each other, in the sense in which
    /// its effort counts.
    #[must_use]
    pub fn sliding_acceleration(&self, element: &FrictionElement) -> f64 {
        let (body, base) = (&self.motion.bodies[element.body], &self.motion.bodies[element.base]);
        let Some((p, d)) = self.friction_line(element) else { return body.alpha - base.alpha };
        let FrictionLaw::Contact { first, second, .. } = element.kind else {
            let at = |b: &BodyState| acceleration_at(b.a, b.omega, b.alpha, p - b.p);
            return (at(body) - at(base)).dot(d);
        };
        // the place of a contact moves along both profiles while they roll
        let v = contact_velocity(p, (body, first), (base, second));
        let at = |b: &BodyState| b.a + (p - b.p).perp() * b.alpha + (v - b.v).perp() * b.omega;
        (at(body) - at(base)).dot(d)
    }

    /// What presses in an element: the force in a hinge or contact, the normal force, the sum of those at two ends.
    #[must_use]
    pub fn pressing(&self, plan: &Plan, element: &FrictionElement) -> f64 {
        let Vec2 { x, y } = self.measured(plan, element);
        match element.kind {
            FrictionLaw::BothEnds { .. } => x.abs() + y.abs(),
            _ => Vec2::new(x, y).norm(),
        }
    }

    /// The friction of an element that slides in a sense, from what presses in the forces as they stand. What presses in a contact
    /// that may open goes on below zero: a motion ends where it opens, and is smooth up to there and beyond.
    #[must_use]
    pub fn sliding_friction(&self, plan: &Plan, element: &FrictionElement, sense: f64) -> f64 {
        let pressing = match (element.kind, element.stop) {
            (_, Some(_)) => self.measured(plan, element).x,
            (FrictionLaw::Contact { first, second, internal, presses, .. }, None) if presses != 0.0 => {
                let touch = self.touch((element.body, first), (element.base, second), internal);
                touch.map_or(f64::NAN, |(_, n)| n.dot(self.measured(plan, element)) * presses)
            }
            _ => self.pressing(plan, element),
        };
        -sense * element.kind.factor() * pressing
    }
}
