//! Which position is meant: its name, where it comes from, the values of the drives.

use crate::math::Vec2;
use crate::model::Value;

/// A position to be solved.
#[derive(Clone, Debug)]
pub struct PoseRequest {
    /// Its name in the file, or the values of its drives.
    pub name: String,
    /// Where it comes from.
    pub origin: PoseOrigin,
    /// The values of the drives, in their order.
    pub drives: Vec<DriveValue>,
}

/// Where a pose comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PoseOrigin {
    /// The drives' own values; counted from 0.
    Sweep(usize),
    /// A `pose` statement: index into [`crate::model::Mechanism::poses`].
    Named(usize),
    /// An `expect … at`: index into [`crate::model::Mechanism::expects`].
    Expected(usize),
}

/// Value of a drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DriveValue {
    /// Angle, rad, or coordinate, m.
    Scalar(f64),
    /// Place of a driven point, m.
    Point(Vec2),
    None,
}

impl DriveValue {
    /// Of a value of the language.
    #[must_use]
    pub const fn of(value: Value) -> Self {
        match value {
            Value::Scalar(x) => Self::Scalar(x),
            Value::Vector(v) => Self::Point(v),
            Value::Bool(_) => Self::None,
        }
    }

    /// As a value of the language; `None` for rates only.
    #[must_use]
    pub const fn value(&self) -> Option<Value> {
        match self {
            Self::Scalar(x) => Some(Value::Scalar(*x)),
            Self::Point(p) => Some(Value::Vector(*p)),
            Self::None => None,
        }
    }
}
