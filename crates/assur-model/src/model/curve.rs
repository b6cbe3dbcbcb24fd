//! Functions that the file gives by tables of values.

use super::Display;
use crate::math::{Piece, TableFunction};
use crate::source::Span;
use crate::units::significant;

/// A curve: a function from a table.
#[derive(Clone, Debug)]
pub struct Curve {
    pub name: String,
    /// Place of its name.
    pub span: Span,
    /// The function, SI to SI.
    pub function: TableFunction,
    /// The unit of its arguments.
    pub argument: Display,
}

/// A long table is seldom compared with another one.
impl PartialEq for Curve {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other) || (self.span == other.span && self.function == other.function)
    }
}

/// What is asked of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurvePart {
    Value,
    /// The derivative by the argument.
    Slope,
}

impl Curve {
    /// The value or the slope at an argument, SI; not a number beyond the table.
    #[must_use]
    pub fn at(&self, part: CurvePart, x: f64) -> f64 {
        match part {
            CurvePart::Value => self.function.value(x),
            CurvePart::Slope => self.function.derivatives(x)[1],
        }
    }

    /// The same of the function that holds on a piece, also beside it.
    #[must_use]
    pub fn on(&self, part: CurvePart, piece: Piece, x: f64) -> f64 {
        let [value, slope, ..] = self.function.derivatives_on(piece, x);
        match part {
            CurvePart::Value => value,
            CurvePart::Slope => slope,
        }
    }

    /// An argument in the unit of the table.
    #[must_use]
    pub fn shown(&self, argument: f64) -> String {
        let text = significant(self.argument.of_si(argument), 6);
        format!("{text} {}", self.argument.unit).trim_end().to_owned()
    }

    /// The arguments of the table: `0 deg to 360 deg`.
    #[must_use]
    pub fn extent(&self) -> String {
        let (first, last) = self.function.range();
        format!("{} to {}", self.shown(first), self.shown(last))
    }
}
