//! A plate cam with its follower, and what is greatest or least over its turn.

use super::fault::Misfit;
use super::point::{CamPoint, Quantity};
use super::program::{Part, Program};
use super::{Follower, Shape};
use crate::element::search::greatest;

/// As near as this to an end of a part, rad, an extreme is there.
const AT_END: f64 = 1e-6;

#[derive(Clone, Debug, PartialEq)]
pub struct Cam {
    /// Least radius of the pitch curve; for a flat face least distance of the face from the centre, m.
    pub base_radius: f64,
    pub ccw: bool,
    pub follower: Follower,
    /// How the follower moves.
    pub program: Program,
    /// Where the follower stands at lift zero: d₀, m, or ψ₀, rad.
    pub(super) start: f64,
}

impl Cam {
    /// A cam.
    ///
    /// # Errors
    /// The follower cannot stand on the base circle, or not at its greatest lift.
    pub fn new(base_radius: f64, ccw: bool, follower: Follower, program: Program) -> Result<Self, Misfit> {
        let start = start(base_radius, &follower)?;
        let (top, limit) = match follower {
            Follower::Translating { .. } => (0.0, 1.0),
            Follower::Oscillating { shape: Shape::Flat, .. } => {
                (start + program.greatest_lift(), std::f64::consts::FRAC_PI_2)
            }
            Follower::Oscillating { .. } => (start + program.greatest_lift(), std::f64::consts::PI),
        };
        if top >= limit {
            return Err(Misfit::TooHigh { start, top, limit });
        }
        Ok(Self { base_radius, ccw, follower, program, start })
    }

    /// The same on another base circle.
    ///
    /// # Errors
    /// The follower cannot stand there.
    pub fn on_base(&self, base_radius: f64) -> Result<Self, Misfit> {
        Self::new(base_radius, self.ccw, self.follower, self.program.clone())
    }

    /// Where the follower stands at lift zero: distance of the tip (face) from the centre along its way, m, or the angle of
    /// the arm (face) against the line from its pivot to the cam's centre, rad.
    #[must_use]
    pub const fn start(&self) -> f64 {
        self.start
    }

    /// All that belongs to a cam angle, by the formula of a part that holds there.
    #[must_use]
    pub fn on_part(&self, part: &Part, phi: f64) -> CamPoint {
        self.with_lift(self.program.on_part(part, phi))
    }

    /// Cam angle and value where a function of the cam is greatest, parts looked at up to their ends.
    pub(super) fn greatest_of(&self, f: impl Fn(&CamPoint) -> f64) -> (f64, f64) {
        let mut best = (0.0, f64::NEG_INFINITY);
        for part in self.program.parts() {
            let value = |phi: f64| f(&self.on_part(&part, phi));
            let found = greatest(part.from, part.to, &value);
            // next to an end of a part it is that end: the search knows a flat top to half its digits
            let ends = [part.from, part.to].into_iter().find(|end| (end - found.0).abs() < AT_END);
            let same = |end: &f64| value(*end) >= found.1 - 1e-13 * found.1.abs();
            let found = ends.filter(same).map_or(found, |end| (end, value(end)));
            // equal hills: the first one
            if found.1 > best.1 + 1e-13 * best.1.abs() || best.1 == f64::NEG_INFINITY {
                best = found;
            }
        }
        best
    }

    /// Cam angle and value where a quantity is greatest, or least. The least radius of curvature is the sharpest convex
    /// one; there is no greatest one where the curve is hollow or straight somewhere (not a number).
    #[must_use]
    pub fn extreme(&self, quantity: Quantity, most: bool) -> (f64, f64) {
        let flat = self.follower.shape() == Shape::Flat;
        match (quantity, most) {
            (Quantity::CurvatureRadius, false) if !flat => {
                let (phi, sharpest) = self.greatest_of(|p| p.curvature);
                (phi, 1.0 / sharpest)
            }
            (Quantity::CurvatureRadius, true) => {
                let (phi, bluntest) = self.greatest_of(|p| -p.curvature);
                (phi, if bluntest < 0.0 { -1.0 / bluntest } else { f64::NAN })
            }
            (quantity, true) => self.greatest_of(|p| p.value(quantity)),
            (quantity, false) => {
                let (phi, least) = self.greatest_of(|p| -p.value(quantity));
                (phi, -least)
            }
        }
    }
}

/// Where the follower stands at lift zero.
fn start(base_radius: f64, follower: &Follower) -> Result<f64, Misfit> {
    match *follower {
        Follower::Translating { shape: Shape::Flat, .. } => Ok(base_radius),
        Follower::Translating { offset, .. } => {
            if offset.abs() >= base_radius {
                return Err(Misfit::Offset);
            }
            Ok(((base_radius - offset) * (base_radius + offset)).sqrt())
        }
        Follower::Oscillating { shape: Shape::Flat, pivot_distance, offset, .. } => {
            let sine = (base_radius + offset) / pivot_distance;
            if sine.abs() >= 1.0 {
                return Err(Misfit::Face { most: pivot_distance - offset });
            }
            Ok(libm::asin(sine))
        }
        Follower::Oscillating { arm, pivot_distance, .. } => {
            let (least, most) = ((pivot_distance - arm).abs(), pivot_distance + arm);
            if base_radius <= least || base_radius >= most {
                return Err(Misfit::Triangle { least, most });
            }
            // tan² (ψ/2) = (r² − (a − L)²) / ((a + L)² − r²), without the cancellation of the cosine rule
            let up = (base_radius - least) * (base_radius + least);
            let down = (most - base_radius) * (most + base_radius);
            Ok(2.0 * libm::atan2(up.sqrt(), down.sqrt()))
        }
    }
}
