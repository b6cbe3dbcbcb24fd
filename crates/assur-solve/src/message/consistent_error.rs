//! Errors and warnings where the laws of friction or of losses have several solutions, or none.

use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// What a search over all states of the forces came to.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum ConsistentError {
    #[error("{count} states of the forces are consistent with the {what}{pose}{more}; {reported}")]
    #[diagnostic(
        code(mech::solve::several_balances),
        severity(warning),
        help("reduce the {what} until only one state is left, or check this one against the real machine")
    )]
    Several {
        count: usize,
        /// `friction` or `losses`.
        what: &'static str,
        /// ` at pose 3 (crank = 60 deg)`, or empty.
        pose: String,
        /// `, and at 2 other poses`, or empty.
        more: String,
        /// Which one is reported.
        reported: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// The search was given up.
    #[error("the forces{pose} cannot be found: too many combinations of the {what}")]
    #[diagnostic(
        code(mech::solve::undecided),
        help("leave out the {what} of some of the marked pairs, or reduce them")
    )]
    Undecided {
        /// `friction` or `losses`.
        what: &'static str,
        pose: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// No direction of the power is consistent.
    #[error("the train is self-locking{pose}: no direction of the power flow is consistent with its losses")]
    #[diagnostic(code(mech::train::blocked))]
    Blocked {
        pose: String,
        /// What makes it so.
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
}

impl assur_text::diagnostic::Problem for ConsistentError {}
