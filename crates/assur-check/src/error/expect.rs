//! The answer key.

use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// What can be wrong with an expectation.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum ExpectError {
    /// A quantity without anything it is compared with.
    #[error("`{text}` is {is}: what is it expected to be?")]
    #[diagnostic(
        code("mech::expect::no_value"),
        help("write `expect {text} = …`, or compare it: `expect {text} > …`")
    )]
    NoValue {
        /// What is expected, as written.
        text: String,
        /// What it is, with its article.
        is: String,
        /// Its place.
        #[label(primary, "not a condition")]
        span: Span,
    },
    /// A truth with values behind it.
    #[error("`{text}` is a condition; it is either true or false")]
    #[diagnostic(
        code("mech::expect::truth"),
        help("remove the right-hand side; to expect the opposite, write `not …`")
    )]
    Truth {
        /// What is expected, as written.
        text: String,
        /// Its place.
        #[label(primary, "a condition")]
        span: Span,
    },
    /// A tolerance on what has none.
    #[error("a condition has no tolerance")]
    #[diagnostic(code("mech::expect::tolerance_of_truth"), help("leave out `within …`"))]
    ToleranceOfTruth {
        /// The tolerance.
        #[label(primary, "nothing to be within")]
        span: Span,
    },
    /// Zero has no digits and no relative tolerance.
    #[error("an expected zero needs a tolerance with a unit")]
    #[diagnostic(code("mech::expect::zero"), help("write `within {example}`"))]
    Zero {
        /// The zero.
        #[label(primary, "a relative tolerance of zero is zero")]
        span: Span,
        /// A tolerance that would do.
        example: String,
    },
    /// A value that has no digits to infer a tolerance from.
    #[error("a tolerance is required here")]
    #[diagnostic(
        code("mech::expect::no_tolerance"),
        help(
            "a value that is computed needs a tolerance: `within 1e-9`, `within 0.1 %`, or one with a unit"
        )
    )]
    NoTolerance {
        /// The value.
        #[label(primary, "not a number as written")]
        span: Span,
    },
    /// A tolerance behind `+-`.
    #[error("`+-` is a sum and a sign, not a tolerance")]
    #[diagnostic(code("mech::expect::no_tolerance"), help("write `expect {line}`"))]
    PlusMinus {
        /// The statement with `within`.
        line: String,
        /// The signs.
        #[label(primary, "`within` instead of this")]
        span: Span,
    },
    /// A tolerance that is no positive number.
    #[error("a tolerance is greater than zero")]
    #[diagnostic(
        code("mech::expect::tolerance"),
        help("write `within 1e-9`, `within 0.1 %`, or one with a unit")
    )]
    Tolerance {
        /// The tolerance.
        #[label(primary, "not greater than zero")]
        span: Span,
    },
    /// A tolerance that any value would meet.
    #[error("any value would meet this tolerance: {why}")]
    #[diagnostic(code("mech::expect::any_value"), help("{help}"))]
    AnyValue {
        /// What is so wide about it.
        why: String,
        /// The tolerance, or the value that it is inferred from.
        #[label(primary, "too wide")]
        span: Span,
        /// A tolerance that would do.
        help: String,
    },
    /// A value that is compared with itself.
    #[error("this is compared with itself: any value would pass")]
    #[diagnostic(
        code("mech::expect::any_value"),
        help("write the value that is expected, as in `expect Mb = 26 N*m`")
    )]
    Itself {
        /// Both sides.
        #[label(primary, "equal whatever comes out")]
        span: Span,
    },
    /// A tolerance of another dimension than the value's.
    #[error("this tolerance is {found}, but `{text}` is {is}")]
    #[diagnostic(
        code("mech::expect::tolerance_unit"),
        help("write a plain number or a percentage for a share of the value, or a tolerance in {unit}")
    )]
    ToleranceUnit {
        /// What is expected, as written.
        text: String,
        /// What that is.
        is: String,
        /// What the tolerance is.
        found: String,
        /// The unit it should have.
        unit: String,
        /// The tolerance.
        #[label(primary, "{found}")]
        span: Span,
    },
    /// One value for many poses.
    #[error("`{text}` has {count}, and nothing says which of them is expected")]
    #[diagnostic(
        code("mech::expect::which_pose"),
        help("add `at pose 1` or `at {drive} = …`, or list one value per pose, with commas")
    )]
    WhichPose {
        /// What is expected, as written.
        text: String,
        /// `12 values, one per pose`
        count: String,
        /// A drive of the sweep.
        drive: String,
        /// Its place.
        #[label(primary, "of which pose?")]
        span: Span,
        /// The sweep.
        #[label("this goes through several poses")]
        sweep: Span,
    },
    /// A list that is longer or shorter than the sweep.
    #[error("{values} values are expected, but the file has {poses}")]
    #[diagnostic(code("mech::expect::count"), help("{help}"))]
    Count {
        /// How many values.
        values: usize,
        /// `12 poses`
        poses: String,
        /// The values.
        #[label(primary, "{values} values")]
        span: Span,
        /// The sweep.
        #[label("{poses}")]
        sweep: Option<Span>,
        /// What to do.
        help: String,
    },
    /// A list for what is the same at every pose.
    #[error("`{text}` has one value for the whole motion, and {count} are expected")]
    #[diagnostic(code("mech::expect::count"), help("leave one of the values"))]
    ListOfOne {
        /// What is expected, as written.
        text: String,
        /// How many values.
        count: usize,
        /// The values.
        #[label(primary, "{count} values")]
        span: Span,
    },
    /// A list for one pose.
    #[error("a list gives one value per pose and cannot be combined with `at …`")]
    #[diagnostic(code("mech::expect::list_at_pose"), help("leave one value, or leave out `at …`"))]
    ListAtPose {
        /// The values.
        #[label(primary, "{count} values")]
        span: Span,
        /// How many.
        count: usize,
    },
    /// A pose that does not exist.
    #[error("there is no pose `{name}`")]
    #[diagnostic(code("mech::expect::unknown_pose"))]
    UnknownPose {
        /// Its name.
        name: String,
        /// Where it stands.
        #[label(primary, "no such pose")]
        span: Span,
        /// The poses there are.
        #[help]
        help: Option<String>,
    },
}
