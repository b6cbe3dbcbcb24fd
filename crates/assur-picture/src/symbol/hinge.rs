//! Hinges.

use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;

/// Radius of a hinge.
pub const RADIUS: f64 = 1.5;
/// Radius of a pin in a slot.
pub const PIN: f64 = 1.2;
/// Width and height of the triangle below a fixed hinge.
const TRIANGLE: Vec2 = Vec2::new(6.2, 5.2);
/// Length of the line below it.
const BASE: f64 = 9.4;
/// From line to line of hatching, and how far each goes down.
const HATCH: (f64, f64) = (1.6, 1.56);

pub fn moving(drawing: &mut Drawing, at: Vec2) {
    drawing.mark(Style::Hinge, Shape::Circle { centre: at, radius: RADIUS });
}

/// A hinge on the ground: its triangle, to be drawn before the circle.
pub fn support(drawing: &mut Drawing, at: Vec2) {
    let half = TRIANGLE.x / 2.0;
    let (left, right) = (at + Vec2::new(-half, TRIANGLE.y), at + Vec2::new(half, TRIANGLE.y));
    drawing.mark(Style::Medium, Shape::Lines { points: vec![left, at, right], closed: false });
    let line = Vec2::new(BASE / 2.0, 0.0);
    let middle = at + Vec2::new(0.0, TRIANGLE.y);
    drawing.line(Style::Medium, middle - line, middle + line);
    hatch(drawing, middle - line, middle + line, Vec2::new(0.0, 1.0));
}

/// Hatching along a line of the ground, on the side of a unit normal.
pub fn hatch(drawing: &mut Drawing, from: Vec2, to: Vec2, side: Vec2) {
    let length = (to - from).norm();
    let Some(along) = (to - from).unit() else { return };
    let (step, deep) = HATCH;
    let mut lines = Vec::new();
    let mut s = 1.5;
    // a line that is long enough for thousands has fewer
    let step = step.max(length / 400.0);
    while s <= length - 0.2 {
        let start = from + along * s;
        lines.push((start, start + side * deep - along * (0.8 * deep)));
        s += step;
    }
    if !lines.is_empty() {
        drawing.mark(Style::Thin, Shape::Strokes(lines));
    }
}
