//! Labels that meet in some frames: the one of lower rank is not shown there.

use super::moved::Moved;
use assur_drawing::{Placed, Rect};

/// Boxes that share less than this are apart, mm.
const TOUCH: f64 = 0.05;

/// A label that gives way to others.
pub struct Faded {
    pub label: usize,
    pub frames: Vec<bool>,
}

/// The labels that give way in some frame.
pub fn faded(labels: &[Placed], moved: &Moved, frames: usize) -> Vec<Faded> {
    let mut order: Vec<usize> = (0..labels.len()).collect();
    order.sort_by_key(|i| labels[*i].label.rank);
    let mut hidden = vec![Vec::with_capacity(frames); labels.len()];
    let mut shown: Vec<Rect> = Vec::with_capacity(labels.len());
    for frame in 0..frames {
        shown.clear();
        for &i in &order {
            let here = labels[i].bounds.shifted(moved.shift(i, frame));
            let meets = shown.iter().any(|other| meet(&here, other));
            hidden[i].push(meets);
            if !meets {
                shown.push(here);
            }
        }
    }
    let of = hidden.into_iter().enumerate().map(|(label, frames)| Faded { label, frames });
    of.filter(|label| label.frames.contains(&true)).collect()
}

fn meet(a: &Rect, b: &Rect) -> bool {
    let shared = |a: [f64; 2], b: [f64; 2]| a[1].min(b[1]) - a[0].max(b[0]) > TOUCH;
    shared([a.min.x, a.max.x], [b.min.x, b.max.x]) && shared([a.min.y, a.max.y], [b.min.y, b.max.y])
}
