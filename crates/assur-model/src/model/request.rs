//! Questions and expectations.

use super::{Display, DriveId, Expr};
use crate::source::Span;

/// One item of `find`.
#[derive(Clone, Debug)]
pub struct Find {
    /// Its name, or its own text with single blanks: column, JSON key, and what `expect` may use.
    pub name: String,
    /// Place of the item.
    pub span: Span,
    pub kind: FindKind,
}

/// The question of a `find` item.
#[derive(Clone, Debug)]
pub enum FindKind {
    /// A value at every pose.
    Value {
        expr: Expr,
        /// How it is printed.
        display: Display,
        /// Needs no pose: given values, `dead`, `stroke`, `time_ratio`.
        poseless: bool,
    },
    /// All reactions in all pairs.
    Reactions,
    /// A table that needs no pose.
    Table(super::Table),
}

/// One `expect`.
#[derive(Clone, Debug)]
pub struct Expect {
    /// The left side's own text with single blanks.
    pub text: String,
    /// Place of the statement.
    pub span: Span,
    pub expr: Expr,
    pub relation: Relation,
    pub tolerance: Tolerance,
    /// Its pose; `None`: the only pose of the file, all poses for a list, or no pose needed.
    pub at: Option<At>,
    /// Compared modulo one turn.
    pub angle: bool,
    /// How it is printed.
    pub display: Display,
    pub poseless: bool,
}

/// The expectation of a value.
#[derive(Clone, Debug)]
pub enum Relation {
    /// Equal: one value, or one value per pose.
    Equal(Vec<Expr>),
    /// Stands in this relation to a bound.
    Compare(super::Comparison, Expr),
    /// A condition that is true.
    Condition,
}

/// The tolerance of an equality, all in SI.
#[derive(Clone, Debug, PartialEq)]
pub enum Tolerance {
    /// Relative to the expected value.
    Relative(f64),
    Absolute(f64),
    /// Inferred from the digits written, one per expected value: absolute, SI.
    Written(Vec<f64>),
    /// Comparisons and conditions have none.
    None,
}

/// The poses of an `expect`.
#[derive(Clone, Debug)]
pub enum At {
    /// A pose by name: of the sweep (`4`), or one of its own (`4'`).
    Pose(String, Span),
    /// Drive values: solved in addition to the sweep.
    Drives(Vec<(DriveId, Expr)>),
    /// An instant of a motion under loads, s.
    Time(f64),
    /// Its first or last instant, or an event.
    Occasion(super::Occasion),
}

/// A construct that parses and checks but cannot be solved yet.
#[derive(Clone, Debug)]
pub struct Unsupported {
    /// Its name, as in "friction in a pair".
    pub what: String,
    pub span: Span,
}
