//! A number with its first and second derivative in time.

use assur::internals::math::{Scalar, V2, Vec2};
use std::ops::{Add, Mul, Sub};

#[derive(Clone, Copy, Debug, Default)]
pub struct Jet<S = f64> {
    pub value: S,
    pub rate: S,
    pub second: S,
}

impl<S: Scalar> Jet<S> {
    pub fn constant(value: S) -> Self {
        Self { value, rate: S::zero(), second: S::zero() }
    }

    /// The same numbers of another kind.
    pub fn of(x: Jet) -> Self {
        Self { value: S::of(x.value), rate: S::of(x.rate), second: S::of(x.second) }
    }
}

impl<S: Scalar> Add for Jet<S> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { value: self.value + o.value, rate: self.rate + o.rate, second: self.second + o.second }
    }
}

impl<S: Scalar> Sub for Jet<S> {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self { value: self.value - o.value, rate: self.rate - o.rate, second: self.second - o.second }
    }
}

impl<S: Scalar> Mul for Jet<S> {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        let both = self.rate * o.rate;
        Self {
            value: self.value * o.value,
            rate: self.rate * o.value + self.value * o.rate,
            second: self.second * o.value + (both + both) + self.value * o.second,
        }
    }
}

/// A moving vector.
#[derive(Clone, Copy, Debug, Default)]
pub struct Moving<S = f64> {
    pub x: Jet<S>,
    pub y: Jet<S>,
}

impl<S: Scalar> Moving<S> {
    pub fn constant(v: Vec2) -> Self {
        Self::fixed(V2::of(v))
    }

    pub fn fixed(v: V2<S>) -> Self {
        Self { x: Jet::constant(v.x), y: Jet::constant(v.y) }
    }

    /// A vector that moves with these derivatives.
    pub fn new(p: V2<S>, v: V2<S>, a: V2<S>) -> Self {
        let jet = |value, rate, second| Jet { value, rate, second };
        Self { x: jet(p.x, v.x, a.x), y: jet(p.y, v.y, a.y) }
    }

    /// The direction `u` that turns with this rate.
    pub fn direction(u: V2<S>, omega: S, alpha: S) -> Self {
        Self::new(u, u.perp() * omega, u.perp() * alpha - u * (omega * omega))
    }

    pub fn plus(self, o: Self) -> Self {
        Self { x: self.x + o.x, y: self.y + o.y }
    }

    pub fn minus(self, o: Self) -> Self {
        Self { x: self.x - o.x, y: self.y - o.y }
    }

    pub fn dot(self, o: Self) -> Jet<S> {
        self.x * o.x + self.y * o.y
    }

    pub fn cross(self, o: Self) -> Jet<S> {
        self.x * o.y - self.y * o.x
    }

    /// Turned by the angle of the direction `u`.
    pub fn turned(self, u: Self) -> Self {
        Self { x: self.x * u.x - self.y * u.y, y: self.x * u.y + self.y * u.x }
    }

    pub fn value(self) -> V2<S> {
        V2::new(self.x.value, self.y.value)
    }

    pub fn rate(self) -> V2<S> {
        V2::new(self.x.rate, self.y.rate)
    }

    pub fn second(self) -> V2<S> {
        V2::new(self.x.second, self.y.second)
    }
}
