//! Units and dimensions.

use assur_text::source::Span;
use assur_text::units::Dimension;
use miette::Diagnostic;
use thiserror::Error;

/// What can be wrong with the units of an expression.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum UnitsError {
    /// A word after a number is no unit.
    #[error("{why}")]
    #[diagnostic(code("mech::unit::unknown"))]
    Unknown {
        /// What is wrong with it.
        why: String,
        /// What the help replaces.
        #[label(primary, "not a unit")]
        span: Span,
        /// What may have been meant.
        #[help]
        help: Option<String>,
    },
    /// A bare number where a quantity is due.
    #[error("{what} needs a unit: it is {want}")]
    #[diagnostic(code("mech::unit::missing"), help("write {example}"))]
    Missing {
        /// What the number is for.
        what: String,
        /// What is due.
        want: Dimension,
        /// The number.
        #[label(primary, "a number without a unit")]
        span: Span,
        /// Where it is used, if that is elsewhere.
        #[label("used here")]
        used: Option<Span>,
        /// The number with the unit that is most likely.
        example: String,
    },
    /// A quantity of another dimension than the one due.
    #[error("{what} should be {want}, but this is {found}")]
    #[diagnostic(code("mech::unit::mismatch"))]
    Mismatch {
        /// What it is for.
        what: String,
        /// What is due.
        want: String,
        /// What is there.
        found: String,
        /// Where it stands.
        #[label(primary, "{found}")]
        span: Span,
        /// What would correct it.
        #[help]
        help: Option<String>,
    },
    /// Two quantities that cannot be added or compared.
    #[error("{left} and {right} cannot be {verb}")]
    #[diagnostic(code("mech::unit::operands"))]
    Operands {
        /// `added`, `compared`, …
        verb: &'static str,
        /// The left one.
        left: String,
        /// The right one.
        right: String,
        /// Its place.
        #[label("{left}")]
        left_span: Span,
        /// Its place.
        #[label(primary, "{right}")]
        right_span: Span,
        /// What would correct it.
        #[help]
        help: Option<String>,
    },
    /// Turns per time, which may be revolutions or radians.
    #[error("{what} is an angular velocity: does `{unit}` mean revolutions or radians?")]
    #[diagnostic(code("mech::unit::hertz"))]
    Hertz {
        /// What it is for.
        what: String,
        /// `Hz`, `1/min`
        unit: String,
        /// Where it stands.
        #[label(primary, "revolutions or radians?")]
        span: Span,
        /// Where it is used, if that is elsewhere.
        #[label("used here")]
        used: Option<Span>,
        /// The two values that may be meant.
        #[help]
        help: String,
    },
    /// A number where a vector is due, or the other way round, or a truth.
    #[error("{what} should be {want}, but this is {found}")]
    #[diagnostic(code("mech::unit::shape"))]
    Shape {
        /// What it is for.
        what: String,
        /// `a vector`
        want: &'static str,
        /// `a number`
        found: &'static str,
        /// Where it stands.
        #[label(primary, "{found}")]
        span: Span,
        /// What would correct it.
        #[help]
        help: Option<String>,
    },
    /// A power or root that has no dimension.
    #[error("{what} has no dimension")]
    #[diagnostic(code("mech::unit::power"))]
    Power {
        /// `the square root of a length`
        what: String,
        /// The base.
        #[label(primary, "{base}")]
        span: Span,
        /// What the base is.
        base: Dimension,
        /// What would correct it.
        #[help]
        help: Option<String>,
    },
    /// A constant expression without value.
    #[error("this has no value: {why}")]
    #[diagnostic(code("mech::unit::no_value"))]
    NoValue {
        /// `division by zero`
        why: &'static str,
        /// Where it stands.
        #[label(primary, "{why}")]
        span: Span,
        /// The numbers.
        #[help]
        help: Option<String>,
    },
    /// A part of a unit that is also a name of the file.
    #[error("`{name}` is read as a unit here, and it is also a name of this file")]
    #[diagnostic(
        code("mech::unit::also_a_name"),
        severity(Warning),
        help(
            "for the name, put blanks around the operator, as in `… * {name}` or `… / {name}`; or rename `{name}`"
        )
    )]
    AlsoAName {
        /// The word.
        name: String,
        /// The unit.
        #[label(primary, "read as a unit")]
        span: Span,
        /// The name's declaration.
        #[label("declared here")]
        declared: Span,
    },
}
