//! Errors of loads and unknown loads.

use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors of gravity, loads and balances.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum LoadError {
    /// A force on a link without a point.
    #[error("{what} on `{link}` has no point")]
    #[diagnostic(
        code("mech::geometry::force_without_place"),
        help("give the point at which it acts: `{example}`")
    )]
    ForceWithoutPlace {
        /// The force, with its article.
        what: String,
        link: String,
        /// As it should look.
        example: String,
        #[label("the point is missing")]
        span: Span,
    },
    /// An unknown force without direction.
    #[error("the force `{name}` has no direction")]
    #[diagnostic(code("mech::geometry::force_without_direction"), help("give its direction: `{example}`"))]
    ForceWithoutDirection {
        name: String,
        /// As it should look.
        example: String,
        #[label("the direction is missing")]
        span: Span,
    },
    /// A word that does not belong to this kind of load.
    #[error("{message}")]
    #[diagnostic(code("mech::geometry::load_form"), help("{help}"))]
    Form {
        /// The words that do not fit together.
        message: String,
        help: String,
        /// The word or value.
        #[label("does not fit here")]
        span: Span,
    },
    /// A force in a hinge, a torque in a slide.
    #[error("`{pair}` is {is}: {fits} acts between its links, not {given}")]
    #[diagnostic(code("mech::geometry::wrong_effort"), help("{help}"))]
    WrongEffort {
        pair: String,
        is: String,
        /// The effort that acts in it.
        fits: String,
        given: String,
        help: String,
        /// The pair in the load.
        #[label(primary, "{is}")]
        span: Span,
        /// `force` or `torque`.
        #[label("{given}")]
        kind: Span,
    },
    /// A load depends on a force, or an acceleration, that is found from the loads.
    #[error("{what} must not depend on {on}")]
    #[diagnostic(code("mech::geometry::depends_on_forces"), help("{help}"))]
    DependsOnForces {
        /// The load or its condition.
        what: String,
        /// The result it asks for.
        on: String,
        /// What it may depend on.
        help: String,
        #[label("{on}")]
        span: Span,
    },
}

impl assur_text::diagnostic::Problem for LoadError {}
