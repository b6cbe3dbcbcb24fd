//! Evaluates expressions at a position.

use super::pose_answers::PoseAnswers;
use super::sizes::ROUNDING;
use crate::math::Vec2;
use crate::model::{Axis, BinaryOp, Comparison, Expr, Function, Value};

/// NaN where types do not fit: `check` has seen to it that they do.
const NOT_A_NUMBER: Value = Value::Scalar(f64::NAN);

impl PoseAnswers<'_> {
    /// The value of an expression. What is not defined (a root of a negative number, a ratio of zeros) is NaN.
    #[must_use]
    pub fn value(&self, expr: &Expr) -> Value {
        match expr {
            Expr::Constant(value) => *value,
            Expr::Vector(x, y) => Value::Vector(Vec2::new(self.scalar(x), self.scalar(y))),
            Expr::Polar(r, phi) => Value::Vector(Vec2::direction(self.scalar(phi)) * self.scalar(r)),
            Expr::Component(v, axis) => {
                let v = self.vector(v);
                Value::Scalar(match axis {
                    Axis::X => v.x,
                    Axis::Y => v.y,
                })
            }
            Expr::Negate(a) => match self.value(a) {
                Value::Scalar(x) => Value::Scalar(-x),
                Value::Vector(v) => Value::Vector(-v),
                Value::Bool(_) => NOT_A_NUMBER,
            },
            Expr::Binary(op, a, b) => binary(*op, self.value(a), self.value(b)),
            Expr::Power(a, b) => Value::Scalar(power(self.scalar(a), self.scalar(b))),
            Expr::Call(function @ (Function::Abs | Function::Max | Function::Min), args) => {
                let taken = self.call_on_side(expr, args);
                taken.map_or_else(|| self.call(*function, args), Value::Scalar)
            }
            Expr::Call(function, args) => self.call(*function, args),
            Expr::Compare(how, a, b) => Value::Bool(self.comparison(expr, *how, (a, b))),
            Expr::And(a, b) => Value::Bool(self.truth(a) && self.truth(b)),
            Expr::Or(a, b) => Value::Bool(self.truth(a) || self.truth(b)),
            Expr::Not(a) => Value::Bool(!self.truth(a)),
            Expr::Quantity(id) => self.quantity(*id),
            Expr::Query(query) => self.query(query),
            Expr::Curve(curve, part, x) => Value::Scalar(self.curve(expr, (curve, *part), x)),
            Expr::Frictionless(a) => self.without_friction().value(a),
        }
    }

    /// A scalar; NaN for anything else.
    #[must_use]
    pub fn scalar(&self, expr: &Expr) -> f64 {
        match self.value(expr) {
            Value::Scalar(x) => x,
            Value::Vector(_) | Value::Bool(_) => f64::NAN,
        }
    }

    /// A vector; NaN for anything else.
    #[must_use]
    pub fn vector(&self, expr: &Expr) -> Vec2 {
        match self.value(expr) {
            Value::Vector(v) => v,
            // a literal 0 fits any dimension, and any shape
            Value::Scalar(0.0) => Vec2::zero(),
            Value::Scalar(_) | Value::Bool(_) => Vec2::new(f64::NAN, f64::NAN),
        }
    }

    /// A truth; false for anything else.
    #[must_use]
    pub fn truth(&self, expr: &Expr) -> bool {
        matches!(self.value(expr), Value::Bool(true))
    }

    /// A root; of what is less than zero only by rounding of its terms it is zero.
    fn root(&self, expr: &Expr) -> f64 {
        let x = self.scalar(expr);
        let nothing = x < 0.0 && -x <= ROUNDING * self.terms(expr);
        if nothing { 0.0 } else { x.sqrt() }
    }

    /// The sum of the magnitudes of the terms of a sum.
    fn terms(&self, expr: &Expr) -> f64 {
        match expr {
            Expr::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => self.terms(a) + self.terms(b),
            Expr::Negate(a) => self.terms(a),
            Expr::Quantity(id) => {
                let law = self.mechanism.quantities.get(id.index()).map(|quantity| &quantity.expr);
                law.map_or(0.0, |law| self.terms(law))
            }
            _ => self.value(expr).magnitude(),
        }
    }

    fn call(&self, function: Function, args: &[Expr]) -> Value {
        let arg = |i: usize| args.get(i).map_or(NOT_A_NUMBER, |e| self.value(e));
        let scalar = |i: usize| args.get(i).map_or(f64::NAN, |e| self.scalar(e));
        let vector = |i: usize| args.get(i).map_or(Vec2::new(f64::NAN, f64::NAN), |e| self.vector(e));
        Value::Scalar(match function {
            Function::Sqrt => args.first().map_or(f64::NAN, |e| self.root(e)),
            Function::Abs => scalar(0).abs(),
            Function::Sin => libm::sin(scalar(0)),
            Function::Cos => libm::cos(scalar(0)),
            Function::Tan => libm::tan(scalar(0)),
            Function::Asin => libm::asin(scalar(0)),
            Function::Acos => libm::acos(scalar(0)),
            Function::Atan => libm::atan(scalar(0)),
            Function::Exp => libm::exp(scalar(0)),
            Function::Log => libm::log(scalar(0)),
            Function::Atan2 => libm::atan2(scalar(0), scalar(1)),
            Function::Mag => match arg(0) {
                Value::Scalar(x) => x.abs(),
                Value::Vector(v) => libm::hypot(v.x, v.y),
                Value::Bool(_) => f64::NAN,
            },
            Function::Dot => vector(0).dot(vector(1)),
            Function::Cross => vector(0).cross(vector(1)),
            Function::Max => (1..args.len()).map(scalar).fold(scalar(0), known(f64::max)),
            Function::Min => (1..args.len()).map(scalar).fold(scalar(0), known(f64::min)),
            Function::Direction => vector(0).angle(),
            Function::Unit => {
                return Value::Vector(vector(0).unit().unwrap_or(Vec2::new(f64::NAN, f64::NAN)));
            }
        })
    }
}

