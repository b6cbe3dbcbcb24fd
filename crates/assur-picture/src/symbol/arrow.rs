//! Arrows of loads, efforts and drives; arrows of forces that stay on their lines of action.

use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;

/// An arc arrow about a point, in the sense of positive angles of the ground (counter-clockwise) or against it. `middle` is the
/// angle of its middle on the ground, rad.
pub fn turn(
    drawing: &mut Drawing,
    style: Style,
    centre: Vec2,
    radius: f64,
    (middle, angle): (f64, f64),
    ccw: bool,
) {
    let sweep = if ccw { angle } else { -angle };
    // the y axis of paper points down
    let from = -(middle - 0.5 * sweep);
    drawing.mark(style, Shape::ArcArrow { centre, radius, from, sweep: -sweep });
}

/// The middle of such an arc.
pub fn middle(centre: Vec2, radius: f64, angle: f64) -> Vec2 {
    centre + Vec2::direction(-angle) * radius
}

/// An arrow from a point.
pub fn straight(drawing: &mut Drawing, style: Style, from: Vec2, to: Vec2) {
    drawing.mark(style, Shape::Arrow(from, to));
}

/// Between arrows on one line, mm.
const APART: f64 = 1.5;
/// Arrows that begin nearer to each other begin at one point, mm.
const SAME: f64 = 1.2;
/// The cosine beyond which two directions lie on each other.
const PARALLEL: f64 = 0.97;

/// Arrows of forces at points. One that another one covers is shifted along its own line, which changes no moment.
#[derive(Default)]
pub struct OnLines {
    /// Point, direction, and between which distances from the point it is covered, mm.
    taken: Vec<(Vec2, Vec2, [f64; 2])>,
}

impl OnLines {
    /// Where an arrow of a force at a point begins: at the point, else where it ends at the point, else beyond the others.
    pub fn begin(&mut self, at: Vec2, along: Vec2, length: f64) -> Vec2 {
        let covered: Vec<[f64; 2]> = self
            .taken
            .iter()
            .filter(|(point, other, _)| (*point - at).norm() < SAME && other.dot(along).abs() > PARALLEL)
            .map(|(_, other, [a, b])| if other.dot(along) > 0.0 { [*a, *b] } else { [-b, -a] })
            .collect();
        let is_free = |begin: &f64| covered.iter().all(|[a, b]| begin + length <= *a || *begin >= *b);
        let beyond = covered.iter().fold(0.0, |most: f64, [_, b]| most.max(*b)) + APART;
        let begin = [0.0, -length - APART].into_iter().find(is_free).unwrap_or(beyond);
        self.taken.push((at, along, [begin, begin + length]));
        at + along * begin
    }
}
