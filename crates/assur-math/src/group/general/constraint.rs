//! Constraints between two bodies, and the scalar rows they consist of.

use super::{Acceleration, Pose, Velocity};
use crate::math::{Vec2, acceleration_at, velocity_at};

/// A point of a body.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    pub body: usize,
    /// The point in the body's frame, m.
    pub r: Vec2,
}

/// A line of a body.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    pub body: usize,
    /// Its origin in the body's frame, m.
    pub r: Vec2,
    /// Its unit direction in the body's frame.
    pub d: Vec2,
}

/// A given value with its rate and second rate.
#[derive(Clone, Copy, Debug, Default)]
pub struct Law {
    /// Value, m.
    pub value: f64,
    /// Rate, m/s or rad/s.
    pub rate: f64,
    /// Second rate, m/s² or rad/s².
    pub second: f64,
}

/// What joins two bodies. Bodies are named by their place in the slice of poses.
#[derive(Clone, Copy, Debug)]
pub enum Constraint {
    /// Two points coincide. λ: the force on the body of `a`, in two components.
    Revolute {
        /// A point of one body.
        a: Point,
        /// A point of the other.
        b: Point,
    },
    /// The direction of `b` is that of `a` turned by `angle`. λ: the couple on `b`.
    Angle {
        /// The body from which the angle is measured.
        a: usize,
        /// The body to which it is measured.
        b: usize,
        /// (cos, sin) of the angle.
        angle: Vec2,
        /// Its rate, rad/s.
        rate: f64,
        /// Its second rate, rad/s².
        second: f64,
    },
    /// A point keeps an offset to the left of a line. λ: the force on its body, along the line's left normal.
    Offset {
        point: Point,
        line: Line,
        /// Offset, m.
        law: Law,
    },
    /// A point has a given coordinate along a line. λ: the force on its body, along the line.
    Coordinate {
        point: Point,
        line: Line,
        /// Coordinate from the line's origin, m.
        law: Law,
    },
    /// Two points have a given distance. λ: the force on the body of `a`, away from `b`.
    Distance {
        /// A point of one body.
        a: Point,
        /// A point of the other.
        b: Point,
        /// Distance, m, > 0.
        law: Law,
    },
}

/// One scalar constraint in one position.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    pub a: usize,
    pub b: usize,
    /// Unit direction of the force, null for a couple.
    pub g: Vec2,
    /// Arms of the force from the origins of the two bodies.
    pub r_a: Vec2,
    pub r_b: Vec2,
    /// Whether it is of an angle, not of a length.
    pub couple: bool,
    /// Factor of ω_b − ω_a.
    pub turn: f64,
    /// φ less its value: m, or for an angle its chord 2 sin(half the error).
    pub residual: f64,
}

impl Constraint {
    /// The constant angle between body `a` and body `b` for which the local direction `d_a` of the one and `d_b` of
    /// the other are the same.
    #[must_use]
    pub fn parallel(a: usize, d_a: Vec2, b: usize, d_b: Vec2) -> Self {
        Self::Angle { a, b, angle: d_a.turned_back(d_b), rate: 0.0, second: 0.0 }
    }

    /// The two bodies it joins.
    #[must_use]
    pub fn bodies(&self) -> [usize; 2] {
        match self {
            Self::Revolute { a, b } | Self::Distance { a, b, .. } => [a.body, b.body],
            Self::Angle { a, b, .. } => [*a, *b],
            Self::Offset { point, line, .. } | Self::Coordinate { point, line, .. } => {
                [point.body, line.body]
            }
        }
    }

    /// Number of scalar constraints.
    #[must_use]
    pub fn rows(&self) -> usize {
        if matches!(self, Self::Revolute { .. }) { 2 } else { 1 }
    }

    /// Where it touches bodies of known motion, which come from the place `moving` on.
    pub(super) fn points_of_known(&self, moving: usize, poses: &[Pose]) -> impl Iterator<Item = Vec2> {
        let points = match *self {
            Self::Revolute { a, b } | Self::Distance { a, b, .. } => {
                [Some((a.body, a.r)), Some((b.body, b.r))]
            }
            Self::Angle { .. } => [None, None],
            Self::Offset { point, line, .. } | Self::Coordinate { point, line, .. } => {
                [Some((point.body, point.r)), Some((line.body, line.r))]
            }
        };
        let known = points.into_iter().flatten().filter(move |&(body, _)| body >= moving);
        known.map(|(body, r)| poses[body].point(r))
    }

    /// The greatest local coordinate or value, m.
    pub(super) fn extent(&self) -> f64 {
        match self {
            Self::Revolute { a, b } => a.r.norm().max(b.r.norm()),
            Self::Angle { .. } => 0.0,
            Self::Offset { point, line, law } | Self::Coordinate { point, line, law } => {
                point.r.norm().max(line.r.norm()).max(law.value.abs())
            }
            Self::Distance { a, b, law } => a.r.norm().max(b.r.norm()).max(law.value.abs()),
        }
    }

    /// Rate and second rate of the value.
    fn law(&self) -> (f64, f64) {
        match *self {
            Self::Revolute { .. } => (0.0, 0.0),
            Self::Angle { rate, second, .. } => (rate, second),
            Self::Offset { law, .. } | Self::Coordinate { law, .. } | Self::Distance { law, .. } => {
                (law.rate, law.second)
            }
        }
    }

