//! RPP: a link hung by a revolute A on a body of known motion, sliding along a line of a body that itself slides on
//! a known guide.
//!
//! Body 2 keeps its point R at the offset h_2 to the left of the guide (point Q, unit direction d_2) and turns with
//! it; it carries a line through R with unit direction d_1. Body 1 slides along that line and turns with it, its
//! revolute A at the offset h_1 to the left. So both directions are known, n_i = perp(d_i), and two coordinates are
//! not:
//!
//! ```text
//! R = Q + s_2 d_2 + h_2 n_2,    A = R + s_1 d_1 + h_1 n_1.
//! ```
//!
//! Position:      s_1 d_1 + s_2 d_2 = A − Q − h_1 n_1 − h_2 n_2.
//!
//! G is the point of the guide's body under A, ω_g the angular velocity of that body, and of bodies 1 and 2.
//! Velocity:      v_A = v_G + ṡ_1 d_1 + ṡ_2 d_2.
//! Acceleration:  a_A = a_G + 2 ω_g × (ṡ_1 d_1 + ṡ_2 d_2) + s̈_1 d_1 + s̈_2 d_2.
//!
//! All three read x_1 d_1 + x_2 d_2 = b. Vector products with d_2 and d_1 leave one unknown each:
//!
//! ```text
//! x_1 = b × d_2 / D,    x_2 = d_1 × b / D,    D = d_1 × d_2 = sin of the angle between the lines.
//! ```
//!
//! D vanishes where the lines are parallel; everywhere else the group closes, in one way.
//!
//! Forces: N_1 along n_1 through A and couple K_1 about A, of body 1 on body 2; N_2 along n_2 through R and couple K_2
//! about R, of the guide on body 2. Body 1 about A, body 2 across d_2, across d_1, and about R:
//!
//! ```text
//! K_1 = M_1,    N_1 = −F_2·d_2 / D,    N_2 = F_2·d_1 / D,    K_2 = −M_2 − M_1 − s_1 N_1,
//! ```
//!
//! then f_A = N_1 n_1 − F_1.

use crate::math::{Scalar, V2};

/// Where the bodies are.
#[derive(Clone, Copy, Debug)]
pub struct Position<S> {
    /// The point R of body 2, m.
    pub p_R: V2<S>,
    /// Coordinate of A along the line of body 2 from R, m.
    pub s_1: S,
    /// Coordinate of R along the guide from Q, m.
    pub s_2: S,
    /// d_1 × d_2.
    pub conditioning: S,
}

/// The group in one position: what position, velocity, acceleration and reactions share.
#[derive(Clone, Copy, Debug)]
pub struct Rpp<S> {
    /// Unit direction of the line of body 2.
    pub d_1: V2<S>,
    /// Unit direction of the guide.
    pub d_2: V2<S>,
    /// 1 / (d_1 × d_2).
    pub inverse: S,
}

/// Forces in the pairs.
#[derive(Clone, Copy, Debug)]
pub struct Reactions<S> {
    /// On body 1 at A, N.
    pub f_A: V2<S>,
    /// Normal force of body 1 on body 2, along n_1 through A, N.
    pub normal_1: S,
    /// Couple of body 1 on body 2 about A, N m.
    pub couple_1: S,
    /// Normal force of the guide on body 2, along n_2 through R, N.
    pub normal_2: S,
    /// Couple of the guide on body 2 about R, N m.
    pub couple_2: S,
}

impl<S: Scalar> Rpp<S> {
    /// The group in one position.
    /// # Given
    /// `d_1`, `d_2` unit directions of the line of body 2 and of the guide, not parallel.
    #[inline(always)]
    pub fn new(d_1: V2<S>, d_2: V2<S>) -> Self {
        Self { d_1, d_2, inverse: S::one() / d_1.cross(d_2) }
    }

    /// Position of the bodies.
    /// # Given
    /// `p_A` outer revolute, m; `h_1` its offset from the line of body 2, m; `p_Q` point of the guide, m; `h_2`
    /// offset of R from the guide, m.
    #[inline(always)]
    pub fn position(&self, p_A: V2<S>, h_1: S, p_Q: V2<S>, h_2: S) -> Position<S> {
        let foot = p_Q + self.d_2.perp() * h_2;
        let (s_1, s_2) = self.solve(p_A - foot - self.d_1.perp() * h_1);
        Position { p_R: foot + self.d_2 * s_2, s_1, s_2, conditioning: self.d_1.cross(self.d_2) }
    }

    /// Velocities along the line and along the guide, (ṡ_1, ṡ_2), m/s.
    /// # Given
    /// `v_A` velocity of A; `v_G` velocity of the point of the guide's body under A, m/s.
    #[inline(always)]
    pub fn velocity(&self, v_A: V2<S>, v_G: V2<S>) -> (S, S) {
        self.solve(v_A - v_G)
    }

    /// Accelerations along the line and along the guide, (s̈_1, s̈_2), m/s².
    /// # Given
    /// `s_dot_1`, `s_dot_2` from [`Rpp::velocity`]; `a_A` acceleration of A; `a_G` acceleration of the point of
    /// the guide's body under A, m/s²; `omega_g` angular velocity of that body, rad/s.
    #[inline(always)]
    pub fn acceleration(&self, s_dot_1: S, s_dot_2: S, a_A: V2<S>, a_G: V2<S>, omega_g: S) -> (S, S) {
        let slide = self.d_1 * s_dot_1 + self.d_2 * s_dot_2;
        self.solve(a_A - a_G - slide.perp() * (S::of(2.0) * omega_g))
    }

    /// x_1 d_1 + x_2 d_2 = b.
    #[inline(always)]
    fn solve(&self, b: V2<S>) -> (S, S) {
        (b.cross(self.d_2) * self.inverse, self.d_1.cross(b) * self.inverse)
    }

    /// Forces in the pairs.
    /// # Given
    /// `s_1` coordinate of A along the line of body 2, m; `F_1`, `F_2` applied and inertia forces, N; `M_1`
    /// moment of the first about A, `M_2` of the second about R, N m.
    #[inline(always)]
    pub fn reactions(&self, s_1: S, F_1: V2<S>, M_1: S, F_2: V2<S>, M_2: S) -> Reactions<S> {
        let normal_1 = -(F_2.dot(self.d_2) * self.inverse);
        Reactions {
            f_A: self.d_1.perp() * normal_1 - F_1,
            normal_1,
            couple_1: M_1,
            normal_2: F_2.dot(self.d_1) * self.inverse,
            couple_2: -M_2 - M_1 - s_1 * normal_1,
        }
    }
}
