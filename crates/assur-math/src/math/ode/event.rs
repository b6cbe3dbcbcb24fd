//! Where a function of t passes zero within a step.
//!
//! The function is looked at in ten places, denser towards the ends, where nothing beyond is seen; the widest gap is a fifth
//! of the step. Where the polynomial through them turns towards zero between two, there are three more. Between two that
//! differ in sign lies a root. Where three have one sign and the one between is nearest to zero the extreme is looked for:
//! beyond zero, two roots lie beside it. So two roots are found however close they are. Where the extreme is zero but for rounding
//! the function touches zero, as a magnitude does: that is one place, at the end of a step too.

use super::{Real, epsilon};
use crate::math::root_within;
use std::ops::ControlFlow;

/// A function passes zero, or comes to zero and turns back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<S> {
    pub t: S,
    /// It comes from below.
    pub rising: bool,
    pub touches: bool,
}

impl<S> Crossing<S> {
    /// Whether the function is above zero behind it.
    pub const fn leads_up(&self) -> bool {
        self.rising != self.touches
    }
}

/// How near to zero an extreme touches it: a part of the greatest magnitude, that of the step or one that is known.
#[derive(Clone, Copy, Debug)]
pub struct Touching {
    pub part: f64,
    pub greatest: f64,
}

impl Touching {
    /// What turns before zero does not count.
    pub const NEVER: Self = Self { part: 0.0, greatest: 0.0 };
}

const PLACES: usize = 10;

/// Parts of the step.
const PARTS: [f64; PLACES] =
    [0.0, 1.0 / 256.0, 0.0625, 0.21875, 0.40625, 0.59375, 0.78125, 0.9375, 255.0 / 256.0, 1.0];

/// Where the polynomial is looked at between two places.
const INSIDE: usize = 3;

const MORE: usize = PLACES + INSIDE * (PLACES - 1);

/// The value of the polynomial there: the weight of each place (Lagrange).
const WEIGHTS: [[[f64; PLACES]; INSIDE]; PLACES - 1] = weights();

const fn inside(gap: usize, i: usize) -> f64 {
    PARTS[gap] + (PARTS[gap + 1] - PARTS[gap]) * (i + 1) as f64 / (INSIDE + 1) as f64
}

const fn weights() -> [[[f64; PLACES]; INSIDE]; PLACES - 1] {
    let mut weights = [[[1.0; PLACES]; INSIDE]; PLACES - 1];
    let mut k = 0;
    while k < (PLACES - 1) * INSIDE * PLACES * PLACES {
        let (gap, i) = (k / (INSIDE * PLACES * PLACES), k / (PLACES * PLACES) % INSIDE);
        let (place, other) = (k / PLACES % PLACES, k % PLACES);
        if place != other {
            weights[gap][i][place] *= (inside(gap, i) - PARTS[other]) / (PARTS[place] - PARTS[other]);
        }
        k += 1;
    }
    weights
}

/// Evaluations for an extreme: with those of the parabola eight are usual.
const MOST: usize = 100;

/// What comes to zero within a gap is no greater where that begins, of the greatest.
const COMES_NEAR: f64 = 1.0 / 16.0;

/// A place this part of the step behind an end is the end: polynomials of neighbouring steps differ by more.
const AT_END: f64 = 1e-8;

/// What touches zero is, as found first, no more than this part of what it is at the ends of its gap.
const NEARLY: f64 = 1e-3;

/// A touch is refined from places this part of its gap beside it.
const BESIDE: f64 = 1e-3;

/// Golden section: the lesser part of 1.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// A place and the value there.
type Point<S> = (S, S);

/// Tells of every change of sign of `g` between two places, in order, to 4 ε of the number. A zero at the last place is one,
/// at the first none; where the step began at a root, `passed` says that it was rising, and its sign is not read from what is left of it.
pub fn crossings<S: Real, B>(
    step: (S, S),
    passed: Option<bool>,
    g: impl FnMut(S) -> S,
    found: impl FnMut(Crossing<S>) -> ControlFlow<B>,
) -> ControlFlow<B> {
    crossings_and_touches(step, passed, Touching::NEVER, g, found)
}

