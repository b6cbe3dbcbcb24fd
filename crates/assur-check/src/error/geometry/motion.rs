//! Errors of drives, poses and clauses of `assemble`.

use assur_text::diagnostic::{Fix, Help, Problem};
use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors of drives, poses and assembly.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum MotionError {
    /// A phase of what has no wheels on two links.
    #[error("`{name}` has no phase")]
    #[diagnostic(
        code("mech::geometry::no_phase"),
        help(
            "name a mesh, a belt or a chain: `assemble k phase 40 deg`; for links and points see `near`, `left of` and `> 0`"
        )
    )]
    NoPhase {
        name: String,
        #[label(primary, "not a mesh, a belt or a chain")]
        span: Span,
        #[label("declared here")]
        declared: Span,
    },
    /// Two drives move the same thing.
    #[error("`{name}` is driven twice")]
    #[diagnostic(
        code("mech::geometry::driven_twice"),
        help("write several positions in one drive: `drive {name} = 10 deg, 55 deg, 80 deg`")
    )]
    DrivenTwice {
        /// The name of the drive.
        name: String,
        #[label(primary, "driven again here")]
        again: Span,
        #[label("already driven here")]
        first: Span,
    },
    /// A start without a position where positions are asked for.
    #[error("a start needs a position where the motion depends on it")]
    #[diagnostic(
        code("mech::geometry::no_drive_position"),
        help("write `start {name}`, with your own values")
    )]
    StartWithoutPosition {
        /// The start with example values.
        name: String,
        #[label("no position")]
        span: Span,
    },
    /// A thing that has no coordinate to drive or to compare.
    #[error("`{name}` is {is} and has no coordinate")]
    #[diagnostic(code("mech::geometry::no_coordinate"), help("{help}"))]
    NoCoordinate {
        name: String,
        /// Its kind, with its article.
        is: String,
        /// Names that can be used.
        help: String,
        #[label("no coordinate")]
        span: Span,
    },
    /// The ground is driven or loaded.
    #[error("{what} on the ground has no effect: the ground is fixed")]
    #[diagnostic(code("mech::geometry::on_ground"), help("{help}"))]
    OnGround {
        help: String,
        /// What, with its article.
        what: String,
        #[label("the ground")]
        span: Span,
    },
    /// A word of sense that does not fit the drive.
    #[error("{message}")]
    #[diagnostic(code("mech::geometry::wrong_sense"), help("{help}"))]
    WrongSense {
        /// The words that do not fit together.
        message: String,
        help: String,
        #[label("does not fit here")]
        span: Span,
    },
    /// An acceleration without a speed.
    #[error("`{name}` accelerates, but has no speed")]
    #[diagnostic(
        code("mech::geometry::acceleration_without_speed"),
        help("give the present speed too; from rest: `at {zero} accelerating …`")
    )]
    AccelerationWithoutSpeed {
        /// The name of the drive.
        name: String,
        /// A speed of zero.
        zero: String,
        #[label("acceleration without speed")]
        span: Span,
    },
    /// A drive of a linkage without a position.
    #[error("`{name}` is driven, but its position is not given")]
    #[diagnostic(
        code("mech::geometry::drive_without_position"),
        help(
            "give a position, several, or a range: `drive {name} = {example}`; only trains of wheels and ropes move by rates alone"
        )
    )]
    WithoutPosition {
        /// The name of the drive.
        name: String,
        example: String,
        #[label("the position is missing")]
        span: Span,
    },
    /// A wrong number of steps.
    #[error("the number of steps must be a whole number from 1 to {most}; got {value}")]
    #[diagnostic(
        code("mech::geometry::steps"),
        help("write for example `0 deg .. 360 deg in 12 steps`, one pose every 30 deg")
    )]
    Steps {
        value: String,
        /// The most there may be.
        most: usize,
        #[label("{value}")]
        span: Span,
    },
    /// A range that ends where it begins.
    #[error("the range of `{name}` has no length: it ends where it begins")]
    #[diagnostic(code("mech::geometry::empty_range"), help("write `{line}`, or another end of the range"))]
    EmptyRange {
        name: String,
        /// The drive at one position.
        line: String,
        #[label("one position, in several steps")]
        span: Span,
    },
    /// Numbers that are too far apart.
    #[error("numbers near {at} are {step} apart, too much for {against} and the six digits that are printed")]
    #[diagnostic(code("mech::geometry::spacing"), severity(Warning), help("{help}"))]
    Spacing {
        /// The coordinate or the angle.
        at: String,
        /// From a number to the next there.
        step: String,
        /// What is to be resolved.
        against: String,
        help: &'static str,
        /// The point, the line or the drive.
        #[label("far from zero")]
        span: Span,
    },
    /// A step that gives no number of steps.
    #[error("{message}")]
    #[diagnostic(code("mech::geometry::steps"), help("{help}"))]
    StepSize {
        /// What is wrong, with the numbers.
        message: String,
        help: String,
        /// The words at its place.
        label: &'static str,
        #[label("{label}")]
        span: Span,
    },
    /// Two drives go through different numbers of positions.
    #[error("the drives go through different numbers of positions: {first_count} and {count}")]
    #[diagnostic(
        code("mech::geometry::positions_differ"),
        help(
            "give both the same number of positions, or one of them a single position: drives move together, pose by pose"
        )
    )]
    PositionsDiffer {
        /// Of the first drive.
        first_count: usize,
        count: usize,
        #[label("{first_count} positions")]
        first: Span,
        #[label(primary, "{count} positions")]
        span: Span,
    },
    /// A pose sets something that is not driven.
    #[error("`{name}` is not driven")]
    #[diagnostic(code("mech::geometry::not_driven"), help("{help}"))]
    NotDriven {
        /// The name in the pose.
        name: String,
        /// The name of the drive.
        help: Help,
        #[label("no drive moves it")]
        span: Span,
    },
    /// A pose does not give the position of a drive.
    #[error("{what} does not give the position of `{drive}`")]
    #[diagnostic(
        code("mech::geometry::pose_incomplete"),
        help("add `{example}`, with its own value: `{drive}` goes through several positions")
    )]
    PoseIncomplete {
        what: String,
        drive: String,
        example: String,
        #[label(primary, "the position of `{drive}` is missing")]
        span: Span,
        #[label("several positions")]
        drive_span: Span,
    },
    /// A pose is named as one of the sweep.
    #[error("the sweep already has a pose {pose}")]
    #[diagnostic(
        code("mech::geometry::pose_of_sweep"),
        help("write `pose {pose}'`; poses of the sweep are numbered from 1 to {count}")
    )]
    PoseOfSweep {
        pose: String,
        /// How many poses the sweep has.
        count: usize,
        #[label(primary, "this name is taken")]
        span: Span,
        #[label("{count} poses")]
        drive: Span,
    },
    /// `ahead` or `behind` of a point that slides on no guide.
    #[error("`ahead` and `behind` need a guide, and `{point}` slides on none")]
    #[diagnostic(code("mech::geometry::no_guide"), help("{help}"))]
    NoGuide {
        point: String,
        help: String,
        #[label("not the point of a prismatic pair")]
        span: Span,
    },
    /// `near` if the first pose is not known.
    #[error("`near` needs a known first pose, but `{drive}` begins at a dead position")]
    #[diagnostic(
        code("mech::geometry::near_with_dead"),
        help(
            "choose the assembly by `left of`, `ahead of` or a sign, as in `assemble s > 0`: it must be known before the \
             dead position is found"
        )
    )]
    NearWithDead {
        drive: String,
        #[label(primary, "refers to the first pose")]
        span: Span,
        #[label("depends on `dead`, `stroke` or `time_ratio`")]
        drive_span: Span,
    },
    /// A pair that has no single point.
    #[error("`{name}` is {is}, which has no single point")]
    #[diagnostic(code("mech::geometry::no_single_point"), help("name a point of a link, as in `{example}`"))]
    NoSinglePoint {
        name: String,
        is: String,
        example: String,
        #[label("the point is not clear")]
        span: Span,
    },
    /// A side is seen from a point towards the same point.
    #[error("from `{name}` towards `{name}` there is no direction")]
    #[diagnostic(
        code("mech::geometry::no_direction"),
        help("name two different points: `C left of B-D` looks from B towards D")
    )]
    NoDirection {
        name: String,
        #[label("the same point")]
        span: Span,
    },
}

impl Problem for MotionError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            Self::NotDriven { help, .. } => help.fixes().to_vec(),
            Self::WithoutPosition { name, example, span } => {
                Fix::quoted(&format!("write `drive {name} = {example}`"), *span)
            }
            Self::EmptyRange { line, span, .. } => Fix::quoted(&format!("write `{line}`"), *span),
            Self::WrongSense { help, span, .. } => Fix::quoted(help, *span),
            Self::NoSinglePoint { example, span, .. } => Fix::quoted(&format!("write `{example}`"), *span),
            _ => Vec::new(),
        }
    }
}
