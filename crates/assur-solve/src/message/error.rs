//! Why a position has no solution, or one to be careful with.

use super::consistent_error::ConsistentError;
use super::flywheel_error::FlywheelError;
use super::friction_error::FrictionError;
use super::simulate_error::SimulateError;
use super::train_error::TrainError;
use crate::source::Span;
use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// A position that cannot be solved, or a warning about one.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum SolveError {
    /// A construct that cannot be solved yet.
    #[error("{what} cannot be solved yet")]
    #[diagnostic(
        code(mech::request::not_supported_yet),
        help("remove it to solve the rest of the file; `assur check` shows the structure of the whole file")
    )]
    NotSupportedYet {
        what: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    #[error("the mechanism does not close{pose}: {gap}")]
    #[diagnostic(code(mech::assembly::does_not_close))]
    DoesNotClose {
        /// ` at pose 3 (crank = 60 deg)`, or empty.
        pose: String,
        /// By how much, between which points.
        gap: String,
        #[help]
        help: String,
        /// The pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Several assemblies and no choice.
    #[error("the mechanism has {count} assemblies{pose}, and {which}")]
    #[diagnostic(code(mech::assembly::ambiguous))]
    Ambiguous {
        count: usize,
        /// ` at pose 3 (crank = 60 deg)`, or empty.
        pose: String,
        /// What the file does not say.
        which: &'static str,
        /// The lines to paste.
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A mechanism that does not come back after whole turns of its drive.
    #[error(
        "after whole turns of the drive the mechanism is not where it began: `{link}` is elsewhere by {by}"
    )]
    #[diagnostic(
        code(mech::solve::not_periodic),
        severity(warning),
        help(
            "the pose at {at} is left out, and functions over the sweep take a part of the cycle: go on until all links come back, as in `0 deg .. 720 deg in 24 steps`"
        )
    )]
    Elsewhere {
        /// The link that is farthest from where it began.
        link: String,
        by: String,
        /// Drive values of the position that is left out.
        at: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    #[error("no assembly{pose} satisfies `assemble`")]
    #[diagnostic(code(mech::assembly::hint_not_met))]
    HintNotMet {
        /// ` at pose 3 (crank = 60 deg)`, or empty.
        pose: String,
        /// The assemblies there are.
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    #[error("dead position{pose}: {stands}")]
    #[diagnostic(code(mech::solve::dead_position))]
    DeadPosition {
        /// ` at pose 3 (crank = 60 deg)`, or empty.
        pose: String,
        /// How its links stand, with the condition figure.
        stands: String,
        #[help]
        help: String,
        /// The pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A curve is asked for a value beyond its table.
    #[error("curve `{name}` has no value at {argument}{pose}: its table goes from {extent}")]
    #[diagnostic(
        code(mech::curve::outside),
        help(
            "add rows, or write `periodic` after its name if it begins again, or `held` if its end values hold beyond the table"
        )
    )]
    CurveLeft {
        name: String,
        /// ` at pose 3 (crank = 60 deg)`, or empty.
        pose: String,
        argument: String,
        extent: String,
        #[label("{extent}")]
        span: Span,
    },
    /// A position too far from the one before.
    #[error("the step to this position is too large{pose}")]
    #[diagnostic(
        code(mech::solve::way_too_long),
        help(
            "ask for positions in between: the motion is followed in steps of two degrees, at most 2 million of them (11,111 turns) from one position to the next"
        )
    )]
    WayTooLong {
        pose: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Near a dead position.
    #[error("near a dead position{pose}: about {digits} digits are left in the {what} of {links}")]
    #[diagnostic(
        code(mech::solve::ill_conditioned),
        severity(warning),
        help(
            "condition figure σ = {condition:.1e}; the error of positions grows as ε/σ, that of velocities and forces as ε/σ², that of accelerations as ε/σ³, with ε = 2.2e-16"
        )
    )]
    IllConditioned {
        pose: String,
        /// The links of the group.
        links: String,
        condition: f64,
        digits: u32,
        /// `velocities`, `accelerations`, `forces`
        what: &'static str,
        /// The pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A position that was iterated to, and may not be a solution.
    #[error("the position of {links} could not be verified{pose}{more}")]
    #[diagnostic(
        code(mech::solve::not_certified),
        severity(warning),
        help(
            "choose a position next to it: the theorem of Newton and Kantorovich needs h ≤ 0.5, but h = {figure}; so near to a dead position rounding errors decide whether there is one solution, two or none"
        )
    )]
    NotCertified {
        pose: String,
        /// The links of the group.
        links: String,
        /// h, and the condition figure σ.
        figure: String,
        /// At how many other poses it is so.
        more: String,
        /// The pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Newton's method did not converge.
    #[error("no assembly of {links} was found{pose}")]
    #[diagnostic(code(mech::assembly::not_found))]
    NotFound {
        pose: String,
        /// The links of the group.
        links: String,
        #[help]
        help: String,
        /// The pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A sweep that closes over a part only.
    #[error("{positions}: the mechanism does not close {ranges}")]
    #[diagnostic(code(mech::assembly::partial_sweep), severity(warning))]
    PartialSweep {
        /// `5 of 12 positions close`
        positions: String,
        /// The ranges that do not, in words.
        ranges: String,
        #[help]
        help: String,
        #[label("this sweep")]
        span: miette::SourceSpan,
    },
    /// A change of assembly between two positions.
    #[error("{links} change to their other assembly between poses {from} and {to}, at {near}")]
    #[diagnostic(
        code(mech::assembly::branch_switch),
        severity(warning),
        help(
            "check the motion after this change point, where both assemblies meet: the links continue by their velocity, but a real machine may continue in either assembly"
        )
    )]
    BranchSwitch {
        /// The links of the group.
        links: String,
        from: String,
        to: String,
        /// Drive values of the change.
        near: String,
        /// The pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A contact that pulls.
    #[error("contact `{name}` would have to pull{pose}: normal force {normal}{more}")]
    #[diagnostic(
        code(mech::solve::contact_pulls),
        severity(warning),
        help(
            "press the profiles together by a spring or a load, or guide a pin in a `slot`: they part here"
        )
    )]
    ContactPulls {
        name: String,
        /// Where it pulls most.
        pose: String,
        /// The normal force there, negative.
        normal: String,
        /// At how many other poses it pulls too.
        more: String,
        #[label("parts here")]
        span: miette::SourceSpan,
    },
    /// Asked for velocities of a drive without speed.
    #[error("{what} is needed, but no drive has {needs}")]
    #[diagnostic(code(mech::request::needs_speed))]
    NeedsSpeed {
        /// `a velocity`, `an acceleration`
        what: &'static str,
        /// `a speed`, `a speed or a sense`
        needs: &'static str,
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// The rotation of a roller that turns freely.
    #[error("`{name}` turns freely: its rotation is not determined")]
    #[diagnostic(
        code(mech::request::free_rotation),
        help(
            "ask for points of its axis, or of the link that carries it; or give the circle to that link, so that it slides instead of rolling"
        )
    )]
    FreeRotation {
        name: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Speeds in forces, with a drive that has only a sense.
    #[error("{what} {depends} on speeds, but no drive has one: the result is for unit speed, {unit}")]
    #[diagnostic(code(mech::request::unit_speed), severity(Warning), help("{help}"))]
    UnitSpeed {
        /// `` `T` and `k` ``
        what: String,
        /// `depends` or `depend`
        depends: &'static str,
        /// `1 rad/s of `crank``
        unit: String,
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Damping where nothing moves.
    #[error("damping is left out: no drive has a speed")]
    #[diagnostic(code(mech::request::no_damping), severity(Warning), help("{help}"))]
    NoDamping {
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Friction at two contacts whose share is not determined.
    #[error(
        "the friction in {pairs} depends on how the load is shared between two contacts, which is statically indeterminate: {chain} a chain of prismatic pairs"
    )]
    #[diagnostic(
        code(mech::friction::open_couple),
        help(
            "leave `contacts` out, so that friction depends on the normal force, or make one of the pairs a revolute pair"
        )
    )]
    OpenCouple {
        /// `` `F` and `H` ``
        pairs: String,
        /// `it closes` or `they close`
        chain: &'static str,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A dead position that does not exist.
    #[error("`{what}` is not defined: {why}")]
    #[diagnostic(code(mech::solve::no_extreme))]
    NoExtreme {
        /// `dead(G, 1)`, `stroke(G)`, …
        what: String,
        why: String,
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A range that ends where it begins.
    #[error("the range of `{name}` has no length: it ends where it begins, at {at}")]
    #[diagnostic(code(mech::geometry::empty_range), help("{help}"))]
    EmptyRange {
        name: String,
        at: String,
        help: String,
        #[label("one position, in several steps")]
        span: miette::SourceSpan,
    },
    /// A function over a sweep where there is none.
    #[error("no function over the sweep can be found: {why}")]
    #[diagnostic(code(mech::solve::no_sweep))]
    NoSweep {
        why: String,
        #[help]
        help: String,
        /// What asks for it, and the drive.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// An unknown effort that holds nothing.
    #[error("the forces cannot be found{pose}: {why}")]
    #[diagnostic(code(mech::solve::effort_cannot_hold))]
    EffortCannotHold {
        pose: String,
        why: String,
        #[help]
        help: String,
        /// The effort and the pairs of the group.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// An instant centre where nothing turns.
    #[error("`{link}` does not turn against {seen_from}{pose}{more}: its instant centre is at infinity")]
    #[diagnostic(code(mech::solve::no_centre), severity(warning), help("{help}"))]
    NoCentre {
        link: String,
        /// `the ground`, or the other link.
        seen_from: String,
        /// ` at pose 3 (crank = 60 deg)`, or empty.
        pose: String,
        /// `, and at 2 other poses`, or empty.
        more: String,
        /// What to ask for instead.
        help: String,
        #[label("no value")]
        span: miette::SourceSpan,
    },
    /// A motion under loads.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Simulate(#[from] SimulateError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Flywheel(#[from] FlywheelError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Friction(#[from] FrictionError),
    /// What only trains have.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Train(#[from] TrainError),
    /// Several states of the forces, or none.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Consistent(#[from] ConsistentError),
    /// A number that is not finite.
    #[error("{what}{pose} cannot be computed: the numbers are too large")]
    #[diagnostic(
        code(mech::solve::not_finite),
        help("check units and powers of ten of lengths, speeds, masses and loads")
    )]
    NotFinite {
        pose: String,
        what: String,
        /// Its place, and the drives.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
}
