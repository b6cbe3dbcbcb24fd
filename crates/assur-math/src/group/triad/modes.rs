//! All assemblies of a triad.
//!
//! Leg 1 is a link, q = A_1 − O_1. With z the direction of the plate, c_i = ρ_i − ρ_1 in its frame, written z c_i when
//! turned by z, and e_i = O_i − O_1, the closure of legs 2 and 3 less that of leg 1 is linear in q:
//!
//! ```text
//! q·w_i = h_i,    w_i = z c_i − e_i,    h_i = (l_i² − l_1² − |c_i|² − |e_i|²) / 2 + (z c_i)·e_i,
//! w_i = n_i,                            h_i = n_i·(Q_i − O_1) − n_i·(z c_i)    on a guide.
//! ```
//!
//! Two lines give q; that it has the length l_1 leaves one equation for z:
//!
//! ```text
//! f(z) = |h_2 w_3 − h_3 w_2|² − l_1² (w_2 × w_3)² = 0,
//! ```
//!
//! a sum of cosines and sines of no more than three times the angle: with t = tan of half the angle, times (1 + t²)³, a
//! polynomial of degree six. (Bilateration of the coupler curve gives the same sextic; Rojas and Thomas, "The forward
//! kinematics of 3-RPR planar robots: a review and a distance-based formulation", IEEE Trans. Robotics 27, 2011.)
//!
//! The two halves of the turn, from the direction 0 and from its opposite, have t in [−1, 1]. There the polynomial stands
//! in Bernstein's form, whose coefficients change their sign at least as often as the polynomial has roots, and by an even
//! number more: no change, no root; one change, one root. Else the interval is halved. A coefficient within rounding errors
//! of zero may have either sign, so that no root is missed: what cannot be decided goes on to Newton's method as well.
//! Where w_2 and w_3 are parallel a root belongs to two assemblies; both intersections of the better line with the circle
//! about O_1 are tried.

use super::position::{End, Followed, Plate};
use crate::group::general::Pose;
use crate::math::Vec2;

/// Rounding errors of f and of its coefficients, in units of the sum of the magnitudes of its terms.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// An interval of t that is not divided any more.
const NARROW: f64 = 1.0 / 16_777_216.0;
/// Assemblies nearer than this, relative to the plate, are one; where they are not certified, those nearer than the root.
const SAME: f64 = 1e-9;

type Bernstein = [f64; 7];

/// All assemblies of a triad, in the order of the plate's angle. For use when a problem is set up: it allocates.
/// # Given
/// `ends` one of which at least is a hinge; else none is found.
#[must_use]
pub fn modes(plate: &Plate, ends: &[End; 3]) -> Vec<Followed> {
    let Some(sextic) = Sextic::new(plate, ends) else { return Vec::new() };
    let mut found: Vec<Followed> = Vec::new();
    for z in sextic.roots() {
        for sign in [1.0, -1.0] {
            let start = sextic.pose(plate, z, sign);
            let Some(mode) = plate.uncertified(ends, &start, &mut ()) else { continue };
            let same = |other: &Followed| {
                let close = if mode.h <= 0.5 && other.h <= 0.5 { SAME } else { SAME.sqrt() };
                plate.apart(&mode.pose, &other.pose) <= close * plate.length
            };
            if !found.iter().any(same) {
                found.push(Followed { certified: mode.h <= 0.5, ..mode });
            }
        }
    }
    found.sort_by(|a, b| a.pose.u.angle().total_cmp(&b.pose.u.angle()));
    found
}

/// The first start of the search of [`modes`] that leads to a pose.
#[must_use]
pub fn start_of(plate: &Plate, ends: &[End; 3], pose: &Pose) -> Option<Pose> {
    let sextic = Sextic::new(plate, ends)?;
    let starts = sextic.roots().into_iter().flat_map(|z| [1.0, -1.0].map(|sign| sextic.pose(plate, z, sign)));
    let leads = |start: &Pose| {
        let end = plate.uncertified(ends, start, &mut ());
        end.is_some_and(|end| plate.apart(&end.pose, pose) <= SAME.sqrt() * plate.length)
    };
    starts.into_iter().find(leads)
}