/// As [`crossings`], and of places where `g` touches zero. For these it is looked at a little beyond the step.
pub fn crossings_and_touches<S: Real, B>(
    (from, to): (S, S),
    passed: Option<bool>,
    touching: Touching,
    mut g: impl FnMut(S) -> S,
    mut found: impl FnMut(Crossing<S>) -> ControlFlow<B>,
) -> ControlFlow<B> {
    let mut points = PARTS.map(|part| point_at((from, to), part, &mut g));
    let greatest = points.iter().fold(S::of(touching.greatest), |most, point| most.max(point.1.abs()));
    let near = S::of(touching.part) * greatest;
    if let Some(rising) = passed {
        points[0].1 = passed_value(points[0].1, rising);
    }
    let (points, count) = with_more((from, to), points, &mut g);
    let points = &points[..count];
    let mut last = points[0];
    if passed.is_none() && S::zero().lt(near) {
        let before = beyond_end(from, from - to, &mut g);
        if let Turn::Touches(t) = extreme(before, last, points[1], near, &mut g)
            && ahead(t, from + S::of(AT_END) * (to - from), to - from)
        {
            found(Crossing { t, rising: sign(before.1) < 0, touches: true })?;
        }
    }
    let touch = if S::zero().lt(near) { touch_at_end(points, greatest, near, &mut g) } else { None };
    for i in 1..count {
        if i + 1 == count && touch.is_some() {
            break;
        }
        if opposite(last, points[i]) {
            found(crossing(last, points[i], &mut g))?;
        } else if let Some(&after) = points.get(i + 1) {
            match extreme(last, points[i], after, near, &mut g) {
                Turn::Passes(beyond) => {
                    found(crossing(last, beyond, &mut g))?;
                    // from there on as between any two places
                    last = beyond;
                    if opposite(last, points[i]) && !ahead(beyond.0, points[i].0, to - from) {
                        found(crossing(last, points[i], &mut g))?;
                    } else {
                        continue;
                    }
                }
                Turn::Touches(t) => found(Crossing { t, rising: sign(last.1) < 0, touches: true })?,
                Turn::None => {}
            }
        }
        if sign(points[i].1) != 0 {
            last = points[i];
        }
    }
    let end = points[count - 1];
    if touch.is_some() || (sign(end.1) == 0 && sign(last.1) != 0) {
        let t = touch.filter(|t| ahead(end.0, *t, to - from)).unwrap_or(end.0);
        found(Crossing { t, rising: sign(points[count - 2].1) < 0, touches: touch.is_some() })?;
    }
    ControlFlow::Continue(())
}

/// Where a function touches zero in the last gap.
fn touch_at_end<S: Real>(points: &[Point<S>], greatest: S, near: S, g: &mut impl FnMut(S) -> S) -> Option<S> {
    let &[from, .., before, end] = points else { return None };
    let comes = near.lt(before.1.abs()) && end.1.abs().lt(before.1.abs());
    let passes = sign(end.1) * sign(before.1) <= 0;
    // of what is far from zero there is nothing to see beyond
    if !comes || S::of(COMES_NEAR).lt(before.1.abs() / greatest) || (passes && near.lt(end.1.abs())) {
        return None;
    }
    let beyond = beyond_end(end.0, end.0 - from.0, g);
    if !beyond.1.abs().lt(S::of(f64::INFINITY)) {
        return (!passes && !near.lt(end.1.abs())).then_some(end.0);
    }
    if passes {
        return (sign(beyond.1) == sign(before.1)).then_some(end.0);
    }
    let slack = S::of(AT_END) * (end.0 - from.0);
    match extreme(before, end, beyond, near, g) {
        Turn::Touches(t) if !ahead(t, end.0 + slack, end.0 - from.0) => Some(t),
        _ => None,
    }
}

/// The value a little beyond an end of the step.
fn beyond_end<S: Real>(end: S, step: S, g: &mut impl FnMut(S) -> S) -> Point<S> {
    let t = end + S::of(PARTS[1]) * step;
    (t, g(t))
}

/// The value at a part of the step; where that is a root by chance, beside it, as there is more to see.
fn point_at<S: Real>((from, to): (S, S), part: f64, g: &mut impl FnMut(S) -> S) -> Point<S> {
    let t = if part < 1.0 { from + S::of(part) * (to - from) } else { to };
    let value = g(t);
    if sign(value) != 0 || part == 0.0 || part == 1.0 {
        return (t, value);
    }
    let beside = t + S::of(1.0 / 1024.0) * (to - from);
    (beside, g(beside))
}

/// The places and, where the polynomial through all comes nearer to zero between two of one sign than at both, or turns
/// between two of different sign, those between.
fn with_more<S: Real>(
    step: (S, S),
    points: [Point<S>; PLACES],
    g: &mut impl FnMut(S) -> S,
) -> ([Point<S>; MORE], usize) {
    let (mut all, mut count) = ([points[0]; MORE], 1);
    for (gap, pair) in points.windows(2).enumerate() {
        let values = WEIGHTS[gap].map(|weights| {
            let terms = weights.iter().zip(&points);
            terms.fold(S::zero(), |sum, (weight, point)| sum + S::of(*weight) * point.1)
        });
        if hides(pair[0].1, values, pair[1].1) {
            for i in 0..INSIDE {
                all[count] = point_at(step, inside(gap, i), g);
                count += 1;
            }
        }
        all[count] = pair[1];
        count += 1;
    }
    (all, count)
}

