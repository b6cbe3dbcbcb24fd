//! Mass centres and named points.

use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;
use std::f64::consts::FRAC_PI_2;

/// Radius of the sign of a mass centre.
pub const RADIUS: f64 = 1.25;
/// Radius of one of several masses of a link.
const PART: f64 = 0.9;
/// Radius of a point.
pub const POINT: f64 = 0.6;

/// A circle with two filled quarters.
pub fn centre(drawing: &mut Drawing, at: Vec2) {
    drawing.mark(Style::Centre, Shape::Circle { centre: at, radius: RADIUS });
    for from in [-FRAC_PI_2, FRAC_PI_2] {
        drawing.mark(Style::Solid, Shape::Sector { centre: at, radius: RADIUS, from, sweep: FRAC_PI_2 });
    }
}

pub fn point(drawing: &mut Drawing, at: Vec2) {
    drawing.mark(Style::Solid, Shape::Circle { centre: at, radius: POINT });
}

/// One of several masses of a link.
pub fn part(drawing: &mut Drawing, at: Vec2) {
    drawing.mark(Style::Solid, Shape::Circle { centre: at, radius: PART });
}