pub(super) fn binary(op: BinaryOp, a: Value, b: Value) -> Value {
    use BinaryOp::{Add, Div, Mul, Sub};
    use Value::{Scalar, Vector};
    match (op, a, b) {
        (Add, Scalar(a), Scalar(b)) => Scalar(a + b),
        (Sub, Scalar(a), Scalar(b)) => Scalar(a - b),
        (Mul, Scalar(a), Scalar(b)) => Scalar(a * b),
        (Div, Scalar(a), Scalar(b)) => Scalar(a / b),
        (Add, Vector(a), Vector(b)) => Vector(a + b),
        (Sub, Vector(a), Vector(b)) => Vector(a - b),
        (Mul, Vector(a), Scalar(k)) | (Mul, Scalar(k), Vector(a)) => Vector(a * k),
        (Div, Vector(a), Scalar(k)) => Vector(a / k),
        (Add, Vector(a), Scalar(0.0)) | (Sub, Vector(a), Scalar(0.0)) | (Add, Scalar(0.0), Vector(a)) => {
            Vector(a)
        }
        (Sub, Scalar(0.0), Vector(a)) => Vector(-a),
        _ => NOT_A_NUMBER,
    }
}

/// A function of two numbers that does not exist where one of them does not.
fn known(f: impl Fn(f64, f64) -> f64) -> impl Fn(f64, f64) -> f64 {
    move |a, b| if a.is_nan() || b.is_nan() { f64::NAN } else { f(a, b) }
}

/// Whole powers by multiplication, so that they are exact where the numbers are.
fn power(base: f64, exponent: f64) -> f64 {
    if exponent == 2.0 { base * base } else { known(libm::pow)(base, exponent) }
}

#[must_use]
pub fn compare(how: Comparison, a: f64, b: f64) -> bool {
    match how {
        Comparison::Less => a < b,
        Comparison::LessEqual => a <= b,
        Comparison::Greater => a > b,
        Comparison::GreaterEqual => a >= b,
    }
}
