//! Any other group: m bodies under 3m scalar constraints, by Newton's method.
//!
//! A body has a pose: the origin p of its frame and the direction u of its x axis. Constraints join bodies of the
//! group to each other and to bodies of known motion. Each scalar constraint has the form
//!
//! ```text
//! φ(poses) = value(t),    φ̇ = g·(v_a − v_b) + c (ω_b − ω_a),
//! ```
//!
//! v_a and v_b being velocities of the points of the two bodies that coincide at one place of the constraint, so that
//! a row of the Jacobian is the wrench of a unit force g, or of a unit couple, on body a and its opposite on body b:
//!
//! | constraint  | φ                      | g                  | c |
//! | ----------- | ---------------------- | ------------------ | - |
//! | revolute    | P_a − P_b, twice       | x, y axes          | 0 |
//! | angle       | angle from a to b      | 0                  | 1 |
//! | offset      | n·(P_a − Q_b)          | left normal n of b's line | 0 |
//! | coordinate  | d·(P_a − Q_b)          | direction d of b's line   | 0 |
//! | distance    | \|P_a − P_b\|          | unit vector B→A    | 0 |
//!
//! Laws of wheels, Σ c_i q_i = const, join more bodies than two: see `gearing`.
//!
//! Position: J δ = −φ, δ the translations and rotations, repeated. A body is turned by the rational rotation with
//! tan(half angle) = δ_θ / 2 and its direction renormalised. Lengths are measured in a length of the group, so that
//! rows and columns weigh alike. A step turns no body by more than half a radian and must lessen the residual; where
//! Newton's step does not, a regularised one (Levenberg, Marquardt) is tried. What has not converged is not an answer.
//!
//! Velocity:      J q̇ = valuė − (what the known bodies contribute).
//! Acceleration:  J q̈ = valuë + g·(ω_a² r_a − ω_b² r_b) + (2 ω_b g × v_rel on a line, −v_⊥²/|r| for a distance) − …
//!
//! Forces: body i is in balance when the i-th columns give Jᵀ λ = −(F, M). λ_k is the force along g, on body a, or the
//! couple on body b: the reaction of the pair, or the effort of the drive. Balances that stand elsewhere than the
//! drives are a second list of constraints with its own Jacobian at the same poses: `Angle` is a torque between two
//! bodies, `Coordinate` a force along a line.
//!
//! The determinant of J vanishes at the dead positions of the group, and everywhere when constraints are redundant.
//! Its sign is the same throughout one branch. The condition figure is 1 / (‖J‖ ‖J⁻¹‖) of the row-scaled Jacobian.

mod assemblies;
mod constraint;
mod gearing;
mod newton;
mod rates;

pub use assemblies::{InitialGuess, assemblies, assemblies_near, is_never_regular, start_of};
pub use constraint::{Constraint, Law, Line, Point};
pub use gearing::{GearTerm, Geared, Gearing};
pub use newton::{Failure, General};

use crate::math::Vec2;

/// Where a body is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Origin of its frame, m.
    pub p: Vec2,
    /// Direction of its x axis.
    pub u: Vec2,
}

/// Velocity of a body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Velocity {
    /// Of its origin, m/s.
    pub v: Vec2,
    /// Angular velocity, rad/s.
    pub omega: f64,
}

/// Acceleration of a body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Acceleration {
    /// Of its origin, m/s².
    pub a: Vec2,
    /// Angular acceleration, rad/s².
    pub alpha: f64,
}

/// Forces on a body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Load {
    /// Sum, N.
    pub F: Vec2,
    /// Moment about the origin of the body, N m.
    pub M: f64,
}

impl Pose {
    /// Position in the ground of the local point `r`, m.
    #[must_use]
    pub fn point(&self, r: Vec2) -> Vec2 {
        self.p + r.turned(self.u)
    }

    /// Moved by `shift`, m, and turned by the rational rotation of `turn`, rad: exact for small ones to third order.
    #[inline]
    #[must_use]
    pub fn moved(&self, shift: Vec2, turn: f64) -> Self {
        let t = 0.5 * turn;
        let u = self.u + self.u.perp() * turn - self.u * (t * t);
        Self { p: self.p + shift, u: u / u.norm() }
    }

    /// Where the body will be after the time `dt`, s, to second order.
    #[must_use]
    pub fn predicted(&self, velocity: &Velocity, acceleration: &Acceleration, dt: f64) -> Self {
        let half = 0.5 * dt * dt;
        self.moved(velocity.v * dt + acceleration.a * half, velocity.omega * dt + acceleration.alpha * half)
    }
}
