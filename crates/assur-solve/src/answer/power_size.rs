//! The size of the terms that a power is made of: forces times speeds, whatever the angle between them.

use super::pose_answers::PoseAnswers;
use crate::math::Vec2;
use crate::model::{Expr, LinkId, LoadKind, PairId, Query, Value};
use crate::position::BodyState;

impl PoseAnswers<'_> {
    /// Of a power whose work is asked for, W.
    #[must_use]
    pub(crate) fn size_of_power(&self, power: &Expr) -> f64 {
        match power {
            Expr::Negate(a) => self.size_of_power(a),
            Expr::Binary(_, a, b) => self.size_of_power(a) + self.size_of_power(b),
            Expr::Query(Query::LoadPower(id)) => self.load_power_size(id.index()),
            Expr::Query(Query::SpringPower(id)) => self.spring_power_size(*id),
            Expr::Query(Query::FrictionPower(pair)) => self.friction_power_size(*pair),
            other => self.scalar(other).abs(),
        }
    }

    fn load_power_size(&self, index: usize) -> f64 {
        match (&self.mechanism.loads[index].kind, self.load(index)) {
            (
                LoadKind::Force { on, at, .. } | LoadKind::ForceAgainstMotion { on, at, .. },
                Value::Vector(force),
            ) => force.norm() * speed_size(self.body(*on), self.place(*on, at)),
            (LoadKind::Torque { on, .. }, Value::Scalar(torque)) => torque.abs() * self.turning_size(*on),
            (LoadKind::InPair { pair, .. }, Value::Scalar(effort)) => effort.abs() * self.rate_size(*pair),
            _ => f64::NAN,
        }
    }

    fn spring_power_size(&self, id: usize) -> f64 {
        let s = &self.mechanism.springs[id];
        let ends = [s.from, s.to].map(|(link, at)| {
            let body = self.body(link);
            (body.position(at), speed_size(body, body.position(at)))
        });
        let speed = ends[0].1 + ends[1].1;
        let length = (ends[1].0 - ends[0].0).norm() + s.free_length;
        (s.stiffness * length + s.damping * speed) * speed
    }

    fn friction_power_size(&self, pair: PairId) -> f64 {
        let of = |(element, value): (&crate::plan::FrictionElement, f64)| {
            let bodies = [element.body, element.base].map(LinkId::at);
            let rate = match self.state.friction_line(element) {
                None => bodies.map(|body| self.turning_size(body)),
                Some((at, _)) => bodies.map(|body| speed_size(self.body(body), at)),
            };
            value.abs() * (rate[0] + rate[1])
        };
        self.elements(pair).map(of).sum()
    }

    /// Of the rate of a pair's coordinate.
    fn rate_size(&self, pair: PairId) -> f64 {
        if let Some((first, second)) = self.hinge(pair) {
            return self.turning_size(first) + self.turning_size(second);
        }
        let Some(g) = self.guide(pair) else { return 0.0 };
        let at = self.body(g.slider).position(g.point);
        speed_size(self.body(g.slider), at) + speed_size(self.body(g.guide), at)
    }

    /// Of an angular velocity, which is found from velocities over lengths.
    fn turning_size(&self, link: LinkId) -> f64 {
        if link == LinkId::GROUND { 0.0 } else { self.body(link).omega.abs().max(self.fastest().1) }
    }
}

/// Of the velocity of a place on a body.
fn speed_size(body: &BodyState, at: Vec2) -> f64 {
    body.v.norm() + (at - body.p).norm() * body.omega.abs()
}
