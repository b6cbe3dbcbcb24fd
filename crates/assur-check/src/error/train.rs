//! What can be wrong with wheels and what runs between them.

use assur_text::source::Span;
use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// Errors of wheels, shafts and transmissions.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum TrainError {
    /// Two wheels of one shaft that are to drive each other.
    #[error("`{name}` joins `{first}` and `{second}`, which both sit on `{link}`")]
    #[diagnostic(
        code("mech::train::same_shaft"),
        help("wheels on one shaft turn as one; {what} joins wheels of two shafts")
    )]
    SameShaft {
        /// What joins them, with its article.
        what: &'static str,
        /// Its name.
        name: String,
        /// The first wheel.
        first: String,
        /// The second wheel.
        second: String,
        /// Their link.
        link: String,
        /// The first.
        #[label("on `{link}`")]
        first_span: Span,
        /// The second.
        #[label(primary, "on `{link}` too")]
        second_span: Span,
    },
    /// Two wheels whose axes no link holds at a distance.
    #[error("nothing holds the axes of `{first}` and `{second}` at a distance: {why}")]
    #[diagnostic(code("mech::train::no_carrier"))]
    NoCarrier {
        /// The first wheel.
        first: String,
        /// The second wheel.
        second: String,
        /// On what each of them turns.
        why: String,
        /// What to write.
        #[help]
        help: String,
        /// The transmission.
        #[label(primary, "joins them")]
        span: Span,
    },
    /// A shaft of the ground that meshes with a fixed wheel.
    #[error("`{shaft}` turns on the ground and meshes with the fixed wheel `{fixed}`: it cannot turn")]
    #[diagnostic(code("mech::train::no_carrier"))]
    Stands {
        /// The shaft.
        shaft: String,
        /// The wheel of the ground.
        fixed: String,
        /// What to write.
        #[help]
        help: String,
        /// The mesh.
        #[label(primary, "with a fixed wheel")]
        span: Span,
        /// The shaft.
        #[label("on the ground")]
        shaft_span: Span,
    },
    /// Sizes that do not agree.
    #[error("{message}")]
    #[diagnostic(code("mech::train::sizes"))]
    Sizes {
        /// What does not agree, with the numbers.
        message: String,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// An internal mesh of two wheels of one size.
    #[error("`{first}` and `{second}` are of one size ({size}): neither fits into the other")]
    #[diagnostic(
        code("mech::train::internal"),
        help(
            "in an internal mesh the larger wheel is the ring; leave `internal` out where both have outer teeth"
        )
    )]
    Internal {
        /// The first wheel.
        first: String,
        /// The second wheel.
        second: String,
        /// Their size.
        size: String,
        /// The mesh.
        #[label(primary, "internal")]
        span: Span,
    },
    /// Placed wheels that do not touch.
    #[error("`{first}` and `{second}` stand {distance} apart, but {rule} is {due}")]
    #[diagnostic(
        code("mech::train::centre_distance"),
        help("move one of the axes, or change a size: {rule} must be the distance of the axes")
    )]
    CentreDistance {
        /// The first wheel.
        first: String,
        /// The second wheel.
        second: String,
        /// The distance of their axes.
        distance: String,
        /// `the sum of their radii`
        rule: &'static str,
        /// What it comes to.
        due: String,
        /// The mesh.
        #[label(primary, "cannot touch")]
        span: Span,
    },
    /// A planet that cannot mesh on both sides.
    #[error(
        "shaft `{shaft}` cannot turn about one axis: `{first}` asks for an arm of {one}, `{second}` for {two}"
    )]
    #[diagnostic(code("mech::train::planet_distance"), severity(Warning), help("{help}"))]
    PlanetDistance {
        /// What to write.
        help: String,
        /// The planet's shaft.
        shaft: String,
        /// The first mesh.
        first: String,
        /// The second mesh.
        second: String,
        /// The arm of the first.
        one: String,
        /// The arm of the second.
        two: String,
        /// The first mesh.
        #[label("an arm of {one}")]
        first_span: Span,
        /// The second mesh.
        #[label(primary, "an arm of {two}")]
        second_span: Span,
    },
    /// A rope that runs nowhere.
    #[error("{message}")]
    #[diagnostic(code("mech::train::rope_end"))]
    RopeEnd {
        /// What is wrong.
        message: String,
        /// What to write.
        #[help]
        help: String,
        /// Place.
        #[label(primary, "here")]
        span: Span,
    },
    /// An efficiency that is none.
    #[error("an efficiency lies above 0 and not above 1, this is {value}")]
    #[diagnostic(code("mech::train::efficiency"), help("{help}"))]
    Efficiency {
        /// What is written.
        value: String,
        /// What to write.
        help: String,
        /// Place.
        #[label(primary, "more than goes in")]
        span: Span,
    },
}
