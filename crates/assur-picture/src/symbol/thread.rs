//! The turns of a worm or a screw, seen across its axis.

use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;

/// Half the height of a thread, and half a turn along the axis.
const HEIGHT: f64 = 2.2;
const TURN: f64 = 1.75;
/// Half the length of a worm, and of a spindle.
pub const WORM: f64 = 7.0;
pub const SPINDLE: f64 = 10.0;

/// A line with the turns of a thread, which have run so far since the first frame, mm.
pub fn thread(drawing: &mut Drawing, at: Vec2, half: f64, run: f64) {
    let count = 2 * (half / TURN).round().max(2.0) as i32;
    let step = 2.0 * half / f64::from(count);
    let run = 2.0 * step * (run / (2.0 * step)).rem_euclid(1.0);
    let point = |i: i32| {
        let x = at.x - half + step * f64::from(i) + run;
        Vec2::new(x, at.y + if i.rem_euclid(2) == 0 { HEIGHT } else { -HEIGHT })
    };
    drawing.mark(Style::Medium, Shape::Lines { points: (0..=count).map(point).collect(), closed: false });
    drawing.line(Style::Medium, at - Vec2::new(half, 0.0), at + Vec2::new(half, 0.0));
}
