//! The error of an answer.
//!
//! A difference from the reference is taken over the greatest magnitude of its kind in play, over all bodies, pairs and
//! positions that are compared; L is the extent of the mechanism, the greatest distance of a joint from the origin of its
//! link's frame.
//!
//! | kind | difference | over |
//! | --- | --- | --- |
//! | position | \|Δp\| of a body's origin, L \|Δu\| of its direction | L |
//! | velocity | \|Δv\|, L \|Δω\| | the greatest \|v\|, L \|ω\| |
//! | acceleration | \|Δa\|, L \|Δα\| | the greatest \|a\|, L \|α\|, L ω² |
//! | beyond | \|Δ\| of a derivative after it, L times that of the angle | the greatest of them, L ω³; counted with accelerations |
//! | force | \|ΔF\| of a reaction, of an unknown force | the greatest reaction, unknown force, load on a body |
//! | moment | \|ΔM\| of a couple in a pair, of an unknown torque | the greatest of them, and L times the greatest force |

use super::answer::Answer;
use crate::math::{Double, V2};
use crate::plan::Level;
use crate::position::PLACES;
use crate::solve::{Model, extent, knows_couple};
use crate::structure::EffortKind;
use std::ops::Range;

/// The greatest magnitudes in play.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scales {
    /// L, m.
    pub extent: f64,
    /// m/s.
    pub velocity: f64,
    /// m/s².
    pub acceleration: f64,
    /// Of rates beyond it.
    pub beyond: f64,
    /// N.
    pub force: f64,
    pub moment: f64,
}

/// Greatest errors, each relative to its scale.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Error {
    /// Of positions and directions.
    pub position: f64,
    pub velocity: f64,
    pub acceleration: f64,
    pub force: f64,
    pub moment: f64,
}

impl Error {
    /// The greatest of all.
    #[must_use]
    pub fn greatest(&self) -> f64 {
        let kinds = [self.position, self.velocity, self.acceleration, self.force, self.moment];
        kinds.into_iter().fold(0.0, f64::max)
    }

    fn worse(self, other: Self) -> Self {
        Self {
            position: self.position.max(other.position),
            velocity: self.velocity.max(other.velocity),
            acceleration: self.acceleration.max(other.acceleration),
            force: self.force.max(other.force),
            moment: self.moment.max(other.moment),
        }
    }
}

/// What is no number is infinitely wrong.
fn magnitude(x: f64) -> f64 {
    if x.is_nan() { f64::INFINITY } else { x.abs() }
}

fn size(v: V2<Double>) -> f64 {
    magnitude(libm::hypot(v.x.rounded(), v.y.rounded()))
}

fn is_torque(kind: &EffortKind) -> bool {
    matches!(kind, EffortKind::Angle(_) | EffortKind::RelativeAngle { .. })
}

/// The greatest magnitudes of answers.
pub(super) fn scales(model: &Model<'_>, answers: &[Answer]) -> Scales {
    let extent = extent(model);
    let mut most = Scales { extent, ..Scales::default() };
    // what the plan does not follow stands as it was
    let level = model.plan.effects.level;
    for answer in answers {
        for b in &answer.bodies {
            if level > Level::Positions {
                most.velocity = most.velocity.max(size(b.v)).max(extent * b.omega.rounded().abs());
            }
            if level > Level::Velocities {
                most.acceleration = most.acceleration.max(size(b.a)).max(extent * b.alpha.rounded().abs());
                // what is nothing is not judged by itself
                most.acceleration = most.acceleration.max(extent * b.omega.rounded() * b.omega.rounded());
            }
            for order in beyond(model) {
                let (origin, turn) = b.rate(order);
                let least = b.omega.rounded().abs().powi(3);
                most.beyond = most.beyond.max(size(origin)).max(extent * turn.rounded().abs().max(least));
            }
        }
        most.force = most.force.max(answer.load);
        for r in &answer.reactions {
            most.force = most.force.max(size(r.force));
            most.moment = most.moment.max(r.couple.rounded().abs());
        }
        for (effort, e) in model.structure.efforts.iter().zip(&answer.efforts) {
            let kind = if is_torque(&effort.kind) { &mut most.moment } else { &mut most.force };
            *kind = kind.max(e.rounded().abs());
        }
    }
    most.moment = most.moment.max(extent * most.force);
    most
}

/// The derivatives after accelerations that a plan follows.
fn beyond(model: &Model<'_>) -> Range<usize> {
    if model.plan.effects.beyond { 3..PLACES } else { 3..3 }
}

/// A difference over its scale; none where nothing is in play.
fn over(difference: f64, scale: f64) -> f64 {
    if scale > 0.0 { difference / scale } else { 0.0 }
}

/// Errors of one answer; all are infinite where it has nothing to show.
pub(super) fn error(model: &Model<'_>, scales: &Scales, got: &Answer, exact: &Answer) -> Error {
    let mut error = Error::default();
    if got.bodies.len() != exact.bodies.len() {
        return Error { position: f64::INFINITY, ..error };
    }
    let length = scales.extent;
    for (a, b) in got.bodies.iter().zip(&exact.bodies) {
        let turn = |x: Double, y: Double| length * magnitude((x - y).rounded());
        let position = size(a.p - b.p).max(length * size(a.u - b.u));
        error = error.worse(Error {
            position: over(position, length),
            velocity: over(size(a.v - b.v).max(turn(a.omega, b.omega)), scales.velocity),
            acceleration: over(size(a.a - b.a).max(turn(a.alpha, b.alpha)), scales.acceleration),
            ..Error::default()
        });
        for order in beyond(model) {
            let ((p, turned), (q, wanted)) = (a.rate(order), b.rate(order));
            let rate = over(size(p - q).max(turn(turned, wanted)), scales.beyond);
            error.acceleration = error.acceleration.max(rate);
        }
    }
    // a reaction that the reference does not know either is not compared
    let known = |x: Double| x.rounded().is_finite();
    for (i, (a, b)) in got.reactions.iter().zip(&exact.reactions).enumerate() {
        if known(b.force.x) && known(b.force.y) && known(b.couple) {
            let force = over(size(a.force - b.force), scales.force);
            let couple = magnitude((a.couple - b.couple).rounded());
            let moment = if knows_couple(model, i) { over(couple, scales.moment) } else { 0.0 };
            error = error.worse(Error { force, moment, ..Error::default() });
        }
    }
    let efforts = model.structure.efforts.iter().zip(got.efforts.iter().zip(&exact.efforts));
    for (effort, (a, b)) in efforts.filter(|(_, (_, b))| known(**b)) {
        let difference = magnitude((*a - *b).rounded());
        error = error.worse(if is_torque(&effort.kind) {
            Error { moment: over(difference, scales.moment), ..Error::default() }
        } else {
            Error { force: over(difference, scales.force), ..Error::default() }
        });
    }
    error
}

/// The worst errors of answers, position by position.
pub(super) fn errors<'a>(
    model: &Model<'_>,
    scales: &Scales,
    pairs: impl Iterator<Item = (&'a Answer, &'a Answer)>,
) -> Error {
    pairs.fold(Error::default(), |worst, (got, exact)| worst.worse(error(model, scales, got, exact)))
}
