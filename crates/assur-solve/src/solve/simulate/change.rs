//! Where a change point is, and how far to both sides it is gone over.

use crate::math::Vec2;
use crate::math::chebyshev::NODES;
use crate::position::{BodyState, Branch, State};

/// A bridge reaches at most so far to both sides, of the coordinate, rad or parts of the extent.
pub(super) const REACH: f64 = 0.5;
/// A change point is looked for up to here, and given up beyond it.
pub(super) const FARTHEST: f64 = 2.0 * REACH;
/// What the series leave off is less than this.
pub(super) const SMOOTH: f64 = 1e-11;
/// Groups below this |σ| at the change point have their assemblies in one there.
pub(super) const CHANGES: f64 = 1e-3;
/// The change point is known well enough below this; nearer to it nothing tells on which side of it links stand.
pub(super) const FOUND: f64 = 1e-6;
/// Below this |σ| the formulas have lost digits on either side of it.
pub(super) const CLOSE: f64 = 1e-2;
/// The way to it is gone in so many steps at most, each leaving a tenth.
const STEPS: usize = 16;
const PART: f64 = 0.9;
/// Numbers of a body.
pub(super) const WIDTH: usize = 10;

/// Of the numbers of a body: how often they are differentiated, and which are lengths.
pub(super) const ORDERS: [usize; WIDTH] = [0, 0, 0, 0, 1, 1, 1, 2, 2, 2];
pub(super) const IS_LENGTH: [bool; WIDTH] = [true, true, false, false, true, true, false, true, true, false];
/// Rounding of all terms of a series over that of its last ones.
pub(super) const OF_ALL: f64 = NODES as f64;

/// Moves a body as these numbers say: place, direction, velocity, angular velocity, acceleration, angular acceleration.
pub(super) fn put_numbers(body: &mut BodyState, n: &[f64]) {
    let u = Vec2::new(n[2], n[3]);
    *body = BodyState {
        p: Vec2::new(n[0], n[1]),
        u: u / u.norm(),
        v: Vec2::new(n[4], n[5]),
        omega: n[6],
        a: Vec2::new(n[7], n[8]),
        alpha: n[9],
        turned: body.turned,
        ..BodyState::rest()
    };
}

/// The place ahead where the least |σ| vanishes, and the position just before it; `None` where the mechanism does not close on the way,
/// or nothing vanishes.
pub(super) fn change_point(
    at: &mut impl FnMut(f64, &[Branch]) -> Option<State>,
    near: &[Branch],
    value: f64,
    ahead: f64,
) -> Option<(f64, State)> {
    let sigma = |state: &State| state.motion.conditions.iter().fold(1.0_f64, |least, c| least.min(c.abs()));
    let mut before = (value, sigma(&at(value, near)?));
    let mut q = value + ahead * 0.1 * before.1;
    for _ in 0..STEPS {
        let state = at(q, near)?;
        let here = sigma(&state);
        let slope = (here - before.1) / (q - before.0);
        let to_go = -here / slope;
        // it falls ahead, and not far away
        if to_go.is_nan() || to_go * ahead <= 0.0 || (q + to_go - value).abs() > FARTHEST {
            return None;
        }
        if here < FOUND {
            return Some((q, state));
        }
        before = (q, here);
        q += PART * to_go;
    }
    None
}
