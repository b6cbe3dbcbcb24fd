//! Cylinders.

use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;

/// Half the width of the barrel, mm.
const HALF: f64 = 2.5;

/// Barrel and rod between two hinges; `least` is the shortest that it becomes, mm, and sets the length of the barrel.
pub fn cylinder(drawing: &mut Drawing, from: Vec2, to: Vec2, least: f64) {
    let length = (to - from).norm();
    let Some(along) = (to - from).unit() else { return };
    let begin = (0.12 * length).min(4.0);
    let end = (0.62 * least).max(0.3 * length).min(0.8 * length);
    let half = HALF.min(length / 4.0);
    let across = along.perp() * half;
    let (a, b) = (from + along * begin, from + along * end);
    drawing.line(Style::Link, from, a);
    drawing.mark(Style::Block, Shape::polygon(vec![a + across, b + across, b - across, a - across]));
    let piston = from + along * (begin + 0.62 * (end - begin));
    drawing.line(Style::Link, piston + across * 0.9, piston - across * 0.9);
    drawing.line(Style::Link, piston, to);
}
