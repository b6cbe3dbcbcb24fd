//! Which boxes of a label are clear of what no label may touch. They are of one size, so that what is near is turned once into what their
//! middles have to keep away from. The middles lie on lines, of which several are looked at side by side in single precision; what is too
//! close to touching for that is decided by the box and the obstacle themselves.

use crate::geometry::{Rect, Segment};
use crate::grid::touches;
use crate::mark::Obstacle;
use assur_math::math::Vec2;
use wide::f32x4;

/// How many lines are looked at side by side.
pub(crate) const SIDE: usize = 4;
/// What is nearer than this to touching is decided exactly, mm: five times what single precision rounds at a distance of twice [`FAR`].
const CLOSE: f32 = 2e-3;
/// What is farther than this, or longer, is decided exactly, mm.
const FAR: f64 = 500.0;
/// What moves less along an axis moves across it, mm per mm.
const ACROSS: f32 = 1e-12;
/// What is nearer along both axes than this part of a radius is in the disc.
const IN_DISC: f64 = 0.7;
/// Nothing is so near.
const NEVER: [f32; 2] = [f32::NEG_INFINITY; 2];

/// The boxes of a label, or the discs in them, and what is kept free around them.
#[derive(Clone, Copy, Default)]
pub(crate) struct Boxes {
    pub half: Vec2,
    pub round: bool,
    pub apart: f64,
}

/// A line of middles: where it begins, and its direction.
pub(crate) type Line = (Vec2, Vec2);

/// An obstacle, and what the middle of a box keeps away from.
struct Kept {
    obstacle: Obstacle,
    /// The middle of a stroke, from the origin.
    middle: [f32; 2],
    /// How near to it a middle may be along the axes.
    within: [f32; 2],
    /// How near it is for sure if it is so near across the stroke too; never where that is not known.
    sure: [f32; 2],
    /// The direction of a stroke, and how near across it; none where corners are round.
    across: Option<[f32; 3]>,
}

impl Kept {
    fn of(obstacle: &Obstacle, boxes: &Boxes, origin: Vec2) -> Self {
        let (Segment { a, b }, wide, is_disc) = match *obstacle {
            Obstacle::Stroke(stroke, half) => (stroke, half + boxes.apart, false),
            Obstacle::Disc(centre, radius) => (Segment { a: centre, b: centre }, radius + boxes.apart, true),
        };
        let (middle, end) = ((a + b) * 0.5 - origin, (b - a) * 0.5);
        let reach = boxes.half + Vec2::new(wide, wide);
        let within = reach + Vec2::new(end.x.abs(), end.y.abs());
        let size = middle.x.abs() + middle.y.abs() + within.x + within.y;
        if size.is_nan() || size >= FAR {
            let (middle, within) = ([0.0; 2], [f32::INFINITY; 2]);
            return Self { obstacle: *obstacle, middle, within, sure: NEVER, across: None };
        }
        let is_straight = !is_disc && !boxes.round;
        let length = end.dot(end).sqrt();
        let across = (is_straight && length > 0.0).then(|| {
            let u = end * length.recip();
            rounded([u.x, u.y, reach.x * u.y.abs() + reach.y * u.x.abs()])
        });
        let (middle, within) = (rounded([middle.x, middle.y]), rounded([within.x, within.y]));
        let sure = match (is_disc, boxes.round) {
            (true, true) => rounded([IN_DISC * reach.x; 2]),
            (true, false) => rounded([boxes.half.x + IN_DISC * wide, boxes.half.y + IN_DISC * wide]),
            (false, true) => NEVER,
            (false, false) => within,
        };
        Self { obstacle: *obstacle, middle, within, sure, across }
    }
}

#[allow(clippy::cast_possible_truncation)] // the rest is in what is close
fn rounded<const N: usize>(x: [f64; N]) -> [f32; N] {
    x.map(|x| x as f32)
}

/// The parts of lines on which something is near, from and to.
#[derive(Clone, Copy)]
struct Span {
    from: f32x4,
    to: f32x4,
}

impl Span {
    const ALL: Self = Self { from: f32x4::splat(f32::NEG_INFINITY), to: f32x4::splat(f32::INFINITY) };

    /// Where also a number, that is zero at a distance, is below another but for its sign.
    fn and(self, at: f32x4, below: f32x4) -> Self {
        Self { from: self.from.fast_max(at - below), to: self.to.fast_min(at + below) }
    }
}

/// Lines side by side.
struct Lines {
    start: [f32x4; 2],
    along: [f32x4; 2],
    /// Distance along the line per distance along the axes.
    per: [f32x4; 2],
    /// The box of all their middles.
    centre: [f32; 2],
    half: [f32; 2],
}

/// Of a change along a line, which may be none.
fn inverse(change: f32x4) -> f32x4 {
    let least = f32x4::splat(ACROSS);
    f32x4::ONE / change.abs().simd_lt(least).bitselect(least, change)
}

