//! The size of an expression at a position: what its rounding is small against.
//!
//! A sum has the sizes of its terms, whatever it comes to. What a function makes of the rounding of its argument follows from its
//! derivative. A number that depends on the reciprocal of what is zero but for rounding has no size.

use super::pose_answers::PoseAnswers;
use super::sizes::{ROUNDING, Sizes, is_zero};
use crate::model::{Axis, BinaryOp, CurvePart, Expr, Function, Value};

/// A value with its size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Measured {
    pub value: Value,
    /// What its rounding is small against; NaN where it has no value, whatever was computed.
    pub size: f64,
}

impl PoseAnswers<'_> {
    /// The value of an expression with its size.
    #[must_use]
    pub(crate) fn measured(&self, expr: &Expr, sizes: &Sizes) -> Measured {
        Measured { value: self.value(expr), size: self.size(expr, sizes) }
    }

    /// The size of an expression: no less than its magnitude, NaN where it has none.
    #[must_use]
    pub(crate) fn size(&self, expr: &Expr, sizes: &Sizes) -> f64 {
        let size = |e: &Expr| self.size(e, sizes);
        let at_least = |size: f64| if size.is_nan() { size } else { size.max(self.value(expr).magnitude()) };
        match expr {
            Expr::Constant(value) => value.magnitude(),
            Expr::Vector(x, y) => libm::hypot(size(x), size(y)),
            Expr::Polar(r, phi) => size(r) + self.scalar(r).abs() * size(phi),
            Expr::Component(v, axis) => match (&**v, axis) {
                (Expr::Vector(x, _), Axis::X) => size(x),
                (Expr::Vector(_, y), Axis::Y) => size(y),
                _ => size(v),
            },
            Expr::Negate(a) | Expr::Frictionless(a) => size(a),
            Expr::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => size(a) + size(b),
            Expr::Binary(BinaryOp::Mul, a, b) => at_least(self.product(a, b, sizes)),
            Expr::Binary(BinaryOp::Div, a, b) => {
                let (of, over) = (self.value(a).magnitude(), self.scalar(b).abs());
                let over_size = self.denominator(over, size(b));
                (size(a) + of * (over_size / over)) / over
            }
            Expr::Power(a, b) => at_least(self.power_size(a, b, sizes)),
            Expr::Call(function, args) => at_least(self.call_size(*function, args, sizes)),
            Expr::Compare(..) | Expr::And(..) | Expr::Or(..) | Expr::Not(_) => 0.0,
            Expr::Quantity(id) => sizes.quantity(id.index()),
            Expr::Query(query) => at_least(self.query_size(query, sizes)),
            Expr::Curve(curve, part, x) => {
                let derivatives = curve.function.derivatives(self.scalar(x));
                let slope = derivatives[if *part == CurvePart::Value { 1 } else { 2 }];
                // beyond its table a curve has no value, whatever its argument is
                at_least(if slope.is_nan() { 0.0 } else { slope.abs() * size(x) })
            }
        }
    }

    /// The size of what is divided by; none where it is zero.
    fn denominator(&self, value: f64, size: f64) -> f64 {
        if is_zero(value, size) { f64::NAN } else { size }
    }

    fn product(&self, a: &Expr, b: &Expr, sizes: &Sizes) -> f64 {
        let (s_a, s_b) = (self.size(a, sizes), self.size(b, sizes));
        self.value(a).magnitude() * s_b + self.value(b).magnitude() * s_a + ROUNDING * s_a * s_b
    }

    fn power_size(&self, base: &Expr, exponent: &Expr, sizes: &Sizes) -> f64 {
        let (x, n) = (self.scalar(base).abs(), self.scalar(exponent));
        let size = self.size(base, sizes);
        // a root of rounding is far greater than rounding
        let x = if n < 0.0 && is_zero(x, size) { f64::NAN } else { x.max(ROUNDING * size) };
        if x == 0.0 {
            return 0.0;
        }
        let of_exponent = match exponent {
            Expr::Constant(_) => 0.0,
            _ => libm::pow(x, n) * libm::log(x).abs() * self.size(exponent, sizes),
        };
        n.abs() * libm::pow(x, n - 1.0) * size + of_exponent
    }

    fn call_size(&self, function: Function, args: &[Expr], sizes: &Sizes) -> f64 {
        let size = |i: usize| args.get(i).map_or(0.0, |e| self.size(e, sizes));
        let scalar = |i: usize| args.get(i).map_or(f64::NAN, |e| self.scalar(e));
        let slope = |x: f64| x * size(0);
        match function {
            Function::Abs | Function::Mag | Function::Sin | Function::Cos => size(0),
            Function::Max | Function::Min => (0..args.len()).map(size).fold(0.0, f64::max),
            Function::Sqrt => {
                let least = scalar(0).max(ROUNDING * size(0));
                if least > 0.0 { slope(0.5 / least.sqrt()) } else { 0.0 }
            }
            Function::Tan => slope(1.0 + libm::tan(scalar(0)).powi(2)),
            Function::Asin | Function::Acos => {
                slope(1.0 / (1.0 - scalar(0).powi(2)).max(ROUNDING * size(0).max(1.0)).sqrt())
            }
            Function::Atan => slope(1.0 / (1.0 + scalar(0).powi(2))),
            Function::Exp => slope(libm::exp(scalar(0))),
            Function::Log => self.denominator(scalar(0), size(0)) / scalar(0).abs(),
            Function::Atan2 => {
                let r = libm::hypot(scalar(0), scalar(1));
                self.denominator(r, size(0).max(size(1))) / r
            }
            Function::Direction | Function::Unit => {
                let r = args.first().map_or(f64::NAN, |v| self.value(v).magnitude());
                self.denominator(r, size(0)) / r
            }
            Function::Dot | Function::Cross => match args {
                [a, b] => self.product(a, b, sizes),
                _ => f64::NAN,
            },
        }
    }
}
