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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec2;

    #[test]
    fn pulls_its_ends_together_when_long() {
        let s = spring(Vec2::new(3.0, 4.0), Vec2::new(5.0, 0.0), 100.0, 4.0, 10.0);
        assert_eq!((s.extension, s.tension), (1.0, 130.0));
        assert!((s.f_1 - Vec2::new(78.0, 104.0)).norm() < 1e-13);
        let pushed = spring(Vec2::new(3.0, 4.0), Vec2::zero(), 100.0, 6.0, 0.0);
        assert!((pushed.tension + 100.0).abs() < 1e-12);
    }

    #[test]
    fn keeps_its_digits_near_the_free_length() {
        // r = (1, q): l − 1 = q²/2 − q⁴/8 + …, far below the last place of l.
        let q = 1e-9;
        let s = spring(Vec2::new(1.0, q), Vec2::zero(), 1.0, 1.0, 0.0);
        assert!((s.extension / (q * q / 2.0) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn ends_that_coincide() {
        let s = spring(Vec2::zero(), Vec2::zero(), 100.0, 0.5, 1.0);
        assert_eq!((s.extension, s.f_1), (-0.5, Vec2::zero()));
        let s = spring(Vec2::zero(), Vec2::zero(), 100.0, 0.0, 1.0);
        assert_eq!((s.extension, s.f_1), (0.0, Vec2::zero()));
    }
}
