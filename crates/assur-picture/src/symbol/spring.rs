//! Springs.

use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;

/// Teeth of the zigzag; the length of the spring does not change their number.
const TEETH: usize = 7;
const HALF: f64 = 2.5;
/// Straight parts at both ends, as a part of the length, and at most, mm.
const ENDS: (f64, f64) = (0.2, 8.0);

/// A zigzag between two points.
pub fn spring(drawing: &mut Drawing, from: Vec2, to: Vec2) {
    let length = (to - from).norm();
    let Some(along) = (to - from).unit() else { return };
    let end = (ENDS.0 * length).min(ENDS.1);
    let (start, inner) = (from + along * end, length - 2.0 * end);
    let half = HALF.min(length / 6.0);
    let mut points = vec![from, start];
    for tooth in 0..2 * TEETH {
        let side = if tooth % 2 == 0 { half } else { -half };
        let s = inner * (tooth as f64 + 0.5) / (2 * TEETH) as f64;
        points.push(start + along * s + along.perp() * side);
    }
    points.extend([to - along * end, to]);
    drawing.mark(Style::Medium, Shape::Lines { points, closed: false });
}