/// w = c z − e and h = k + g·z of one leg.
#[derive(Clone, Copy, Default)]
pub(super) struct Line {
    c: Vec2,
    e: Vec2,
    k: f64,
    g: Vec2,
}

impl Line {
    /// Of a pin at `c` from the first leg's, the first leg being a link of a length about an origin.
    pub(super) fn new(c: Vec2, end: &End, (origin, length): (Vec2, f64)) -> Self {
        match *end {
            End::Hinge { p, length: l } => {
                let e = p - origin;
                // (l_i − l_1)(l_i + l_1): exact where the legs are alike
                let k = 0.5 * ((l - length) * (l + length) - c.dot(c) - e.dot(e));
                Self { c, e, k, g: e.turned_back(c) }
            }
            End::Guide { p, n } => {
                Self { c: Vec2::zero(), e: -n, k: n.dot(p - origin), g: -n.turned_back(c) }
            }
        }
    }

    pub(super) fn at(&self, z: Vec2) -> (Vec2, f64) {
        (self.c.turned(z) - self.e, self.k + self.g.dot(z))
    }

    /// Bounds of |w| and |h|.
    fn bounds(&self) -> (f64, f64) {
        (self.c.norm() + self.e.norm(), self.k.abs() + self.g.norm())
    }
}

struct Sextic {
    /// Index of leg 1, its hinge and its length.
    first: usize,
    origin: Vec2,
    length: f64,
    lines: [Line; 2],
    /// f as cosines and sines of 0 to 3 times the angle.
    waves: [Vec2; 4],
    /// What rounding may make of a coefficient.
    doubt: f64,
}

impl Sextic {
    fn new(plate: &Plate, ends: &[End; 3]) -> Option<Self> {
        let first = ends.iter().position(|end| matches!(end, End::Hinge { .. }))?;
        let End::Hinge { p: origin, length } = ends[first] else { return None };
        let line = |i: usize| Line::new(plate.arms[i] - plate.arms[first], &ends[i], (origin, length));
        let lines = [line((first + 1) % 3), line((first + 2) % 3)];
        let mut sextic = Self { first, origin, length, lines, waves: [Vec2::zero(); 4], doubt: 0.0 };
        let ((w_2, h_2), (w_3, h_3)) = (lines[0].bounds(), lines[1].bounds());
        let (near, far) = (h_2 * w_3 + h_3 * w_2, length * w_2 * w_3);
        sextic.doubt = ROUNDING * (near * near + far * far);
        sextic.expand();
        Some(sextic)
    }

    fn value(&self, z: Vec2) -> f64 {
        let ((w_2, h_2), (w_3, h_3)) = (self.lines[0].at(z), self.lines[1].at(z));
        let (near, far) = (w_3 * h_2 - w_2 * h_3, self.length * w_2.cross(w_3));
        near.dot(near) - far * far
    }

    /// Eight values at equal distances determine the seven coefficients.
    fn expand(&mut self) {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let eighth = Vec2::new(half, half);
        let mut z = Vec2::new(1.0, 0.0);
        for j in 0..8 {
            // every second direction is exact
            z = match j {
                0 => z,
                2 | 4 | 6 => [Vec2::new(0.0, 1.0), Vec2::new(-1.0, 0.0), Vec2::new(0.0, -1.0)][j / 2 - 1],
                _ => z.turned(eighth),
            };
            let value = self.value(z);
            let mut power = Vec2::new(1.0, 0.0);
            for (k, wave) in self.waves.iter_mut().enumerate() {
                *wave += power * (value * if k == 0 { 0.125 } else { 0.25 });
                power = power.turned(z);
            }
        }
    }

