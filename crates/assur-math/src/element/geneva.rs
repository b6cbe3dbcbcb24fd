//! A Geneva wheel: a pin on a crank turns it by one slot per turn, and a locking arc holds it in between.
//!
//! With the crank's angle φ against the line from its centre A to the wheel's centre C and λ = AB/AC, the direction of the
//! slot in which the pin is, against the line from C to A, is
//!
//! ```text
//! δ  = −atan2(λ sin φ, 1 − λ cos φ),
//! δ′ = −λ (cos φ − λ)/D,   δ″ = λ (1 − λ²) sin φ/D²,   D = 1 − 2 λ cos φ + λ².
//! ```
//!
//! The pin enters where the next slot waits, δ = π/n. Where it enters along the slot, λ = sin(π/n), the wheel starts from
//! rest without a shock.

use std::f64::consts::{PI, TAU};

/// Angles this near to the begin or the end of the engagement are there, rad.
const NEAR: f64 = 1e-12;
/// A ratio this near to sin(π/n), as a part of it, is that of an entry along the slot.
const EQUAL: f64 = 1e-9;

/// The law of a Geneva wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geneva {
    /// Radius of the pin's circle over the distance of the centres.
    pub ratio: f64,
    pub slots: u32,
    /// Half of the crank's angle while the pin is in a slot, rad.
    half: f64,
}

/// The wheel at an angle of the crank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slotted {
    /// δ, δ′, δ″ of the slot that the pin is in, or was in last, or enters next.
    pub slot: [f64; 3],
    /// The pin is in a slot.
    pub engaged: bool,
}

impl Geneva {
    /// A wheel; `None` where the pin does not reach the next slot.
    #[must_use]
    pub fn new(ratio: f64, slots: u32) -> Option<Self> {
        let step = PI / f64::from(slots);
        let sine = libm::sin(step) / ratio;
        (ratio < 1.0 && sine <= 1.0 + EQUAL).then(|| {
            let half = if (sine - 1.0).abs() <= EQUAL { 0.5 * PI - step } else { libm::asin(sine) - step };
            Self { ratio, slots, half }
        })
    }

    /// Half of the crank's angle while the pin is in a slot, rad.
    #[must_use]
    pub const fn half(&self) -> f64 {
        self.half
    }

    /// The ratio of the angular velocities where the pin enters: not zero where it enters with a shock.
    #[must_use]
    pub fn shock(&self) -> f64 {
        let smooth = (libm::sin(PI / f64::from(self.slots)) / self.ratio - 1.0).abs() <= EQUAL;
        if smooth { 0.0 } else { self.in_slot(self.half)[1] }
    }

    /// The angle between neighbouring slots, rad.
    #[must_use]
    pub fn pitch(&self) -> f64 {
        TAU / f64::from(self.slots)
    }

    /// The wheel at a crank's angle in (−π, π].
    #[must_use]
    pub fn at(&self, phi: f64) -> Slotted {
        if -self.half - NEAR <= phi && phi < self.half - NEAR {
            return Slotted { slot: self.in_slot(phi), engaged: true };
        }
        let rest = 0.5 * self.pitch();
        Slotted { slot: [if phi < 0.0 { rest } else { -rest }, 0.0, 0.0], engaged: false }
    }

    fn in_slot(&self, phi: f64) -> [f64; 3] {
        let (sin, cos) = libm::sincos(phi);
        let k = self.ratio;
        let d = 1.0 - 2.0 * k * cos + k * k;
        [-libm::atan2(k * sin, 1.0 - k * cos), -k * (cos - k) / d, k * (1.0 - k) * (1.0 + k) * sin / (d * d)]
    }
}
