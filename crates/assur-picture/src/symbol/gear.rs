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

/// A rack whose pitch line touches the pitch circle of a wheel on a side, with teeth where the wheel has any.
pub fn rack(
    drawing: &mut Drawing,
    (centre, radius): (Vec2, f64),
    side: Vec2,
    teeth: Option<f64>,
    fixed: bool,
) {
    let (touch, along) = (centre + side * radius, side.perp());
    let reach = reach(radius);
    let (from, to) = (touch - along * reach, touch + along * reach);
    drawing.line(Style::Medium, from, to);
    if let Some(teeth) = teeth {
        let module = (2.0 * radius / teeth).max(MODULE);
        let mut points = Vec::new();
        let places = (-2 * TEETH..2 * TEETH).map(|tooth| PI * module * (f64::from(tooth) + 0.5));
        for place in places.filter(|place| place.abs() < reach) {
            let middle = touch + along * place;
            for (s, up) in [(-0.3, 1.0), (-0.15, -1.0), (0.15, -1.0), (0.3, 1.0)] {
                points.push(middle + along * (s * PI * module) + side * (up * module));
            }
        }
        drawing.mark(Style::Thin, Shape::Lines { points, closed: false });
    }
    if fixed {
        super::hinge::hatch(drawing, from, to, side);
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

/// A belt on two wheels.
pub fn belt(drawing: &mut Drawing, a: (Vec2, f64), b: (Vec2, f64), crossed: bool) {
    for (from, to) in tangents(a, b, crossed).into_iter().flatten() {
        drawing.line(Style::Medium, from, to);
    }
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