impl Lines {
    fn of(lines: &[Line; SIDE], origin: Vec2, (first, last): (f64, f64)) -> Self {
        let each = |of: &dyn Fn(&Line) -> f64| f32x4::new(rounded(std::array::from_fn(|i| of(&lines[i]))));
        let start = [each(&|(start, _)| start.x - origin.x), each(&|(start, _)| start.y - origin.y)];
        let along = [each(&|(_, along)| along.x), each(&|(_, along)| along.y)];
        let at = |i: usize, far: f64| start[i] + along[i] * f32x4::splat(rounded([far])[0]);
        let ends = [0, 1].map(|i| {
            let (first, last) = (at(i, first), at(i, last));
            let sooner = first.fast_min(last).to_array().into_iter().reduce(|a, b| if a < b { a } else { b });
            let later = first.fast_max(last).to_array().into_iter().reduce(|a, b| if a > b { a } else { b });
            (sooner.unwrap_or_default(), later.unwrap_or_default())
        });
        let (centre, half) = (ends.map(|(a, b)| 0.5 * (a + b)), ends.map(|(a, b)| 0.5 * (b - a)));
        Self { start, along, per: along.map(inverse), centre, half }
    }

    /// Whether something is far from all of them.
    fn are_far(&self, kept: &Kept) -> bool {
        let far = |i: usize| (kept.middle[i] - self.centre[i]).abs() > kept.within[i] + self.half[i] + CLOSE;
        far(0) || far(1)
    }

    /// Where on them something is so near: for sure, and perhaps.
    fn spans(&self, kept: &Kept) -> [Span; 2] {
        let (mut sure, mut perhaps) = (Span::ALL, Span::ALL);
        let mut and = |zero: f32x4, inverse: f32x4, below: [f32; 2]| {
            let (at, per) = (-zero * inverse, inverse.abs());
            sure = sure.and(at, per * f32x4::splat(below[0] - CLOSE));
            perhaps = perhaps.and(at, per * f32x4::splat(below[1] + CLOSE));
        };
        let d = [0, 1].map(|i| self.start[i] - f32x4::splat(kept.middle[i]));
        and(d[0], self.per[0], [kept.sure[0], kept.within[0]]);
        and(d[1], self.per[1], [kept.sure[1], kept.within[1]]);
        if let Some([x, y, below]) = kept.across {
            let cross = |v: [f32x4; 2]| v[0] * f32x4::splat(y) - v[1] * f32x4::splat(x);
            and(cross(d), inverse(cross(self.along)), [below; 2]);
        }
        [sure, perhaps]
    }
}

/// What the boxes of a label keep away from.
#[derive(Default)]
pub(crate) struct Clearance {
    boxes: Boxes,
    origin: Vec2,
    kept: Vec<Kept>,
}

impl Clearance {
    /// Replaces what there is; the boxes are near to the origin.
    pub fn fill(&mut self, obstacles: impl Iterator<Item = Obstacle>, boxes: Boxes, origin: Vec2) {
        (self.boxes, self.origin) = (boxes, origin);
        self.kept.clear();
        self.kept.extend(obstacles.map(|obstacle| Kept::of(&obstacle, &boxes, origin)));
    }

    /// Which boxes touch nothing, of middles at distances along lines, which rise: a bit for each line, in four bits for each distance.
    pub fn free<const N: usize>(
        &self,
        lines: &[Line; SIDE],
        distances: &[f64; N],
        middle: impl Fn(usize, usize) -> Vec2,
    ) -> u32 {
        let far = distances.map(|far| f32x4::splat(rounded([far])[0]));
        let lines = Lines::of(lines, self.origin, (distances[0], distances[N - 1]));
        let within = |span: &Span| {
            let bits = |all: u32, (i, far): (usize, &f32x4)| {
                all | (far.simd_gt(span.from) & far.simd_lt(span.to)).to_bitmask() << (SIDE * i)
            };
            far.iter().enumerate().fold(0, bits)
        };
        let mut free = u32::MAX >> (32 - SIDE * N);
        for kept in &self.kept {
            if lines.are_far(kept) {
                continue;
            }
            let [sure, perhaps] = lines.spans(kept);
            let near = free & within(&perhaps);
            if near == 0 {
                continue;
            }
            free &= !within(&sure);
            let mut open = near & free;
            while open != 0 {
                let bit = open.trailing_zeros() as usize;
                open &= open - 1;
                if self.touches(kept, middle(bit % SIDE, bit / SIDE)) {
                    free &= !(1 << bit);
                }
            }
            if free == 0 {
                break;
            }
        }
        free
    }

    fn touches(&self, kept: &Kept, middle: Vec2) -> bool {
        let Boxes { half, round, apart } = self.boxes;
        touches(&Rect::around(middle, half), round, &kept.obstacle, apart)
    }
}
