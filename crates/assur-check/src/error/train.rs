//! Errors of wheels and transmissions.

use assur_text::diagnostic::{Fix, Help, Problem};
use assur_text::source::Span;
use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// Errors of wheels, shafts and transmissions.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum TrainError {
    /// Two wheels of one shaft that should drive each other.
    #[error("`{name}` joins `{first}` and `{second}`, which are both on `{link}`")]
    #[diagnostic(
        code("mech::train::same_shaft"),
        help("put one of them on another shaft: {what} joins wheels of two shafts")
    )]
    SameShaft {
        /// The transmission, with its article.
        what: &'static str,
        name: String,
        first: String,
        second: String,
        link: String,
        #[label("on `{link}`")]
        first_span: Span,
        #[label(primary, "on `{link}` too")]
        second_span: Span,
    },
    /// Two wheels whose axes no link holds at a distance.
    #[error("no link holds the axes of `{first}` and `{second}` at a fixed distance: {why}")]
    #[diagnostic(code("mech::train::no_carrier"))]
    NoCarrier {
        first: String,
        second: String,
        /// The links on which they turn.
        why: String,
        #[help]
        help: String,
        #[label(primary, "joins them")]
        span: Span,
    },
    /// A shaft of the ground that meshes with a fixed wheel.
    #[error("`{shaft}` cannot turn: its axis is on the ground and it meshes with the fixed wheel `{fixed}`")]
    #[diagnostic(code("mech::train::no_carrier"))]
    Stands {
        shaft: String,
        /// The wheel of the ground.
        fixed: String,
        #[help]
        help: String,
        #[label(primary, "with a fixed wheel")]
        span: Span,
        #[label("on the ground")]
        shaft_span: Span,
    },
    /// Sizes that do not agree.
    #[error("{message}")]
    #[diagnostic(code("mech::train::sizes"))]
    Sizes {
        /// The sizes that do not agree, with the numbers.
        message: String,
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// An internal mesh of two wheels of one size.
    #[error("`{first}` and `{second}` have the same size ({size}): neither fits into the other")]
    #[diagnostic(
        code("mech::train::internal"),
        help("make one wheel larger, it is the ring; or leave out `internal` if both have outer teeth")
    )]
    Internal {
        first: String,
        second: String,
        size: String,
        #[label(primary, "internal")]
        span: Span,
    },
    /// Placed wheels that do not touch.
    #[error("the axes of `{first}` and `{second}` are {distance} apart, but {rule} is {due}")]
    #[diagnostic(
        code("mech::train::centre_distance"),
        help("move one of the axes, or change a size: {rule} must equal the distance of the axes")
    )]
    CentreDistance {
        first: String,
        second: String,
        /// The distance of their axes.
        distance: String,
        /// `the sum of their radii`
        rule: &'static str,
        due: String,
        #[label(primary, "cannot touch")]
        span: Span,
    },
    /// A planet that cannot mesh on both sides.
    #[error(
        "planet `{shaft}` cannot mesh on both sides: `{first}` needs an arm of {one}, `{second}` needs {two}"
    )]
    #[diagnostic(code("mech::train::planet_distance"), severity(Warning), help("{help}"))]
    PlanetDistance {
        help: Help,
        shaft: String,
        first: String,
        second: String,
        /// The arm of the first.
        one: String,
        /// The arm of the second.
        two: String,
        #[label("an arm of {one}")]
        first_span: Span,
        #[label(primary, "an arm of {two}")]
        second_span: Span,
    },
    /// Two wheels on one axis that a planet turns alike.
    #[error(
        "`{first}` and `{second}` turn alike: both mesh with planet `{shaft}` from outside, at the ratio {ratio} seen from its \
         carrier"
    )]
    #[diagnostic(
        code("mech::train::turn_alike"),
        severity(Advice),
        help(
            "for a differential give the carrier a second planet that meshes with `{shaft}`, and let `{second}` mesh with that \
             one: side wheels of a bevel differential turn in opposite senses"
        )
    )]
    TurnAlike {
        shaft: String,
        /// The shaft of the first wheel.
        first: String,
        /// The shaft of the second.
        second: String,
        /// Speed of the wheels for one of the planet's.
        ratio: String,
        #[label("turns `{first}`")]
        first_span: Span,
        #[label(primary, "turns `{second}` in the same sense")]
        second_span: Span,
    },
    /// A rope with a wrong end.
    #[error("{message}")]
    #[diagnostic(code("mech::train::rope_end"))]
    RopeEnd {
        message: String,
        #[help]
        help: String,
        #[label(primary, "here")]
        span: Span,
    },
    /// An efficiency out of range.
    #[error("the efficiency must be between 0 and 1; got {value}")]
    #[diagnostic(code("mech::train::efficiency"), help("{help}"))]
    Efficiency {
        value: String,
        help: String,
        #[label(primary, "out of range")]
        span: Span,
    },
}

impl Problem for TrainError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            Self::Efficiency { help, span, .. } => Fix::quoted(help, *span),
            Self::PlanetDistance { help, .. } => help.fixes().to_vec(),
            _ => Vec::new(),
        }
    }
}
