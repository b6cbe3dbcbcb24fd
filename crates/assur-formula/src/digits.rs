//! The digits of an equation: as few as let it balance from what is printed.

use crate::expr::Expr;
use crate::number::{Figures, LARGE, with_decimals, with_digits, with_power};
use crate::quantity::ROUNDING;

/// The digits that leaves start with, and the most of them.
const FEWEST: usize = 5;
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
