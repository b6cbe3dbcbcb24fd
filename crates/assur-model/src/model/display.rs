//! How a value is printed.

use crate::math::Vec2;
use crate::units::Conversion;

/// How a value is printed: SI value over `factor`, followed by `unit`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Display {
    /// Unit as the author writes it; empty for plain numbers and conditions.
    pub unit: String,
    /// SI value of one unit.
    pub factor: f64,
    /// Exponents of length, mass, time; the angle kind.
    pub dimension: [i8; 4],
}

impl Display {
    /// A number of SI units in the author's unit.
    #[must_use]
    pub fn of_si(&self, si: f64) -> f64 {
        Conversion::into_units_of(self.factor).of(si)
    }

    /// A vector of SI units in the author's unit.
    #[must_use]
    pub fn of_si_vector(&self, si: Vec2) -> Vec2 {
        Vec2::new(self.of_si(si.x), self.of_si(si.y))
    }
}
