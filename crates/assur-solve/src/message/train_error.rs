//! What is said of trains: places and positions left open, ropes that push, transmissions that lock.

use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// An error or a warning about a train.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum TrainError {
    /// A position that depends on a drive which has a rate only.
    #[error("{what} hangs on the position of `{drive}`, which the file does not give")]
    #[diagnostic(code(mech::train::no_position))]
    NoPosition {
        /// What is asked, or what must be known.
        what: String,
        /// The drive.
        drive: String,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A reaction to forces whose places are not known.
    #[error(
        "the reaction in `{pair}` is not known: its place, or that of a force that it holds, is left open"
    )]
    #[diagnostic(code(mech::train::no_place))]
    NoPlace {
        /// The pair.
        pair: String,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A rope that would have to push.
    #[error("rope `{name}` would have to push{pose}{more}: its pull is {tension}")]
    #[diagnostic(
        code(mech::train::rope_pushes),
        severity(warning),
        help(
            "a rope only pulls: it would be slack there, and what hangs on it would fall; look at the sense of the load, or add a counterweight"
        )
    )]
    RopePushes {
        /// The rope.
        name: String,
        /// Where it pulls least.
        pose: String,
        /// `, and at 3 other poses`
        more: String,
        /// Its pull there.
        tension: String,
        /// Its place.
        #[label("slack")]
        span: miette::SourceSpan,
    },
    /// Transmissions that the load cannot drive.
    #[error("the load cannot drive the mechanism{pose}{more}: it is self-locking")]
    #[diagnostic(code(mech::train::self_locking), severity(warning))]
    SelfLocking {
        /// Where.
        pose: String,
        /// `, and at 3 other poses`
        more: String,
        /// What makes it so.
        #[help]
        help: String,
        /// The transmissions.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
}
