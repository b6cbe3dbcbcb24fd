//! Motion under given loads.

use super::Expr;
use crate::source::Span;

/// `simulate 0 s .. 2 s in 200 steps within 1e-8`
#[derive(Clone, Debug)]
pub struct Simulation {
    /// Place of the statement.
    pub span: Span,
    /// The first instant, s.
    pub from: f64,
    /// The last, s; after the first.
    pub to: f64,
    /// Number of steps between printed instants; `None` for the first and the last alone.
    pub steps: Option<usize>,
    /// The wanted accuracy of all that is printed, relative to the greatest of its kind; `None` where the file says nothing.
    pub within: Option<f64>,
}

impl Simulation {
    /// The accuracy where nothing else is wanted.
    pub const WITHIN: f64 = 1e-9;

    /// How many instants are printed.
    #[must_use]
    pub fn instants(&self) -> usize {
        self.steps.unwrap_or(1) + 1
    }

    /// A printed instant, s, counted from 0.
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // steps are at most a million
    pub fn instant(&self, index: usize) -> f64 {
        let steps = self.steps.unwrap_or(1);
        if index >= steps {
            self.to
        } else {
            self.from + (self.to - self.from) * (index as f64 / steps as f64)
        }
    }
}

/// `event top: omega(bar) = 0 rad/s falling`, `until angle(crank) = 360 deg`
#[derive(Clone, Debug)]
pub struct Event {
    /// Its name; an end by `until` has none.
    pub name: Option<String>,
    /// Place of the statement.
    pub span: Span,
    /// A number that passes zero where it happens; of a condition one that is positive where it is true.
    pub value: Expr,
    /// It counts where the number rises, or falls, alone.
    pub rising: Option<bool>,
    /// The motion ends there.
    pub ends: bool,
}

/// The instant of a motion that an expectation is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Occasion {
    /// The first instant.
    Begin,
    /// The last.
    End,
    /// An event, by index into [`super::Mechanism::events`], and which time, counted from 1.
    Event(usize, usize),
}
