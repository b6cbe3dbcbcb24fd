//! Vectors of the plane, x to the right and y up.

use super::{Double, Scalar};
use std::f64::consts::PI;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A vector of the plane. As a direction it is the pair (cos, sin).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct V2<S> {
    pub x: S,
    pub y: S,
}

/// A vector of `f64`.
pub type Vec2 = V2<f64>;

impl<S: Scalar> V2<S> {
    /// The vector (x, y).
    #[inline(always)]
    pub const fn new(x: S, y: S) -> Self {
        Self { x, y }
    }

    #[inline(always)]
    #[must_use]
    pub fn zero() -> Self {
        Self::new(S::zero(), S::zero())
    }

    /// The same `f64` vector in every lane.
    #[inline(always)]
    #[must_use]
    pub fn of(v: Vec2) -> Self {
        Self::new(S::of(v.x), S::of(v.y))
    }

    #[inline(always)]
    pub fn dot(self, o: Self) -> S {
        self.x * o.x + self.y * o.y
    }

    /// The z component of the vector product `self` × `o`.
    #[inline(always)]
    pub fn cross(self, o: Self) -> S {
        self.x * o.y - self.y * o.x
    }

    /// Turned by +90°: the left normal, and ω × r for ω = 1.
    #[inline(always)]
    #[must_use]
    pub fn perp(self) -> Self {
        Self::new(-self.y, self.x)
    }

    #[inline(always)]
    pub fn norm(self) -> S {
        self.dot(self).sqrt()
    }

    /// Turned by the angle of the direction `u`: local coordinates to ground axes.
    #[inline(always)]
    #[must_use]
    pub fn turned(self, u: Self) -> Self {
        Self::new(self.x * u.x - self.y * u.y, self.x * u.y + self.y * u.x)
    }

    /// Turned back by the angle of the direction `u`: ground axes to local coordinates.
    #[inline(always)]
    #[must_use]
    pub fn turned_back(self, u: Self) -> Self {
        Self::new(self.x * u.x + self.y * u.y, self.y * u.x - self.x * u.y)
    }
}

impl Vec2 {
    /// The direction of an angle, rad.
    #[must_use]
    pub fn direction(angle: f64) -> Self {
        let (sin, cos) = libm::sincos(angle);
        Self::new(cos, sin)
    }

    /// The angle of the vector in (−π, π], rad.
    #[must_use]
    pub fn angle(self) -> f64 {
        libm::atan2(self.y, self.x)
    }

    /// The vector over its magnitude; `None` for the null vector and for components that are not finite.
    #[must_use]
    pub fn unit(self) -> Option<Self> {
        let n = libm::hypot(self.x, self.y);
        (n > 0.0 && n.is_finite()).then(|| self / n)
    }
}

impl<S: Scalar> Add for V2<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self::new(self.x + o.x, self.y + o.y)
    }
}

impl<S: Scalar> Sub for V2<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self::new(self.x - o.x, self.y - o.y)
    }
}

impl<S: Scalar> Neg for V2<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl<S: Scalar> Mul<S> for V2<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, k: S) -> Self {
        Self::new(self.x * k, self.y * k)
    }
}

impl<S: Scalar> Div<S> for V2<S> {
    type Output = Self;
    #[inline(always)]
    fn div(self, k: S) -> Self {
        Self::new(self.x / k, self.y / k)
    }
}

impl<S: Scalar> AddAssign for V2<S> {
    #[inline(always)]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl<S: Scalar> SubAssign for V2<S> {
    #[inline(always)]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}

// Numbers that may be angles.

/// A number of which sine and cosine can be formed.
pub trait Angular: Scalar<Mask = bool> {
    /// π.
    fn pi() -> Self;
    /// Sine and cosine of an angle, rad.
    fn sine_cosine(self) -> (Self, Self);
    /// The angle in (−π, π] of a direction, rad.
    fn angle_of(direction: V2<Self>) -> Self;
    /// The nearest `f64`.
    fn nearest(self) -> f64;
}

impl Angular for f64 {
    fn pi() -> Self {
        PI
    }
    fn sine_cosine(self) -> (Self, Self) {
        libm::sincos(self)
    }
    fn angle_of(direction: V2<Self>) -> Self {
        direction.angle()
    }
    fn nearest(self) -> f64 {
        self
    }
}

impl Angular for Double {
    fn pi() -> Self {
        Self::PI
    }
    fn sine_cosine(self) -> (Self, Self) {
        let u = self.as_direction();
        (u.y, u.x)
    }
    fn angle_of(direction: V2<Self>) -> Self {
        Self::angle_of(direction)
    }
    fn nearest(self) -> f64 {
        self.high
    }
}

// A rigid body in the plane: the motion of one of its points from the motion of another.

/// Velocity of the point at `r` from O: v = v_O + ω × r.
#[inline(always)]
pub fn velocity_at<S: Scalar>(v_o: V2<S>, omega: S, r: V2<S>) -> V2<S> {
    v_o + r.perp() * omega
}

/// Acceleration of the point at `r` from O: a = a_O + α × r − ω² r.
#[inline(always)]
pub fn acceleration_at<S: Scalar>(a_o: V2<S>, omega: S, alpha: S, r: V2<S>) -> V2<S> {
    a_o + r.perp() * alpha - r * (omega * omega)
}
