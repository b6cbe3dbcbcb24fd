//! Quantities: letters with a value.

use crate::expr::Expr;
use crate::name::Name;
use crate::number::{Figures, shortest, with_digits};
use crate::unit::Unit;
use std::sync::Arc;

/// A quantity with its value: in SI, angles in degrees.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    pub name: Name,
    pub value: f64,
    pub unit: Unit,
    /// What it is large against: less than a part of this is rounding.
    pub scale: f64,
    /// The file states it: it keeps its digits.
    pub given: bool,
    /// How far rounding in what it comes from may have moved it.
    pub rounding: f64,
}

/// What is left of a difference of equal numbers, over these.
pub(crate) const ROUNDING: f64 = 1e-11;
/// The most digits that a given value keeps.
const GIVEN: usize = 7;

impl Quantity {
    /// Whether it is nothing but rounding.
    #[must_use]
    pub fn is_nothing(&self) -> bool {
        self.value.abs() <= ROUNDING * self.scale
    }

    /// As a number in an equation, with this number of digits where it does not keep its own.
    #[must_use]
    pub fn figures(&self, digits: usize) -> Figures {
        if self.is_nothing() {
            return Figures::zero();
        }
        if self.given
            && let Some(figures) = shortest(self.value, GIVEN)
        {
            return figures;
        }
        with_digits(self.value, digits)
    }
}

/// A quantity as a leaf of formulas.
#[must_use]
pub fn quantity(name: Name, value: f64, unit: Unit) -> Expr {
    Expr::Leaf(Arc::new(Quantity { name, value, unit, scale: value.abs(), given: false, rounding: 0.0 }))
}
