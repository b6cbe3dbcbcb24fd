//! Numbers of twice the digits: the reference for what `f64` loses.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Scalar, V2};

/// The unevaluated sum of two `f64`, the second at most half a unit in the last place of the first: about 32 digits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Double {
    pub high: f64,
    pub low: f64,
}

/// x + y and its rounding error, for |x| ≥ |y| (Dekker).
fn quick_sum(x: f64, y: f64) -> Double {
    let high = x + y;
    Double { high, low: y - (high - x) }
}

/// x + y and its rounding error (Knuth).
fn two_sum(x: f64, y: f64) -> Double {
    let high = x + y;
    let part = high - x;
    Double { high, low: (x - (high - part)) + (y - part) }
}

fn two_product(x: f64, y: f64) -> Double {
    let (high, low) = x.two_product(y);
    Double { high, low }
}

/// 2π in three parts.
const TURN: [f64; 3] = [std::f64::consts::TAU, 2.449_293_598_294_706_4e-16, -5.989_539_619_436_679e-33];

impl Double {
    /// π.
    pub const PI: Self = Self { high: 0.5 * TURN[0], low: 0.5 * TURN[1] };

    /// Rounded to `f64`.
    #[must_use]
    pub const fn rounded(self) -> f64 {
        self.high
    }

    /// The direction (cos, sin) of an angle, rad.
    #[must_use]
    pub fn direction(angle: f64) -> V2<Self> {
        Self::of(angle).as_direction()
    }

    /// The direction (cos, sin) of the angle, rad: the Taylor series of a 32nd of what is left of whole turns, then five
    /// doublings.
    #[must_use]
    pub fn as_direction(self) -> V2<Self> {
        let turns = (self.high / TURN[0]).round();
        let taken = TURN.iter().fold(self, |left, &part| left - two_product(turns, part));
        let small = taken * Self::of(1.0 / 32.0);
        let (mut cos, mut sin, mut term) = (Self::zero(), Self::zero(), Self::one());
        for i in 0..24_u32 {
            match i % 4 {
                0 => cos = cos + term,
                1 => sin = sin + term,
                2 => cos = cos - term,
                _ => sin = sin - term,
            }
            term = term * small / Self::of(f64::from(i + 1));
        }
        (0..5).fold(V2::new(cos, sin), |u, _| u.turned(u))
    }

    /// The angle in (−π, π] of a direction, rad: the nearest `f64` with what it leaves, whose sine is it to all digits.
    #[must_use]
    pub fn angle_of(direction: V2<Self>) -> Self {
        let near = libm::atan2(direction.y.high, direction.x.high);
        let left = Self::direction(near).cross(direction);
        Self::of(near) + left
    }
}

// not written out at every place: the closed forms would grow tenfold, and the compiler would take minutes for them
impl Add for Double {
    type Output = Self;
    #[inline(never)]
    fn add(self, o: Self) -> Self {
        let (s, t) = (two_sum(self.high, o.high), two_sum(self.low, o.low));
        let s = quick_sum(s.high, s.low + t.high);
        quick_sum(s.high, s.low + t.low)
    }
}

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

impl Mul for Double {
    type Output = Self;
    #[inline(never)]
    fn mul(self, o: Self) -> Self {
        let p = two_product(self.high, o.high);
        quick_sum(p.high, p.low + (self.high * o.low + self.low * o.high))
    }
}

impl Div for Double {
    type Output = Self;
    /// Long division with three digits of 53 bits.
    #[inline(never)]
    fn div(self, o: Self) -> Self {
        let first = self.high / o.high;
        if !first.is_finite() || o.high.is_infinite() {
            return Self { high: first, low: 0.0 };
        }
        let left = self - o * Self::of(first);
        let second = left.high / o.high;
        let third = (left - o * Self::of(second)).high / o.high;
        quick_sum(first, second) + Self::of(third)
    }
}

impl Scalar for Double {
    type Mask = bool;
    const EXTENDED: bool = true;

    fn of(x: f64) -> Self {
        Self { high: x, low: 0.0 }
    }
    /// One step of Newton's method for the reciprocal root from that of the leading part (Karp and Markstein).
    fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        if root == 0.0 || !root.is_finite() {
            return Self::of(root);
        }
        let left = self - two_product(root, root);
        quick_sum(root, left.high / (2.0 * root))
    }
    fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }
    fn max(self, other: Self) -> Self {
        if self.lt(other) { other } else { self }
    }
    fn min(self, other: Self) -> Self {
        if other.lt(self) { other } else { self }
    }
    fn lt(self, other: Self) -> bool {
        self.high < other.high || self.high == other.high && self.low < other.low
    }
    fn select(mask: bool, a: Self, b: Self) -> Self {
        if mask { a } else { b }
    }
    /// Twice the digits are enough for what needs the error of a product.
    fn two_product(self, other: Self) -> (Self, Self) {
        (self * other, Self::zero())
    }
}
