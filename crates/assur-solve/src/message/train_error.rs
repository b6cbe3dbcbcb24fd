//! Messages about trains: positions that are not given, ropes that push, transmissions that lock.

use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// An error or a warning about a train.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum TrainError {
    /// A position that depends on a drive which has a rate only.
    #[error("{what} depends on the position of `{drive}`, which is not given")]
    #[diagnostic(code(mech::train::no_position))]
    NoPosition {
        /// What is asked, or what must be known.
        what: String,
        drive: String,
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A reaction to forces whose places are not known.
    #[error(
        "the reaction in `{pair}` cannot be found: its position, or that of a force on its shaft, is not given"
    )]
    #[diagnostic(code(mech::train::no_place))]
    NoPlace {
        pair: String,
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Friction that depends on a force without a place.
    #[error(
        "the friction in {pairs} cannot be found: the position of a force that presses there is not given"
    )]
    #[diagnostic(code(mech::train::no_place))]
    FrictionWithoutPlace {
        pairs: String,
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A rope that would have to push.
    #[error("rope `{name}` would have to push{pose}{more}: its pull is {tension}")]
    #[diagnostic(
        code(mech::train::rope_pushes),
        severity(warning),
        help(
            "check the sense of the load, or add a counterweight: a rope only pulls, so it would be slack there"
        )
    )]
    RopePushes {
        name: String,
        /// Where it pulls least.
        pose: String,
        /// `, and at 3 other poses`
        more: String,
        tension: String,
        #[label("slack")]
        span: miette::SourceSpan,
    },
    /// A belt or a clutch that slips.
    #[error(
        "{what} `{name}` slips{pose}{more}: it must transmit {wanted}, and its friction {capacity} at most"
    )]
    #[diagnostic(code(mech::train::slips), severity(warning), help("{help}"))]
    Slips {
        /// `belt` or `clutch`.
        what: &'static str,
        name: String,
        /// Where it must transmit most.
        pose: String,
        /// `, and at 3 other poses`
        more: String,
        /// The force or torque wanted there.
        wanted: String,
        /// The greatest that it can transmit.
        capacity: String,
        help: String,
        #[label("slips")]
        span: miette::SourceSpan,
    },
    /// A belt with a slip that the power runs through backwards.
    #[error(
        "power runs backwards through belt `{name}`{pose}: its slip is of the speed that `{driver}` gives"
    )]
    #[diagnostic(code(mech::train::slip_backwards), help("{help}"))]
    SlipBackwards {
        name: String,
        pose: String,
        /// The wheel written first.
        driver: String,
        help: String,
        #[label("the first wheel must drive")]
        span: miette::SourceSpan,
    },
    /// Transmissions that the load cannot drive.
    #[error("the load cannot drive the mechanism{pose}{more}: it is self-locking")]
    #[diagnostic(code(mech::train::self_locking), severity(warning))]
    SelfLocking {
        pose: String,
        /// `, and at 3 other poses`
        more: String,
        /// What makes it so.
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
}

impl assur_text::diagnostic::Problem for TrainError {}
