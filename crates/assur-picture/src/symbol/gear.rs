//! Teeth and hatching of wheels from the front.

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

/// Hatching at the rim of a wheel of the ground.
pub fn held(drawing: &mut Drawing, centre: Vec2, radius: f64, about: f64) {
    let step = 1.6 / radius;
    let lines = (-3..=3).map(|i| {
        let angle = about + step * f64::from(i);
        (on_circle(centre, radius, angle), on_circle(centre, radius + 2.0, angle + step * 0.8))
    });
    drawing.mark(Style::Thin, Shape::Strokes(lines.collect()));
}
