//! Blocks, rails and slots.

use super::hinge::hatch;
use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;

/// Half length and half height of a block on a rail of the ground.
pub const BLOCK: Vec2 = Vec2::new(6.0, 3.4);
/// The same of a block on a bar.
pub const SLEEVE: Vec2 = Vec2::new(5.2, 3.0);
/// From a block to its rail.
const RAIL: f64 = 0.8;
/// From a rod to the lines of its guide.
const BUSH: f64 = 1.5;
/// Half the distance of the lines of a slot.
const SLOT: f64 = 1.7;

/// A block about a point, along a unit direction, from and to coordinates along it.
pub fn block(drawing: &mut Drawing, at: Vec2, along: Vec2, (from, to): (f64, f64), half: f64) {
    let across = along.perp() * half;
    let (a, b) = (at + along * from, at + along * to);
    drawing.mark(Style::Block, Shape::polygon(vec![a + across, b + across, b - across, a - across]));
}

/// The side of a guide on which its rail is: below, and right of an upright one.
pub fn below(along: Vec2) -> Vec2 {
    let normal = along.perp();
    let is_below = if normal.y.abs() > 0.05 { normal.y > 0.0 } else { normal.x > 0.0 };
    if is_below { normal } else { -normal }
}

/// A rail below a block from and to coordinates along it.
pub fn rail(drawing: &mut Drawing, at: Vec2, along: Vec2, (from, to): (f64, f64)) {
    let side = below(along);
    let away = side * (BLOCK.y + RAIL);
    let (a, b) = (at + along * from + away, at + along * to + away);
    drawing.line(Style::Medium, a, b);
    hatch(drawing, a, b, side);
}

/// The lines on both sides of a block that the ground holds.
pub fn fixed(drawing: &mut Drawing, at: Vec2, along: Vec2) {
    let side = below(along);
    for side in [side, -side] {
        let (a, b) = (at - along * SLEEVE.x + side * SLEEVE.y, at + along * SLEEVE.x + side * SLEEVE.y);
        hatch(drawing, a, b, side);
    }
}

/// The fixed guide of a rod: a line on both sides of it, hatched, from and to coordinates along it.
pub fn bush(drawing: &mut Drawing, at: Vec2, along: Vec2, (from, to): (f64, f64)) {
    for side in [along.perp(), -along.perp()] {
        let (a, b) = (at + along * from + side * BUSH, at + along * to + side * BUSH);
        drawing.line(Style::Medium, a, b);
        hatch(drawing, a, b, side);
    }
}

/// A slot from and to coordinates along it; one of the ground is hatched.
pub fn slot(drawing: &mut Drawing, at: Vec2, along: Vec2, (from, to): (f64, f64), of_ground: bool) {
    let across = along.perp() * SLOT;
    let (a, b) = (at + along * from, at + along * to);
    drawing.line(Style::Medium, a + across, b + across);
    drawing.line(Style::Medium, a - across, b - across);
    // round ends
    let begin = libm::atan2(across.y, across.x);
    let half = std::f64::consts::PI;
    drawing.mark(Style::Medium, Shape::Arc { centre: a, radius: SLOT, from: begin, sweep: half });
    drawing.mark(Style::Medium, Shape::Arc { centre: b, radius: SLOT, from: begin + half, sweep: half });
    if of_ground {
        let side = below(along);
        hatch(drawing, a + side * SLOT, b + side * SLOT, side);
    }
}
