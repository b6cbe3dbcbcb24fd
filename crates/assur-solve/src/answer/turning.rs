//! The angular velocity of a link against another, where they turn against each other.

use super::PoseAnswers;
use crate::model::LinkId;
use assur_math::math::ROUNDING;

/// ω of L against K; not a number where that is no more than rounding: then every point moves alike.
pub(super) fn turning(answers: &PoseAnswers<'_>, link: LinkId, seen_from: LinkId) -> f64 {
    let bodies = &answers.state.motion.bodies;
    let omega = answers.body(link).omega - answers.body(seen_from).omega;
    let greatest =
        |of: &dyn Fn(&crate::position::BodyState) -> f64| bodies.iter().map(of).fold(0.0, f64::max);
    let origin = bodies.first().map_or(crate::math::Vec2::zero(), |ground| ground.p);
    let extent = greatest(&|body| (body.p - origin).norm());
    // of bodies that only slide, rounding is that of velocities over distances
    let sliding = if extent > 0.0 { greatest(&|body| body.v.norm()) / extent } else { 0.0 };
    let scale = greatest(&|body| body.omega.abs()).max(sliding);
    if omega.abs() > ROUNDING * scale { omega } else { f64::NAN }
}
