//! Labels that find no place among the marks: beside the drawing, on the nearer side, with a leader line.

use crate::geometry::Rect;
use crate::label::{Anchor, Label};
use assur_math::math::Vec2;

/// From the drawing to the labels beside it, mm.
const AWAY: f64 = 5.0;
/// Between two of them.
const APART: f64 = 0.9;

/// A label with its box and its leader line.
pub struct Outside {
    pub label: usize,
    pub bounds: Rect,
    /// From the anchor to the box.
    pub leader: (Vec2, Vec2),
}

/// Puts labels around a drawing: each on the side its anchor is nearest to, in the order of their anchors.
pub fn place(hull: &Rect, labels: &[Label], left: &[usize]) -> Vec<Outside> {
    let mut sides: [Vec<usize>; 4] = Default::default();
    for &label in left {
        let p = anchor(&labels[label]);
        let gaps = [p.x - hull.min.x, hull.max.x - p.x, p.y - hull.min.y, hull.max.y - p.y];
        let side = (0..4).min_by(|a, b| gaps[*a].total_cmp(&gaps[*b])).unwrap_or(0);
        sides[side].push(label);
    }
    let mut placed: Vec<Outside> = Vec::new();
    let mut hull = *hull;
    for (side, mut own) in sides.into_iter().enumerate() {
        let upright = side < 2;
        if side == 2 {
            // above and below all that is at the sides
            let mut wider = hull;
            placed.iter().for_each(|p| wider.join(&p.bounds));
            (hull.min.y, hull.max.y) = (wider.min.y, wider.max.y);
        }
        let along = |label: usize| if upright { anchor(&labels[label]).y } else { anchor(&labels[label]).x };
        own.sort_by(|a, b| along(*a).total_cmp(&along(*b)).then(a.cmp(b)));
        let extent = |label: usize| if upright { labels[label].half().y } else { labels[label].half().x };
        let mut end = f64::NEG_INFINITY;
        for label in own {
            let start = (along(label) - extent(label)).max(end);
            end = start + 2.0 * extent(label) + APART;
            placed.push(beside(&hull, side, label, &labels[label], start + extent(label)));
        }
    }
    placed
}

fn anchor(label: &Label) -> Vec2 {
    match label.anchor {
        Anchor::Point(p, _) => p,
        Anchor::Line(a, b) => (a + b) * 0.5,
    }
}

fn beside(hull: &Rect, side: usize, label: usize, what: &Label, middle: f64) -> Outside {
    let half = what.half();
    let centre = match side {
        0 => Vec2::new(hull.min.x - AWAY - half.x, middle),
        1 => Vec2::new(hull.max.x + AWAY + half.x, middle),
        2 => Vec2::new(middle, hull.min.y - AWAY - half.y),
        _ => Vec2::new(middle, hull.max.y + AWAY + half.y),
    };
    let bounds = Rect::around(centre, half);
    let from = anchor(what);
    let to = bounds.grown(0.3).nearest(from);
    let radius = match what.anchor {
        Anchor::Point(_, radius) => radius,
        Anchor::Line(..) => 0.0,
    };
    let start = from + (to - from).unit().map_or(Vec2::zero(), |u| u * radius);
    Outside { label, bounds, leader: (start, to) }
}
