//! What can be wrong with an answer key, or with an answer.

use miette::Diagnostic;
use thiserror::Error;

use super::expect::Outcome;
use crate::diagnostic::did_you_mean;
use crate::model::{Expect, Value};
use crate::solve::{Pose, PoseOrigin, SolveError};
use crate::source::Span;

/// An expectation that does not hold, or that cannot be evaluated.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum ExpectError {
    /// The answer differs.
    #[error("{message}")]
    #[diagnostic(code(mech::expect::mismatch))]
    Mismatch {
        /// What was expected, and what was got.
        message: String,
        /// By how much it differs, and how much is allowed.
        difference: String,
        /// Where.
        #[label("{difference}")]
        span: Span,
        /// What slip would explain it.
        #[help]
        help: Option<String>,
    },
    /// A sweep, and nothing says which of its poses.
    #[error("`{text}` has {poses} values, one per pose, and only one is expected")]
    #[diagnostic(
        code(mech::expect::which_pose),
        help("say where it holds, as in `at pose 1` or `at crank = 30 deg`, or list one value per pose")
    )]
    NeedsPose {
        /// What is expected of.
        text: String,
        /// How many poses there are.
        poses: usize,
        /// Where.
        #[label("at which pose?")]
        span: Span,
    },
    /// A list of another length than the sweep.
    #[error("{values} values are expected of `{text}` at {poses} pose{}", if *poses == 1 { "" } else { "s" })]
    #[diagnostic(code(mech::expect::count), help("list one value per pose, in the order of the sweep"))]
    ListLength {
        /// What is expected of.
        text: String,
        /// Values in the list.
        values: usize,
        /// Poses.
        poses: usize,
        /// Where.
        #[label("{values} values")]
        span: Span,
    },
    /// No pose of that name.
    #[error("there is no pose `{name}`")]
    #[diagnostic(code(mech::expect::unknown_pose))]
    UnknownPose {
        /// The name.
        name: String,
        /// Where.
        #[label("no pose of this name")]
        span: Span,
        /// The poses there are.
        #[help]
        help: String,
    },
    /// The pose has no solution.
    #[error("`{text}` cannot be compared: {reason}")]
    #[diagnostic(
        code(mech::expect::pose_failed),
        help("an expectation can only hold at a pose that is solved")
    )]
    PoseFailed {
        /// What is expected of.
        text: String,
        /// Why the pose has no solution, and which it is.
        reason: String,
        /// Where.
        #[label("expected here")]
        span: Span,
    },
    /// The value does not exist.
    #[error("`{text}` has no value{pose}{}", why.as_ref().map(|w| format!(": {w}")).unwrap_or_default())]
    #[diagnostic(code(mech::expect::undefined))]
    NoValue {
        /// What is expected of.
        text: String,
        /// ` at pose 3`, or empty.
        pose: String,
        /// Why not, where that is known.
        why: Option<String>,
        /// Where.
        #[label("nothing to compare with")]
        span: Span,
        /// What to look for.
        #[help]
        help: Option<&'static str>,
    },
}

impl ExpectError {
    pub(super) fn needs_pose(expect: &Expect, poses: usize) -> Self {
        Self::NeedsPose { text: expect.text.clone(), poses, span: expect.span }
    }

    pub(super) fn list_length(expect: &Expect, values: usize, poses: usize) -> Self {
        Self::ListLength { text: expect.text.clone(), values, poses, span: expect.span }
    }

    pub(super) fn unknown_pose(name: &str, span: Span, poses: &[Pose]) -> Self {
        let names: Vec<&str> = poses
            .iter()
            .filter(|p| !matches!(p.origin, PoseOrigin::Expected(_)))
            .map(|p| p.name.as_str())
            .collect();
        let help = match (did_you_mean(name, names.iter().copied()).first(), names.as_slice()) {
            (Some(near), _) => format!("did you mean `{near}`?"),
            (None, []) => "the file has no poses".to_owned(),
            (None, [only]) => format!("the file has one pose, `{only}`"),
            (None, [first, .., last]) => format!("the poses are `{first}` to `{last}`"),
        };
        Self::UnknownPose { name: name.to_owned(), span, help }
    }

    pub(super) fn pose_failed(expect: &Expect, error: &SolveError) -> Self {
        Self::PoseFailed { text: expect.text.clone(), reason: error.to_string(), span: expect.span }
    }

    pub(super) fn no_solution(expect: &Expect) -> Self {
        let why = Some("the file has no pose".to_owned());
        Self::NoValue { text: expect.text.clone(), pose: String::new(), why, span: expect.span, help: None }
    }

    pub(super) fn no_value(expect: &Expect, pose: String, why: Option<String>) -> Self {
        let help = match why {
            Some(_) => None,
            None => Some("look for a division by zero, or a root or an inverse function out of its range"),
        };
        Self::NoValue { text: expect.text.clone(), pose, why, span: expect.span, help }
    }

    pub(super) fn mismatch(outcome: &Outcome) -> Self {
        let Outcome { text, display, got, place: at, .. } = outcome;
        let span = outcome.span;
        if *got == Value::Truth(false) {
            let message = format!("expected {text}{at}, and it does not hold");
            return Self::Mismatch { message, difference: "does not hold".to_owned(), span, help: None };
        }
        let off = outcome.difference();
        let digits = digits_to_tell(outcome.expected.magnitude(), off.magnitude());
        let expected = outcome.expectation(digits);
        let message = format!("expected {text} {expected}{at}, got {}", display.text(*got, digits));
        let difference = match outcome.within {
            Some(within) => format!(
                "off by {}, allowed {}",
                display.text(Value::Scalar(off.magnitude()), 3),
                display.text(Value::Scalar(within), 3)
            ),
            None => format!("off by {}", display.text(Value::Scalar(off.magnitude()), 3)),
        };
        Self::Mismatch { message, difference, span, help: slip(outcome) }
    }
}

/// Digits that show where two numbers part, with two more: at least 6.
fn digits_to_tell(value: f64, difference: f64) -> usize {
    let parts_after = libm::log10(value / difference).ceil();
    if parts_after.is_finite() && parts_after > 4.0 {
        (parts_after as usize).saturating_add(2).min(17)
    } else {
        6
    }
}

/// The usual slips: a sign, a prefix, degrees for radians.
fn slip(outcome: &Outcome) -> Option<String> {
    let (Value::Scalar(got), Value::Scalar(expected), Some(within)) =
        (outcome.got, outcome.expected, outcome.within)
    else {
        return None;
    };
    if expected == 0.0 {
        return None;
    }
    // half a graphical solution's accuracy
    let alike = |factor: f64| {
        let allowed = (within * factor.abs()).max(0.02 * (expected * factor).abs());
        (got - expected * factor).abs() <= allowed
    };
    let degree = std::f64::consts::PI / 180.0;
    if alike(-1.0) {
        return Some("the two differ in their sign: which way is positive, and on which link?".to_owned());
    }
    for factor in [1e3, 1e-3, 1e6, 1e-6] {
        if alike(factor) || alike(-factor) {
            return Some("the two differ by a power of 1000: check the units".to_owned());
        }
    }
    if alike(degree) || alike(1.0 / degree) {
        return Some("the two differ by 180/pi: one is in degrees, the other in radians".to_owned());
    }
    None
}
