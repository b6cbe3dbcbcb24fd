//! A number with its first and second derivative in time.

use assur::math::Vec2;
use std::ops::{Add, Mul, Sub};

#[derive(Clone, Copy, Debug, Default)]
pub struct Jet {
    pub value: f64,
    pub rate: f64,
    pub second: f64,
}

impl Jet {
    pub const fn constant(value: f64) -> Self {
        Self { value, rate: 0.0, second: 0.0 }
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { value: self.value + o.value, rate: self.rate + o.rate, second: self.second + o.second }
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + o * Jet::constant(-1.0)
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self {
            value: self.value * o.value,
            rate: self.rate * o.value + self.value * o.rate,
            second: self.second * o.value + 2.0 * self.rate * o.rate + self.value * o.second,
        }
    }
}

/// A moving vector.
#[derive(Clone, Copy, Debug, Default)]
pub struct Moving {
    pub x: Jet,
    pub y: Jet,
}

impl Moving {
    pub fn constant(v: Vec2) -> Self {
        Self { x: Jet::constant(v.x), y: Jet::constant(v.y) }
    }

    /// A vector that moves with these derivatives.
    pub fn new(p: Vec2, v: Vec2, a: Vec2) -> Self {
        let jet = |value, rate, second| Jet { value, rate, second };
        Self { x: jet(p.x, v.x, a.x), y: jet(p.y, v.y, a.y) }
    }

    /// The direction `u` that turns with this rate.
    pub fn direction(u: Vec2, omega: f64, alpha: f64) -> Self {
        Self::new(u, u.perp() * omega, u.perp() * alpha - u * (omega * omega))
    }

    pub fn plus(self, o: Self) -> Self {
        Self { x: self.x + o.x, y: self.y + o.y }
    }

    pub fn minus(self, o: Self) -> Self {
        Self { x: self.x - o.x, y: self.y - o.y }
    }

    pub fn dot(self, o: Self) -> Jet {
        self.x * o.x + self.y * o.y
    }

    pub fn cross(self, o: Self) -> Jet {
        self.x * o.y - self.y * o.x
    }

    /// Turned by the angle of the direction `u`.
    pub fn turned(self, u: Self) -> Self {
        Self { x: self.x * u.x - self.y * u.y, y: self.x * u.y + self.y * u.x }
    }

    pub fn value(self) -> Vec2 {
        Vec2::new(self.x.value, self.y.value)
    }

    pub fn rate(self) -> Vec2 {
        Vec2::new(self.x.rate, self.y.rate)
    }

    pub fn second(self) -> Vec2 {
        Vec2::new(self.x.second, self.y.second)
    }
}
