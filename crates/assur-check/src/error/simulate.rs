//! Errors of motion under given loads.

use assur_text::diagnostic::{Fix, Help, Problem};
use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors of `start`, `simulate`, `event` and `until`.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum SimulateError {
    /// Two statements of which a file has one.
    #[error("a file has one `{word}`, and this is the second")]
    #[diagnostic(code("mech::simulate::twice"), help("{help}"))]
    Twice {
        /// The word of the statement.
        word: &'static str,
        help: String,
        #[label(primary, "again here")]
        again: Span,
        #[label("first here")]
        first: Span,
    },
    /// A rate beside a position that has its own.
    #[error(
        "the rate of `{name}` is given twice: it is the derivative of its position, which depends on `time`"
    )]
    #[diagnostic(code("mech::simulate::twice"), help("leave out `at …` and `accelerating …`"))]
    RateTwice {
        name: String,
        #[label(primary, "again here")]
        again: Span,
        #[label("has its own rate")]
        first: Span,
    },
    /// A start of something that a drive or another start gives.
    #[error("{what}")]
    #[diagnostic(code("mech::simulate::twice"), help("{help}"))]
    StartedTwice {
        /// What is given twice.
        what: String,
        help: String,
        #[label(primary, "started here")]
        again: Span,
        #[label("given here")]
        first: Span,
    },
    /// A statement of a motion that is not followed.
    #[error("`{word}` belongs to a motion under loads, and the file has no `simulate`")]
    #[diagnostic(code("mech::simulate::missing"), help("{help}"))]
    Missing {
        /// The word of the statement.
        word: &'static str,
        help: String,
        #[label("no `simulate`")]
        span: Span,
    },
    /// A motion that starts nowhere: every coordinate is driven.
    #[error("the motion follows from the loads where a coordinate is free, and this file has no `start`")]
    #[diagnostic(code("mech::simulate::no_start"), help("{help}"))]
    NoStart {
        help: String,
        /// The statement `simulate`.
        #[label("nothing is free")]
        span: Span,
    },
    /// A stop that has no meaning.
    #[error("{what}")]
    #[diagnostic(code("mech::simulate::stop"), help("{help}"))]
    Stop {
        what: String,
        help: String,
        #[label(primary, "here")]
        span: Span,
        #[label("first here")]
        first: Option<Span>,
    },
    /// A start of a point.
    #[error("a start is the value of an angle or a coordinate, and `{name}` is a point")]
    #[diagnostic(
        code("mech::simulate::point"),
        help("name its link, as in `start {link} = 45 deg`, or a pair")
    )]
    Point {
        name: String,
        link: String,
        #[label("a point")]
        span: Span,
    },
    /// The last instant does not come after the first.
    #[error("the motion ends at {to}, and {from} is not before it")]
    #[diagnostic(
        code("mech::simulate::interval"),
        help("write the earlier instant first: `simulate 0 s .. 2 s`")
    )]
    Interval {
        from: String,
        to: String,
        #[label("no time between them")]
        span: Span,
    },
    /// A wanted accuracy that is none.
    #[error("{within} is no accuracy of a motion")]
    #[diagnostic(
        code("mech::simulate::within"),
        help(
            "write a number between 0 and 1: `within 1e-9` keeps all that is printed to 1e-9 of the greatest of its kind"
        )
    )]
    Within {
        within: String,
        #[label("not between 0 and 1")]
        span: Span,
    },
    /// An instant outside the motion.
    #[error("the motion is followed from {from} to {to}, and {time} is not in this time")]
    #[diagnostic(
        code("mech::simulate::outside"),
        help("ask for an instant of the motion, or let `simulate` include it")
    )]
    Outside {
        time: String,
        from: String,
        to: String,
        #[label(primary, "outside")]
        span: Span,
        /// The statement `simulate`.
        #[label("followed here")]
        simulate: Span,
    },
    /// An expectation that does not say for which instant it is.
    #[error("`{text}` has a value at each of {count} instants, and {values} given here")]
    #[diagnostic(
        code("mech::simulate::which_instant"),
        help("say for which instant it is, as in `at time = 0.5 s`, or give {count} values")
    )]
    WhichInstant {
        text: String,
        /// How many instants are printed.
        count: usize,
        /// How many values there are, with the verb.
        values: String,
        #[label(primary, "for which instant?")]
        span: Span,
        /// The statement `simulate`.
        #[label("the instants")]
        simulate: Span,
    },
    /// An event that is not declared.
    #[error("there is no event `{name}`")]
    #[diagnostic(code("mech::simulate::unknown_event"), help("{help}"))]
    UnknownEvent {
        name: String,
        /// The one that may be meant, or how to declare it.
        help: Help,
        #[label("not declared")]
        span: Span,
    },
    /// A number where a condition or a value to be passed is wanted.
    #[error("this is {is}: nothing says when it happens")]
    #[diagnostic(
        code("mech::simulate::no_condition"),
        help(
            "give the value that is passed, as in `omega(crank) = 0 rad/s`, or a condition, as in `omega(crank) < 0 rad/s`"
        )
    )]
    NoCondition {
        is: String,
        #[label("when?")]
        span: Span,
    },
    /// A condition that no number tells from its opposite.
    #[error("the instant at which this condition becomes true cannot be found")]
    #[diagnostic(
        code("mech::simulate::no_margin"),
        help("write it as a comparison of numbers, or as several with `and`, `or`, `not`")
    )]
    NoMargin {
        #[label("no comparison of numbers")]
        span: Span,
    },
    /// `time` declared in a file where it is the instant.
    #[error("`time` is the instant of the motion in a file with `simulate`")]
    #[diagnostic(code("mech::simulate::time"), help("give the quantity another name"))]
    Time {
        #[label(primary, "declared here")]
        span: Span,
        /// The statement `simulate`.
        #[label("the motion")]
        simulate: Span,
    },
    /// What belongs to positions of a drive.
    #[error("{what} belongs to positions that are given, and this file follows a motion")]
    #[diagnostic(code("mech::simulate::positions"), help("{help}"))]
    Positions {
        what: String,
        /// What to write instead.
        help: String,
        #[label(primary, "of given positions")]
        span: Span,
        /// The statement `simulate`.
        #[label("the motion follows from the loads")]
        simulate: Span,
    },
    /// An effect that a motion under loads has of itself.
    #[error("{what} has no meaning where the motion follows from the loads")]
    #[diagnostic(code("mech::simulate::no_meaning"), help("{help}"))]
    NoMeaning {
        what: String,
        /// What to write instead.
        help: String,
        #[label("no meaning here")]
        span: Span,
    },
    /// An unknown effort that would hold a free coordinate.
    #[error("{count} for {driven}: nothing holds a free coordinate")]
    #[diagnostic(code("mech::simulate::balance"), help("{help}"))]
    Balance {
        count: String,
        /// How many coordinates are prescribed.
        driven: String,
        help: String,
        #[label("not needed")]
        span: Span,
    },
}

impl Problem for SimulateError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            Self::UnknownEvent { help, .. } => help.fixes().to_vec(),
            Self::Stop { first: Some(_), span, .. } => vec![Fix::left_out("this stop", *span)],
            Self::Twice { again, .. } => vec![Fix::left_out("the second one", *again)],
            Self::NoMeaning { help, span, .. } if help.starts_with("leave ") => {
                vec![Fix::left_out("this", *span)]
            }
            _ => Vec::new(),
        }
    }
}
