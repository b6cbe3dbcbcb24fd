//! Values in the author's units.

use super::{Display, Value};
use crate::math::Vec2;
use crate::units::{Dimension, Unit, significant};

impl Display {
    /// A number of SI units in the author's unit.
    #[must_use]
    pub fn of_si(&self, si: f64) -> f64 {
        if self.factor == 0.0 || self.factor == 1.0 {
            return si;
        }
        Unit { factor: self.factor, dimension: Dimension::NUMBER, text: String::new() }.from_si(si)
    }

    /// A vector of SI units in the author's unit.
    #[must_use]
    pub fn of_si_vector(&self, si: Vec2) -> Vec2 {
        Vec2::new(self.of_si(si.x), self.of_si(si.y))
    }

    /// An SI value in figures, without its unit.
    #[must_use]
    pub fn figures(&self, value: Value, digits: usize) -> String {
        match value {
            Value::Scalar(x) => significant(self.of_si(x), digits),
            Value::Vector(v) => {
                let v = self.of_si_vector(v);
                format!("({}, {})", significant(v.x, digits), significant(v.y, digits))
            }
            Value::Truth(truth) => truth.to_string(),
        }
    }

    /// An SI value in figures, with its unit.
    #[must_use]
    pub fn text(&self, value: Value, digits: usize) -> String {
        let figures = self.figures(value, digits);
        match value {
            Value::Scalar(_) | Value::Vector(_) if !self.unit.is_empty() => {
                format!("{figures} {}", self.unit)
            }
            _ => figures,
        }
    }
}

impl Value {
    /// Whether it is a truth, or numbers that are finite.
    #[must_use]
    pub fn is_defined(&self) -> bool {
        match self {
            Self::Scalar(x) => x.is_finite(),
            Self::Vector(v) => v.x.is_finite() && v.y.is_finite(),
            Self::Truth(_) => true,
        }
    }

    /// Magnitude of a number or a vector; zero for a truth.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        match self {
            Self::Scalar(x) => x.abs(),
            Self::Vector(v) => libm::hypot(v.x, v.y),
            Self::Truth(_) => 0.0,
        }
    }
}
