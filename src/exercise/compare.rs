//! How values are compared.

use assur_model::model::{Comparison, Display, Value};

/// Rounding of the tolerance itself does not decide: 1.73 and 1.72 differ by 0.01.
const SLACK: f64 = 1.0 + 1e-9;

/// Whether a difference is allowed.
pub fn is_within(difference: f64, within: f64) -> bool {
    difference <= within * SLACK
}

/// The expectation, as `= 26 N*m` or `> 40 deg`; empty for a condition.
pub(super) fn bound(
    comparison: Option<Comparison>,
    display: &Display,
    expected: Value,
    digits: usize,
) -> String {
    if matches!(expected, Value::Bool(_)) {
        return String::new();
    }
    let sign = match comparison {
        None => "=",
        Some(Comparison::Less) => "<",
        Some(Comparison::LessEqual) => "<=",
        Some(Comparison::Greater) => ">",
        Some(Comparison::GreaterEqual) => ">=",
    };
    format!("{sign} {}", display.text(expected, digits))
}

/// Differences between a value and the one expected.
pub mod equal {
    use assur_math::math::Vec2;
    use assur_model::model::Value;
    use std::f64::consts::TAU;

    /// A literal 0 fits any shape.
    pub fn shaped_like(shape: Value, value: Value) -> Value {
        match (shape, value) {
            (Value::Vector(_), Value::Scalar(0.0)) => Value::Vector(Vec2::zero()),
            _ => value,
        }
    }

    /// The first less the second; NaN where their types differ.
    pub fn difference(got: Value, expected: Value, angle: bool) -> Value {
        match (got, expected) {
            (Value::Scalar(a), Value::Scalar(b)) if angle => Value::Scalar(within_half_a_turn(a - b)),
            (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(a - b),
            (Value::Vector(a), Value::Vector(b)) => Value::Vector(a - b),
            (Value::Bool(a), Value::Bool(b)) => Value::Scalar(if a == b { 0.0 } else { 1.0 }),
            _ => Value::Scalar(f64::NAN),
        }
    }

    fn within_half_a_turn(angle: f64) -> f64 {
        angle - TAU * (angle / TAU).round()
    }
}
