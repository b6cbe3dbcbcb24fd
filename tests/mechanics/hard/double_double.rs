//! Double-double arithmetic: about 32 digits, enough to judge what f64 loses.

use std::ops::{Add, Div, Mul, Neg, Sub};

use assur::internals::math::Scalar;

/// The unevaluated sum of two doubles, the second below half an ulp of the first.
#[derive(Clone, Copy, Debug)]
pub struct DoubleDouble(pub f64, pub f64);

fn quick_sum(a: f64, b: f64) -> DoubleDouble {
    let s = a + b;
    DoubleDouble(s, b - (s - a))
}

fn sum(a: f64, b: f64) -> DoubleDouble {
    let s = a + b;
    let t = s - a;
    DoubleDouble(s, (a - (s - t)) + (b - t))
}

fn product(a: f64, b: f64) -> DoubleDouble {
    let p = a * b;
    DoubleDouble(p, a.mul_add(b, -p))
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        let (s, t) = (sum(self.0, o.0), sum(self.1, o.1));
        let s = quick_sum(s.0, s.1 + t.0);
        quick_sum(s.0, s.1 + t.1)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        let p = product(self.0, o.0);
        quick_sum(p.0, p.1 + (self.0 * o.1 + self.1 * o.0))
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let first = self.0 / o.0;
        let rest = self - o * Self::of(first);
        let second = rest.0 / o.0;
        let rest = rest - o * Self::of(second);
        quick_sum(first, second) + Self::of(rest.0 / o.0)
    }
}

impl Scalar for DoubleDouble {
    type Mask = bool;

    fn of(x: f64) -> Self {
        Self(x, 0.0)
    }
    fn sqrt(self) -> Self {
        if self.0 == 0.0 {
            return Self::of(0.0);
        }
        let root = Self::of(self.0.sqrt());
        let once = root + (self - root * root) / (root + root);
        once + (self - once * once) / (once + once)
    }
    fn abs(self) -> Self {
        if self.0 < 0.0 { -self } else { self }
    }
    fn max(self, other: Self) -> Self {
        if self.lt(other) { other } else { self }
    }
    fn min(self, other: Self) -> Self {
        if other.lt(self) { other } else { self }
    }
    fn lt(self, other: Self) -> bool {
        self.0 < other.0 || (self.0 == other.0 && self.1 < other.1)
    }
    fn select(mask: bool, a: Self, b: Self) -> Self {
        if mask { a } else { b }
    }
}
