//! What drives say at an instant.

use crate::position::{DriveInput, Motion};

/// What the drives of one instant say beside their positions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Instant {
    pub time: f64,
    /// Rate and acceleration, by drive.
    pub rates: Vec<(f64, f64)>,
}

impl Instant {
    /// Sets instant, rates and accelerations.
    pub fn set(&self, motion: &mut Motion) {
        motion.time = self.time;
        for (input, (rate, acceleration)) in motion.inputs.iter_mut().zip(&self.rates) {
            (input.rate, input.acceleration) = (*rate, *acceleration);
        }
    }
}

/// Value, rate and acceleration of a drive whose motion is given, so long after the first instant, s.
pub(super) fn prescribed(first: &DriveInput, elapsed: f64) -> (f64, f64, f64) {
    let value = first.value + (first.rate + 0.5 * first.acceleration * elapsed) * elapsed;
    (value, first.rate + first.acceleration * elapsed, first.acceleration)
}
