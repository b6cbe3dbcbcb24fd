//! RPR: a link hung by a revolute A carries a line, along which a body hung by a revolute B slides.
//!
//! Body 1 turns about A and carries the line, unit direction e, left normal n = perp(e), origin of its coordinate at
//! the foot of A. Body 2 turns about B, slides along the line and turns with body 1. r = B − A, L = |r|, and h is
//! the constant offset of B to the left of the parallel to the line through A:
//!
//! ```text
//! r = s e + h n.
//! ```
//!
//! Position: L² = s² + h², so s = ±√((L − h)(L + h)); read as complex numbers r = (s + i h) e, so
//!
//! ```text
//! e = (s r − h perp(r)) / L².
//! ```
//!
//! Velocity:      v_B − v_A = ω × r + ṡ e.
//! Acceleration:  a_B − a_A = α × r − ω² r + 2 ω ṡ n + s̈ e.
//!
//! Both read x perp(r) + y e = b. Components along n and e:
//!
//! ```text
//! x = b·n / s,    y = b·e + x h,    s = r·e = L sin(transmission angle).
//! ```
//!
//! s vanishes where B stands beside A, L = |h|. With h = 0 the group has no dead position but A = B.
//!
//! Forces: normal force N along n through B and couple K about B, of body 1 on body 2. Body 2 about B, then body 1
//! about A:
//!
//! ```text
//! K = −M_2,    N s = M_1 − K    ⇒    N = (M_1 + M_2) / s,
//! ```
//!
//! then f_A = N n − F_1 and f_B = −N n − F_2.

use super::Gap;
use crate::math::{Scalar, V2, Vec2};

/// Where the line is.
#[derive(Clone, Copy, Debug)]
pub struct Position<S> {
    /// Unit direction of the line.
    pub e: V2<S>,
    /// Coordinate of B along the line from the foot of A, m.
    pub s: S,
    /// s / L; its sign is that of s.
    pub conditioning: S,
    /// L − |h|, m; ≥ 0 when the offset fits between the pins.
    pub closure: S,
}

/// Position of the line and of B along it.
/// # Given
/// `p_A`, `p_B` outer revolutes, m; `h` offset of B to the left of the line's parallel through A, m; `root`
/// the sign of s, ±1.
/// # Returns
/// See [`Position`]. Where the offset does not fit, s = 0 and e is not a unit vector; where A and B
/// coincide e is null.
/// # Method
/// Right triangle with hypotenuse L and leg h, the radicand as a product.
#[inline(always)]
pub fn position<S: Scalar>(p_A: V2<S>, p_B: V2<S>, h: S, root: S) -> Position<S> {
    let r = p_B - p_A;
    let square = r.dot(r);
    let inverse = S::one() / square.max(S::of(f64::MIN_POSITIVE));
    let length = square.sqrt();
    let s = root * ((length - h) * (length + h)).max(S::zero()).sqrt();
    Position {
        e: (r * s - r.perp() * h) * inverse,
        s,
        conditioning: s * length * inverse,
        closure: length - h.abs(),
    }
}

/// By how much the pins are too near for the offset, m; `None` when it fits.
/// # Given
/// As for [`position`].
#[cold]
#[must_use]
pub fn gap(p_A: Vec2, p_B: Vec2, h: f64) -> Option<Gap> {
    let missing = h.abs() - (p_B - p_A).norm();
    (missing > 0.0).then_some(Gap::TooNear(missing))
}

/// The group in one position: what velocity, acceleration and reactions share.
#[derive(Clone, Copy, Debug)]
pub struct Rpr<S> {
    /// B − A, m.
    pub r: V2<S>,
    /// Unit direction of the line.
    pub e: V2<S>,
    /// Offset of B, m.
    pub h: S,
    /// 1 / s, 1/m.
    pub inverse: S,
}

/// Forces in the pairs.
#[derive(Clone, Copy, Debug)]
pub struct Reactions<S> {
    /// On body 1 at A, N.
    pub f_A: V2<S>,
    /// On body 2 at B, N.
    pub f_B: V2<S>,
    /// Normal force N of body 1 on body 2, along n through B, N.
    pub normal: S,
    /// Couple K of body 1 on body 2 about B, N m.
    pub couple: S,
}

impl<S: Scalar> Rpr<S> {
    /// The group in one position.
    /// # Given
    /// `r` = B − A, m; `e` unit direction of the line; `h` offset of B, m; `s` its coordinate, m, not 0.
    #[inline(always)]
    pub fn new(r: V2<S>, e: V2<S>, h: S, s: S) -> Self {
        Self { r, e, h, inverse: S::one() / s }
    }

    /// Angular velocity of both bodies and velocity of B along the line, (ω, ṡ).
    /// # Given
    /// `v_A`, `v_B` velocities of the outer revolutes, m/s.
    #[inline(always)]
    pub fn velocity(&self, v_A: V2<S>, v_B: V2<S>) -> (S, S) {
        self.solve(v_B - v_A)
    }

    /// Angular acceleration of both bodies and acceleration of B along the line, (α, s̈).
    /// # Given
    /// `omega`, `s_dot` from [`Rpr::velocity`]; `a_A`, `a_B` accelerations of the outer revolutes, m/s².
    #[inline(always)]
    pub fn acceleration(&self, omega: S, s_dot: S, a_A: V2<S>, a_B: V2<S>) -> (S, S) {
        let coriolis = self.e.perp() * (S::of(2.0) * omega * s_dot);
        self.solve(a_B - a_A - coriolis + self.r * (omega * omega))
    }

    /// x perp(r) + y e = b.
    #[inline(always)]
    fn solve(&self, b: V2<S>) -> (S, S) {
        let x = self.e.cross(b) * self.inverse;
        (x, b.dot(self.e) + x * self.h)
    }

    /// Forces in the pairs.
    /// # Given
    /// `F_1`, `F_2` applied and inertia forces, N; `M_1` moment of the first about A, `M_2` of the second
    /// about B, N m.
    #[inline(always)]
    pub fn reactions(&self, F_1: V2<S>, M_1: S, F_2: V2<S>, M_2: S) -> Reactions<S> {
        let normal = (M_1 + M_2) * self.inverse;
        let force = self.e.perp() * normal;
        Reactions { f_A: force - F_1, f_B: -force - F_2, normal, couple: -M_2 }
    }
}
