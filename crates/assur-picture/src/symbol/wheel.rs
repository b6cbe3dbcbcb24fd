//! What shows that a wheel turns, and what runs on its rim.

use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;
use std::f64::consts::{FRAC_PI_2, TAU};

/// From mark to mark on what runs, mm, and half their length.
const STEP: f64 = 6.0;
const MARK: f64 = 0.9;
/// Of smaller wheels a line shows the turn.
const SMALL: f64 = 3.0;
/// A dot that tells one spoke from the others: its radius, and where it is on the spoke.
const DOT: (f64, f64) = (0.6, 0.78);

/// Spokes of a wheel that moves; the first at an angle of paper has a dot.
pub fn spokes(drawing: &mut Drawing, centre: Vec2, radius: f64, angle: f64) {
    let spoke = |quarter: u8| Vec2::direction(angle + FRAC_PI_2 * f64::from(quarter));
    if radius < SMALL {
        drawing.line(Style::Thin, centre, centre + spoke(0) * radius);
        return;
    }
    let lines = (0..4).map(|quarter| (centre, centre + spoke(quarter) * radius));
    drawing.mark(Style::Thin, Shape::Strokes(lines.collect()));
    drawing.mark(Style::Block, Shape::Circle { centre: centre + spoke(0) * (DOT.1 * radius), radius: DOT.0 });
}

/// Three lines between two radii, of a side of a clutch that moves.
pub fn ticks(drawing: &mut Drawing, centre: Vec2, [inner, outer]: [f64; 2], angle: f64) {
    let ray = |third: u8| Vec2::direction(angle + TAU / 3.0 * f64::from(third));
    let lines = (0..3).map(|third| (centre + ray(third) * inner, centre + ray(third) * outer));
    drawing.mark(Style::Thin, Shape::Strokes(lines.collect()));
}

/// Marks on a part of a rope or a belt that has run so far since the first frame, mm.
pub fn running(drawing: &mut Drawing, from: Vec2, to: Vec2, run: f64) {
    let length = (to - from).norm();
    let Some(along) = (to - from).unit().filter(|_| length > 1.5 * STEP) else { return };
    let first = (run / STEP).rem_euclid(1.0);
    let across = along.perp() * MARK;
    let count = (length / STEP) as u32;
    let marks = (0..count).map(|i| {
        let at = from + along * (STEP * (f64::from(i) + first)).min(length);
        (at - across, at + across)
    });
    drawing.mark(Style::Thin, Shape::Strokes(marks.collect()));
}