    /// The `k`-th scalar constraint.
    pub(super) fn row(&self, k: usize, poses: &[Pose]) -> Row {
        match *self {
            Self::Revolute { a, b } => {
                let g = if k == 0 { Vec2::new(1.0, 0.0) } else { Vec2::new(0.0, 1.0) };
                between(a, b, g, 0.0, poses)
            }
            Self::Angle { a, b, angle, .. } => angle_row(a, b, angle, poses),
            Self::Offset { point, line, law } => {
                on_line(point, line, line.d.turned(poses[line.body].u).perp(), law.value, poses)
            }
            Self::Coordinate { point, line, law } => {
                on_line(point, line, line.d.turned(poses[line.body].u), law.value, poses)
            }
            Self::Distance { a, b, law } => {
                let apart = poses[a.body].point(a.r) - poses[b.body].point(b.r);
                // Coincident points have no direction: a null row, which makes the Jacobian singular.
                between(a, b, apart / apart.norm().max(f64::MIN_POSITIVE), law.value, poses)
            }
        }
    }

    /// φ̇ of the drive.
    pub(super) fn rate(&self) -> f64 {
        self.law().0
    }

    /// φ̈ of the drive plus what the velocities contribute: the row times the accelerations must equal it.
    pub(super) fn second_rate(&self, row: &Row, poses: &[Pose], velocities: &[Velocity]) -> f64 {
        let contributed = match *self {
            Self::Revolute { .. } | Self::Angle { .. } => row.centripetal(velocities),
            Self::Offset { .. } | Self::Coordinate { .. } => row.along_line(velocities),
            Self::Distance { a, b, .. } => {
                let apart = (poses[a.body].point(a.r) - poses[b.body].point(b.r)).norm();
                let across = row.g.cross(row.relative(velocities));
                row.centripetal(velocities) - (across * across) / apart.max(f64::MIN_POSITIVE)
            }
        };
        self.law().1 + contributed
    }
}

impl Row {
    /// What makes a length of the row's residual or rate: 1, and `length` for an angle.
    pub(super) fn weight(&self, length: f64) -> f64 {
        if self.couple { length } else { 1.0 }
    }

    /// g·(ω_a² r_a − ω_b² r_b).
    fn centripetal(&self, velocities: &[Velocity]) -> f64 {
        let (a, b) = (velocities[self.a].omega, velocities[self.b].omega);
        self.g.dot(self.r_a * (a * a) - self.r_b * (b * b))
    }

    /// The velocity of the point of body a from that of body b beneath it.
    fn relative(&self, velocities: &[Velocity]) -> Vec2 {
        let (a, b) = (velocities[self.a], velocities[self.b]);
        velocity_at(a.v, a.omega, self.r_a) - velocity_at(b.v, b.omega, self.r_b)
    }

    /// What the velocities contribute to the second rate of a coordinate of a line of body b.
    pub(super) fn along_line(&self, velocities: &[Velocity]) -> f64 {
        let turning = velocities[self.b].omega;
        self.centripetal(velocities) + 2.0 * turning * self.g.dot(self.relative(velocities).perp())
    }

    /// The row times the velocity of body a, then of body b.
    pub(super) fn times_velocity(&self, a: &Velocity, b: &Velocity) -> (f64, f64) {
        (
            self.g.dot(velocity_at(a.v, a.omega, self.r_a)) - self.turn * a.omega,
            self.turn * b.omega - self.g.dot(velocity_at(b.v, b.omega, self.r_b)),
        )
    }

    /// The row times the acceleration of body a, then of body b.
    pub(super) fn times_acceleration(&self, a: &Acceleration, b: &Acceleration) -> (f64, f64) {
        (
            self.g.dot(acceleration_at(a.a, 0.0, a.alpha, self.r_a)) - self.turn * a.alpha,
            self.turn * b.alpha - self.g.dot(acceleration_at(b.a, 0.0, b.alpha, self.r_b)),
        )
    }
}

/// g·(P_a − P_b) = value, each body moving its own point.
fn between(a: Point, b: Point, g: Vec2, value: f64, poses: &[Pose]) -> Row {
    let (r_a, r_b) = (a.r.turned(poses[a.body].u), b.r.turned(poses[b.body].u));
    let apart = poses[a.body].p - poses[b.body].p + r_a - r_b;
    Row { a: a.body, b: b.body, g, r_a, r_b, couple: false, turn: 0.0, residual: g.dot(apart) - value }
}

/// g·(P − Q) = value with g fixed in the line's body, which moves its point under P.
pub(super) fn on_line(point: Point, line: Line, g: Vec2, value: f64, poses: &[Pose]) -> Row {
    let (a, b) = (&poses[point.body], &poses[line.body]);
    let r_a = point.r.turned(a.u);
    let r_b = a.p + r_a - b.p;
    let apart = r_b - line.r.turned(b.u);
    Row { a: point.body, b: line.body, g, r_a, r_b, couple: false, turn: 0.0, residual: g.dot(apart) - value }
}

/// The error of an angle as its chord, so that no angle is computed and only one direction is a root.
fn angle_row(a: usize, b: usize, angle: Vec2, poses: &[Pose]) -> Row {
    let want = angle.turned(poses[a].u);
    let got = poses[b].u;
    let chord = (got - want).norm();
    let residual = if want.cross(got) < 0.0 { -chord } else { chord };
    let turn = 0.5 * (got + want).norm();
    Row { a, b, g: Vec2::zero(), r_a: Vec2::zero(), r_b: Vec2::zero(), couple: true, turn, residual }
}
