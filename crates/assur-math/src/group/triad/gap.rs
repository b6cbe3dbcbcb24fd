//! Why a triad does not close, and by how much.
//!
//! Two legs and the plate make a four-bar of the lengths |O_j − O_i|, l_i, |A_j − A_i|, l_j, which closes where the longest
//! is no longer than the others together. If every two legs do, the plate moves on two of them, and the third pin stays
//! too far from where its leg holds it, or too near: by how much is searched for over the directions of the plate.

use super::modes::Line;
use super::position::{End, Plate};
use crate::math::Vec2;

/// Directions of the plate that are tried.
const DIRECTIONS: u32 = 1440;

/// What does not reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Miss {
    /// Two links with the plate between them do not close. Lengths in the order base, first leg, plate, second leg.
    Pair {
        legs: [usize; 2],
        /// The four lengths, m.
        lengths: [f64; 4],
        /// Index of the longest.
        longest: usize,
        /// How much it is too long, m.
        gap: f64,
    },
    /// With the other legs on it the plate's pin does not reach its place.
    Third {
        leg: usize,
        /// Its pin comes as near, or gets as far, as this, m: from the hinge of the leg, or from its guide.
        reached: f64,
        /// The distance that is missing, m; negative where the pin does not get far enough.
        gap: f64,
    },
}

/// What does not reach where a triad does not close. The numbers are good to five digits.
/// # Given
/// `ends` one of which at least is a hinge.
#[cold]
#[must_use]
pub fn gap(plate: &Plate, ends: &[End; 3]) -> Option<Miss> {
    let pairs = [[0, 1], [1, 2], [0, 2]];
    if let Some(miss) = pairs.into_iter().find_map(|legs| pair(plate, ends, legs)) {
        return Some(miss);
    }
    let thirds = (0..3).filter_map(|leg| third(plate, ends, leg));
    thirds.min_by(|a, b| size(a).total_cmp(&size(b)))
}

fn size(miss: &Miss) -> f64 {
    match miss {
        Miss::Pair { gap, .. } | Miss::Third { gap, .. } => gap.abs(),
    }
}

fn pair(plate: &Plate, ends: &[End; 3], legs: [usize; 2]) -> Option<Miss> {
    let [End::Hinge { p, length: one }, End::Hinge { p: q, length: two }] = legs.map(|i| ends[i]) else {
        return None;
    };
    let lengths = [(q - p).norm(), one, (plate.arms[legs[1]] - plate.arms[legs[0]]).norm(), two];
    let longest = (0..4).max_by(|&i, &j| lengths[i].total_cmp(&lengths[j]))?;
    let gap = 2.0 * lengths[longest] - lengths.iter().sum::<f64>();
    (gap > 0.0).then_some(Miss::Pair { legs, lengths, longest, gap })
}

/// The least that is missing at the pin of a leg while the others hold.
fn third(plate: &Plate, ends: &[End; 3], leg: usize) -> Option<Miss> {
    let others = [(leg + 1) % 3, (leg + 2) % 3];
    let first = *others.iter().find(|&&i| matches!(ends[i], End::Hinge { .. }))?;
    let second = others[0] + others[1] - first;
    let End::Hinge { p: origin, length } = ends[first] else { return None };
    let arm = |i: usize| plate.arms[i] - plate.arms[first];
    let line = Line::new(arm(second), &ends[second], (origin, length));
    // signed: what is missing at one direction of the plate, on one side
    let missing = |angle: f64, side: f64| {
        let z = Vec2::direction(angle);
        let (w, h) = line.at(z);
        let square = w.dot(w).max(f64::MIN_POSITIVE);
        let along = h / square;
        let across = (length * length / square - along * along).sqrt();
        let pin = origin + w * along + w.perp() * (side * across) + arm(leg).turned(z);
        match ends[leg] {
            End::Hinge { p, length } => (pin - p).norm() - length,
            End::Guide { p, n } => n.dot(pin - p),
        }
    };
    let (mut best, step) = (f64::INFINITY, std::f64::consts::TAU / f64::from(DIRECTIONS));
    for side in [1.0, -1.0] {
        // NaN where the others do not hold
        let off =
            |angle: f64| Some(missing(angle, side).abs()).filter(|x| !x.is_nan()).unwrap_or(f64::INFINITY);
        for k in 0..DIRECTIONS {
            let angle = f64::from(k) * step;
            if off(angle) <= best.abs() && off(angle).is_finite() {
                best = missing(least(off, angle, step), side);
            }
        }
    }
    let own = if let End::Hinge { length, .. } = ends[leg] { length } else { 0.0 };
    best.is_finite().then_some(Miss::Third { leg, reached: (own + best).abs(), gap: best })
}

/// Where a function is least within a step of a place, by halving the step.
fn least(of: impl Fn(f64) -> f64, at: f64, step: f64) -> f64 {
    let (mut at, mut step) = (at, step);
    for _ in 0..40 {
        step *= 0.5;
        for next in [at - step, at + step] {
            if of(next) < of(at) {
                at = next;
            }
        }
    }
    at
}
