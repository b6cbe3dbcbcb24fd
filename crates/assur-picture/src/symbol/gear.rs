//! Teeth and hatching of wheels and racks from the front.

use assur_drawing::{Drawing, Shape, Style, on_circle};
use assur_math::math::Vec2;
use std::f64::consts::PI;

/// Teeth on each side of the place where wheels meet.
pub const TEETH: i32 = 3;
/// The smallest module that is drawn, mm: smaller teeth are shown larger.
pub const MODULE: f64 = 0.7;

/// Teeth of a wheel about an angle; those of a ring point inwards.
pub fn row(drawing: &mut Drawing, centre: Vec2, radius: f64, about: f64, module: f64, shift: f64, out: f64) {
    let pitch = PI * module / radius;
    if radius < 2.0 * module {
        return;
    }
    let mut points = Vec::new();
    for tooth in -TEETH..=TEETH {
        let middle = about + pitch * (f64::from(tooth) + shift);
        for (s, up) in [(-0.3, -1.0), (-0.15, 1.0), (0.15, 1.0), (0.3, -1.0)] {
            points.push(on_circle(centre, radius + out * up * module, middle + s * pitch));
        }
    }
    drawing.mark(Style::Thin, Shape::Lines { points, closed: false });
}

/// How far a rack goes beyond its wheel, mm, and how much of a wheel it is along at most.
const RACK: f64 = 8.0;
const ALONG: f64 = 40.0;

/// Half the length of the rack of a wheel.
pub fn reach(radius: f64) -> f64 {
    radius.min(ALONG) + RACK
}

/// A toothed line, its pitch line through a place, from and to coordinates along it. The teeth are about a place of their own on it, as
/// far as they reach, at most this number on each side.
pub fn rack(
    drawing: &mut Drawing,
    (touch, side): (Vec2, Vec2),
    (from, to): (f64, f64),
    teeth: Option<(f64, f64, i32)>,
    fixed: bool,
) {
    let along = side.perp();
    let (first, last) = (touch + along * from, touch + along * to);
    drawing.line(Style::Medium, first, last);
    if let Some((module, about, count)) = teeth {
        let mut points = Vec::new();
        let places = (-count..count).map(|tooth| about + PI * module * (f64::from(tooth) + 0.5));
        for place in places.filter(|place| (from..to).contains(place)) {
            let middle = touch + along * place;
            for (s, up) in [(-0.3, 1.0), (-0.15, -1.0), (0.15, -1.0), (0.3, 1.0)] {
                points.push(middle + along * (s * PI * module) + side * (up * module));
            }
        }
        drawing.mark(Style::Thin, Shape::Lines { points, closed: false });
    }
    if fixed {
        super::hinge::hatch(drawing, first, last, side);
    }
}

/// The tangents of two wheels, crossed where these turn against each other; none where one wheel is in the other.
pub fn tangents(
    (c_a, r_a): (Vec2, f64),
    (c_b, r_b): (Vec2, f64),
    crossed: bool,
) -> Option<[(Vec2, Vec2); 2]> {
    let along = (c_b - c_a).unit()?;
    let cos = (if crossed { r_a + r_b } else { r_a - r_b }) / (c_b - c_a).norm();
    if cos.abs() >= 1.0 {
        return None;
    }
    let sin = (1.0 - cos * cos).sqrt();
    let one = |side: f64| {
        let normal = along * cos + along.perp() * (side * sin);
        let end = if crossed { c_b - normal * r_b } else { c_b + normal * r_b };
        (c_a + normal * r_a, end)
    };
    Some([one(-1.0), one(1.0)])
}

/// Hatching at the rim of a wheel of the ground.
pub fn held(drawing: &mut Drawing, centre: Vec2, radius: f64, about: f64) {
    let step = 1.6 / radius;
    let lines = (-3..=3).map(|i| {
        let angle = about + step * f64::from(i);
        (on_circle(centre, radius, angle), on_circle(centre, radius + 2.0, angle + step * 0.8))
    });
    drawing.mark(Style::Thin, Shape::Strokes(lines.collect()));
}
