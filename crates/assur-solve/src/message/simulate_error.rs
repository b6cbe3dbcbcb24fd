//! Why a motion under loads cannot go on.

use crate::source::Span;
use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// A motion under loads that ends early.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum SimulateError {
    /// A dead position of the free coordinates.
    #[error("the motion cannot go on at {time}: {group} in a dead position, |σ| = {condition}")]
    #[diagnostic(code(mech::simulate::dead_position))]
    Dead {
        time: String,
        /// The links of the group, with the verb.
        group: String,
        condition: String,
        #[help]
        help: String,
        /// The starts, and the pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A start with a speed in a dead position of its coordinate.
    #[error("`{name}` can have no speed where it starts: it is in its dead position there")]
    #[diagnostic(code(mech::simulate::dead_position))]
    NoRate {
        name: String,
        #[help]
        help: String,
        #[label("no motion of the links gives it this speed")]
        span: Span,
    },
    /// A start in a change point.
    #[error("two motions begin where `{name}` starts, and nothing says which is meant")]
    #[diagnostic(code(mech::simulate::two_motions))]
    TwoMotions {
        name: String,
        /// The lines that choose one.
        #[help]
        help: String,
        /// The start, and the pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A free coordinate that moves no mass.
    #[error("nothing resists the acceleration of {coordinates} at {time}: {what} without inertia")]
    #[diagnostic(code(mech::simulate::no_inertia))]
    NoInertia {
        coordinates: String,
        time: String,
        /// What moves without inertia.
        what: &'static str,
        /// Which links could have some.
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A load without a value.
    #[error("a load has no value at {time}")]
    #[diagnostic(
        code(mech::simulate::no_value),
        help(
            "look for a root of a negative number, a division by zero or a curve that is left: the loads are expressions of time, positions and velocities"
        )
    )]
    NoValue {
        time: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// More steps than a run may take.
    #[error(
        "the steps of the motion are too short: it has reached {time} of {end}, and at most {most} steps are done"
    )]
    #[diagnostic(
        code(mech::simulate::too_many_steps),
        help(
            "let `simulate` end earlier, ask for less accuracy with `within`, or look for a spring or damper that is far stiffer than the motion, or a `start` so large that its last digit is longer than a step"
        )
    )]
    TooManySteps {
        most: usize,
        /// The instant that was reached.
        time: String,
        /// The last one wanted.
        end: String,
        /// The statement `simulate`.
        #[label("only to {time}")]
        span: Span,
    },
    /// It was told to end.
    #[error("the motion was stopped at {time}, before its end at {end}: what it did until then is printed")]
    #[diagnostic(help("let `simulate` end earlier, or ask for less accuracy with `within`"))]
    Interrupted {
        /// The instant that was reached.
        time: String,
        /// The last one wanted.
        end: String,
        /// The statement `simulate`.
        #[label("only to {time}")]
        span: Span,
    },
    /// The wanted accuracy is not reached.
    #[error("{known}")]
    #[diagnostic(code(mech::simulate::tolerance))]
    Accuracy {
        /// The error that is estimated, and the wanted one.
        known: String,
        /// What can be kept.
        #[help]
        help: String,
        /// The statement `simulate`.
        #[label("not reached")]
        span: Span,
    },
    /// An end that does not come.
    #[error("the motion does not come to this end until {time}, its last instant")]
    #[diagnostic(
        code(mech::simulate::never_ended),
        severity(warning),
        help("let `simulate` go on for longer, or leave `until` out")
    )]
    NeverEnded {
        time: String,
        /// The statement `until`.
        #[label("does not happen")]
        span: Span,
    },
    #[error("friction jams the motion at {time}: no acceleration satisfies its laws, or several do")]
    #[diagnostic(
        code(mech::simulate::jam),
        help("with less friction, or a longer guide, the motion goes on")
    )]
    Jam {
        time: String,
        /// The pairs that rub.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A pair that does not take the forces there: a contact or a rope that opens, a clutch that slips.
    #[error("{what}")]
    #[diagnostic(code(mech::simulate::opens))]
    Opens {
        /// What it would have to do, and the instant.
        what: String,
        /// What it does there.
        text: &'static str,
        #[help]
        help: String,
        #[label("{text}")]
        span: Span,
    },
    /// A coordinate that starts beyond its stop.
    #[error("`{name}` is {by} {side} its stop at {time}")]
    #[diagnostic(code(mech::simulate::stop_passed))]
    StopPassed {
        name: String,
        by: String,
        side: &'static str,
        time: String,
        #[help]
        help: String,
        #[label("passed")]
        span: Span,
    },
    /// Several stops that are hit at once.
    #[error("the stops of {names} are hit at once at {time}")]
    #[diagnostic(
        code(mech::simulate::stops_at_once),
        help(
            "let the starts differ a little, or let `simulate` end before: the motion after several impacts at once depends on their order"
        )
    )]
    StopsAtOnce {
        names: String,
        time: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Rebounds in which friction holds a pair for a while.
    #[error(
        "from {time} on the rebounds at the stop of `{name}` are too low to be followed, and pairs that rub stick and slip in them"
    )]
    #[diagnostic(
        code(mech::simulate::shaken),
        help(
            "leave out `restitution` of the stop: it then stays closed after its first impact; or let `simulate` end before {time}"
        )
    )]
    Shaken {
        /// The pair of the stop.
        name: String,
        time: String,
        /// The stop, and what rubs.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A cam that friction would let roll on its follower.
    #[error("from {time} on friction would hold `{name}`, so that the cam rolls on its follower")]
    #[diagnostic(
        code(mech::simulate::rolls),
        help("let `simulate` end before {time}, or give the contact less friction")
    )]
    Rolls {
        name: String,
        time: String,
        #[label("comes to rest")]
        span: Span,
    },
    /// A steady motion that was not found.
    #[error("{what}")]
    #[diagnostic(code(mech::simulate::no_cycle), help("{help}"))]
    NoCycle {
        what: String,
        help: &'static str,
        /// The statement `simulate`.
        #[label("does not come again")]
        span: Span,
    },
}

impl assur_text::diagnostic::Problem for SimulateError {}