/// More roots may lie between two values than their signs say, as those between them go.
fn hides<S: Real>(a: S, between: [S; INSIDE], b: S) -> bool {
    if sign(a) * sign(b) > 0 {
        let side = if a.lt(S::zero()) { -S::one() } else { S::one() };
        let least = (a * side).min(b * side);
        return between.iter().any(|value| (*value * side).lt(least));
    }
    let way = b - a;
    let (mut last, mut turns) = (a, false);
    for value in between.into_iter().chain([b]) {
        turns |= ((value - last) * way).lt(S::zero());
        last = value;
    }
    turns
}

/// The first change of sign or touch.
pub fn first_crossing_or_touch<S: Real>(
    step: (S, S),
    passed: Option<bool>,
    touching: Touching,
    g: impl FnMut(S) -> S,
) -> Option<Crossing<S>> {
    crossings_and_touches(step, passed, touching, g, ControlFlow::Break).break_value()
}

/// The first change of sign.
pub fn first_crossing<S: Real>(
    step: (S, S),
    passed: Option<bool>,
    g: impl FnMut(S) -> S,
) -> Option<Crossing<S>> {
    crossings(step, passed, g, ControlFlow::Break).break_value()
}

/// The value where a root was just passed: of the side beyond, however little.
fn passed_value<S: Real>(value: S, rising: bool) -> S {
    match (sign(value), rising) {
        (1, true) | (-1, false) => value,
        (_, true) => S::tiny(),
        (_, false) => -S::tiny(),
    }
}

fn sign<S: Real>(x: S) -> i8 {
    i8::from(S::zero().lt(x)) - i8::from(x.lt(S::zero()))
}

fn opposite<S: Real>(a: Point<S>, b: Point<S>) -> bool {
    sign(a.1) * sign(b.1) < 0
}

/// a lies further than b in the direction of the step.
fn ahead<S: Real>(a: S, b: S, direction: S) -> bool {
    if direction.lt(S::zero()) { a.lt(b) } else { b.lt(a) }
}

fn crossing<S: Real>(a: Point<S>, b: Point<S>, g: &mut impl FnMut(S) -> S) -> Crossing<S> {
    let tolerance = if S::EXTENDED { 2e-31 } else { 4.0 * f64::EPSILON };
    let t = root_within(tolerance, (a.0, b.0), (a.1, b.1), g);
    Crossing { t, rising: sign(a.1) < 0, touches: false }
}

/// What a function does between two places of one sign.
enum Turn<S> {
    /// It is beyond zero at a place.
    Passes(Point<S>),
    Touches(S),
    None,
}

/// Where a and c have one sign and b is nearest to zero: the least of ±g by parabolas, by golden section where they do not serve
/// (R. P. Brent, Algorithms for Minimization Without Derivatives, 1973).
fn extreme<S: Real>(
    mut a: Point<S>,
    mut b: Point<S>,
    mut c: Point<S>,
    near: S,
    g: &mut impl FnMut(S) -> S,
) -> Turn<S> {
    let side = sign(a.1);
    let farther = |p: Point<S>| sign(p.1) == side && !p.1.abs().lt(b.1.abs());
    let known = sign(b.1) == side || (S::zero().lt(near) && sign(b.1) == 0);
    if side == 0 || !known || !farther(a) || !farther(c) {
        return Turn::None;
    }
    let same = |p: Point<S>| !p.1.abs().lt(b.1.abs()) && !b.1.abs().lt(p.1.abs());
    if same(a) && same(c) {
        // what stands still
        return Turn::None;
    }
    let from_sign = if side < 0 { -S::one() } else { S::one() };
    let (begin, end) = (a, c);
    let least = epsilon::<S>().sqrt() * (c.0 - a.0).abs();
    for turn in 0..MOST {
        let x = if turn % 4 == 3 { None } else { vertex(a, b, c) };
        let x = x.filter(|x| least.lt((*x - b.0).abs()) && between(a.0, *x, c.0)).unwrap_or_else(|| {
            let part = S::of(GOLDEN);
            let (to_a, to_c) = (a.0 - b.0, c.0 - b.0);
            b.0 + part * if to_a.abs().lt(to_c.abs()) { to_c } else { to_a }
        });
        let new = (x, g(x));
        if (new.1 * from_sign).lt(-near) {
            return Turn::Passes(new);
        }
        let nearer = (new.1 * from_sign).lt(b.1 * from_sign);
        if between(a.0, x, b.0) {
            (a, b, c) = if nearer { (a, new, b) } else { (new, b, c) };
        } else {
            (a, b, c) = if nearer { (b, new, c) } else { (a, b, new) };
        }
        if (c.0 - a.0).abs().lt(S::of(4.0) * least) {
            break;
        }
    }
    // what stays so small all the time comes from nowhere
    let least = begin.1.abs().min(end.1.abs());
    let may_touch = S::zero().lt(near) && near.lt(least) && b.1.abs().lt(near.max(S::of(NEARLY) * least));
    if !may_touch {
        return Turn::None;
    }
    let t = touched(b.0, S::of(BESIDE) * (end.0 - begin.0), g);
    if near.lt(g(t).abs().min(b.1.abs())) { Turn::None } else { Turn::Touches(t) }
}

