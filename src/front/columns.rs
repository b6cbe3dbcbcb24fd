//! The answers of many positions as columns of numbers.

use super::solution::{Diagnostics, Expectation};
use std::ops::{Deref, Range};
use std::sync::Arc;

/// The answers of all positions, column by column, SI and radians. NaN where a position has no answer.
#[derive(Clone, Debug, Default)]
pub struct Columns {
    /// What heads the names of positions: `pose`, or that of instants.
    pub pose_header: String,
    /// How many positions there are.
    pub len: usize,
    /// Names of positions that are not their number, counted from 1, with the index of the position.
    pub names: Vec<(usize, String)>,
    /// The columns: drives, what is asked for, reactions.
    pub columns: Vec<Column>,
    /// The residuals of independent equations.
    pub residuals: Residuals,
    /// The least condition figure of all groups, in (0, 1].
    pub condition: Values,
    /// The positions without a solution.
    pub failures: Vec<PoseFailure>,
    /// The expectations of the text, if the positions are its own.
    pub expectations: Vec<Expectation>,
    /// Warnings and errors.
    pub diagnostics: Diagnostics,
}

/// A column of numbers.
#[derive(Clone, Debug)]
pub struct Column {
    /// Its name, with `.x` or `.y` for a component of a vector.
    pub name: String,
    /// Its SI unit; empty for plain numbers.
    pub unit: String,
    /// The author's unit.
    pub written: WrittenUnit,
    /// It shows a condition: 1 is true, 0 false.
    pub condition: bool,
    /// Its numbers in SI.
    pub values: Values,
}

/// A unit of the author.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WrittenUnit(assur_model::model::Display);

impl WrittenUnit {
    pub(super) const fn of(display: assur_model::model::Display) -> Self {
        Self(display)
    }

    /// Its spelling; empty for plain numbers.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.0.unit
    }

    /// A number of SI units in this unit.
    #[must_use]
    pub fn of_si(&self, si: f64) -> f64 {
        self.0.of_si(si)
    }
}

/// Residuals, position by position. NaN where there are none: without forces, without speeds.
#[derive(Clone, Debug, Default)]
pub struct Residuals {
    /// Worst mismatch of the pairs over the size of the mechanism.
    pub closure: Values,
    /// Worst equilibrium of a link over the greatest force.
    pub equilibrium: Values,
    /// Sum of the powers over the greatest force times the greatest velocity.
    pub power: Values,
}

/// A position without a solution.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PoseFailure {
    /// Its index, from 0.
    pub index: usize,
    /// `mech::<stage>::<what_is_wrong>`
    pub code: Option<String>,
    /// The reason.
    pub message: String,
}

/// The numbers of a column: a part of memory that all columns of a solution share.
#[derive(Clone, Debug, Default)]
pub struct Values {
    memory: Arc<Vec<f64>>,
    first: usize,
    len: usize,
}

impl Deref for Values {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        &self.memory[self.first..self.first + self.len]
    }
}

impl Values {
    pub(super) const fn of(memory: Arc<Vec<f64>>, first: usize, len: usize) -> Self {
        Self { memory, first, len }
    }

    /// The memory, and where the numbers are in it.
    #[must_use]
    pub fn into_parts(self) -> (Arc<Vec<f64>>, Range<usize>) {
        (self.memory, self.first..self.first + self.len)
    }
}
