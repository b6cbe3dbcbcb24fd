//! Errors of an answer key, or with an answer.

use miette::Diagnostic;
use thiserror::Error;

use assur_model::model::{At, Expect};
use assur_solve::solve::{Pose, PoseOrigin};
use assur_text::diagnostic::{Diagnosis, did_you_mean};
use assur_text::source::Span;

/// An expectation that does not hold, or that cannot be evaluated.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum ExpectError {
    #[error("{message}")]
    #[diagnostic(code(mech::expect::mismatch))]
    Mismatch {
        /// The expected and the computed value.
        message: String,
        /// By how much it differs, and how much is allowed.
        difference: String,
        #[label("{difference}")]
        span: Span,
        /// The common mistake that explains it.
        #[help]
        help: Option<String>,
    },
    /// A sweep, and nothing says which of its poses.
    #[error("`{text}` has {poses} values, one per pose, but only one is expected")]
    #[diagnostic(
        code(mech::expect::which_pose),
        help("add a pose, as in `at pose 1` or `at crank = 30 deg`, or list one value per pose")
    )]
    NeedsPose {
        text: String,
        /// How many poses there are.
        poses: usize,
        #[label("the pose is missing")]
        span: Span,
    },
    /// A list of another length than the sweep.
    #[error("`{text}` has {poses} pose{}, but {values} values are expected", if *poses == 1 { "" } else { "s" })]
    #[diagnostic(code(mech::expect::count), help("list one value per pose, in the order of the sweep"))]
    ListLength {
        text: String,
        /// Values in the list.
        values: usize,
        poses: usize,
        #[label("{values} values")]
        span: Span,
    },
    /// No pose of that name.
    #[error("there is no pose `{name}`")]
    #[diagnostic(code(mech::expect::unknown_pose))]
    UnknownPose {
        name: String,
        #[label("no pose of this name")]
        span: Span,
        /// The poses there are.
        #[help]
        help: String,
    },
    /// The pose has no solution.
    #[error("`{text}`{} cannot be compared: {reason}", and_more(*more))]
    #[diagnostic(code(mech::expect::pose_failed), help("choose a pose that can be solved"))]
    PoseFailed {
        text: String,
        /// How many other expectations cannot be compared either.
        more: usize,
        /// Why the pose has no solution, and which it is.
        reason: String,
        #[label("expected here")]
        span: Span,
    },
    /// A function over the sweep or the motion that `find` asks for does not exist.
    #[error("`{text}` is not defined: {why}")]
    #[diagnostic(code(mech::expect::undefined))]
    NoAnswer {
        text: String,
        why: String,
        #[label("asked for here")]
        span: Span,
        /// A cause to check.
        #[help]
        help: &'static str,
    },
    /// The value does not exist.
    #[error("`{text}` is not defined{pose}{}", why.as_ref().map(|w| format!(": {w}")).unwrap_or_default())]
    #[diagnostic(code(mech::expect::undefined))]
    NoValue {
        text: String,
        /// ` at pose 3`, or empty.
        pose: String,
        /// Why not, where that is known.
        why: Option<String>,
        #[label("no value to compare")]
        span: Span,
        /// A cause to check.
        #[help]
        help: Option<&'static str>,
    },
}

impl assur_text::diagnostic::Problem for ExpectError {}

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

    pub(super) fn pose_failed(expect: &Expect, error: &Diagnosis) -> Self {
        Self::PoseFailed { text: expect.text.clone(), more: 0, reason: error.to_string(), span: expect.span }
    }

    pub(super) fn no_solution(expect: &Expect) -> Self {
        let why = Some(match expect.at {
            Some(At::Time(_) | At::Occasion(_)) => "the motion ends before this instant".to_owned(),
            _ => "the file has no pose".to_owned(),
        });
        Self::NoValue { text: expect.text.clone(), pose: String::new(), why, span: expect.span, help: None }
    }

    pub(super) fn no_value(expect: &Expect, pose: String, why: Option<String>) -> Self {
        let help = match why {
            Some(_) => None,
            None => Some("check for a division by zero, or a root or an inverse function out of its range"),
        };
        Self::NoValue { text: expect.text.clone(), pose, why, span: expect.span, help }
    }

    /// The same for all expectations that name a pose without solution: the first one, with the number of the others.
    pub(super) fn of_failed_poses(all: Vec<Self>) -> Vec<Self> {
        let failed = |e: &Self| matches!(e, Self::PoseFailed { .. });
        let others = all.iter().filter(|e| failed(e)).count().saturating_sub(1);
        let (mut first, mut kept) = (true, Vec::new());
        for mut error in all {
            if let Self::PoseFailed { more, .. } = &mut error {
                if !std::mem::take(&mut first) {
                    continue;
                }
                *more = others;
            }
            kept.push(error);
        }
        kept
    }

    /// The same, where all expectations are met in another assembly; `more` of them are not met besides this one.
    pub fn of_assembly(self, more: usize, line: &str) -> Self {
        let Self::Mismatch { message, difference, span, .. } = self.and_more(more) else { return self };
        let help = Some(format!("in the other assembly (`{line}`) all are met"));
        Self::Mismatch { message, difference, span, help }
    }

    /// The same, for others besides that are not met either.
    pub(super) fn and_more(&self, more: usize) -> Self {
        let mut same = self.clone();
        if let Self::Mismatch { message, .. } = &mut same
            && more > 0
        {
            let (verb, s) = if more == 1 { ("is", "") } else { ("are", "s") };
            *message = format!("{message}; {more} more expectation{s} {verb} not met");
        }
        same
    }
}

/// ` and 3 more`
fn and_more(more: usize) -> String {
    if more == 0 { String::new() } else { format!(" and {more} more") }
}
