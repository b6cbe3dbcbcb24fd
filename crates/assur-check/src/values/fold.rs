//! Expressions of constants are constants.

use assur_math::math::Vec2;
use assur_model::model::{Axis, BinaryOp, Comparison, Curve, CurvePart, Expr, Function, Value};
use std::sync::Arc;

/// The number of a constant.
pub fn scalar(e: &Expr) -> Option<f64> {
    match e {
        Expr::Constant(Value::Scalar(x)) => Some(*x),
        _ => None,
    }
}

/// The vector of a constant.
pub fn vector(e: &Expr) -> Option<Vec2> {
    match e {
        Expr::Constant(Value::Vector(v)) => Some(*v),
        _ => None,
    }
}

fn boolean(e: &Expr) -> Option<bool> {
    match e {
        Expr::Constant(Value::Bool(t)) => Some(*t),
        _ => None,
    }
}

const fn vector_of(v: Vec2) -> Expr {
    Expr::Constant(Value::Vector(v))
}

const fn truth_of(t: bool) -> Expr {
    Expr::Constant(Value::Bool(t))
}

/// −e
pub fn negate(e: Expr) -> Expr {
    match e {
        Expr::Constant(Value::Scalar(x)) => Expr::number(-x),
        Expr::Constant(Value::Vector(v)) => vector_of(-v),
        Expr::Negate(inner) => *inner,
        e => Expr::Negate(Box::new(e)),
    }
}

/// (x, y)
pub fn pair(x: Expr, y: Expr) -> Expr {
    match (scalar(&x), scalar(&y)) {
        (Some(x), Some(y)) => vector_of(Vec2::new(x, y)),
        _ => Expr::Vector(Box::new(x), Box::new(y)),
    }
}

/// magnitude @ angle
pub fn polar(magnitude: Expr, angle: Expr) -> Expr {
    match (scalar(&magnitude), scalar(&angle)) {
        (Some(r), Some(phi)) => vector_of(Vec2::direction(phi) * r),
        _ => Expr::Polar(Box::new(magnitude), Box::new(angle)),
    }
}

pub fn component(v: Expr, axis: Axis) -> Expr {
    match (vector(&v), axis) {
        (Some(v), Axis::X) => Expr::number(v.x),
        (Some(v), Axis::Y) => Expr::number(v.y),
        (None, _) => Expr::Component(Box::new(v), axis),
    }
}

/// Sum, difference, product, quotient.
pub fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    let known = match (op, (scalar(&a), vector(&a)), (scalar(&b), vector(&b))) {
        (BinaryOp::Add, (Some(x), _), (Some(y), _)) => Some(Expr::number(x + y)),
        (BinaryOp::Sub, (Some(x), _), (Some(y), _)) => Some(Expr::number(x - y)),
        (BinaryOp::Mul, (Some(x), _), (Some(y), _)) => Some(Expr::number(x * y)),
        (BinaryOp::Div, (Some(x), _), (Some(y), _)) => Some(Expr::number(x / y)),
        (BinaryOp::Add, (_, Some(u)), (_, Some(v))) => Some(vector_of(u + v)),
        (BinaryOp::Sub, (_, Some(u)), (_, Some(v))) => Some(vector_of(u - v)),
        (BinaryOp::Mul, (_, Some(v)), (Some(k), _)) | (BinaryOp::Mul, (Some(k), _), (_, Some(v))) => {
            Some(vector_of(v * k))
        }
        (BinaryOp::Div, (_, Some(v)), (Some(k), _)) => Some(vector_of(v / k)),
        _ => None,
    };
    known.unwrap_or_else(|| Expr::Binary(op, Box::new(a), Box::new(b)))
}

/// A power; small whole exponents by multiplication.
pub fn power(base: Expr, exponent: Expr) -> Expr {
    match (scalar(&base), scalar(&exponent)) {
        (Some(x), Some(2.0)) => Expr::number(x * x),
        (Some(x), Some(n)) => Expr::number(libm::pow(x, n)),
        _ => Expr::Power(Box::new(base), Box::new(exponent)),
    }
}

pub fn compare(op: Comparison, a: Expr, b: Expr) -> Expr {
    match (scalar(&a), scalar(&b)) {
        (Some(x), Some(y)) => truth_of(match op {
            Comparison::Less => x < y,
            Comparison::LessEqual => x <= y,
            Comparison::Greater => x > y,
            Comparison::GreaterEqual => x >= y,
        }),
        _ => Expr::Compare(op, Box::new(a), Box::new(b)),
    }
}

pub fn and(a: Expr, b: Expr) -> Expr {
    match (boolean(&a), boolean(&b)) {
        (Some(true), _) => b,
        (_, Some(true)) => a,
        (Some(false), _) | (_, Some(false)) => truth_of(false),
        _ => Expr::And(Box::new(a), Box::new(b)),
    }
}

pub fn or(a: Expr, b: Expr) -> Expr {
    match (boolean(&a), boolean(&b)) {
        (Some(false), _) => b,
        (_, Some(false)) => a,
        (Some(true), _) | (_, Some(true)) => truth_of(true),
        _ => Expr::Or(Box::new(a), Box::new(b)),
    }
}

pub fn not(e: Expr) -> Expr {
    match boolean(&e) {
        Some(t) => truth_of(!t),
        None => Expr::Not(Box::new(e)),
    }
}

/// Something of a curve.
pub fn curve(curve: &Arc<Curve>, part: CurvePart, argument: Expr) -> Expr {
    match scalar(&argument) {
        Some(x) => Expr::number(curve.at(part, x)),
        None => Expr::Curve(curve.clone(), part, Box::new(argument)),
    }
}

/// A function of constants.
pub fn call(function: Function, args: Vec<Expr>) -> Expr {
    known(function, &args).unwrap_or(Expr::Call(function, args))
}

fn known(function: Function, args: &[Expr]) -> Option<Expr> {
    let x = |i: usize| args.get(i).and_then(scalar);
    let v = |i: usize| args.get(i).and_then(vector);
    let number = match function {
        Function::Sqrt => x(0)?.sqrt(),
        Function::Abs => x(0)?.abs(),
        Function::Sin => libm::sin(x(0)?),
        Function::Cos => libm::cos(x(0)?),
        Function::Tan => libm::tan(x(0)?),
        Function::Asin => libm::asin(x(0)?),
        Function::Acos => libm::acos(x(0)?),
        Function::Exp => libm::exp(x(0)?),
        Function::Log => libm::log(x(0)?),
        Function::Atan => libm::atan(x(0)?),
        Function::Atan2 => libm::atan2(x(0)?, x(1)?),
        Function::Max => all(args)?.into_iter().fold(f64::NEG_INFINITY, f64::max),
        Function::Min => all(args)?.into_iter().fold(f64::INFINITY, f64::min),
        Function::Mag => libm::hypot(v(0)?.x, v(0)?.y),
        Function::Dot => v(0)?.dot(v(1)?),
        Function::Cross => v(0)?.cross(v(1)?),
        Function::Direction => v(0)?.angle(),
        Function::Unit => {
            let u = v(0)?;
            return Some(vector_of(u.unit().unwrap_or(Vec2::new(f64::NAN, f64::NAN))));
        }
    };
    Some(Expr::number(number))
}

fn all(args: &[Expr]) -> Option<Vec<f64>> {
    args.iter().map(scalar).collect()
}
