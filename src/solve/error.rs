//! Why a position has no solution, or one to be careful with.

use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

use crate::source::Span;

/// A position that cannot be solved, or a warning about one.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum SolveError {
    /// A construct that cannot be solved yet.
    #[error("{what} cannot be solved yet")]
    #[diagnostic(
        code(mech::request::not_supported_yet),
        help("it is read and checked; remove it to solve the rest of the file")
    )]
    NotSupportedYet {
        /// What it is.
        what: String,
        /// Its place.
        #[label("not supported yet")]
        span: miette::SourceSpan,
    },
    /// No assembly.
    #[error("the mechanism does not close{pose}: {gap}")]
    #[diagnostic(code(mech::assembly::does_not_close))]
    DoesNotClose {
        /// ` at pose 3 (crank = 60 deg)`, or empty.
        pose: String,
        /// By how much, between which points.
        gap: String,
        /// What to do.
        #[help]
        help: String,
        /// The pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Two assemblies and no choice.
    #[error("the mechanism can be assembled in {count} ways, and nothing says which")]
    #[diagnostic(code(mech::assembly::ambiguous))]
    Ambiguous {
        /// How many.
        count: usize,
        /// The lines to paste.
        #[help]
        help: String,
        /// The pairs concerned.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Hints that contradict.
    #[error("no assembly fits what `assemble` says")]
    #[diagnostic(code(mech::assembly::hint_not_met))]
    HintNotMet {
        /// The assemblies there are.
        #[help]
        help: String,
        /// The hints.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Dead position.
    #[error(
        "dead position{pose}: the group {group} is in line and cannot be solved (condition {condition:.1e})"
    )]
    #[diagnostic(
        code(mech::solve::dead_position),
        help("velocities and forces do not exist here; move the drive a little, or drive another link")
    )]
    DeadPosition {
        /// ` at pose 3 (crank = 60 deg)`, or empty.
        pose: String,
        /// The links of the group.
        group: String,
        /// Its condition figure.
        condition: f64,
        /// The pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Near a dead position.
    #[error(
        "near a dead position{pose}: condition {condition:.1e} of the group {group}, about {digits} digits are left in the accelerations and forces"
    )]
    #[diagnostic(code(mech::solve::ill_conditioned), severity(warning))]
    IllConditioned {
        /// Where.
        pose: String,
        /// The links of the group.
        group: String,
        /// Its condition figure.
        condition: f64,
        /// Digits left.
        digits: u32,
        /// The pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Newton's method did not converge.
    #[error("no assembly of the group {group} was found{pose}")]
    #[diagnostic(
        code(mech::assembly::not_found),
        help("say where its points are about, as in `assemble C near (0.2 m, 0.1 m)`, or check the lengths")
    )]
    NotFound {
        /// Where.
        pose: String,
        /// The links of the group.
        group: String,
        /// The pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A sweep that closes over a part only.
    #[error("the sweep closes over a part only: {closed} of {total} positions; {ranges}")]
    #[diagnostic(
        code(mech::assembly::partial_sweep),
        severity(warning),
        help("positions that do not close are listed and left out")
    )]
    PartialSweep {
        /// Positions that close.
        closed: usize,
        /// All positions.
        total: usize,
        /// The ranges that do not, in words.
        ranges: String,
        /// The drive.
        #[label("this sweep")]
        span: miette::SourceSpan,
    },
    /// A change of assembly between two positions.
    #[error(
        "the assembly of the group {group} changes between {from} and {to}: it passes a dead position on the way"
    )]
    #[diagnostic(
        code(mech::assembly::branch_switch),
        severity(warning),
        help(
            "the motion was followed through the dead position by its velocity and acceleration; make the steps smaller to see it"
        )
    )]
    BranchSwitch {
        /// The links of the group.
        group: String,
        /// Pose before.
        from: String,
        /// Pose after.
        to: String,
        /// The pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A contact that pulls.
    #[error("contact `{name}` would have to pull{pose}: normal force {normal:.6} N")]
    #[diagnostic(
        code(mech::solve::contact_pulls),
        severity(warning),
        help("the profiles part here: press them together by a spring or a load, or use a slot")
    )]
    ContactPulls {
        /// Its name.
        name: String,
        /// Where.
        pose: String,
        /// Normal force, N, negative.
        normal: f64,
        /// Its place.
        #[label("parts here")]
        span: miette::SourceSpan,
    },
    /// Asked for velocities of a drive without speed.
    #[error("`{what}` needs {needs}, and no drive has one")]
    #[diagnostic(code(mech::request::needs_speed))]
    NeedsSpeed {
        /// What was asked.
        what: String,
        /// `a speed` or `a speed in time`.
        needs: &'static str,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A drive without positions where a pose is needed.
    #[error("drive `{drive}` gives no position")]
    #[diagnostic(
        code(mech::request::needs_position),
        help("write where it stands, as in `drive {drive} = 0 deg`")
    )]
    NeedsPosition {
        /// The drive.
        drive: String,
        /// Its place.
        #[label("rates only")]
        span: miette::SourceSpan,
    },
    /// Sweeps of different length.
    #[error("drives `{first}` and `{second}` sweep over {count_first} and {count_second} positions")]
    #[diagnostic(
        code(mech::request::sweep_lengths),
        help("give both the same number of positions, or one of them a single one")
    )]
    SweepLengths {
        /// One drive.
        first: String,
        /// The other.
        second: String,
        /// Its positions.
        count_first: usize,
        /// Its positions.
        count_second: usize,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A dead position that does not exist.
    #[error("`{what}` of pair `{pair}` cannot be found: {why}")]
    #[diagnostic(
        code(mech::solve::no_extreme),
        help("dead positions need one drive that turns and a coordinate that it moves to and fro")
    )]
    NoExtreme {
        /// `dead`, `stroke`, …
        what: &'static str,
        /// The pair.
        pair: String,
        /// Why.
        why: String,
        /// Its place.
        #[label("this pair")]
        span: miette::SourceSpan,
    },
    /// Forces do not determine.
    #[error(
        "forces cannot be solved{pose}: the unknown effort cannot hold the mechanism here (condition {condition:.1e})"
    )]
    #[diagnostic(
        code(mech::solve::effort_cannot_hold),
        help(
            "the effort passes through the hinge or stands across the guide: change its place or direction"
        )
    )]
    EffortCannotHold {
        /// Where.
        pose: String,
        /// The condition figure.
        condition: f64,
        /// The pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A number that is not finite.
    #[error("a result{pose} is too large or not defined")]
    #[diagnostic(
        code(mech::solve::not_finite),
        help("check the magnitudes of lengths, masses and loads for a slip in a unit")
    )]
    NotFinite {
        /// Where.
        pose: String,
        /// The drive.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
}

pub(super) fn label(text: impl Into<String>, span: Span) -> LabeledSpan {
    LabeledSpan::new_with_span(Some(text.into()), span)
}
