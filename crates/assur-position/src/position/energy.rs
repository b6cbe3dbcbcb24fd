//! Energy and power at one position.

use super::body::BodyState;
use super::gap::PartingContact;
use super::model::Model;
use super::reduced::Column;
use super::state::State;
use super::virtual_power::power;
use crate::force::spring::spring;
use crate::math::Vec2;
use crate::model::{Link, LoadId, LoadKind, Mechanism, Place, Spring, Value};
use crate::structure::JointKind;

/// The ends of a spring are at one place below this part of its free length and of how far they are.
const SAME_PLACE: f64 = 1e-12;

impl State {
    /// Kinetic energy of all bodies that have a mass, J.
    #[must_use]
    pub fn kinetic_energy(&self, mechanism: &Mechanism) -> f64 {
        let massive = mechanism.links.iter().zip(&self.motion.bodies).skip(1);
        let of = |(link, body): (&Link, &BodyState)| {
            let Some(m) = &link.mass else { return 0.0 };
            let v = body.velocity(m.centre);
            0.5 * (m.mass * v.dot(v) + m.inertia * body.omega * body.omega)
        };
        massive.map(of).sum()
    }

    /// Potential energy, J: of weights from y = 0, of springs from their free lengths.
    #[must_use]
    pub fn potential_energy(&self, mechanism: &Mechanism) -> f64 {
        let g = mechanism.gravity.map_or(Vec2::zero(), |gravity| gravity.acceleration);
        let massive = mechanism.links.iter().zip(&self.motion.bodies).skip(1);
        let weight = |(link, body): (&Link, &BodyState)| {
            link.mass.as_ref().map_or(0.0, |m| -m.mass * g.dot(body.position(m.centre)))
        };
        let spring = |s: &Spring| {
            let ends = [s.from, s.to].map(|(link, at)| self.motion.bodies[link.index()].position(at));
            let extension = (ends[1] - ends[0]).norm() - s.free_length;
            0.5 * s.stiffness * extension * extension
        };
        massive.map(weight).sum::<f64>() + mechanism.springs.iter().map(spring).sum::<f64>()
    }

    /// From one end of a spring to the other: the way, m, and the velocity, m/s.
    #[must_use]
    pub fn spring_between(&self, s: &Spring) -> (Vec2, Vec2) {
        let ends = [s.from, s.to].map(|(link, at)| {
            let body = &self.motion.bodies[link.index()];
            (body.position(at), body.velocity(at))
        });
        (ends[1].0 - ends[0].0, ends[1].1 - ends[0].1)
    }

    /// Whether the ends of a spring whose force needs a direction are at one place.
    #[must_use]
    pub fn spring_at_zero(&self, s: &Spring) -> bool {
        let (link, at) = s.from;
        let far = s.free_length + self.motion.bodies[link.index()].position(at).norm();
        s.has_direction() && self.spring_between(s).0.norm() <= SAME_PLACE * far
    }

    /// The first such spring, by its place in the mechanism.
    #[must_use]
    pub fn first_spring_at_zero(&self, mechanism: &Mechanism) -> Option<usize> {
        mechanism.springs.iter().position(|spring| self.spring_at_zero(spring))
    }

    /// Power of a spring with its damper, W.
    #[must_use]
    pub fn spring_power(&self, s: &Spring) -> f64 {
        let (r, v) = self.spring_between(s);
        -spring(r, v, s.stiffness, s.free_length, s.damping).f_1.dot(v)
    }

    /// Power of all weights, loads, springs and dampers, W, with the values of the loads that are evaluated at every position.
    #[must_use]
    pub fn power_of_loads(&self, model: &Model<'_>, evaluated: &[(LoadId, Value)]) -> f64 {
        let bodies = &self.motion.bodies;
        let moves = |body: usize| Column { v: bodies[body].v, omega: bodies[body].omega };
        let known: f64 = model.plan.loads.iter().map(|load| power(load, bodies, moves)).sum();
        known + evaluated.iter().map(|(id, value)| self.evaluated_power(model, *id, *value)).sum::<f64>()
    }

    fn evaluated_power(&self, model: &Model<'_>, id: LoadId, value: Value) -> f64 {
        match (&model.mechanism.loads[id.index()].kind, value) {
            (
                LoadKind::Force { on, at, .. } | LoadKind::ForceAgainstMotion { on, at, .. },
                Value::Vector(force),
            ) => {
                let body = &self.motion.bodies[on.index()];
                let v = match at {
                    Place::Local(at) => body.velocity(*at),
                    // a place of the ground: `check` folds it to numbers
                    Place::Ground(crate::model::Expr::Constant(Value::Vector(p))) => {
                        body.v + (*p - body.p).perp() * body.omega
                    }
                    Place::Ground(_) => Vec2::new(f64::NAN, f64::NAN),
                };
                force.dot(v)
            }
            (LoadKind::Torque { on, .. }, Value::Scalar(torque)) => {
                torque * self.motion.bodies[on.index()].omega
            }
            (LoadKind::InPair { pair, .. }, Value::Scalar(effort)) => {
                effort * self.coordinate_rate(model, *pair)
            }
            _ => 0.0,
        }
    }

    /// Rate of the coordinate along which an effort inside a pair acts.
    #[must_use]
    pub fn coordinate_rate(&self, model: &Model<'_>, pair: crate::model::PairId) -> f64 {
        if let Some(sides) = model.mechanism.pair(pair).kind.slipping() {
            let [first, second] = sides.map(|side| self.motion.bodies[side.index()].omega);
            return second - first;
        }
        if let Some(contact) = PartingContact::of_pair(model, pair) {
            return self.gap_rate(&contact);
        }
        let joints = model.structure.replaced.joints_of(pair);
        let mut rates = joints.filter_map(|joint| match &model.structure.replaced.joint(joint).kind {
            JointKind::Prismatic { slider, point, direction, guide, .. } => {
                let (slider, guide) = (&self.motion.bodies[slider.0], &self.motion.bodies[guide.0]);
                let p = slider.position(*point);
                let v = slider.velocity(*point) - guide.v - (p - guide.p).perp() * guide.omega;
                Some(v.dot(direction.turned(slider.u)))
            }
            JointKind::Revolute(members)
                if matches!(model.mechanism.pair(pair).kind, crate::model::PairKind::Revolute(_)) =>
            {
                let [first, second] = members.as_slice() else { return None };
                Some(self.motion.bodies[second.0.0].omega - self.motion.bodies[first.0.0].omega)
            }
            JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => None,
        });
        rates.next().unwrap_or(0.0)
    }
}
