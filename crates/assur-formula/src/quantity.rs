//! Quantities: letters with a value.

use crate::expr::Expr;
use crate::number::{Figures, LARGE, shortest, with_decimals, with_digits, with_power};
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

/// A number without letters, with as many digits as its equation needs.
#[must_use]
pub fn rounded(value: f64) -> Expr {
    quantity(Name::default(), value, Unit::One)
}

// The digits of an equation: as few as let it balance from what is printed.

/// The digits that leaves start with, and the most of them.
pub(crate) const FEWEST: usize = 5;
const MOST: usize = 9;
/// How far the evaluated side may miss the printed result, in units of its last digit.
const MISS: f64 = 0.98;

/// The printed result, the digits of the leaves, and whether the equation balances.
pub(crate) fn of(value: f64, right: &Expr) -> (Figures, usize, bool) {
    let result = result(value, right);
    for digits in FEWEST..=MOST {
        let printed = right.value_of(&|q| q.figures(digits).value());
        if (printed - result.value()).abs() <= MISS * result.last_digit() {
            return (result, digits, true);
        }
    }
    (result, MOST, false)
}

/// Five significant digits of the largest term.
fn result(value: f64, right: &Expr) -> Figures {
    let (largest, scale) = (right.largest_term(), right.scale());
    let nothing = value.abs() <= ROUNDING * scale;
    let of = if nothing { scale } else { largest.max(value.abs()) };
    if of == 0.0 || !of.is_finite() {
        return Figures::zero();
    }
    if !nothing && of <= value.abs() {
        return with_digits(value, FEWEST);
    }
    let text = format!("{:.4e}", of);
    let first: i32 = text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    let value = if nothing { 0.0 } else { value };
    if of >= LARGE && value.abs() < of {
        with_power(value, first, 4)
    } else {
        with_decimals(value, (4 - first).max(0))
    }
}

// Letters of quantities.

/// The letters of a quantity: `R` with the index 12 and the mark t.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Name {
    pub letter: String,
    pub sub: String,
    /// The mark above: n, t, k.
    pub sup: String,
    pub vector: bool,
}

impl Name {
    /// A letter with an index.
    #[must_use]
    pub fn new(letter: &str, sub: &str) -> Self {
        Self { letter: letter.to_owned(), sub: sub.to_owned(), ..Self::default() }
    }

    #[must_use]
    pub fn marked(&self, sup: &str) -> Self {
        Self { sup: sup.to_owned(), ..self.clone() }
    }

    /// With more behind its index; behind a word a letter is set apart.
    #[must_use]
    pub fn and(&self, more: &str) -> Self {
        let is_letter = more.len() == 1 && more.chars().all(char::is_alphabetic);
        let word = self.sub.chars().rev().take_while(|c| c.is_alphabetic()).count() > 2;
        let apart = if is_letter && word { "," } else { "" };
        Self { sub: format!("{}{apart}{more}", self.sub), ..self.clone() }
    }

    /// Its index, or its letter where it has none.
    #[must_use]
    pub fn sub_or_letter(&self) -> String {
        if self.sub.is_empty() { self.letter.clone() } else { self.sub.clone() }
    }

    #[must_use]
    pub fn arrow(&self) -> Self {
        Self { vector: true, ..self.clone() }
    }
}
