//! What the tests of the groups share: random geometry, differences in time, brute-force linear solves.

use assur_math::math::{Vec2, acceleration_at, velocity_at};

/// A small deterministic generator (SplitMix64).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x5851_f42d_4c95_7f2d))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.next() >> 11) as f64 * (0.5f64).powi(53))
    }

    pub fn sign(&mut self) -> f64 {
        if self.next() & 1 == 0 { 1.0 } else { -1.0 }
    }

    pub fn vector(&mut self, size: f64) -> Vec2 {
        Vec2::new(self.within(-size, size), self.within(-size, size))
    }

    /// A unit vector.
    pub fn direction(&mut self) -> Vec2 {
        Vec2::direction(self.within(-3.0, 3.0))
    }

    /// A force and a moment.
    pub fn wrench(&mut self) -> (Vec2, f64) {
        (self.vector(100.0), self.within(-50.0, 50.0))
    }
}

/// A point with constant acceleration: p + v t + a t²/2.
pub struct Path(Vec2, Vec2, Vec2);

impl Path {
    pub fn random(random: &mut Random) -> Self {
        Self(random.vector(2.0), random.vector(3.0), random.vector(4.0))
    }
    pub fn at(&self, t: f64) -> Vec2 {
        self.0 + self.1 * t + self.2 * (t * t / 2.0)
    }
    pub fn velocity(&self) -> Vec2 {
        self.1
    }
    pub fn acceleration(&self) -> Vec2 {
        self.2
    }
}

/// Step of the differences, s.
const STEP: f64 = 1e-4;

/// d/dt at 0, to fourth order.
pub fn rate(f: impl Fn(f64) -> Vec2) -> Vec2 {
    ((f(STEP) - f(-STEP)) * 8.0 - (f(2.0 * STEP) - f(-2.0 * STEP))) / (12.0 * STEP)
}

/// d²/dt² at 0, to fourth order.
pub fn second_rate(f: impl Fn(f64) -> Vec2) -> Vec2 {
    let h = 10.0 * STEP;
    ((f(h) + f(-h)) * 16.0 - (f(2.0 * h) + f(-2.0 * h)) - f(0.0) * 30.0) / (12.0 * h * h)
}

/// Angular velocity of a vector at 0.
pub fn rate_of_direction(f: impl Fn(f64) -> Vec2) -> f64 {
    let r = f(0.0);
    r.cross(rate(f)) / r.dot(r)
}

/// The unknowns x of `rows` x + `loads` = 0.
pub fn equilibrium(rows: &[&[f64]], loads: &[f64]) -> Vec<f64> {
    let n = rows.len();
    let matrix = nalgebra::DMatrix::from_fn(n, n, |i, j| rows[i][j]);
    let load = nalgebra::DVector::from_fn(n, |i, _| -loads[i]);
    matrix.full_piv_lu().solve(&load).expect("a regular test").iter().copied().collect()
}

/// Asserts |got − want| ≤ tolerance · scale.
#[track_caller]
pub fn close(got: f64, want: f64, tolerance: f64, scale: f64) {
    let error = (got - want).abs();
    assert!(error <= tolerance * scale, "{got} is not {want}: off by {error:e}, scale {scale:e}");
}

/// A body whose origin moves on a path and which turns with constant angular acceleration.
pub struct Body {
    origin: Path,
    angle: f64,
    pub omega: f64,
    pub alpha: f64,
}

impl Body {
    pub fn random(random: &mut Random) -> Self {
        Self {
            origin: Path::random(random),
            angle: random.within(-3.0, 3.0),
            omega: random.within(-2.0, 2.0),
            alpha: random.within(-2.0, 2.0),
        }
    }
    /// The same path, turning with `other` at a constant angle to it.
    pub fn turning_with(self, other: &Body, angle: f64) -> Self {
        Self { origin: self.origin, angle: other.angle + angle, omega: other.omega, alpha: other.alpha }
    }
    pub fn origin(&self, t: f64) -> Vec2 {
        self.origin.at(t)
    }
    /// Its x axis.
    pub fn direction(&self, t: f64) -> Vec2 {
        Vec2::direction(self.angle + self.omega * t + self.alpha * (t * t / 2.0))
    }
    /// Velocity and acceleration at time 0 of its point that is at `p` then.
    pub fn motion_at(&self, p: Vec2) -> (Vec2, Vec2) {
        let r = p - self.origin(0.0);
        (
            velocity_at(self.origin.velocity(), self.omega, r),
            acceleration_at(self.origin.acceleration(), self.omega, self.alpha, r),
        )
    }
}
