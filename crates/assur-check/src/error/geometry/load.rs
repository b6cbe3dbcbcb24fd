//! What can be wrong with loads and unknown loads.

use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors of gravity, loads and balances.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum LoadError {
    /// A force on a link without a point.
    #[error("{what} on `{link}` has no place")]
    #[diagnostic(code("mech::geometry::force_without_place"), help("a force acts at a point: `{example}`"))]
    ForceWithoutPlace {
        /// The force, with its article.
        what: String,
        /// The link.
        link: String,
        /// As it should look.
        example: String,
        /// The link's place.
        #[label("at which point?")]
        span: Span,
    },
    /// An unknown force without direction.
    #[error("the force `{name}` has no direction")]
    #[diagnostic(
        code("mech::geometry::force_without_direction"),
        help("one unknown force is a magnitude along a known direction: `{example}`")
    )]
    ForceWithoutDirection {
        /// The balance.
        name: String,
        /// As it should look.
        example: String,
        /// The statement.
        #[label("along which direction?")]
        span: Span,
    },
    /// A word that does not belong to this kind of load.
    #[error("{message}")]
    #[diagnostic(code("mech::geometry::load_form"), help("{help}"))]
    Form {
        /// What does not go together.
        message: String,
        /// What to write.
        help: String,
        /// The word or value.
        #[label("not here")]
        span: Span,
    },
    /// A force in a hinge, a torque in a slide.
    #[error("`{pair}` is {is}: between its links acts {fits}, not {given}")]
    #[diagnostic(code("mech::geometry::wrong_effort"), help("{help}"))]
    WrongEffort {
        /// The pair.
        pair: String,
        /// What it is.
        is: String,
        /// What acts in it.
        fits: String,
        /// What was written.
        given: String,
        /// What to write.
        help: String,
        /// The pair in the load.
        #[label(primary, "{is}")]
        span: Span,
        /// `force` or `torque`.
        #[label("{given}")]
        kind: Span,
    },
    /// A load hangs on a force that is found only with the loads known.
    #[error("{what} hangs on {on}")]
    #[diagnostic(
        code("mech::geometry::depends_on_forces"),
        help(
            "loads come first and forces are found from them: a load and its condition may use given values, positions, \
             velocities and accelerations"
        )
    )]
    DependsOnForces {
        /// The load or its condition.
        what: String,
        /// The result it asks for.
        on: String,
        /// Its place.
        #[label("{on}")]
        span: Span,
    },
}
