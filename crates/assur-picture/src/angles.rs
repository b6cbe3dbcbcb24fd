//! Directions on paper, whose y axis points down.

use assur_math::math::Vec2;
use std::f64::consts::{PI, TAU};

/// A direction of the ground's axes on paper, and back.
pub const fn flipped(v: Vec2) -> Vec2 {
    Vec2::new(v.x, -v.y)
}

/// The direction that leaves the most room between others; none where there are no others.
pub fn freest(directions: &[Vec2]) -> Option<Vec2> {
    let mut angles: Vec<f64> = directions.iter().filter_map(|d| d.unit()).map(Vec2::angle).collect();
    angles.sort_by(f64::total_cmp);
    let first = *angles.first()?;
    angles.push(first + TAU);
    let mut widest: Option<(f64, f64)> = None;
    for pair in angles.windows(2) {
        let gap = pair[1] - pair[0];
        if widest.is_none_or(|(most, _)| gap > most + 1e-6) {
            widest = Some((gap, pair[0] + gap / 2.0));
        }
    }
    widest.map(|(_, middle)| Vec2::direction(middle))
}

/// An angle between −π and π.
pub fn wrapped(angle: f64) -> f64 {
    let turned = angle - TAU * (angle / TAU).round();
    if turned <= -PI { turned + TAU } else { turned }
}
