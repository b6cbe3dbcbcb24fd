//! Dimension lines: thin, with slender heads.

use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;

/// Length and half width of a head.
const HEAD: (f64, f64) = (2.6, 0.32);
/// A shorter line has its heads outside.
const SHORT: f64 = 8.0;
/// How far a line with heads outside goes beyond them.
const OUTSIDE: f64 = 5.0;
/// From a point to the begin of the line that leads away from it, and how far that goes beyond the dimension line.
const GAP: f64 = 2.2;
const BEYOND: f64 = 1.4;

/// A length between two points, measured between their feet on the dimension line.
pub fn between(drawing: &mut Drawing, points: [Vec2; 2], feet: [Vec2; 2]) {
    for (point, foot) in points.into_iter().zip(feet) {
        let far = (foot - point).norm();
        if far > GAP {
            let away = (foot - point) / far;
            drawing.line(Style::Thin, point + away * GAP, foot + away * BEYOND);
        }
    }
    line(drawing, feet);
}

/// A radius, from the centre to the rim.
pub fn radius(drawing: &mut Drawing, centre: Vec2, rim: Vec2) {
    drawing.line(Style::Thin, centre, rim);
    head(drawing, rim, (rim - centre).unit().unwrap_or(Vec2::new(1.0, 0.0)));
}

/// The line with a head at each end.
fn line(drawing: &mut Drawing, [a, b]: [Vec2; 2]) {
    let Some(along) = (b - a).unit() else { return };
    let outside = (b - a).norm() < SHORT;
    let out = if outside { along * OUTSIDE } else { Vec2::zero() };
    drawing.line(Style::Thin, a - out, b + out);
    let towards = if outside { along } else { -along };
    head(drawing, a, towards);
    head(drawing, b, -towards);
}

fn head(drawing: &mut Drawing, tip: Vec2, along: Vec2) {
    let (long, half) = HEAD;
    let base = tip - along * long;
    let side = along.perp() * half;
    drawing.mark(Style::Solid, Shape::polygon(vec![tip, base + side, base - side]));
}
