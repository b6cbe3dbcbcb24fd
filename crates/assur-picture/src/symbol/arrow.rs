//! Arrows of loads, efforts and drives.

use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;

/// An arc arrow about a point, in the sense of positive angles of the ground (counter-clockwise) or against it. `middle` is the
/// angle of its middle on the ground, rad.
pub fn turn(
    drawing: &mut Drawing,
    style: Style,
    centre: Vec2,
    radius: f64,
    (middle, angle): (f64, f64),
    ccw: bool,
) {
    let sweep = if ccw { angle } else { -angle };
    // the y axis of paper points down
    let from = -(middle - 0.5 * sweep);
    drawing.mark(style, Shape::ArcArrow { centre, radius, from, sweep: -sweep });
}

/// The middle of such an arc.
pub fn middle(centre: Vec2, radius: f64, angle: f64) -> Vec2 {
    centre + Vec2::direction(-angle) * radius
}

/// An arrow from a point.
pub fn straight(drawing: &mut Drawing, style: Style, from: Vec2, to: Vec2) {
    drawing.mark(style, Shape::Arrow(from, to));
}
