//! One answer at one pose.

use assur_math::math::Vec2;
use assur_model::model::{Display, Value};
use std::fmt;

/// The kind of an answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// A number.
    Number(f64),
    /// A vector in ground axes: x to the right, y up.
    Vector(f64, f64),
    /// A condition, true or false.
    Condition(bool),
    /// It does not exist at this pose.
    Undefined,
}

/// An answer in the author's unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    quantity: Quantity,
    si: Quantity,
    unit: String,
}

impl Answer {
    pub(super) fn of(value: Option<Value>, display: &Display) -> Self {
        let si = match value {
            Some(Value::Scalar(x)) if x.is_finite() => Quantity::Number(x),
            Some(Value::Vector(Vec2 { x, y })) if x.is_finite() && y.is_finite() => Quantity::Vector(x, y),
            Some(Value::Bool(holds)) => Quantity::Condition(holds),
            _ => Quantity::Undefined,
        };
        let quantity = match si {
            Quantity::Number(x) => Quantity::Number(display.of_si(x)),
            Quantity::Vector(x, y) => Quantity::Vector(display.of_si(x), display.of_si(y)),
            other => other,
        };
        Self { quantity, si, unit: display.unit.clone() }
    }

    /// Its value in [`Answer::unit`].
    #[must_use]
    pub const fn quantity(&self) -> Quantity {
        self.quantity
    }

    /// Its value in SI units, angles in radians.
    #[must_use]
    pub const fn si(&self) -> Quantity {
        self.si
    }

    /// The number in [`Answer::unit`]; `None` if it is not a number.
    #[must_use]
    pub const fn number(&self) -> Option<f64> {
        match self.quantity {
            Quantity::Number(x) => Some(x),
            _ => None,
        }
    }

    /// The components in [`Answer::unit`]; `None` if it is not a vector.
    #[must_use]
    pub const fn vector(&self) -> Option<(f64, f64)> {
        match self.quantity {
            Quantity::Vector(x, y) => Some((x, y)),
            _ => None,
        }
    }

    /// The unit: of the `as` of its `find`, else as the file writes quantities of this kind; empty for a pure number.
    #[must_use]
    pub fn unit(&self) -> &str {
        &self.unit
    }
}

/// With all digits: `12.5 N*m`.
impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.quantity {
            Quantity::Number(x) => write!(f, "{x}")?,
            Quantity::Vector(x, y) => write!(f, "({x}, {y})")?,
            Quantity::Condition(holds) => return write!(f, "{holds}"),
            Quantity::Undefined => return f.write_str("undefined"),
        }
        if self.unit.is_empty() { Ok(()) } else { write!(f, " {}", self.unit) }
    }
}
