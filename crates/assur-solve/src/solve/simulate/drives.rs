//! What drives say at an instant.

use super::bearing::{Bearing, Spread};
use super::derivatives::Derivatives;
use crate::answer::Switch;
use crate::math::Vec2;
use crate::model::{Axis, Drive, DriveTarget, Positions};
use crate::position::{DriveInput, Motion, State};

/// What the drives of one instant say beside their positions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Instant {
    pub time: f64,
    /// Their rates and accelerations.
    pub rates: Vec<DriveInput>,
    /// The work of all loads since the first instant, J.
    pub work: f64,
    /// Works since then, J.
    pub works: Vec<f64>,
    /// What bears the loads beside reactions.
    pub bearing: Bearing,
    /// A second way to share it, where there is one.
    pub spread: Spread,
    /// What stops gave in an impact at the instant.
    pub impulses: Vec<f64>,
    /// On which sides contacts that part stand.
    pub sides: Vec<f64>,
}

impl Instant {
    /// Sets instant, rates and accelerations.
    pub fn set(&self, motion: &mut Motion) {
        (motion.time, motion.work) = (self.time, self.work);
        motion.works.clone_from(&self.works);
        self.bearing.set(motion);
        motion.impulses.clone_from(&self.impulses);
        motion.sides.clone_from(&self.sides);
        for (input, said) in motion.inputs.iter_mut().zip(&self.rates) {
            *input = DriveInput { place: input.place, value: input.value, ..*said };
        }
    }

    /// The state that was found with the other way to share.
    pub fn other(&self, state: &State) -> Option<Box<State>> {
        let (bearing, forces) = self.spread.as_deref()?;
        let mut other = state.answer();
        bearing.set(&mut other.motion);
        other.forces.clone_from(forces);
        Some(Box::new(other))
    }
}

/// What a drive says whose motion is given, at an instant, s, so long after the first one; what is not smooth in it, on its
/// side.
pub(super) fn prescribed(
    drive: &Drive,
    first: &DriveInput,
    (t, elapsed): (f64, f64),
    switches: &[Switch<'_>],
) -> DriveInput {
    let timed = match &drive.positions {
        Positions::List(list) if drive.of_time => list.first(),
        _ => None,
    };
    if let (DriveTarget::Point(..), Some(expr)) = (drive.target, timed) {
        let [x, y] = [Axis::X, Axis::Y].map(|axis| Derivatives::component(expr, axis, t, switches).0);
        let [place, velocity, point_acceleration, point_jerk] =
            [0, 1, 2, 3].map(|order| Vec2::new(x[order], y[order]));
        return DriveInput { place, velocity, point_acceleration, point_jerk, ..*first };
    }
    if let DriveTarget::Point(..) = drive.target {
        let (v, a) = (first.velocity, first.point_acceleration);
        let place = first.place + (v + a * (0.5 * elapsed)) * elapsed;
        return DriveInput { place, velocity: v + a * elapsed, ..*first };
    }
    let [value, rate, acceleration, jerk] = timed.map_or_else(
        || {
            let value = first.value + (first.rate + 0.5 * first.acceleration * elapsed) * elapsed;
            [value, first.rate + first.acceleration * elapsed, first.acceleration, 0.0]
        },
        |expr| Derivatives::of(expr, t, switches).0,
    );
    DriveInput { place: Vec2::direction(value), value, rate, acceleration, jerk, ..*first }
}

/// Whether a drive moves that says this at the first instant.
pub(super) fn moves(first: &DriveInput) -> bool {
    let DriveInput { rate, acceleration, velocity, point_acceleration, .. } = first;
    let points = [velocity.x, velocity.y, point_acceleration.x, point_acceleration.y];
    *rate != 0.0 || *acceleration != 0.0 || points != [0.0; 4]
}
