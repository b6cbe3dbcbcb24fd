//! Which boxes of a label are clear of what no label may touch. They are of one size, so that what is near is turned once into what their
//! middles have to keep away from.

use crate::geometry::{Rect, Segment};
use crate::grid::touches;
use crate::mark::Obstacle;
use assur_math::math::Vec2;

/// What is nearer than this to touching is decided by the box and the obstacle themselves, mm.
const CLOSE: f64 = 1e-7;
/// What moves less along an axis moves across it, mm per mm.
const ACROSS: f64 = 1e-12;

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

/// Where on a line something is so near: for sure, and perhaps.
#[derive(Clone, Copy)]
struct Span {
    sure: (f64, f64),
    perhaps: (f64, f64),
}

impl Span {
    const ALL: Self =
        Self { sure: (f64::NEG_INFINITY, f64::INFINITY), perhaps: (f64::NEG_INFINITY, f64::INFINITY) };

    /// Where also a number, that begins somewhere and changes along the line by what has this inverse, is below another but for its sign.
    fn and(self, begin: f64, inverse: f64, below: f64) -> Self {
        let (at, per) = (-begin * inverse, inverse.abs());
        let (sure, perhaps) = ((below - CLOSE) * per, (below + CLOSE) * per);
        let later = |a: f64, b: f64| if a > b { a } else { b };
        let sooner = |a: f64, b: f64| if a < b { a } else { b };
        Self {
            sure: (later(self.sure.0, at - sure), sooner(self.sure.1, at + sure)),
            perhaps: (later(self.perhaps.0, at - perhaps), sooner(self.perhaps.1, at + perhaps)),
        }
    }
}

/// Of a change along a line, which may be none.
fn inverse(change: f64) -> f64 {
    1.0 / if change.abs() < ACROSS { ACROSS } else { change }
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
}

/// What the boxes of a label keep away from.
pub(crate) struct Clearance {
    boxes: Boxes,
    kept: Vec<Kept>,
}

impl Clearance {
    pub fn of(obstacles: impl Iterator<Item = Obstacle>, boxes: Boxes) -> Self {
        Self { boxes, kept: obstacles.map(|obstacle| Kept::of(&obstacle, &boxes)).collect() }
    }

    /// Takes those of the middles at distances along a line, which rise, whose boxes touch something.
    pub fn thin<const N: usize>(
        &self,
        (start, along): (Vec2, Vec2),
        distances: &[f64; N],
        middles: &[Vec2; N],
        free: &mut [bool; N],
    ) {
        let (first, last) = (middles[0] - start, middles[N - 1] - start);
        let (centre, half) = (start + (first + last) * 0.5, (last - first) * 0.5);
        let half = Vec2::new(half.x.abs() + CLOSE, half.y.abs() + CLOSE);
        let per = Vec2::new(inverse(along.x), inverse(along.y));
        for kept in &self.kept {
            if *free == [false; N] {
                return;
            }
            let (d, within) = (kept.middle - centre, kept.within);
            if d.x.abs() > within.x + half.x || d.y.abs() > within.y + half.y {
                continue;
            }
            let d = start - kept.middle;
            let mut span = Span::ALL.and(d.x, per.x, within.x).and(d.y, per.y, within.y);
            match kept.across {
                Some(across) => {
                    span = span.and(d.cross(kept.end), inverse(along.cross(kept.end)), across);
                }
                None => span.sure = (f64::INFINITY, f64::NEG_INFINITY),
            }
            if span.perhaps.0 >= distances[N - 1] || span.perhaps.1 <= distances[0] {
                continue;
            }
            for ((far, middle), free) in distances.iter().zip(middles).zip(free.iter_mut()) {
                if *free && span.perhaps.0 < *far && *far < span.perhaps.1 {
                    let is_sure = span.sure.0 < *far && *far < span.sure.1;
                    *free = !is_sure && !self.touches(kept, *middle);
                }
            }
        }
    }

    fn touches(&self, kept: &Kept, middle: Vec2) -> bool {
        let Boxes { half, round, apart } = self.boxes;
        touches(&Rect::around(middle, half), round, &kept.obstacle, apart)
    }
}
