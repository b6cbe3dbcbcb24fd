//! Friction that cannot act.

use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

#[derive(Clone, Debug, Error, Diagnostic)]
pub enum FrictionError {
    #[error("friction is left out: the direction in which `{drive}` moves is not given")]
    #[diagnostic(
        code("mech::friction::no_motion"),
        severity(Warning),
        help("give its direction, `drive {drive} = … {sense}`, or a speed")
    )]
    NoMotion {
        /// The driven link, pair or point.
        drive: String,
        /// `turning ccw`
        sense: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
}

impl assur_text::diagnostic::Problem for FrictionError {}
