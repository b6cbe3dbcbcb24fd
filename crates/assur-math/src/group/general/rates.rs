//! Velocities, accelerations and reactions of a general group, all with the Jacobian that was factored last.

use super::{Acceleration, General, Load, Pose, Velocity};
use crate::math::Vec2;

impl General {
    /// Velocities of the group's bodies.
    /// # Given
    /// `velocities` of all bodies; those of the known ones are read, those of the group written. The Jacobian
    /// stands factored, by [`General::position`] or [`General::factor`], at `poses`.
    pub fn velocity(&mut self, poses: &[Pose], velocities: &mut [Velocity]) {
        let mut right = std::mem::take(&mut self.step);
        let mut i = 0;
        for c in &self.constraints {
            for row in &self.rows[i..i + c.rows()] {
                let (a, b) = row.times_velocity(&velocities[row.a], &velocities[row.b]);
                let known = self.known(row.a, a) + self.known(row.b, b);
                right[i] = (c.rate() - known) * row.weight(self.length);
                i += 1;
            }
        }
        for (right, law) in right[i..].iter_mut().zip(&self.laws) {
            *right = law.rate(self.moving, poses, velocities);
        }
        self.jacobian.solve(&mut right);
        for (velocity, x) in velocities.iter_mut().zip(right.chunks_exact(3)) {
            *velocity = Velocity { v: Vec2::new(x[0], x[1]), omega: x[2] / self.length };
        }
        self.step = right;
    }

    /// Accelerations of the group's bodies.
    /// # Given
    /// `poses`, `velocities` of all bodies; `accelerations` of all, read and written as in
    /// [`General::velocity`].
    pub fn acceleration(
        &mut self,
        poses: &[Pose],
        velocities: &[Velocity],
        accelerations: &mut [Acceleration],
    ) {
        let mut right = std::mem::take(&mut self.step);
        let mut i = 0;
        for c in &self.constraints {
            for row in &self.rows[i..i + c.rows()] {
                let (a, b) = row.times_acceleration(&accelerations[row.a], &accelerations[row.b]);
                let known = self.known(row.a, a) + self.known(row.b, b);
                let second = c.second_rate(row, poses, velocities);
                right[i] = (second - known) * row.weight(self.length);
                i += 1;
            }
        }
        for (right, law) in right[i..].iter_mut().zip(&self.laws) {
            *right = law.second(self.moving, poses, velocities, accelerations);
        }
        self.jacobian.solve(&mut right);
        for (acceleration, x) in accelerations.iter_mut().zip(right.chunks_exact(3)) {
            *acceleration = Acceleration { a: Vec2::new(x[0], x[1]), alpha: x[2] / self.length };
        }
        self.step = right;
    }

    /// `x` for a body of known motion, nothing for one of the group.
    fn known(&self, body: usize, x: f64) -> f64 {
        if body < self.moving { 0.0 } else { x }
    }

    /// Reactions and efforts.
    /// # Given
    /// `loads` applied and inertia forces on the group's bodies about their origins; `lambda` room for one
    /// number per scalar constraint.
    /// # Returns
    /// In `lambda`, in the order of the constraints: what each exerts, N or N m, as [`super::Constraint`]
    /// says; then the multipliers of the laws.
    pub fn reactions(&mut self, loads: &[Load], lambda: &mut [f64]) {
        for (load, x) in loads.iter().zip(lambda.chunks_exact_mut(3)) {
            x.copy_from_slice(&[-load.F.x, -load.F.y, -load.M / self.length]);
        }
        self.jacobian.solve_transposed(lambda);
        for (x, row) in lambda.iter_mut().zip(&self.rows) {
            *x *= row.weight(self.length);
        }
        for (x, law) in lambda[self.rows.len()..].iter_mut().zip(&self.laws) {
            *x *= law.weight();
        }
    }

    /// What the constraints exert on body `body`, about its origin: for a known body the force on the rest of the
    /// mechanism's side of the joint.
    /// # Given
    /// `lambda` from [`General::reactions`].
    #[must_use]
    pub fn exerted_on(&self, poses: &[Pose], body: usize, lambda: &[f64]) -> Load {
        let mut sum = Load::default();
        for (row, &x) in self.rows.iter().zip(lambda) {
            if row.a == body {
                sum.F += row.g * x;
                sum.M += row.r_a.cross(row.g) * x - row.turn * x;
            }
            if row.b == body {
                sum.F -= row.g * x;
                sum.M += row.turn * x - row.r_b.cross(row.g) * x;
            }
        }
        for (law, &x) in self.laws.iter().zip(lambda.iter().skip(self.rows.len())) {
            let load = law.exerted_on(body, x, poses);
            sum.F += load.F;
            sum.M += load.M;
        }
        sum
    }
}
