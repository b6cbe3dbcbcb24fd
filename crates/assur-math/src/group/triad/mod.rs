//! Triad: a link on three legs, each a link hung by a revolute or a slider on a guide; the group of class III.
//!
//! The plate carries three revolutes A_i. Leg i is either a link of length l_i between A_i and a revolute O_i on a body
//! of known motion, r_i = A_i − O_i, or a slider that holds A_i on a line of one, through Q_i with the left normal n_i.
//! G is the mean of the A_i on the plate, ρ_i = A_i − G, and ρ² the mean of the ρ_i².
//!
//! Position, see [`position`] and [`modes()`]:
//!
//! ```text
//! φ_i = (|r_i|² − l_i²) / 2l_i = 0,    or    φ_i = n_i·(A_i − Q_i) = 0.
//! ```
//!
//! With d_i = r_i / l_i, or n_i, all derivatives have the same matrix J of the rows (d_i, ρ_i × d_i / ρ):
//!
//! ```text
//! velocity      J (v_G, ρω) = d_i·v_i,                  v_i of O_i, or of the point of the guide that lies at A_i,
//! acceleration  J (a_G, ρα) = d_i·(a_i + ω² ρ_i) + e_i,   e_i = −|v_A − v_O|² / l_i, or 2 ω_g ṡ_i on a guide.
//! ```
//!
//! A slider moves with ṡ_i = −n_i × (v_A − v_g) along its guide, to the right of n_i, and a leg turns with
//! Ω_i = r_i × (v_A − v_O) / l_i²; the second derivatives alike.
//!
//! Forces: f_i is the force of leg i on the plate. Moments of the leg about O_i give r_i × f_i = M_i, so that its part
//! across the leg is M_i / l_i, to the left; balance of a slider along its guide leaves F_i·(direction). A leg hung by a
//! revolute O_i that holds the plate by a guide with the normal n_i puts the moment M_i on it beside a force along n_i
//! through O_i, which stands for A_i. These parts are known, and the parts N_i along d_i follow from the balance of the plate:
//!
//! ```text
//! Jᵀ N = −(F, M / ρ) − Σ (known part, its moment about G / ρ).
//! ```
//!
//! det J vanishes where the lines through A_i along d_i meet in a point or are parallel: the plate could turn about that
//! point. The condition figure is 3 det J / (‖J‖ ‖adj J‖) in Frobenius' norm: 1 where the singular values of J are alike,
//! the same in all axes; its sign is that of det J, which is kept in the motion from one dead position to the next.
//!
//! Source: J.-P. Merlet, Parallel Robots, 2nd ed., sections 4.4 and 5 (planar 3-RRR: sextic, Jacobian, singularities); the
//! forms here are derived anew.

pub mod modes;
pub mod position;

pub use modes::modes;
pub use modes::{Miss, gap};
pub use position::{End, Followed, Plate};

use crate::math::{Scalar, V2};

/// The group in one position: what velocity, acceleration and reactions share.
#[derive(Clone, Copy, Debug)]
pub struct Triad<S> {
    /// Directions of the legs' forces: d_i.
    pub d: [V2<S>; 3],
    /// A_i − G, m.
    pub arms: [V2<S>; 3],
    /// adj J: its columns are vector products of the rows of J.
    adjugate: [[S; 3]; 3],
    /// 1 / det J.
    inverse: S,
    /// 1 / ρ, 1/m.
    per_length: S,
    /// The signed condition figure.
    pub conditioning: S,
}

impl<S: Scalar> Triad<S> {
    /// The group in one position.
    /// # Given
    /// `d` directions of the legs' forces; `arms` = A_i − G, m; `length` = ρ, m, > 0.
    #[inline(always)]
    pub fn new(d: [V2<S>; 3], arms: [V2<S>; 3], length: S) -> Self {
        let per_length = S::one() / length;
        let row = |i: usize| [d[i].x, d[i].y, arms[i].cross(d[i]) * per_length];
        let rows = [row(0), row(1), row(2)];
        let adjugate = [cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])];
        let determinant = dot(rows[0], adjugate[0]);
        let sum = |m: &[[S; 3]; 3]| dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2]);
        let norms = (sum(&rows) * sum(&adjugate)).sqrt().max(S::of(f64::MIN_POSITIVE));
        Self {
            d,
            arms,
            adjugate,
            inverse: S::one() / determinant,
            per_length,
            conditioning: S::of(3.0) * determinant / norms,
        }
    }

    /// J x = b.
    #[inline(always)]
    fn solve(&self, b: [S; 3]) -> [S; 3] {
        let [p, q, r] = &self.adjugate;
        [0, 1, 2].map(|k| (p[k] * b[0] + q[k] * b[1] + r[k] * b[2]) * self.inverse)
    }

    /// Frobenius' norm of J⁻¹.
    #[inline(always)]
    fn inverse_norm(&self) -> S {
        let [p, q, r] = self.adjugate;
        (dot(p, p) + dot(q, q) + dot(r, r)).sqrt() * self.inverse.abs()
    }

    /// Velocity of G, m/s, and angular velocity of the plate, rad/s.
    /// # Given
    /// `along` = d_i·v_i, m/s.
    #[inline(always)]
    pub fn velocity(&self, along: [S; 3]) -> (V2<S>, S) {
        let [x, y, turn] = self.solve(along);
        (V2::new(x, y), turn * self.per_length)
    }

    /// Acceleration of G, m/s², and angular acceleration of the plate, rad/s².
    /// # Given
    /// `omega` of the plate, rad/s; `along` = d_i·a_i + e_i, m/s².
    #[inline(always)]
    pub fn acceleration(&self, omega: S, along: [S; 3]) -> (V2<S>, S) {
        let square = omega * omega;
        let [x, y, turn] = self.solve([0, 1, 2].map(|i| along[i] + square * self.d[i].dot(self.arms[i])));
        (V2::new(x, y), turn * self.per_length)
    }

    /// Forces of the legs on the plate, N.
    /// # Given
    /// `F`, `M` loads on the plate, the moment about G, N and N m; `known` parts of the legs' forces, across d_i, N.
    #[inline(always)]
    pub fn reactions(&self, F: V2<S>, M: S, known: [V2<S>; 3]) -> [V2<S>; 3] {
        let force = F + known[0] + known[1] + known[2];
        let moment = (0..3).fold(M, |sum, i| sum + self.arms[i].cross(known[i]));
        let load = [force.x, force.y, moment * self.per_length];
        [0, 1, 2].map(|i| known[i] - self.d[i] * (dot(self.adjugate[i], load) * self.inverse))
    }
}

#[inline(always)]
fn dot<S: Scalar>(a: [S; 3], b: [S; 3]) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<S: Scalar>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
