//! Two point masses in place of a link of mass m and moment of inertia J_S.
//!
//! Total mass, mass centre and moment of inertia ask for
//!
//! ```text
//! m_1 + m_2 = m,    m_1 r_1 + m_2 r_2 = 0,    m_1 r_1² + m_2 r_2² = J_S,
//! ```
//!
//! r_i from S. Both points lie on one line through S, on either side of it.
//! Static: both points are chosen, the third condition is left open by ΔJ = J_S − m_1 r_1² − m_2 r_2².
//! Dynamic: one point is chosen, at b from S; the other, its centre of oscillation, is at l_2 = J_S / (m b) beyond S.
//!
//! Vectors may stand in any axes, the link's own or the ground's.

use crate::math::{Scalar, V2};

/// Masses in two chosen points.
#[derive(Clone, Copy, Debug)]
pub struct Static<S> {
    /// Mass in the first point, kg.
    pub m_1: S,
    /// Mass in the second point, kg.
    pub m_2: S,
    /// Moment of inertia left over, kg m²; negative when the point masses have more than the link.
    pub dJ: S,
    /// Distance of S to the left of the line from the first point to the second, m; unless it is 0 the masses do
    /// not keep the mass centre.
    pub offset: S,
}

/// Masses in a chosen point and its centre of oscillation.
#[derive(Clone, Copy, Debug)]
pub struct Dynamic<S> {
    /// Mass in the chosen point, kg.
    pub m_1: S,
    /// Mass in the second point, kg.
    pub m_2: S,
    /// Second point, from S, m.
    pub r_2: V2<S>,
    /// Its distance from S, m.
    pub l_2: S,
}

/// Static substitution.
/// # Given
/// `m`, kg; `J_S`, kg m²; `r_1`, `r_2` the two points from S, m, distinct.
#[inline]
pub fn in_points<S: Scalar>(m: S, J_S: S, r_1: V2<S>, r_2: V2<S>) -> Static<S> {
    let along = r_2 - r_1;
    let square = along.dot(along);
    let m_1 = m * (r_2.dot(along) / square);
    let m_2 = -(m * (r_1.dot(along) / square));
    let dJ = J_S - m_1 * r_1.dot(r_1) - m_2 * r_2.dot(r_2);
    Static { m_1, m_2, dJ, offset: r_1.cross(along) / square.sqrt() }
}

/// Dynamic substitution.
/// # Given
/// `m`, kg, > 0; `J_S`, kg m²; `r_1` the chosen point from S, m, not null.
#[inline]
pub fn with_centre_of_oscillation<S: Scalar>(m: S, J_S: S, r_1: V2<S>) -> Dynamic<S> {
    let b = r_1.norm();
    let l_2 = J_S / (m * b);
    let share = m / (b + l_2);
    Dynamic { m_1: share * l_2, m_2: share * b, r_2: -(r_1 * (l_2 / b)), l_2 }
}
