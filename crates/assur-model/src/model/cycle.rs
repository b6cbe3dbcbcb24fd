//! Functions over the sweep.

use super::Expr;
use crate::source::Span;

/// A function over the sweep.
#[derive(Clone, Debug)]
pub struct Cycle {
    /// Place of the call.
    pub span: Span,
    /// The computed quantity.
    pub how: CycleFunction,
    /// Of what: a number.
    pub expr: Expr,
}

/// Functions over the sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CycleFunction {
    /// The greatest value.
    Max,
    /// The least value.
    Min,
    /// The mean over the drive's way.
    Mean,
    /// The integral over the drive's value, in the sense of the sweep.
    Integral,
    /// The drive's value at the greatest value.
    Argmax,
}
