//! Units and dimensions.

use assur_text::diagnostic::{Fix, Help, Problem};
use assur_text::source::Span;
use assur_text::units::Dimension;
use miette::Diagnostic;
use thiserror::Error;

/// Errors of units in an expression.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum UnitsError {
    /// A word after a number is not a unit.
    #[error("{why}")]
    #[diagnostic(code("mech::unit::unknown"))]
    Unknown {
        why: String,
        /// What the help replaces.
        #[label(primary, "not a unit")]
        span: Span,
        #[help]
        help: Option<Help>,
    },
    /// A number without a unit where a quantity is expected.
    #[error("{what} needs a unit: it is {want}")]
    #[diagnostic(code("mech::unit::missing"))]
    Missing {
        /// The purpose of the number.
        what: String,
        want: Dimension,
        #[label(primary, "a number without a unit")]
        span: Span,
        /// Its use, if that is elsewhere.
        #[label("used here")]
        used: Option<Span>,
        /// The number with the unit that is most likely.
        #[help]
        help: Help,
    },
    /// A quantity of another dimension than expected.
    #[error("{what} should be {want}, but this is {found}")]
    #[diagnostic(code("mech::unit::mismatch"))]
    Mismatch {
        what: String,
        want: String,
        found: String,
        #[label(primary, "{found}")]
        span: Span,
        #[help]
        help: Option<String>,
    },
    /// Two quantities that cannot be added or compared.
    #[error("{left} and {right} cannot be {verb}")]
    #[diagnostic(code("mech::unit::operands"))]
    Operands {
        /// `added`, `compared`, …
        verb: &'static str,
        left: String,
        right: String,
        #[label("{left}")]
        left_span: Span,
        #[label(primary, "{right}")]
        right_span: Span,
        #[help]
        help: Option<String>,
    },
    /// Turns per time, which may be revolutions or radians.
    #[error("{what} is an angular velocity, and `{unit}` may mean revolutions or radians")]
    #[diagnostic(code("mech::unit::hertz"))]
    Hertz {
        what: String,
        /// `Hz`, `1/min`
        unit: String,
        #[label(primary, "revolutions or radians?")]
        span: Span,
        /// Its use, if that is elsewhere.
        #[label("used here")]
        used: Option<Span>,
        /// The two possible values.
        #[help]
        help: Help,
    },
    /// A number where a vector is expected, or a vector where a number is expected, or a condition.
    #[error("{what} should be {want}, but this is {found}")]
    #[diagnostic(code("mech::unit::shape"))]
    Shape {
        what: String,
        /// `a vector`
        want: &'static str,
        /// `a number`
        found: &'static str,
        #[label(primary, "{found}")]
        span: Span,
        #[help]
        help: Option<String>,
    },
    /// A power or root that has no dimension.
    #[error("{what} has no dimension")]
    #[diagnostic(code("mech::unit::power"))]
    Power {
        /// `the square root of a length`
        what: String,
        #[label(primary, "{base}")]
        span: Span,
        /// The dimension of the base.
        base: Dimension,
        #[help]
        help: Option<String>,
    },
    /// A constant expression that is not defined.
    #[error("this expression is not defined: {why}")]
    #[diagnostic(code("mech::unit::no_value"))]
    NoValue {
        /// `division by zero`
        why: &'static str,
        #[label(primary, "{why}")]
        span: Span,
        #[help]
        help: Option<String>,
    },
    /// A part of a unit that is also a name of the file.
    #[error("`{name}` is read as a unit here, but it is also a name of this file")]
    #[diagnostic(
        code("mech::unit::also_a_name"),
        severity(Warning),
        help(
            "put blanks around the operator to use the name, as in `… * {name}` or `… / {name}`; or rename `{name}`"
        )
    )]
    AlsoAName {
        name: String,
        #[label(primary, "read as a unit")]
        span: Span,
        #[label("declared here")]
        declared: Span,
    },
}

impl Problem for UnitsError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            Self::Unknown { help: Some(help), .. }
            | Self::Missing { help, .. }
            | Self::Hertz { help, .. } => help.fixes().to_vec(),
            Self::Mismatch { help: Some(help), span: at, .. }
            | Self::Operands { help: Some(help), right_span: at, .. }
                // in a header, and of two vectors, more than this place changes
                if help.starts_with("write `") && !help.contains(['[', '(']) =>
            {
                Fix::quoted(help, *at)
            }
            _ => Vec::new(),
        }
    }
}
