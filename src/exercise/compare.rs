//! How values are compared.

use crate::model::{Comparison, Display, Value};

/// Rounding of the tolerance itself does not decide: 1.73 and 1.72 differ by 0.01.
const SLACK: f64 = 1.0 + 1e-9;

/// Whether a difference is allowed.
pub(super) fn is_within(difference: f64, within: f64) -> bool {
    difference <= within * SLACK
}

/// What is asked of a value, as `= 26 N*m` or `> 40 deg`; empty for a truth.
pub(super) fn bound(
    comparison: Option<Comparison>,
    display: &Display,
    expected: Value,
    digits: usize,
) -> String {
    if matches!(expected, Value::Truth(_)) {
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

pub(super) mod equal {
    use crate::math::Vec2;
    use crate::model::Value;
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
            (Value::Truth(a), Value::Truth(b)) => Value::Scalar(if a == b { 0.0 } else { 1.0 }),
            _ => Value::Scalar(f64::NAN),
        }
    }

    fn within_half_a_turn(angle: f64) -> f64 {
        angle - TAU * (angle / TAU).round()
    }
}

#[cfg(test)]
mod tests {
    use super::equal::{difference, shaped_like};
    use super::is_within;
    use crate::math::Vec2;
    use crate::model::Value;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn one_unit_in_the_last_digit_is_allowed() {
        assert!(is_within(1.73 - 1.72, 0.01));
        assert!(!is_within(0.0101, 0.01));
        assert!(is_within(0.0, 0.0));
        assert!(!is_within(f64::NAN, 1.0));
    }

    #[test]
    fn angles_are_compared_modulo_a_turn() {
        let apart = |a, b| difference(Value::Scalar(a), Value::Scalar(b), true).magnitude();
        assert!(apart(1.0 + TAU, 1.0) < 1e-15);
        assert!(apart(PI - 1e-9, 1e-9 - PI) < 2.1e-9);
        assert!((apart(0.0, PI) - PI).abs() < 1e-15);
    }

    #[test]
    fn vectors_are_compared_by_the_magnitude_of_their_difference() {
        let got = Value::Vector(Vec2::new(3.0, 4.0));
        assert_eq!(difference(got, shaped_like(got, Value::Scalar(0.0)), false).magnitude(), 5.0);
    }
}
