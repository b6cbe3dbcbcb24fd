//! Flywheels that cannot be found, or are not needed.

use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// An error or a warning about a flywheel.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum FlywheelError {
    /// A flywheel that cannot be found.
    #[error("flywheel `{name}` cannot be found: {why}")]
    #[diagnostic(code(mech::solve::no_flywheel))]
    NoFlywheel {
        name: String,
        why: String,
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A flywheel that is not needed.
    #[error("flywheel `{name}` is not needed: the links alone have {have} of {needed}")]
    #[diagnostic(
        code(mech::solve::needless_flywheel),
        severity(warning),
        help(
            "ask for a smaller `fluctuation`, or leave the flywheel out; its moment of inertia is given as 0"
        )
    )]
    NeedlessFlywheel {
        name: String,
        /// Mean reduced moment of inertia of the links.
        have: String,
        /// Moment of inertia needed in all.
        needed: String,
        #[label("asked for here")]
        span: miette::SourceSpan,
    },
}

impl assur_text::diagnostic::Problem for FlywheelError {}
