//! The answer key.

use assur_text::diagnostic::{Fix, Help, Problem};
use assur_text::source::{Edit, Span};
use miette::Diagnostic;
use thiserror::Error;

#[derive(Clone, Debug, Error, Diagnostic)]
pub enum ExpectError {
    /// A quantity without an expected value.
    #[error("`{text}` is {is}, and no expected value is given")]
    #[diagnostic(
        code("mech::expect::no_value"),
        help("write `expect {text} = …`, or compare it: `expect {text} > …`")
    )]
    NoValue {
        /// The expectation, as written.
        text: String,
        /// Its kind, with its article.
        is: String,
        #[label(primary, "not a condition")]
        span: Span,
    },
    /// A condition with a value.
    #[error("`{text}` is a condition; it is either true or false")]
    #[diagnostic(
        code("mech::expect::truth"),
        help("remove the right-hand side; to expect the opposite, write `not …`")
    )]
    ConditionWithValue {
        /// The expectation, as written.
        text: String,
        #[label(primary, "a condition")]
        span: Span,
    },
    /// A tolerance of a condition.
    #[error("a condition has no tolerance")]
    #[diagnostic(code("mech::expect::tolerance_of_truth"), help("leave out `within …`"))]
    ToleranceOfCondition {
        #[label(primary, "a condition is true or false")]
        span: Span,
    },
    /// Zero has no digits and no relative tolerance.
    #[error("an expected zero needs a tolerance with a unit")]
    #[diagnostic(code("mech::expect::zero"), help("write `within {example}`"))]
    Zero {
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
            "add `within 1e-9`, `within 0.1 %`, or a tolerance with a unit: a computed value has no written digits"
        )
    )]
    NoTolerance {
        #[label(primary, "computed, not written as a number")]
        span: Span,
    },
    /// A tolerance after `+-`.
    #[error("`+-` is a sum and a sign, not a tolerance")]
    #[diagnostic(code("mech::expect::no_tolerance"), help("write `expect {line}`"))]
    PlusMinus {
        /// The statement with `within`.
        line: String,
        #[label(primary, "`within` instead of this")]
        span: Span,
    },
    /// A tolerance that is not a positive number.
    #[error("a tolerance must be greater than zero")]
    #[diagnostic(
        code("mech::expect::tolerance"),
        help("write `within 1e-9`, `within 0.1 %`, or one with a unit")
    )]
    Tolerance {
        #[label(primary, "not greater than zero")]
        span: Span,
    },
    /// A tolerance that any value would meet.
    #[error("any value would meet this tolerance: {why}")]
    #[diagnostic(code("mech::expect::any_value"), help("{help}"))]
    AnyValue {
        why: String,
        /// The tolerance, or the value that it is inferred from.
        #[label(primary, "too wide")]
        span: Span,
        /// A tolerance that would do.
        help: Help,
    },
    /// A value that is compared with itself.
    #[error("a value is compared with itself")]
    #[diagnostic(
        code("mech::expect::any_value"),
        help("write the value that is expected, as in `expect Mb = 26 N*m`")
    )]
    Itself {
        #[label(primary, "both sides are equal")]
        span: Span,
    },
    /// A tolerance of another dimension than the value's.
    #[error("the tolerance is {found}, but `{text}` is {is}")]
    #[diagnostic(
        code("mech::expect::tolerance_unit"),
        help("write a plain number or a percentage, both relative to the value, or a tolerance in {unit}")
    )]
    ToleranceUnit {
        /// The expectation, as written.
        text: String,
        is: String,
        /// The dimension of the tolerance.
        found: String,
        /// The unit it should have.
        unit: String,
        #[label(primary, "{found}")]
        span: Span,
    },
    /// One value for many poses.
    #[error("`{text}` has {count}, but only one is expected")]
    #[diagnostic(
        code("mech::expect::which_pose"),
        help("add `at pose 1` or `at {drive} = …`, or list one value per pose, with commas")
    )]
    WhichPose {
        /// The expectation, as written.
        text: String,
        /// `12 values, one per pose`
        count: String,
        /// A drive of the sweep.
        drive: String,
        #[label(primary, "the pose is missing")]
        span: Span,
        #[label("this goes through several poses")]
        sweep: Span,
    },
    /// A list that is longer or shorter than the sweep.
    #[error("{values} values are expected, but the file has {poses}")]
    #[diagnostic(code("mech::expect::count"), help("{help}"))]
    Count {
        values: usize,
        /// `12 poses`
        poses: String,
        #[label(primary, "{values} values")]
        span: Span,
        #[label("{poses}")]
        sweep: Option<Span>,
        help: String,
    },
    /// A list for a quantity with one value for the whole motion.
    #[error("`{text}` has one value for the whole motion, and {count} are expected")]
    #[diagnostic(code("mech::expect::count"), help("keep one of the values"))]
    ListOfOne {
        /// The expectation, as written.
        text: String,
        count: usize,
        #[label(primary, "{count} values")]
        span: Span,
    },
    /// A list for one pose.
    #[error("a list gives one value per pose and cannot be combined with `at …`")]
    #[diagnostic(code("mech::expect::list_at_pose"), help("keep one value, or leave out `at …`"))]
    ListAtPose {
        #[label(primary, "{count} values")]
        span: Span,
        count: usize,
    },
    /// A pose that does not exist.
    #[error("there is no pose `{name}`")]
    #[diagnostic(code("mech::expect::unknown_pose"))]
    UnknownPose {
        name: String,
        #[label(primary, "no such pose")]
        span: Span,
        #[help]
        help: Option<Help>,
    },
}

impl Problem for ExpectError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            Self::UnknownPose { help: Some(help), .. } | Self::AnyValue { help, .. } => help.fixes().to_vec(),
            Self::PlusMinus { line, span } => vec![Fix {
                title: format!("write `expect {line}`"),
                edits: vec![Edit::new(*span, " within ")],
                certain: false,
            }],
            _ => Vec::new(),
        }
    }
}
