//! Functions over the sweep.

use super::Expr;
use crate::source::Span;

/// A function over the sweep.
#[derive(Clone, Debug)]
pub struct Cycle {
    /// Place of the call.
    pub span: Span,
    pub how: CycleFunction,
    /// Of what: a number.
    pub expr: Expr,
    /// Its exponents of length, mass and time.
    pub dimension: [i8; 3],
    /// The part of a motion under loads over which it is taken.
    pub part: Part,
}

/// A part of a motion under loads; the whole of it where no bound is given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Part {
    pub after: Option<Bound>,
    pub before: Option<Bound>,
}

/// Where a part of a motion begins or ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// An instant, s.
    At(f64),
    /// An event, by index into [`super::Mechanism::events`], and which time, counted from 1.
    Event(usize, usize),
}

/// Functions over the sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CycleFunction {
    Max,
    Min,
    /// The mean over the drive's way.
    Mean,
    /// The integral over the drive's value, in the sense of the sweep.
    Integral,
    /// The drive's value at the greatest value.
    Argmax,
}
