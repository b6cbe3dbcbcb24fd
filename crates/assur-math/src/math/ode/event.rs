//! Where a function of t passes zero within a step.
//!
//! The function is looked at in nine places, denser towards the ends as those of Chebyshev; the widest gap is a fifth of the
//! step. Between two that differ in sign lies a root. Where three have one sign and the one between is nearest to zero the
//! extreme is looked for: beyond zero, two roots lie beside it. So two roots are found however close they are, if the
//! function turns only once between neighbouring places.

use super::{Real, epsilon};
use crate::math::root_within;
use std::ops::ControlFlow;

/// A function passes zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<S> {
    /// Where.
    pub t: S,
    /// From below.
    pub rising: bool,
}

/// Places.
const PLACES: usize = 9;

/// (1 − cos(π i/8))/2.
const PARTS: [f64; PLACES] = [
    0.0,
    0.038_060_233_744_356_62,
    0.146_446_609_406_726_24,
    0.308_658_283_817_455_1,
    0.5,
    0.691_341_716_182_544_9,
    0.853_553_390_593_273_8,
    0.961_939_766_255_643_4,
    1.0,
];

/// Evaluations for an extreme: with those of the parabola eight are usual.
const MOST: usize = 100;

/// Golden section: the lesser part of 1.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// A place and the value there.
type Point<S> = (S, S);

/// Tells of every change of sign of `g` between two places, in order, to 4 ε of the number. A zero at the last place is one,
/// at the first none; where the step began at a root, `passed` says that it was rising, and its sign is not read from what is left of it.
pub fn crossings<S: Real, B>(
    (from, to): (S, S),
    passed: Option<bool>,
    mut g: impl FnMut(S) -> S,
    mut found: impl FnMut(Crossing<S>) -> ControlFlow<B>,
) -> ControlFlow<B> {
    let mut points = PARTS.map(|part| {
        let t = if part < 1.0 { from + S::of(part) * (to - from) } else { to };
        let value = g(t);
        if sign(value) != 0 || part == 0.0 || part == 1.0 {
            return (t, value);
        }
        // at a root by chance: beside it there is more to see
        let beside = t + S::of(1.0 / 1024.0) * (to - from);
        (beside, g(beside))
    });
    if let Some(rising) = passed {
        points[0].1 = passed_value(points[0].1, rising);
    }
    let mut last = points[0];
    for i in 1..PLACES {
        if opposite(last, points[i]) {
            found(crossing(last, points[i], &mut g))?;
        } else if let Some(&after) = points.get(i + 1)
            && let Some(beyond) = extreme(last, points[i], after, &mut g)
        {
            found(crossing(last, beyond, &mut g))?;
            // from there on as between any two places
            last = beyond;
            if opposite(last, points[i]) && !ahead(beyond.0, points[i].0, to - from) {
                found(crossing(last, points[i], &mut g))?;
            } else {
                continue;
            }
        }
        if sign(points[i].1) != 0 {
            last = points[i];
        }
    }
    let end = points[PLACES - 1];
    if sign(end.1) == 0 && sign(last.1) != 0 {
        found(Crossing { t: end.0, rising: sign(last.1) < 0 })?;
    }
    ControlFlow::Continue(())
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
    let tolerance = if S::WIDE { 2e-31 } else { 4.0 * S::ROUNDING };
    Crossing { t: root_within(tolerance, (a.0, b.0), (a.1, b.1), g), rising: sign(a.1) < 0 }
}

/// A place between a and c beyond zero, where all three have one sign and b is nearest to zero: the least of |g| by
/// parabolas, by golden section where they do not serve (R. P. Brent, Algorithms for Minimization Without Derivatives, 1973).
fn extreme<S: Real>(
    mut a: Point<S>,
    mut b: Point<S>,
    mut c: Point<S>,
    g: &mut impl FnMut(S) -> S,
) -> Option<Point<S>> {
    let side = sign(b.1);
    let farther = |p: Point<S>| sign(p.1) == side && !p.1.abs().lt(b.1.abs());
    if side == 0 || !farther(a) || !farther(c) {
        return None;
    }
    let least = epsilon::<S>().sqrt() * (c.0 - a.0).abs();
    for turn in 0..MOST {
        let x = if turn % 4 == 3 { None } else { vertex(a, b, c) };
        let x = x.filter(|x| least.lt((*x - b.0).abs()) && between(a.0, *x, c.0)).unwrap_or_else(|| {
            let part = S::of(GOLDEN);
            let (to_a, to_c) = (a.0 - b.0, c.0 - b.0);
            b.0 + part * if to_a.abs().lt(to_c.abs()) { to_c } else { to_a }
        });
        let new = (x, g(x));
        if sign(new.1) * side < 0 {
            return Some(new);
        }
        let nearer = new.1.abs().lt(b.1.abs());
        if between(a.0, x, b.0) {
            (a, b, c) = if nearer { (a, new, b) } else { (new, b, c) };
        } else {
            (a, b, c) = if nearer { (b, new, c) } else { (a, b, new) };
        }
        if (c.0 - a.0).abs().lt(S::of(4.0) * least) {
            break;
        }
    }
    None
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