    /// (1 + t²)³ f over [−1, 1], from the direction 0 or its opposite.
    fn bernstein(&self, opposite: bool) -> Bernstein {
        // 1 + i t is the linear form of (1 − i, 1 + i); f holds Re of the conjugate wave times (1 + it)^(3+k) (1 − it)^(3−k)
        let (plus, minus) = (Vec2::new(1.0, 1.0), Vec2::new(1.0, -1.0));
        let mut sum = [0.0; 7];
        for (k, wave) in self.waves.iter().enumerate() {
            let mut product = vec![Vec2::new(1.0, 0.0)];
            for factor in 0..6 {
                let (low, high) = if factor < 3 + k { (minus, plus) } else { (plus, minus) };
                let mut next = vec![Vec2::zero(); product.len() + 1];
                for (j, x) in product.iter().enumerate() {
                    next[j] += x.turned(low);
                    next[j + 1] += x.turned(high);
                }
                product = next;
            }
            let sign = if opposite && k % 2 == 1 { -1.0 } else { 1.0 };
            for (j, x) in product.iter().enumerate() {
                sum[j] += sign * wave.dot(*x) / [1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0][j];
            }
        }
        sum
    }

    /// Directions of the plate where f vanishes or may do so.
    fn roots(&self) -> Vec<Vec2> {
        let mut out = Vec::new();
        for opposite in [false, true] {
            let mut found = Vec::new();
            // |1 + it|⁶ is 8 at the ends
            isolate(&self.bernstein(opposite), -1.0, 1.0, 8.0 * self.doubt, &mut found);
            out.extend(found.into_iter().map(|t| {
                let z = Vec2::new(1.0 - t * t, 2.0 * t) / (1.0 + t * t);
                if opposite { -z } else { z }
            }));
        }
        out
    }

    /// The pose of a root: q on the better of the two lines, ahead or behind.
    fn pose(&self, plate: &Plate, z: Vec2, sign: f64) -> Pose {
        let (a, b) = (self.lines[0].at(z), self.lines[1].at(z));
        let (w, h) = if a.0.norm() >= b.0.norm() { a } else { b };
        let square = w.dot(w).max(f64::MIN_POSITIVE);
        let along = h / square;
        let across = (self.length * self.length / square - along * along).max(0.0).sqrt();
        let q = w * along + w.perp() * (sign * across);
        Pose { p: self.origin + q - plate.arms[self.first].turned(z), u: z }
    }
}

/// Roots of a polynomial in Bernstein's form between `low` and `high`, each at least once.
fn isolate(c: &Bernstein, low: f64, high: f64, doubt: f64, found: &mut Vec<f64>) {
    let sure = |x: f64| {
        if x > doubt {
            1
        } else if x < -doubt {
            -1
        } else {
            0
        }
    };
    let signs = c.map(sure);
    if signs[0] != 0 && signs.iter().all(|s| *s == signs[0]) {
        return;
    }
    let middle = 0.5 * (low + high);
    let certain = signs.iter().all(|s| *s != 0);
    let changes = signs.windows(2).filter(|s| s[0] != s[1]).count();
    if certain && changes == 1 {
        found.push(bisect(c, low, high));
    } else if high - low <= NARROW || signs.iter().all(|s| *s == 0) {
        found.push(middle);
    } else {
        let (left, right) = halves(c);
        isolate(&left, low, middle, doubt, found);
        isolate(&right, middle, high, doubt, found);
    }
}

/// The one root of an interval.
fn bisect(c: &Bernstein, low: f64, high: f64) -> f64 {
    let (mut c, mut low, mut high) = (*c, low, high);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let (left, right) = halves(&c);
        if (left[6] > 0.0) == (c[0] > 0.0) {
            (c, low) = (right, middle);
        } else {
            (c, high) = (left, middle);
        }
    }
    0.5 * (low + high)
}

/// De Casteljau's division in the middle.
fn halves(c: &Bernstein) -> (Bernstein, Bernstein) {
    let (mut row, mut left, mut right) = (*c, [0.0; 7], [0.0; 7]);
    for k in 0..7 {
        left[k] = row[0];
        right[6 - k] = row[6 - k];
        for j in 0..6 - k {
            row[j] = 0.5 * (row[j] + row[j + 1]);
        }
    }
    (left, right)
}

// Why a triad does not close, and by how much.
//
// Two legs and the plate make a four-bar of the lengths |O_j − O_i|, l_i, |A_j − A_i|, l_j, which closes where the longest
// is no longer than the others together. If every two legs do, the plate moves on two of them, and the third pin stays
// too far from where its leg holds it, or too near: by how much is searched for over the directions of the plate.

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
