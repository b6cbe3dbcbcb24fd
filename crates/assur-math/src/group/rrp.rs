//! RRP: a link hung by a revolute A on a body of known motion, joined by a revolute C to a slider on a known guide.
//!
//! Link 1 is AC, r_1 = C − A, |r_1| = l. Body 2 carries C and slides along the guide, a line of a body of known
//! motion through its point Q with unit direction d and left normal n = perp(d); it turns with the guide. C keeps
//! the offset h to the left of the line: C = Q + s d + h n.
//!
//! Position: with q = A − Q, seen in the axes (d, n) of the guide, r_1 = (u, e):
//!
//! ```text
//! e = h − q·n,    u = ±√(l² − e²) = ±√((l − e)(l + e)),    s = q·d + u.
//! ```
//!
//! G is the point of the guide's body under C, v_G and a_G its velocity and acceleration, ω_g the angular velocity
//! of that body.
//! Velocity:      v_A + ω_1 × r_1 = v_G + ṡ d.
//! Acceleration:  a_A + α_1 × r_1 − ω_1² r_1 = a_G + 2 ω_g ṡ n + s̈ d.
//!
//! Both read x perp(r_1) − y d = b. Components along n and d:
//!
//! ```text
//! x = b·n / u,    y = −x e − b·d,    u = r_1·d = l sin(transmission angle).
//! ```
//!
//! u vanishes where the link stands across the guide, e = ±l.
//!
//! Forces: f_C of link 1 on body 2, normal force N along n and couple K about C of the guide on body 2. Body 2 along
//! d, then link 1 about A:
//!
//! ```text
//! f_C·d = −F_2·d,    f_C·n = (M_1 + e f_C·d) / u,
//! ```
//!
//! then N = −(f_C + F_2)·n, K = −M_2, f_A = f_C − F_1.

use super::Gap;
use crate::math::{Scalar, V2, Vec2};

/// Where link and slider are.
#[derive(Clone, Copy, Debug)]
pub struct Position<S> {
    /// The inner revolute C, m.
    pub p_C: V2<S>,
    /// C − A, m, accurate relative to its own length.
    pub r_1: V2<S>,
    /// Coordinate of C along the guide from Q, m.
    pub s: S,
    /// 1 / u, 1/m; not finite where the link stands across the guide.
    pub inverse: S,
    /// u / l; positive when C is ahead of A along d.
    pub conditioning: S,
    /// l − |e|, m; ≥ 0 when the link reaches the path of C.
    pub closure: S,
}

/// Position of link and slider.
/// # Given
/// `p_A` outer revolute, m; `l` = AC, m, > 0; `p_Q` point of the guide, m, `d` its unit direction; `h` offset
/// of C to the left of the guide, m; `root` +1 with C ahead of A along d, −1 behind.
/// # Returns
/// See [`Position`]. Where the link does not reach, C is the point of its path nearest to A.
/// # Method
/// Circle ∩ line, the radicand as a product.
#[inline(always)]
pub fn position<S: Scalar>(p_A: V2<S>, l: S, p_Q: V2<S>, d: V2<S>, h: S, root: S) -> Position<S> {
    let q = p_A - p_Q;
    let across = h - d.cross(q);
    let along = root * ((l - across) * (l + across)).max(S::zero()).sqrt();
    let r_1 = d * along + d.perp() * across;
    Position {
        p_C: p_A + r_1,
        r_1,
        s: q.dot(d) + along,
        inverse: S::one() / along,
        conditioning: along / l,
        closure: l - across.abs(),
    }
}

/// By how much the link does not reach the path of C, m; `None` when it does.
/// # Given
/// As for [`position`].
#[cold]
#[must_use]
pub fn gap(p_A: Vec2, l: f64, p_Q: Vec2, d: Vec2, h: f64) -> Option<Gap> {
    let missing = (h - d.cross(p_A - p_Q)).abs() - l;
    (missing > 0.0).then_some(Gap::TooFar(missing))
}

/// The group in one position: what velocity, acceleration and reactions share.
#[derive(Clone, Copy, Debug)]
pub struct Rrp<S> {
    /// C − A, m.
    pub r_1: V2<S>,
    /// Unit direction of the guide.
    pub d: V2<S>,
    /// 1 / u = 1 / (r_1·d), 1/m.
    pub inverse: S,
}

/// Forces in the pairs.
#[derive(Clone, Copy, Debug)]
pub struct Reactions<S> {
    /// On link 1 at A, N.
    pub f_A: V2<S>,
    /// Of link 1 on body 2 at C, N.
    pub f_C: V2<S>,
    /// Normal force N of the guide on body 2, along n through C, N.
    pub normal: S,
    /// Couple K of the guide on body 2 about C, N m.
    pub couple: S,
}

impl<S: Scalar> Rrp<S> {
    /// The group in one position.
    /// # Given
    /// `r_1` = C − A, m; `d` unit direction of the guide, not at right angles to it.
    #[inline(always)]
    pub fn new(r_1: V2<S>, d: V2<S>) -> Self {
        Self { r_1, d, inverse: S::one() / r_1.dot(d) }
    }

    /// Angular velocity of link 1 and velocity along the guide, (ω_1, ṡ).
    /// # Given
    /// `v_A` velocity of A; `v_G` velocity of the point of the guide's body under C, m/s.
    #[inline(always)]
    pub fn velocity(&self, v_A: V2<S>, v_G: V2<S>) -> (S, S) {
        self.solve(v_G - v_A)
    }

    /// Angular acceleration of link 1 and acceleration along the guide, (α_1, s̈).
    /// # Given
    /// `omega_1`, `s_dot` from [`Rrp::velocity`]; `a_A` acceleration of A; `a_G` acceleration of the point of
    /// the guide's body under C, m/s²; `omega_g` angular velocity of that body, rad/s.
    #[inline(always)]
    pub fn acceleration(&self, omega_1: S, s_dot: S, a_A: V2<S>, a_G: V2<S>, omega_g: S) -> (S, S) {
        let coriolis = self.d.perp() * (S::of(2.0) * omega_g * s_dot);
        self.solve(a_G - a_A + coriolis + self.r_1 * (omega_1 * omega_1))
    }

    /// x perp(r_1) − y d = b.
    #[inline(always)]
    fn solve(&self, b: V2<S>) -> (S, S) {
        let x = self.d.cross(b) * self.inverse;
        (x, -(x * self.d.cross(self.r_1)) - b.dot(self.d))
    }

    /// Forces in the pairs.
    /// # Given
    /// `F_1`, `F_2` applied and inertia forces, N; `M_1` moment of the first about A, `M_2` of the second
    /// about C, N m.
    #[inline(always)]
    pub fn reactions(&self, F_1: V2<S>, M_1: S, F_2: V2<S>, M_2: S) -> Reactions<S> {
        let (d, n) = (self.d, self.d.perp());
        let along = -F_2.dot(d);
        let across = (M_1 + self.r_1.dot(n) * along) * self.inverse;
        let f_C = d * along + n * across;
        Reactions { f_A: f_C - F_1, f_C, normal: -across - F_2.dot(n), couple: -M_2 }
    }
}
