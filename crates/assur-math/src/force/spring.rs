//! A spring with a damper beside it, between two points.
//!
//! r = P_2 − P_1, l = |r|, u = r / l, free length l_0. The tension is T = k (l − l_0) + c l̇ with l̇ = v·u, v = v_2 − v_1;
//! the force on end 1 is T u, on end 2 it is −T u.
//!
//! The extension is formed as
//!
//! ```text
//! l − l_0 = ((p − l_0)(p + l_0) + q²) / (l + l_0),    p, q the greater and lesser of |r_x|, |r_y|,
//! ```
//!
//! so that a spring along an axis loses no digits near its free length, where l − l_0 of a rounded l would lose all.

use crate::math::{Scalar, V2};

/// What a spring does.
#[derive(Clone, Copy, Debug)]
pub struct Spring<S> {
    /// Force on end 1, N; the force on end 2 is its opposite.
    pub f_1: V2<S>,
    /// Tension T, N; negative in compression.
    pub tension: S,
    /// Extension l − l_0, m.
    pub extension: S,
}

/// Force of a spring; null where its ends coincide, for then it has no direction.
/// # Given
/// `r` = P_2 − P_1, m; `v` = v_2 − v_1, m/s; `k` stiffness, N/m; `l_0` free length, m, ≥ 0; `c` damping, N s/m.
#[inline(always)]
pub fn spring<S: Scalar>(r: V2<S>, v: V2<S>, k: S, l_0: S, c: S) -> Spring<S> {
    let least = S::of(f64::MIN_POSITIVE);
    let l = r.norm();
    let (p, q) = (r.x.abs().max(r.y.abs()), r.x.abs().min(r.y.abs()));
    let extension = ((p - l_0) * (p + l_0) + q * q) / (l + l_0).max(least);
    let u = r / l.max(least);
    let tension = k * extension + c * v.dot(u);
    Spring { f_1: u * tension, tension, extension }
}
