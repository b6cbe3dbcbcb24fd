//! Friction that cannot act.

use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// What can be odd with the friction of a file.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum FrictionError {
    /// Friction without motion.
    #[error("friction opposes motion, and nothing says which way `{drive}` moves: it is left out")]
    #[diagnostic(
        code("mech::friction::no_motion"),
        severity(Warning),
        help("say which way it moves: `drive {drive} = … {sense}`, or give it a speed")
    )]
    NoMotion {
        /// What is driven.
        drive: String,
        /// `turning ccw`
        sense: String,
        /// The properties.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
}
