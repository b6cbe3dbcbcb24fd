//! The smallest base circle on which the pressure angle nowhere exceeds an allowed one.

use super::{Cam, Follower, Quantity, Shape};

/// Base radii looked at between those on which an oscillating follower can stand.
const LOOKS: usize = 400;
/// Halvings of the interval found.
const HALVINGS: usize = 60;

impl Cam {
    /// The smallest base radius on which no pressure angle exceeds `allowed` (rad, 0 < α < π/2), m. `None` where there is
    /// none, and for a flat face across the way, whose pressure angle depends on no radius.
    ///
    /// Knife edge or roller, translating: tan α = |s′ − e| / (d₀ + s), so that d₀ = max(|s′ − e| / tan α − s).
    #[must_use]
    pub fn smallest_base_radius(&self, allowed: f64) -> Option<f64> {
        match self.follower {
            Follower::Translating { shape: Shape::Flat, .. } => None,
            Follower::Translating { offset, .. } => {
                let tan = libm::tan(allowed);
                let need = |sign: f64| self.greatest_of(|p| sign * (p.lift[1] - offset) / tan - p.lift[0]).1;
                let start = need(1.0).max(need(-1.0)).max(0.0);
                Some(libm::hypot(start, offset))
            }
            Follower::Oscillating { shape, arm, pivot_distance, offset, .. } => {
                let (least, most) = match shape {
                    Shape::Flat => (0.0, pivot_distance - offset),
                    Shape::Knife | Shape::Roller(_) => ((pivot_distance - arm).abs(), pivot_distance + arm),
                };
                self.first_allowed(least, most, allowed)
            }
        }
    }

    fn first_allowed(&self, least: f64, most: f64, allowed: f64) -> Option<f64> {
        let good =
            |r: f64| self.on_base(r).is_ok_and(|cam| cam.extreme(Quantity::PressureAngle, true).1 <= allowed);
        let at = |i: usize| least + (most - least) * i as f64 / LOOKS as f64;
        let first = (1..LOOKS).find(|&i| good(at(i)))?;
        let (mut low, mut high) = (at(first - 1), at(first));
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if good(middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        Some(high)
    }
}
