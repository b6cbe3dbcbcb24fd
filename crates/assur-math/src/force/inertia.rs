//! Inertia forces of a link: F_I = −m a_S at the mass centre S and the couple M_I = −J_S α.
//!
//! Reduced to another point O, with r = S − O, the moment is −J_S α − m r × a_S. The pair is equal to the single force
//! F_I on a line at the arm h = |M_I| / |F_I| from S, on the side that gives the couple its sense.

use super::Wrench;
use crate::math::{Scalar, V2};

/// Inertia forces about the mass centre.
/// # Given
/// `m` mass, kg; `J_S` moment of inertia about S, kg m²; `a_S` acceleration of S, m/s²; `alpha`, rad/s².
#[inline(always)]
pub fn about_centre<S: Scalar>(m: S, J_S: S, a_S: V2<S>, alpha: S) -> Wrench<S> {
    Wrench { F: -(a_S * m), M: -(J_S * alpha) }
}

/// Inertia forces about a point O.
/// # Given
/// As above; `r` = S − O, m.
#[inline(always)]
pub fn about<S: Scalar>(m: S, J_S: S, a_S: V2<S>, alpha: S, r: V2<S>) -> Wrench<S> {
    about_centre(m, J_S, a_S, alpha).about(-r)
}

/// Arm h = |M_I| / |F_I| of the resultant from S, m; infinite or NaN where S does not accelerate.
/// # Given
/// As for [`about_centre`].
#[inline(always)]
pub fn arm<S: Scalar>(m: S, J_S: S, a_S: V2<S>, alpha: S) -> S {
    about_centre(m, J_S, a_S, alpha).arm()
}

/// The point nearest to S of the line on which the resultant acts, as a vector from S, m; infinite or NaN where S
/// does not accelerate: r = (F × M) / F², so that r × F = M.
/// # Given
/// As for [`about_centre`].
#[inline(always)]
pub fn line<S: Scalar>(m: S, J_S: S, a_S: V2<S>, alpha: S) -> V2<S> {
    let w = about_centre(m, J_S, a_S, alpha);
    -w.F.perp() * (w.M / w.F.dot(w.F))
}
