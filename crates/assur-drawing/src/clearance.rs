//! Which boxes of a label are clear of what no label may touch. They are of one size, so that what is near is turned once into what their
//! middles have to keep away from.

use crate::geometry::{Rect, Segment};
use crate::grid::touches;
use crate::mark::Obstacle;
use assur_math::math::Vec2;

/// What is nearer than this to touching is decided by the box and the obstacle themselves, mm.
const CLOSE: f64 = 1e-7;

/// The boxes of a label, or the discs in them, and what is kept free around them.
#[derive(Clone, Copy)]
pub(crate) struct Boxes {
    pub half: Vec2,
    pub round: bool,
    pub apart: f64,
}

/// An obstacle, and what the middle of a box keeps away from.
struct Kept {
    obstacle: Obstacle,
    /// The middle of a stroke, and from there to its end.
    middle: Vec2,
    end: Vec2,
    /// How near to the middle of the stroke a middle may be along the axes.
    within: Vec2,
    /// How near across the stroke, times the length of `end`; none where corners are round.
    across: Option<f64>,
}

impl Kept {
    fn of(obstacle: &Obstacle, boxes: &Boxes) -> Self {
        let (Segment { a, b }, wide) = match *obstacle {
            Obstacle::Stroke(stroke, half) => (stroke, half + boxes.apart),
            Obstacle::Disc(centre, radius) => (Segment { a: centre, b: centre }, radius + boxes.apart),
        };
        let (middle, end) = ((a + b) * 0.5, (b - a) * 0.5);
        let reach = boxes.half + Vec2::new(wide, wide);
        let within = reach + Vec2::new(end.x.abs(), end.y.abs());
        let is_straight = matches!(obstacle, Obstacle::Stroke(..)) && !boxes.round;
        let across = is_straight.then_some(reach.x * end.y.abs() + reach.y * end.x.abs());
        Self { obstacle: *obstacle, middle, end, within, across }
    }

    /// Whether a box with its middle at a place touches it.
    fn meets(&self, at: Vec2, boxes: &Boxes) -> bool {
        let d = at - self.middle;
        let mut left = (self.within.x - d.x.abs()).min(self.within.y - d.y.abs());
        if left < -CLOSE {
            return false;
        }
        if let Some(across) = self.across {
            left = left.min(across - d.cross(self.end).abs());
            if left.abs() > CLOSE {
                return left > 0.0;
            }
        }
        touches(&Rect::around(at, boxes.half), boxes.round, &self.obstacle, boxes.apart)
    }
}

/// What the boxes of a label keep away from.
pub(crate) struct Clearance {
    boxes: Boxes,
    kept: Vec<Kept>,
}

impl Clearance {
    pub fn of(obstacles: &[Obstacle], boxes: Boxes) -> Self {
        Self { boxes, kept: obstacles.iter().map(|obstacle| Kept::of(obstacle, &boxes)).collect() }
    }

    /// Takes those places from middles along a line, from the first to the last, at which boxes touch something.
    pub fn thin<const N: usize>(&self, middles: &[Vec2; N], free: &mut [bool; N]) {
        let mut way = Rect::NOTHING;
        way.add(middles[0]);
        way.add(middles[N - 1]);
        let (at, half) = (way.centre(), way.size() * 0.5 + Vec2::new(CLOSE, CLOSE));
        for kept in &self.kept {
            let (d, within) = (kept.middle - at, kept.within + half);
            if d.x.abs() < within.x && d.y.abs() < within.y {
                let free = middles.iter().zip(free.iter_mut()).filter(|(_, free)| **free);
                free.for_each(|(at, free)| *free = !kept.meets(*at, &self.boxes));
            }
        }
    }
}
