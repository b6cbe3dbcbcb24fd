//! Laws of wheels between the bodies of a group: Σ c_i q_i = value, each q_i the angle of a body or the coordinate of a
//! point along a line, with constant coefficients.
//!
//! An angle is counted with its whole turns: from a known angle in a known direction near by, both set before a position is
//! sought. λ is the multiplier: the couple on a body is λ c_i, the force on a point along its line too.

use super::constraint::{Line, Point, Row, on_line};
use super::{Acceleration, Load, Pose, Velocity};
use crate::math::Vec2;

/// Angles may leave (−π, π] by rounding.
const BEYOND: f64 = 1e-9;

/// A law between the motions of any number of bodies.
#[derive(Clone, Debug)]
pub struct Gearing {
    pub terms: Vec<GearTerm>,
    /// The sum, in the unit of coefficients times coordinates.
    pub value: f64,
    /// What makes its row a length of the group's size.
    weight: f64,
}

/// A coordinate with its coefficient.
#[derive(Clone, Copy, Debug)]
pub struct GearTerm {
    pub of: Geared,
    pub coefficient: f64,
}

/// A coordinate that a law speaks of.
#[derive(Clone, Copy, Debug)]
pub enum Geared {
    /// The angle of a body: `angle` where its direction is `near`, within half a turn of it.
    Turn {
        body: usize,
        /// A direction near by.
        near: Vec2,
        /// The angle of that direction with its whole turns, rad.
        angle: f64,
    },
    /// The coordinate of a point along a line.
    Slide { point: Point, line: Line },
}

impl Geared {
    /// The angle of a body.
    #[must_use]
    pub const fn turn(body: usize) -> Self {
        Self::Turn { body, near: Vec2::new(1.0, 0.0), angle: 0.0 }
    }

    fn value(&self, poses: &[Pose]) -> f64 {
        match self {
            Self::Turn { body, near, angle } => angle + poses[*body].u.turned_back(*near).angle(),
            Self::Slide { .. } => self.row(poses).map_or(0.0, |row| row.residual),
        }
    }

    /// The row of a coordinate along a line.
    fn row(&self, poses: &[Pose]) -> Option<Row> {
        match *self {
            Self::Turn { .. } => None,
            Self::Slide { point, line } => {
                Some(on_line(point, line, line.d.turned(poses[line.body].u), 0.0, poses))
            }
        }
    }

    fn bodies(&self) -> [usize; 2] {
        match self {
            Self::Turn { body, .. } => [*body; 2],
            Self::Slide { point, line } => [point.body, line.body],
        }
    }
}

impl Gearing {
    /// The law Σ c_i q_i = `value`.
    #[must_use]
    pub const fn new(terms: Vec<GearTerm>, value: f64) -> Self {
        Self { terms, value, weight: 1.0 }
    }

    /// Whether all bodies that it speaks of are there.
    pub(super) fn is_within(&self, bodies: usize) -> bool {
        self.terms.iter().all(|t| t.of.bodies().iter().all(|&b| b < bodies))
    }

    /// The greatest local coordinate, m.
    pub(super) fn extent(&self) -> f64 {
        let extent = |t: &GearTerm| match t.of {
            Geared::Turn { .. } => 0.0,
            Geared::Slide { point, line } => point.r.norm().max(line.r.norm()),
        };
        self.terms.iter().map(extent).fold(0.0, f64::max)
    }

    /// Weighs the row in a group of this length: its greatest coefficient becomes 1.
    pub(super) fn weigh(&mut self, length: f64) {
        let size = |t: &GearTerm| match t.of {
            Geared::Turn { .. } => t.coefficient.abs() / length,
            Geared::Slide { .. } => t.coefficient.abs(),
        };
        let greatest = self.terms.iter().map(size).fold(0.0, f64::max);
        self.weight = if greatest > 0.0 { 1.0 / greatest } else { 1.0 };
    }

    /// What the multiplier is per unit of the solved unknown.
    pub(super) fn weight(&self) -> f64 {
        self.weight
    }

    /// By how much it does not hold, m.
    pub(super) fn residual(&self, poses: &[Pose]) -> f64 {
        let sum: f64 = self.terms.iter().map(|t| t.coefficient * t.of.value(poses)).sum();
        (sum - self.value) * self.weight
    }

    /// The greatest of its terms: what rounding is relative to, m.
    pub(super) fn size(&self) -> f64 {
        let size = |t: &GearTerm| match t.of {
            Geared::Turn { angle, .. } => (t.coefficient * angle).abs(),
            Geared::Slide { .. } => 0.0,
        };
        self.terms.iter().map(size).fold(self.value.abs(), f64::max) * self.weight
    }