/// The place of a touch from one near it, by what |g| is beside it: it grows as the distance or as its square, and so as a smooth
/// function of the distance, whose inverse passes zero there.
fn touched<S: Real>(t: S, beside: S, g: &mut impl FnMut(S) -> S) -> S {
    let places = [-2.0, -1.0, 1.0, 2.0].map(|part| t + S::of(part) * beside);
    let values = places.map(|place| g(place).abs());
    let square = (values[1] + values[2]).lt(S::of(0.35) * (values[0] + values[3]));
    let unfolded = values.map(|value| if square { value.sqrt() } else { value });
    let [a, b, c, d] = unfolded;
    let (x, mut y) = ([-a, -b, c, d], places);
    // Neville's scheme at zero
    for order in 1..4 {
        for i in 0..4 - order {
            y[i] = y[i] + (y[i + 1] - y[i]) * x[i] / (x[i] - x[i + order]);
        }
    }
    if (y[0] - t).abs().lt(beside) { y[0] } else { t }
}

fn between<S: Real>(a: S, x: S, b: S) -> bool {
    (x - a).lt(S::zero()) == (b - x).lt(S::zero()) && S::zero().lt((x - a).abs().min((b - x).abs()))
}

/// Where the parabola through three points turns.
fn vertex<S: Real>(a: Point<S>, b: Point<S>, c: Point<S>) -> Option<S> {
    let (r, q) = ((b.0 - a.0) * (b.1 - c.1), (b.0 - c.0) * (b.1 - a.1));
    let (below, above) = (S::of(2.0) * (r - q), (b.0 - a.0) * r - (b.0 - c.0) * q);
    S::zero().lt(below.abs()).then(|| b.0 - above / below)
}

// The polynomial through values and rates at places of a step (Hermite), by Newton's divided differences with each place
// twice.

#[derive(Clone, Debug)]
pub(super) struct Hermite<S> {
    /// Parts of the step.
    pub places: Vec<S>,
    /// Of component i those from i·2·places on.
    differences: Vec<S>,
    /// How many places are of use; none before the polynomial is made.
    pub used: usize,
}

impl<S: Real> Hermite<S> {
    pub(super) fn new(places: usize, n: usize) -> Self {
        // the ends first, then halves, quarters … of a half turn: any number of them lies well, and in a stable sequence
        let angle = |mut i: usize| {
            let (mut part, mut unit) = (0.0, 0.5);
            while i > 0 {
                part += if i % 2 == 1 { unit } else { 0.0 };
                (i, unit) = (i / 2, 0.5 * unit);
            }
            part
        };
        let inner = (1..places - 1).map(|i| 0.5 - 0.5 * libm::cos(std::f64::consts::PI * angle(i)));
        let places: Vec<S> = [0.0, 1.0].into_iter().chain(inner).map(S::of).collect();
        Self { differences: vec![S::zero(); 2 * places.len() * n], places, used: 0 }
    }

    fn rows(&self) -> usize {
        2 * self.places.len()
    }

    /// The value at a place, and the rate times the length of the step.
    pub(super) fn set(&mut self, place: usize, component: usize, value: S, rate: S) {
        let row = component * self.rows() + 2 * place;
        (self.differences[row], self.differences[row + 1]) = (value, rate);
    }

    /// Divided differences, in place of values and rates.
    pub(super) fn divide(&mut self, used: usize) {
        let (rows, places) = (self.rows(), &self.places);
        for c in self.differences.chunks_exact_mut(rows) {
            // the rates are those between a place and itself
            for place in (1..used).rev() {
                c[2 * place] = (c[2 * place] - c[2 * place - 2]) / (places[place] - places[place - 1]);
            }
            for order in 2..2 * used {
                for i in (order..2 * used).rev() {
                    c[i] = (c[i] - c[i - 1]) / (places[i / 2] - places[(i - order) / 2]);
                }
            }
        }
        self.used = used;
    }

    pub(super) fn value(&self, component: usize, s: S) -> S {
        let row = component * self.rows();
        let last = 2 * self.used - 1;
        (0..last).rev().fold(self.differences[row + last], |value, i| {
            self.differences[row + i] + (s - self.places[i / 2]) * value
        })
    }
}
