//! Questions and expectations.

use super::{Expr, Name, Number, Setting};
use assur_text::source::{Span, Spanned};

/// `find F_I3 = inertia_force(piston), Mb as kN*m, reactions`
#[derive(Clone, Debug, PartialEq)]
pub struct Find {
    pub items: Vec<FindItem>,
}

/// One thing to find.
#[derive(Clone, Debug, PartialEq)]
pub struct FindItem {
    /// The name it is given.
    pub name: Option<Name>,
    pub value: Expr,
    /// What is asked, printed from the tree: what it is called where it has no name.
    pub text: String,
    /// `in 72 steps`
    pub steps: Option<Expr>,
    /// `as kN*m`: the unit to print it in, not looked up.
    pub unit: Option<Spanned<String>>,
    pub span: Span,
}

/// `expect Mb = 26 N*m within 1 % at crank = 90 deg`
#[derive(Clone, Debug, PartialEq)]
pub struct Expect {
    /// What is expected: a quantity where `values` follow, otherwise a condition.
    pub what: Expr,
    /// That, printed from the tree.
    pub text: String,
    /// The values after `=`; empty for a condition such as `locked()` or `a > b`.
    pub values: Vec<Expr>,
    pub within: Option<Expr>,
    /// The pose it holds for.
    pub at: Option<ExpectAt>,
}

/// The pose an expectation holds for.
#[derive(Clone, Debug, PartialEq)]
pub enum ExpectAt {
    /// `at pose 4'`
    Pose(Name),
    /// `at event top 2`, and which of them.
    Event(Name, Option<Spanned<usize>>),
    /// `at crank = 90 deg`, `at time = 1 s`
    Settings(Vec<Setting>),
}

/// `variants { … }`
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Variants {
    pub columns: Vec<Column>,
    /// The rows; a row's length may differ from the header's.
    pub rows: Vec<Row>,
    /// The names in a header that could not be read.
    pub bad: Vec<String>,
}

/// `curve p periodic { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    pub name: Name,
    /// What is between its points; absent for monotone cubics.
    pub between: Option<CurveBetween>,
    /// What is beyond its ends; absent for nothing.
    pub beyond: Option<CurveBeyond>,
    /// Argument and value, and the points.
    pub table: Variants,
}

/// How values between points are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveBetween {
    /// `linear`
    Linear,
    /// `smooth`
    Smooth,
}

/// What holds beyond the ends of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveBeyond {
    /// `periodic`
    Periodic,
    /// `held`
    Held,
}

/// `vA [m/s]`
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The name that the column sets.
    pub name: Name,
    /// The unit of its numbers, not looked up.
    pub unit: Option<Spanned<String>>,
}

/// A row of plain numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub cells: Vec<Spanned<Cell>>,
    pub span: Span,
}

/// A cell of a row.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A number without a unit.
    Number(Number),
    /// The name of the row.
    Name(String),
}

impl Cell {
    /// The cell as written, a name without its quotes.
    #[must_use]
    pub fn text(&self) -> &str {
        match self {
            Self::Number(number) => &number.text,
            Self::Name(name) => name,
        }
    }
}
