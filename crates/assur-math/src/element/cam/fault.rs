//! Errors of a cam: a follower that does not stand on it, a profile that the follower cannot follow.

use super::{Cam, Quantity, Shape};

/// Relative difference below which two radii are equal.
const EQUAL: f64 = 1e-9;

/// Why a follower does not stand on its base circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Misfit {
    /// The line of the follower passes outside the base circle.
    Offset,
    /// Arm, pivot distance and base radius make no triangle: the base radius must lie between these, m.
    Triangle { least: f64, most: f64 },
    /// A flat face cannot reach the base circle: its radius must be less than this, m.
    Face { most: f64 },
    /// At its greatest lift the follower has turned past the line that it may reach, rad.
    TooHigh {
        /// Its angle at lift zero.
        start: f64,
        /// Its angle at the greatest lift.
        top: f64,
        /// The angle it must stay below.
        limit: f64,
    },
}

/// Why a follower cannot follow its profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// The profile cuts itself: somewhere the pitch curve bends more sharply than the roller (a flat face meets a hollow).
    Undercut {
        /// Cam angle, rad.
        phi: f64,
        /// Least radius of curvature of the pitch curve (of the profile under a flat face), m.
        radius: f64,
    },
    /// The profile comes to a point.
    Pointed {
        /// Cam angle, rad.
        phi: f64,
        /// The radius that equals that of the roller, m.
        radius: f64,
    },
    /// The follower turns away faster than the cam comes on: the curve loops back.
    Loop {
        /// Cam angle, rad.
        phi: f64,
    },
}

impl Cam {
    /// What the follower cannot follow, the worst of it.
    #[must_use]
    pub fn fault(&self) -> Option<Fault> {
        let (phi, back) = self.greatest_of(|p| -p.advance);
        if back >= 0.0 {
            return Some(Fault::Loop { phi });
        }
        let shape = self.follower.shape();
        let roller = shape.radius();
        let (phi, radius) = self.extreme(Quantity::CurvatureRadius, false);
        let judged = |off: f64| {
            if off < -EQUAL * self.base_radius {
                Some(Fault::Undercut { phi, radius })
            } else if off <= EQUAL * self.base_radius {
                Some(Fault::Pointed { phi, radius })
            } else {
                None
            }
        };
        match shape {
            Shape::Flat => judged(radius),
            // a curve that is nowhere convex is none
            Shape::Roller(_) if radius > 0.0 => judged(radius - roller),
            Shape::Roller(_) | Shape::Knife => None,
        }
    }

    /// The next greater base radius with a profile that the follower can follow, m; `None` where none is found.
    #[must_use]
    pub fn enough_base_radius(&self) -> Option<f64> {
        let sound = |r: f64| self.on_base(r).ok().map(|cam| cam.fault().is_none());
        let mut bad = self.base_radius;
        let mut good = bad * 1.02;
        while !sound(good)? {
            (bad, good) = (good, good * 1.02);
            if good > 100.0 * self.base_radius {
                return None;
            }
        }
        for _ in 0..40 {
            let middle = 0.5 * (bad + good);
            if sound(middle)? {
                good = middle;
            } else {
                bad = middle;
            }
        }
        Some(good)
    }
}
