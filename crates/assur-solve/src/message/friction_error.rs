//! Messages about friction: locking, and friction that does not act.

use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// A warning, a note or an error about friction.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum FrictionError {
    /// Friction locks the mechanism.
    #[error("{pairs}: the mechanism is locked{pose}{more}; {verdict}")]
    #[diagnostic(code("mech::friction::locked"), severity(Warning))]
    Locked {
        /// `friction in `P` and `B``
        pairs: String,
        /// ` at pose 3 (crank = 60 deg)`, or empty.
        pose: String,
        /// ` and at 2 more poses`, or empty.
        more: String,
        /// The efficiency, or that no effort moves it.
        verdict: String,
        /// Where it would move.
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A number is asked for that a locked mechanism does not have.
    #[error("{asked} no value{pose}{more}: friction locks the mechanism, so no effort moves it")]
    #[diagnostic(
        code("mech::friction::no_effort"),
        help("ask for `efficiency()`, `locked()` or `frictionless({first})`, which are defined there")
    )]
    NoEffort {
        /// What is asked, with its verb: `` `F` has ``.
        asked: String,
        /// The first of it.
        first: String,
        pose: String,
        /// ` and at 2 more poses`, or empty.
        more: String,
        /// Where it is asked.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// No relative motion in a pair with friction.
    #[error("no sliding in `{pair}`{pose}{more}: friction is taken as zero")]
    #[diagnostic(code("mech::friction::no_sliding"), severity(Advice))]
    NoSliding {
        pair: String,
        pose: String,
        /// ` and at 2 more poses`, or empty.
        more: String,
        #[label("no relative motion")]
        span: miette::SourceSpan,
    },
    /// A transmission with losses that stands.
    #[error(
        "nothing moves in `{pair}`{pose}{more}: the power has no direction, and its losses are taken as zero"
    )]
    #[diagnostic(
        code(mech::friction::no_sliding),
        severity(warning),
        help("for the beginning of a motion give the drive a small speed in its sense, as `at 1e-6 m/s`")
    )]
    NoTurning {
        pair: String,
        pose: String,
        /// ` and at 2 more poses`, or empty.
        more: String,
        #[label("no motion")]
        span: miette::SourceSpan,
    },
}

impl assur_text::diagnostic::Problem for FrictionError {}
