//! Whether a position is a solution: the theorem of Newton and Kantorovich.
//!
//! At a position x found, with rounding errors in its residuals φ(x), let β = ‖J⁻¹‖, η ≥ |J⁻¹ φ| and λ a Lipschitz constant
//! of J near by. Where h = β λ η ≤ 1/2 there is a solution within 2η of x, and no other within 1/βλ (Ortega and Rheinboldt,
//! Iterative Solution of Nonlinear Equations in Several Variables, 12.6.2). The norms are those of the greatest component,
//! rows scaled as for the condition figure σ = 1/β, rotations measured in the length L of the group.
//!
//! Constraints are of second degree in positions, cosines and sines. With ρ_a, ρ_b the arms of the points on bodies that
//! move and s their distance, λ of a row is at most
//!
//! ```text
//! revolute                       (|ρ_a| + |ρ_b|) / L²
//! offset, coordinate             the same, and (|s| + |ρ_b|) / L² + 2 (√2 + …) / L where the line moves
//! distance                       the same as a revolute, and the square of how fast the points part, over |s|
//! angle                          0
//! law of wheels                  the sum over its coordinates, 0 of an angle
//! ```
//!
//! The bounds are doubled, for they hold at x and are needed within 2η of it.

use super::constraint::Row;
use super::{Constraint, General, Pose};

/// Rounding errors of a residual, in units of the greatest coordinate.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl General {
    /// The figure h of the position last found: at most 1/2 where there is certainly a solution, and only one near by.
    #[must_use]
    pub fn certificate(&self) -> f64 {
        self.certificate
    }

    /// h of the position whose Jacobian was factored last, with this condition figure.
    /// # Given
    /// `size` greatest coordinate in play, m.
    pub(super) fn certify(&self, condition: f64, size: f64, poses: &[Pose]) -> f64 {
        let rounding = ROUNDING * size;
        let (mut lambda, mut residual, mut i) = (0.0_f64, 0.0_f64, 0);
        for constraint in &self.constraints {
            for row in &self.rows[i..i + constraint.rows()] {
                let scale = self.jacobian.row_scale(i);
                lambda = lambda.max(2.0 * scale * self.second_derivative(constraint, row));
                residual = residual.max(scale * (row.residual.abs() * row.weight(self.length) + rounding));
                i += 1;
            }
        }
        for (i, law) in (i..).zip(&self.laws) {
            let scale = self.jacobian.row_scale(i);
            lambda = lambda.max(2.0 * scale * law.bend(self.moving, self.length, poses));
            residual = residual.max(scale * (law.residual(poses).abs() + rounding));
        }
        let beta = 1.0 / condition;
        let h = beta * lambda * beta * residual;
        // what holds at the position holds within 2η as long as that is short
        if 2.0 * beta * residual <= 1e-3 * self.length { h } else { h.max(1.0) }
    }

    /// A bound of the second derivative of a row along two directions of unit components.
    fn second_derivative(&self, constraint: &Constraint, row: &Row) -> f64 {
        let per = 1.0 / self.length;
        let Reach { moves: [a, b], arms: [arm_a, arm_b] } = row.reach(self.moving, self.length);
        match constraint {
            Constraint::Angle { .. } => 0.0,
            Constraint::Revolute { .. } => (arm_a + arm_b) * per,
            Constraint::Distance { law, .. } => {
                let parting = speed(a, arm_a) + speed(b, arm_b);
                (arm_a + arm_b) * per + 2.0 * parting * parting / law.value.abs().max(f64::MIN_POSITIVE)
            }
            Constraint::Offset { .. } | Constraint::Coordinate { .. } => row.bend(self.moving, self.length),
        }
    }
}

/// Which of a row's bodies move, and their arms in lengths of the group.
struct Reach {
    moves: [f64; 2],
    arms: [f64; 2],
}

/// How fast a point of a body moves in any one direction.
fn speed(moves: f64, arm: f64) -> f64 {
    moves * std::f64::consts::SQRT_2 + arm
}

impl Row {
    fn reach(&self, moving: usize, length: f64) -> Reach {
        let [a, b] = [self.a, self.b].map(|body| f64::from(u8::from(body < moving)));
        Reach { moves: [a, b], arms: [a * self.r_a.norm() / length, b * self.r_b.norm() / length] }
    }

    /// A bound of the second derivative of a point's place along or across a line of body b.
    pub(super) fn bend(&self, moving: usize, length: f64) -> f64 {
        let Reach { moves: [a, b], arms: [arm_a, arm_b] } = self.reach(moving, length);
        // r_b of a line reaches to the point: arm and distance in one
        ((arm_a + 2.0 * arm_b) + 2.0 * b * (speed(a, arm_a) + speed(b, arm_b))) / length
    }
}
