//! A unit as an author wrote it.

use super::Dimension;
use std::fmt;

/// A unit: how many SI units it is, and how it was written.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// How many SI units it is.
    pub factor: f64,
    pub dimension: Dimension,
    /// Its spelling, as found in the text.
    pub text: String,
}

impl Unit {
    /// The SI unit of a dimension; its spelling is empty for a plain number.
    #[must_use]
    pub fn si(dimension: Dimension) -> Self {
        Self { factor: 1.0, dimension, text: dimension.si_text() }
    }

    /// A value in this unit, in SI.
    #[must_use]
    pub fn to_si(&self, value: f64) -> f64 {
        whole_reciprocal(self.factor).map_or(value * self.factor, |n| value / n)
    }

    /// An SI value, in this unit.
    #[must_use]
    pub fn from_si(&self, value: f64) -> f64 {
        Conversion::into_units_of(self.factor).of(value)
    }
}

/// 2⁵²: what is added to it has no digits behind the point.
const WHOLE: f64 = 4_503_599_627_370_496.0;

/// The whole number that a factor below one is the reciprocal of: dividing by 1000 rounds right where multiplying by
/// 0.001 need not.
pub(super) fn whole_reciprocal(factor: f64) -> Option<f64> {
    if factor >= 1.0 {
        return None;
    }
    // the nearest whole number, where there is one that is meant
    let n = (1.0 / factor + WHOLE) - WHOLE;
    (n <= 1e15 && 1.0 / n == factor).then_some(n)
}

/// From SI into a unit, as [`Unit::from_si`], with what does not depend on the number found once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Conversion {
    None,
    Times(f64),
    Over(f64),
}

impl Conversion {
    /// Into units of so many SI units; 0 stands for 1.
    #[must_use]
    pub fn into_units_of(factor: f64) -> Self {
        match whole_reciprocal(factor) {
            _ if factor == 0.0 || factor == 1.0 => Self::None,
            Some(n) => Self::Times(n),
            None => Self::Over(factor),
        }
    }

    /// A number of SI units in this unit.
    #[inline]
    #[must_use]
    pub fn of(self, si: f64) -> f64 {
        match self {
            Self::None => si,
            Self::Times(n) => si * n,
            Self::Over(factor) => si / factor,
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}
