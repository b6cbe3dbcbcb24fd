//! The curvature of the path of a point: none where the point is at rest, or its path is straight.

use super::pose_answers::{NAN_VECTOR, PoseAnswers};
use super::sizes::Sizes;
use crate::math::Vec2;
use crate::model::PointRef;
use crate::position::BodyState;
use assur_math::math::ROUNDING;

impl PoseAnswers<'_> {
    /// Velocity of a point, and v × a; none where one of the two is no more than rounding of what moves.
    fn bend(&self, point: &PointRef) -> Option<(Vec2, f64)> {
        let bodies = &self.state.motion.bodies;
        let greatest = |of: &dyn Fn(&BodyState) -> f64| bodies.iter().map(of).fold(0.0, f64::max);
        let origin = bodies.first().map_or(Vec2::zero(), |ground| ground.p);
        let extent = greatest(&|body| (body.p - origin).norm());
        let turned = greatest(&|body| body.alpha.abs().max(body.omega * body.omega));
        let speed = greatest(&|body| body.v.norm()).max(greatest(&|body| body.omega.abs()) * extent);
        let acceleration = greatest(&|body| body.a.norm()).max(turned * extent);
        let v = self.velocity(point);
        let bend = v.cross(self.acceleration(point));
        let moves = v.norm() > ROUNDING * speed && bend.abs() > ROUNDING * v.norm() * acceleration;
        moves.then_some((v, bend))
    }

    /// |v|³ / (v × a)
    pub(super) fn curvature_radius(&self, point: &PointRef) -> f64 {
        self.bend(point).map_or(f64::NAN, |(v, bend)| v.dot(v) * v.norm() / bend)
    }

    /// p + (−v_y, v_x) |v|² / (v × a)
    pub(super) fn curvature_centre(&self, point: &PointRef) -> Vec2 {
        self.bend(point).map_or(NAN_VECTOR, |(v, bend)| self.position(point) + v.perp() * (v.dot(v) / bend))
    }

    /// The radius with the rounding of velocity and acceleration in it.
    pub(super) fn curvature_size(&self, point: &PointRef, sizes: &Sizes) -> f64 {
        self.bend(point).map_or(f64::NAN, |(v, bend)| {
            let grown = sizes.speed() / v.norm() + v.norm() * sizes.acceleration() / bend.abs();
            sizes.length + v.dot(v) * v.norm() / bend.abs() * grown
        })
    }
}
