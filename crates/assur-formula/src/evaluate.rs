//! Values of trees: from the values of the leaves, or from what is printed.

use crate::expr::{Expr, Function, Sign};
use crate::quantity::Quantity;
use crate::unit::Unit;

const RADIAN: f64 = std::f64::consts::PI / 180.0;

impl Expr {
    #[must_use]
    pub fn value(&self) -> f64 {
        self.value_of(&|q| q.value)
    }

    /// Its value with these of its quantities.
    #[must_use]
    pub fn value_of(&self, of: &dyn Fn(&Quantity) -> f64) -> f64 {
        match self {
            Self::Int(n) | Self::Degrees(n) => *n as f64,
            Self::Number(x) => *x,
            Self::Pi => std::f64::consts::PI,
            Self::Leaf(q) => of(q),
            Self::Neg(x) => -x.value_of(of),
            Self::Sum(terms) => terms.iter().fold(0.0, |sum, (sign, x)| match sign {
                Sign::Plus => sum + x.value_of(of),
                Sign::Minus => sum - x.value_of(of),
            }),
            Self::Product(factors) => factors.iter().map(|x| x.value_of(of)).product(),
            Self::Ratio(a, b) => a.value_of(of) / b.value_of(of),
            Self::Power(x, n) => power(x.value_of(of), *n),
            Self::Root(x) => x.value_of(of).max(0.0).sqrt(),
            Self::Abs(x) => x.value_of(of).abs(),
            Self::Of(function, x) => function.of(x.value_of(of)),
        }
    }

    /// What its value is large against: the value if nothing in it cancelled.
    #[must_use]
    pub fn scale(&self) -> f64 {
        match self {
            Self::Int(_) | Self::Degrees(_) | Self::Number(_) | Self::Pi => self.value().abs(),
            Self::Leaf(q) if q.is_nothing() => q.scale,
            Self::Leaf(q) => q.value.abs(),
            Self::Neg(x) | Self::Abs(x) => x.scale(),
            Self::Sum(terms) => terms.iter().map(|(_, x)| x.scale()).fold(0.0, f64::max),
            Self::Product(factors) => factors.iter().map(Self::scale).product(),
            Self::Ratio(a, b) => {
                let size = b.value().abs();
                if size > 0.0 { a.scale() / size } else { f64::INFINITY }
            }
            Self::Power(x, n) => power(x.scale(), *n),
            Self::Root(x) => x.scale().sqrt(),
            Self::Of(function, _) if function.is_of_angle() => self.value().abs().max(1.0),
            Self::Of(..) => self.value().abs().max(1.0),
        }
    }

    /// How far rounding in its leaves may move its value: of the first order, and generous.
    #[must_use]
    pub fn rounding(&self) -> f64 {
        const UNIT: f64 = 4.0 * f64::EPSILON;
        let own = UNIT * self.value().abs();
        own + match self {
            Self::Int(_) | Self::Degrees(_) | Self::Number(_) | Self::Pi => 0.0,
            Self::Leaf(q) if q.unit == Unit::Angle => q.rounding + UNIT * 360.0,
            Self::Leaf(q) => q.rounding + UNIT * q.value.abs(),
            Self::Neg(x) | Self::Abs(x) => x.rounding(),
            Self::Sum(terms) => terms.iter().map(|(_, x)| x.rounding()).sum(),
            Self::Product(factors) => {
                let values: Vec<f64> = factors.iter().map(|x| x.value().abs()).collect();
                let others = |i: usize| -> f64 {
                    values.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, v)| v).product()
                };
                factors.iter().enumerate().map(|(i, x)| x.rounding() * others(i)).sum()
            }
            Self::Ratio(a, b) => {
                let size = b.value().abs().max(f64::MIN_POSITIVE);
                (a.rounding() + a.value().abs() / size * b.rounding()) / size
            }
            Self::Power(x, n) => f64::from(*n) * power(x.value().abs(), n - 1) * x.rounding(),
            Self::Root(x) => {
                let (inner, moved) = (x.value().max(0.0), x.rounding());
                (inner + moved).sqrt() - inner.sqrt()
            }
            Self::Of(function, x) => {
                let moved = x.rounding();
                let ends = [x.value() - moved, x.value(), x.value() + moved].map(|x| function.of(x));
                (ends[0] - ends[1]).abs().max((ends[2] - ends[1]).abs())
            }
        }
    }

    /// The largest of its terms: what its digits are counted from.
    pub(crate) fn largest_term(&self) -> f64 {
        match self {
            Self::Neg(x) => x.largest_term(),
            Self::Sum(terms) => terms.iter().map(|(_, x)| x.value().abs()).fold(0.0, f64::max),
            Self::Ratio(a, b) => a.largest_term() / b.value().abs(),
            other => other.value().abs(),
        }
    }
}

/// A power by products.
fn power(x: f64, exponent: u8) -> f64 {
    (1..exponent).fold(x, |product, _| product * x)
}

impl Function {
    fn of(self, x: f64) -> f64 {
        match self {
            Self::Sin => libm::sin(x * RADIAN),
            Self::Cos => libm::cos(x * RADIAN),
            Self::Tan => libm::tan(x * RADIAN),
            Self::Arcsin => libm::asin(x.clamp(-1.0, 1.0)) / RADIAN,
            Self::Arccos => libm::acos(x.clamp(-1.0, 1.0)) / RADIAN,
            Self::Arctan => libm::atan(x) / RADIAN,
            Self::Exp => libm::exp(x),
        }
    }
}
