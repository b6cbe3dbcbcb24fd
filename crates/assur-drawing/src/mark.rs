//! Marks: what a picture is made of.

use crate::geometry::{Rect, Segment};
use crate::style::Style;
use assur_math::math::Vec2;
use std::f64::consts::TAU;

/// Length of an arrow's head, mm.
const HEAD: f64 = 2.6;
const HALF_HEAD: f64 = 0.75;
/// The part of a short arrow that is head.
const HEAD_PART: f64 = 0.6;
/// Parts of an arc for the search of free places.
const ARC_PARTS: f64 = 0.35;

/// The shape of a mark; all in millimetres, y down.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    Line(Vec2, Vec2),
    /// Lines from point to point.
    Lines {
        points: Vec<Vec2>,
        /// Back to the first.
        closed: bool,
    },
    /// Separate lines: hatching.
    Strokes(Vec<(Vec2, Vec2)>),
    Circle {
        centre: Vec2,
        radius: f64,
    },
    /// An arc from an angle by an angle, rad, counted from x towards y (which is down).
    Arc {
        centre: Vec2,
        radius: f64,
        from: f64,
        /// How far it goes.
        sweep: f64,
    },
    /// A sector of a circle, between two angles.
    Sector {
        centre: Vec2,
        radius: f64,
        from: f64,
        /// How far it goes.
        sweep: f64,
    },
    Arrow(Vec2, Vec2),
    /// An arc with a head at its end.
    ArcArrow {
        centre: Vec2,
        radius: f64,
        from: f64,
        /// How far it goes.
        sweep: f64,
    },
}

/// A shape in a style, of a group.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    pub shape: Shape,
    pub style: Style,
    /// Its group: index into the drawing's.
    pub group: usize,
}

/// What labels keep away from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Obstacle {
    /// A stroke with half its width.
    Stroke(Segment, f64),
    Disc(Vec2, f64),
}

/// The point of a circle at an angle.
#[must_use]
pub fn on_circle(centre: Vec2, radius: f64, angle: f64) -> Vec2 {
    centre + Vec2::direction(angle) * radius
}

/// Tells the short parts of an arc by their ends.
fn each_part(centre: Vec2, radius: f64, from: f64, sweep: f64, mut tell: impl FnMut(Vec2, Vec2)) {
    let parts = (sweep.abs() / ARC_PARTS).ceil().max(1.0);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // less than a hundred
    let count = parts.min(100.0) as usize;
    let at = |i: usize| on_circle(centre, radius, from + sweep * i as f64 / count as f64);
    let mut before = at(0);
    for i in 1..=count {
        let here = at(i);
        tell(before, here);
        before = here;
    }
}

impl Shape {
    #[must_use]
    pub const fn polygon(points: Vec<Vec2>) -> Self {
        Self::Lines { points, closed: true }
    }

    /// An arrow's head: tip and the two corners behind it, and where its shaft ends.
    #[must_use]
    pub fn head(from: Vec2, tip: Vec2, length: f64) -> [Vec2; 4] {
        let along = (tip - from).unit().unwrap_or(Vec2::new(1.0, 0.0));
        let long = HEAD.min(HEAD_PART * length);
        let half = along.perp() * (HALF_HEAD * long / HEAD);
        let base = tip - along * long;
        [tip, base + half, base - half, base]
    }

    /// The head of an arrow or of an arc with one.
    #[must_use]
    pub fn own_head(&self) -> Option<[Vec2; 4]> {
        match *self {
            Self::Arrow(from, to) => Some(Self::head(from, to, (to - from).norm())),
            Self::ArcArrow { centre, radius, from, sweep } => {
                let length = (radius * sweep).abs();
                let tip = on_circle(centre, radius, from + sweep);
                // the head lies along the chord of its own length
                let back = HEAD.min(HEAD_PART * length) / radius * sweep.signum();
                Some(Self::head(on_circle(centre, radius, from + sweep - back), tip, length))
            }
            _ => None,
        }
    }

    /// How far the shaft of an arc with a head goes.
    #[must_use]
    pub fn shaft_sweep(radius: f64, sweep: f64) -> f64 {
        let back = HEAD.min(HEAD_PART * (radius * sweep).abs()) / radius * 0.9;
        sweep - back * sweep.signum()
    }

    /// The strokes of it, arcs in short parts.
    #[must_use]
    pub fn segments(&self) -> Vec<Segment> {
        let mut all = Vec::new();
        self.each_segment(|segment| all.push(segment));
        all
    }

    /// Tells each of its strokes, arcs in short parts.
    pub fn each_segment(&self, mut tell: impl FnMut(Segment)) {
        let mut line = |a: Vec2, b: Vec2| tell(Segment { a, b });
        match self {
            Self::Line(a, b) | Self::Arrow(a, b) => line(*a, *b),
            Self::Lines { points, closed } => {
                points.windows(2).for_each(|w| line(w[0], w[1]));
                if let (true, Some(first), Some(last)) = (*closed, points.first(), points.last()) {
                    line(*last, *first);
                }
            }
            Self::Strokes(lines) => lines.iter().for_each(|(a, b)| line(*a, *b)),
            Self::Circle { centre, radius } => each_part(*centre, *radius, 0.0, TAU, line),
            Self::Arc { centre, radius, from, sweep } | Self::ArcArrow { centre, radius, from, sweep } => {
                each_part(*centre, *radius, *from, *sweep, line);
            }
            Self::Sector { centre, radius, from, sweep } => {
                each_part(*centre, *radius, *from, *sweep, &mut line);
                line(*centre, on_circle(*centre, *radius, *from));
                line(*centre, on_circle(*centre, *radius, from + sweep));
            }
        }
    }

    /// Whether it has a place: all its numbers are finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        let mut finite = true;
        let is = |p: Vec2| p.x.is_finite() && p.y.is_finite();
        self.each_segment(|segment| finite &= is(segment.a) && is(segment.b));
        finite
    }

    /// Its box, without the width of its stroke.
    #[must_use]
    pub fn bounds(&self) -> Rect {
        let mut rect = Rect::NOTHING;
        if let Self::Circle { centre, radius } = self {
            return Rect::around(*centre, Vec2::new(*radius, *radius));
        }
        self.each_segment(|segment| {
            rect.add(segment.a);
            rect.add(segment.b);
        });
        for corner in self.own_head().into_iter().flatten() {
            rect.add(corner);
        }
        rect
    }

    /// What labels keep away from: strokes with half their width, small circles whole.
    #[must_use]
    pub fn obstacles(&self, half: f64) -> Vec<Obstacle> {
        let mut all = Vec::new();
        self.each_obstacle(half, |obstacle| all.push(obstacle));
        all
    }

    /// Tells each of them.
    pub fn each_obstacle(&self, half: f64, mut tell: impl FnMut(Obstacle)) {
        match self {
            Self::Circle { centre, radius } if *radius <= SMALL => {
                tell(Obstacle::Disc(*centre, radius + half));
            }
            _ => {
                self.each_segment(|segment| tell(Obstacle::Stroke(segment, half)));
                if let Some([tip, _, _, base]) = self.own_head() {
                    let wide = (HALF_HEAD * (tip - base).norm() / HEAD).max(half);
                    tell(Obstacle::Stroke(Segment { a: tip, b: base }, wide));
                }
            }
        }
    }
}

/// Radius up to which the inside of a circle is no place for a label.
const SMALL: f64 = 2.2;
