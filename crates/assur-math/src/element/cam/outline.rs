//! The curves of a cam as polygons, with corners at equal steps of the cam angle.

use super::{Cam, CamPoint, Shape};
use crate::math::Vec2;
use std::f64::consts::TAU;

/// Steps with which the search for enough of them begins.
const FIRST: u32 = 36;
/// The most steps of a curve.
pub const MOST_STEPS: u32 = 36_000;
/// Where between two corners the distance of the curve is measured.
const BETWEEN: [f64; 3] = [0.25, 0.5, 0.75];

impl Cam {
    /// The profile, about the centre of the cam, m.
    #[must_use]
    pub fn profile(&self, steps: u32) -> Vec<Vec2> {
        self.corners(steps, |p| p.contact)
    }

    /// The path of the roller's centre in the cam; none without a roller.
    #[must_use]
    pub fn pitch_curve(&self, steps: u32) -> Option<Vec<Vec2>> {
        matches!(self.follower.shape(), Shape::Roller(_)).then(|| self.corners(steps, |p| p.tip))
    }

    /// The steps with which no curve is farther from its chords than this, m; none where there would be too many.
    #[must_use]
    pub fn steps_within(&self, error: f64) -> Option<u32> {
        let mut steps = FIRST;
        loop {
            let reached = self.chord_error(steps);
            if reached <= error {
                return Some(steps);
            }
            if steps == MOST_STEPS {
                return None;
            }
            // the error falls with the square of the number
            let factor = (reached / error).sqrt().clamp(1.01, 4.0);
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // at most four times the most
            let more = (f64::from(steps) * factor).ceil() as u32;
            steps = more.min(MOST_STEPS);
        }
    }

    /// How far the curves are from their chords, m.
    #[must_use]
    pub fn chord_error(&self, steps: u32) -> f64 {
        let profile = self.departure(steps, |p| p.contact);
        match self.follower.shape() {
            Shape::Roller(_) => profile.max(self.departure(steps, |p| p.tip)),
            _ => profile,
        }
    }

    fn departure(&self, steps: u32, of: fn(&CamPoint) -> Vec2) -> f64 {
        let step = TAU / f64::from(steps);
        let at = |i: f64| self.in_cam(of(&self.at(step * i)), step * i);
        let far = |i: u32| {
            let i = f64::from(i);
            let (a, b) = (at(i), at(i + 1.0));
            BETWEEN.map(|part| distance(at(i + part), a, b)).into_iter().fold(0.0, f64::max)
        };
        (0..steps).map(far).fold(0.0, f64::max)
    }

    fn corners(&self, steps: u32, of: fn(&CamPoint) -> Vec2) -> Vec<Vec2> {
        let angles = (0..steps).map(|i| TAU * f64::from(i) / f64::from(steps));
        angles.map(|phi| self.in_cam(of(&self.at(phi)), phi)).collect()
    }
}

/// From a point to a line between two others.
fn distance(p: Vec2, a: Vec2, b: Vec2) -> f64 {
    let along = b - a;
    let squared = along.dot(along);
    let t = if squared > 0.0 { ((p - a).dot(along) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (a + along * t - p).norm()
}
