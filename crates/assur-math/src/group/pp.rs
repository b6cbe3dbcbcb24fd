//! PP: one translating body on two guides of known bodies, such as a wedge between two others.
//!
//! Guide i is the line through Q_i with unit direction d_i and left normal n_i; the body's point R keeps the offset
//! h_i to its left. The two pairs fix the orientation twice: the guides' bodies must turn alike, or not at all,
//! and a chain of prismatic pairs counts with 2n = P_L.
//!
//! Position, velocity, acceleration of R on its two guides are those of the revolute of a PRP group, which see:
//!
//! ```text
//! x_1 d_1 − x_2 d_2 = b,    D = d_1 × d_2,
//! ```
//!
//! with one body in place of two. D vanishes where the guides are parallel.
//!
//! Forces: N_i along n_i through R and couple K_i about R, of guide i on the body. Across d_2, across d_1, about R:
//!
//! ```text
//! N_1 = −F·d_2 / D,    N_2 = F·d_1 / D,    K_1 + K_2 = −M.
//! ```
//!
//! How the couple is shared between the guides is not determined.

pub use super::prp::Position;
use super::prp::Prp;
use crate::math::{Scalar, V2};

/// The group in one position: what position, velocity, acceleration and reactions share.
#[derive(Clone, Copy, Debug)]
pub struct Pp<S>(Prp<S>);

/// Forces in the pairs.
#[derive(Clone, Copy, Debug)]
pub struct Reactions<S> {
    /// Normal force of guide 1 on the body, along n_1 through R, N.
    pub normal_1: S,
    /// Normal force of guide 2 on the body, along n_2 through R, N.
    pub normal_2: S,
    /// Sum of the couples of both guides on the body about R, N m.
    pub couple: S,
}

impl<S: Scalar> Pp<S> {
    /// The group in one position.
    /// # Given
    /// `d_1`, `d_2` unit directions of the guides, not parallel.
    #[inline(always)]
    pub fn new(d_1: V2<S>, d_2: V2<S>) -> Self {
        Self(Prp::new(d_1, d_2))
    }

    /// Position of the body; R is `p_C` of the answer.
    /// # Given
    /// `p_Q1`, `p_Q2` points of the guides, m; `h_1`, `h_2` offsets of R to their left, m.
    #[inline(always)]
    pub fn position(&self, p_Q1: V2<S>, h_1: S, p_Q2: V2<S>, h_2: S) -> Position<S> {
        self.0.position(p_Q1, h_1, p_Q2, h_2)
    }

    /// Velocities along the guides, (ṡ_1, ṡ_2), m/s.
    /// # Given
    /// `v_G1`, `v_G2` velocities of the guides' points under R, m/s.
    #[inline(always)]
    pub fn velocity(&self, v_G1: V2<S>, v_G2: V2<S>) -> (S, S) {
        self.0.velocity(v_G1, v_G2)
    }

    /// Accelerations along the guides, (s̈_1, s̈_2), m/s².
    /// # Given
    /// `s_dot_1`, `s_dot_2` from [`Pp::velocity`]; `a_G1`, `a_G2` accelerations of the guides' points under R,
    /// m/s²; `omega` angular velocity of guides and body, rad/s.
    #[inline(always)]
    pub fn acceleration(&self, s_dot_1: S, a_G1: V2<S>, s_dot_2: S, a_G2: V2<S>, omega: S) -> (S, S) {
        self.0.acceleration(s_dot_1, a_G1, omega, s_dot_2, a_G2, omega)
    }

    /// Forces in the pairs.
    /// # Given
    /// `F` applied and inertia forces on the body, N; `M` their moment about R, N m.
    #[inline(always)]
    pub fn reactions(&self, F: V2<S>, M: S) -> Reactions<S> {
        let Prp { d_1, d_2, inverse } = self.0;
        Reactions { normal_1: -(F.dot(d_2) * inverse), normal_2: F.dot(d_1) * inverse, couple: -M }
    }
}
