//! PRP: two sliders, each on a guide of a body of known motion, joined by a revolute C.
//!
//! Guide i is the line through Q_i with unit direction d_i and left normal n_i = perp(d_i); C keeps the offset h_i to
//! its left: C = Q_i + s_i d_i + h_i n_i. Body i turns with guide i.
//!
//! Position: with c = (Q_2 + h_2 n_2) − (Q_1 + h_1 n_1),
//!
//! ```text
//! s_1 d_1 − s_2 d_2 = c.
//! ```
//!
//! G_i is the point of guide i's body under C, ω_i the angular velocity of that body.
//! Velocity:      v_G1 + ṡ_1 d_1 = v_G2 + ṡ_2 d_2.
//! Acceleration:  a_G1 + 2 ω_1 ṡ_1 n_1 + s̈_1 d_1 = a_G2 + 2 ω_2 ṡ_2 n_2 + s̈_2 d_2.
//!
//! All three read x_1 d_1 − x_2 d_2 = b. Vector products with d_2 and d_1 leave one unknown each:
//!
//! ```text
//! x_1 = b × d_2 / D,    x_2 = b × d_1 / D,    D = d_1 × d_2 = sin of the angle between the guides.
//! ```
//!
//! D vanishes where the guides are parallel; everywhere else the group closes, in one way.
//!
//! Forces: f_C of body 1 on body 2, normal force N_i along n_i and couple K_i about C of guide i on body i. Each body
//! along its guide:
//!
//! ```text
//! f_C·d_1 = F_1·d_1,   f_C·d_2 = −F_2·d_2    ⇒    f_C = −((F_2·d_2) n_1 + (F_1·d_1) n_2) / D,
//! ```
//!
//! then N_1 = (f_C − F_1)·n_1, N_2 = −(f_C + F_2)·n_2, K_i = −M_i.

use crate::math::{Scalar, V2};

/// Where the sliders are.
#[derive(Clone, Copy, Debug)]
pub struct Position<S> {
    /// The revolute C, m.
    pub p_C: V2<S>,
    /// Coordinate of C along guide 1 from Q_1, m.
    pub s_1: S,
    /// Coordinate of C along guide 2 from Q_2, m.
    pub s_2: S,
    /// d_1 × d_2.
    pub conditioning: S,
}

/// The group in one position: what position, velocity, acceleration and reactions share.
#[derive(Clone, Copy, Debug)]
pub struct Prp<S> {
    /// Unit direction of guide 1.
    pub d_1: V2<S>,
    /// Unit direction of guide 2.
    pub d_2: V2<S>,
    /// 1 / (d_1 × d_2).
    pub inverse: S,
}

/// Forces in the pairs.
#[derive(Clone, Copy, Debug)]
pub struct Reactions<S> {
    /// Of body 1 on body 2 at C, N.
    pub f_C: V2<S>,
    /// Normal force of guide 1 on body 1, along n_1 through C, N.
    pub normal_1: S,
    /// Couple of guide 1 on body 1 about C, N m.
    pub couple_1: S,
    /// Normal force of guide 2 on body 2, along n_2 through C, N.
    pub normal_2: S,
    /// Couple of guide 2 on body 2 about C, N m.
    pub couple_2: S,
}

impl<S: Scalar> Prp<S> {
    /// The group in one position.
    /// # Given
    /// `d_1`, `d_2` unit directions of the guides, not parallel.
    #[inline(always)]
    pub fn new(d_1: V2<S>, d_2: V2<S>) -> Self {
        Self { d_1, d_2, inverse: S::one() / d_1.cross(d_2) }
    }

    /// Position of the sliders.
    /// # Given
    /// `p_Q1`, `p_Q2` points of the guides, m; `h_1`, `h_2` offsets of C to their left, m.
    #[inline(always)]
    pub fn position(&self, p_Q1: V2<S>, h_1: S, p_Q2: V2<S>, h_2: S) -> Position<S> {
        let foot = p_Q1 + self.d_1.perp() * h_1;
        let (s_1, s_2) = self.solve(p_Q2 + self.d_2.perp() * h_2 - foot);
        Position { p_C: foot + self.d_1 * s_1, s_1, s_2, conditioning: self.d_1.cross(self.d_2) }
    }

    /// Velocities along the guides, (ṡ_1, ṡ_2), m/s.
    /// # Given
    /// `v_G1`, `v_G2` velocities of the guides' points under C, m/s.
    #[inline(always)]
    pub fn velocity(&self, v_G1: V2<S>, v_G2: V2<S>) -> (S, S) {
        self.solve(v_G2 - v_G1)
    }

    /// Accelerations along the guides, (s̈_1, s̈_2), m/s².
    /// # Given
    /// `s_dot_1`, `s_dot_2` from [`Prp::velocity`]; `a_G1`, `a_G2` accelerations of the guides' points under C,
    /// m/s²; `omega_1`, `omega_2` angular velocities of the guides, rad/s.
    #[inline(always)]
    pub fn acceleration(
        &self,
        s_dot_1: S,
        a_G1: V2<S>,
        omega_1: S,
        s_dot_2: S,
        a_G2: V2<S>,
        omega_2: S,
    ) -> (S, S) {
        let two = S::of(2.0);
        let coriolis_1 = self.d_1.perp() * (two * omega_1 * s_dot_1);
        let coriolis_2 = self.d_2.perp() * (two * omega_2 * s_dot_2);
        self.solve(a_G2 + coriolis_2 - a_G1 - coriolis_1)
    }

    /// x_1 d_1 − x_2 d_2 = b.
    #[inline(always)]
    fn solve(&self, b: V2<S>) -> (S, S) {
        (b.cross(self.d_2) * self.inverse, b.cross(self.d_1) * self.inverse)
    }

    /// Forces in the pairs.
    /// # Given
    /// `F_1`, `F_2` applied and inertia forces, N; `M_1`, `M_2` their moments about C, N m.
    #[inline(always)]
    pub fn reactions(&self, F_1: V2<S>, M_1: S, F_2: V2<S>, M_2: S) -> Reactions<S> {
        let (n_1, n_2) = (self.d_1.perp(), self.d_2.perp());
        let f_C = -(n_1 * F_2.dot(self.d_2) + n_2 * F_1.dot(self.d_1)) * self.inverse;
        Reactions {
            f_C,
            normal_1: n_1.dot(f_C - F_1),
            couple_1: -M_1,
            normal_2: -n_2.dot(f_C + F_2),
            couple_2: -M_2,
        }
    }
}