    /// Enters the row into the Jacobian.
    pub(super) fn enter(&self, poses: &[Pose], moving: usize, length: f64, line: &mut [f64]) {
        for term in &self.terms {
            let c = term.coefficient * self.weight;
            let mut add = |body: usize, g: Vec2, moment: f64| {
                if body < moving {
                    line[3 * body] += c * g.x;
                    line[3 * body + 1] += c * g.y;
                    line[3 * body + 2] += c * moment / length;
                }
            };
            match (term.of, term.of.row(poses)) {
                (Geared::Turn { body, .. }, _) => add(body, Vec2::zero(), 1.0),
                (_, Some(row)) => {
                    add(row.a, row.g, row.r_a.cross(row.g));
                    add(row.b, -row.g, -row.r_b.cross(row.g));
                }
                (_, None) => {}
            }
        }
    }

    /// What the known bodies contribute to its rate, with the opposite sign.
    pub(super) fn rate(&self, moving: usize, poses: &[Pose], velocities: &[Velocity]) -> f64 {
        let known = |body: usize, x: f64| if body < moving { 0.0 } else { x };
        let rate = |t: &GearTerm| match (t.of, t.of.row(poses)) {
            (Geared::Turn { body, .. }, _) => known(body, velocities[body].omega),
            (_, Some(row)) => {
                let (a, b) = row.times_velocity(&velocities[row.a], &velocities[row.b]);
                known(row.a, a) + known(row.b, b)
            }
            (_, None) => 0.0,
        };
        -self.terms.iter().map(|t| t.coefficient * rate(t)).sum::<f64>() * self.weight
    }

    /// What the known bodies and the velocities contribute to its second rate, with the opposite sign.
    pub(super) fn second(
        &self,
        moving: usize,
        poses: &[Pose],
        velocities: &[Velocity],
        accelerations: &[Acceleration],
    ) -> f64 {
        let known = |body: usize, x: f64| if body < moving { 0.0 } else { x };
        let second = |t: &GearTerm| match (t.of, t.of.row(poses)) {
            (Geared::Turn { body, .. }, _) => known(body, accelerations[body].alpha),
            (_, Some(row)) => {
                let (a, b) = row.times_acceleration(&accelerations[row.a], &accelerations[row.b]);
                known(row.a, a) + known(row.b, b) - row.along_line(velocities)
            }
            (_, None) => 0.0,
        };
        -self.terms.iter().map(|t| t.coefficient * second(t)).sum::<f64>() * self.weight
    }

    /// How the row changes from place to place: a bound of its second derivative, as the certificate needs it.
    pub(super) fn bend(&self, moving: usize, length: f64, poses: &[Pose]) -> f64 {
        let bend = |t: &GearTerm| match t.of.row(poses) {
            Some(row) => t.coefficient.abs() * row.bend(moving, length),
            None => 0.0,
        };
        self.terms.iter().map(bend).sum::<f64>() * self.weight
    }

    /// What a multiplier exerts on a body, about its origin.
    pub(super) fn exerted_on(&self, body: usize, lambda: f64, poses: &[Pose]) -> Load {
        let mut sum = Load::default();
        for term in &self.terms {
            let x = lambda * term.coefficient;
            match (term.of, term.of.row(poses)) {
                (Geared::Turn { body: own, .. }, _) if own == body => sum.M += x,
                (_, Some(row)) => {
                    for (own, r, sign) in [(row.a, row.r_a, x), (row.b, row.r_b, -x)] {
                        if own == body {
                            sum.F += row.g * sign;
                            sum.M += r.cross(row.g) * sign;
                        }
                    }
                }
                _ => {}
            }
        }
        sum
    }

    /// Counts the angles of the group's bodies from where they stand, between −π and π.
    pub(super) fn count_from(&mut self, moving: usize, poses: &[Pose]) {
        for term in &mut self.terms {
            if let Geared::Turn { body, near, angle } = &mut term.of
                && *body < moving
            {
                (*near, *angle) = (poses[*body].u, poses[*body].u.angle());
            }
        }
    }

    /// Whether the angles of the group's bodies lie between −π and π.
    pub(super) fn is_principal(&self, moving: usize, poses: &[Pose]) -> bool {
        let within = |t: &GearTerm| match t.of {
            Geared::Turn { body, .. } if body < moving => {
                t.of.value(poses).abs() <= std::f64::consts::PI + BEYOND
            }
            _ => true,
        };
        self.terms.iter().all(within)
    }
}
