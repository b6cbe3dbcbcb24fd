//! What can be wrong with a drive, a pose or a clause of `assemble`.

use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors of drives, poses and assembly.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum MotionError {
    /// Two drives move the same thing.
    #[error("`{name}` is driven twice")]
    #[diagnostic(
        code("mech::geometry::driven_twice"),
        help("several positions stand in one drive: `drive {name} = 10 deg, 55 deg, 80 deg`")
    )]
    DrivenTwice {
        /// What is driven.
        name: String,
        /// The second drive.
        #[label(primary, "driven again here")]
        again: Span,
        /// The first.
        #[label("already driven here")]
        first: Span,
    },
    /// A thing that has no coordinate to drive or to compare.
    #[error("`{name}` is {is} and has no coordinate")]
    #[diagnostic(code("mech::geometry::no_coordinate"), help("{help}"))]
    NoCoordinate {
        /// The name.
        name: String,
        /// What it is, with its article.
        is: String,
        /// What can be named instead.
        help: String,
        /// Its place.
        #[label("no coordinate")]
        span: Span,
    },
    /// The ground is driven or loaded.
    #[error("{what} on the ground has no effect: the ground is held")]
    #[diagnostic(code("mech::geometry::on_ground"), help("name the moving link it is meant for"))]
    OnGround {
        /// What, with its article.
        what: String,
        /// Where.
        #[label("the ground")]
        span: Span,
    },
    /// A word of sense that does not go with what is driven.
    #[error("{message}")]
    #[diagnostic(code("mech::geometry::wrong_sense"), help("{help}"))]
    WrongSense {
        /// What does not go together.
        message: String,
        /// What to write.
        help: String,
        /// The word.
        #[label("not here")]
        span: Span,
    },
    /// An acceleration without a speed.
    #[error("`{name}` accelerates, but has no speed")]
    #[diagnostic(
        code("mech::geometry::acceleration_without_speed"),
        help("state the speed of this instant too, from rest: `at {zero} accelerating …`")
    )]
    AccelerationWithoutSpeed {
        /// What is driven.
        name: String,
        /// A speed of zero.
        zero: String,
        /// The acceleration.
        #[label("which speed does it change?")]
        span: Span,
    },
    /// A drive of a linkage without a position.
    #[error("`{name}` is driven, but nothing says where it stands")]
    #[diagnostic(
        code("mech::geometry::drive_without_position"),
        help(
            "give a position, several, or a range: `drive {name} = {example}`; only trains of wheels and ropes move by rates alone"
        )
    )]
    WithoutPosition {
        /// What is driven.
        name: String,
        /// A position.
        example: String,
        /// The drive.
        #[label("at which position?")]
        span: Span,
    },
    /// A number of steps that is none.
    #[error("the number of steps must be a whole number from 1 to {most}, it is {value}")]
    #[diagnostic(
        code("mech::geometry::steps"),
        help("`0 deg .. 360 deg in 12 steps` is a pose every 30 deg")
    )]
    Steps {
        /// What was given.
        value: String,
        /// The most there may be.
        most: usize,
        /// Its place.
        #[label("{value}")]
        span: Span,
    },
    /// A step that does not divide its range.
    #[error("the range of {length} is not a whole number of steps of {of}")]
    #[diagnostic(code("mech::geometry::steps"), help("write `in {count} steps`, or another step"))]
    StepSize {
        /// The size of a step.
        of: String,
        /// The length of the range.
        length: String,
        /// A number of steps that fits.
        count: String,
        /// Its place.
        #[label("leaves a rest")]
        span: Span,
    },
    /// Two drives go through different numbers of positions.
    #[error("the drives go through different numbers of positions: {first_count} and {count}")]
    #[diagnostic(
        code("mech::geometry::positions_differ"),
        help("drives move together, pose by pose: give both as many positions, or one of them a single one")
    )]
    PositionsDiffer {
        /// Of the first drive.
        first_count: usize,
        /// Of the second.
        count: usize,
        /// The first drive.
        #[label("{first_count} positions")]
        first: Span,
        /// The second.
        #[label(primary, "{count} positions")]
        span: Span,
    },
    /// A pose sets something that is not driven.
    #[error("`{name}` is not driven")]
    #[diagnostic(code("mech::geometry::not_driven"), help("{help}"))]
    NotDriven {
        /// What the pose sets.
        name: String,
        /// What is driven.
        help: String,
        /// Its place.
        #[label("no drive moves it")]
        span: Span,
    },
    /// A pose leaves a drive open.
    #[error("{what} leaves `{drive}` open")]
    #[diagnostic(
        code("mech::geometry::pose_incomplete"),
        help(
            "`{drive}` goes through several positions; say where it stands: add `{example}`, with its own value"
        )
    )]
    PoseIncomplete {
        /// The pose.
        what: String,
        /// The drive.
        drive: String,
        /// What to add.
        example: String,
        /// The pose.
        #[label(primary, "where does `{drive}` stand?")]
        span: Span,
        /// The drive.
        #[label("several positions")]
        drive_span: Span,
    },
    /// A pose is named as one of the sweep.
    #[error("the sweep already has a pose {pose}")]
    #[diagnostic(
        code("mech::geometry::pose_of_sweep"),
        help("poses of the sweep are numbered from 1 to {count}; write `pose {pose}'`")
    )]
    PoseOfSweep {
        /// The name.
        pose: String,
        /// How many poses the sweep has.
        count: usize,
        /// The pose.
        #[label(primary, "this name is taken")]
        span: Span,
        /// The drive.
        #[label("{count} poses")]
        drive: Span,
    },
    /// `ahead` or `behind` of a point that slides on nothing.
    #[error("`{point}` slides on no guide, so nothing is ahead of or behind another point")]
    #[diagnostic(code("mech::geometry::no_guide"), help("{help}"))]
    NoGuide {
        /// The point.
        point: String,
        /// What to write instead.
        help: String,
        /// Its place.
        #[label("not the point of a prismatic pair")]
        span: Span,
    },
    /// `near` where the first pose is not known yet.
    #[error("`near` needs a first pose, but `{drive}` begins at a dead position")]
    #[diagnostic(
        code("mech::geometry::near_with_dead"),
        help(
            "dead positions are sought over the whole turn, with the assembly given: name it by `left of`, `ahead of` or a \
             sign, as in `assemble s > 0`"
        )
    )]
    NearWithDead {
        /// The drive.
        drive: String,
        /// The clause.
        #[label(primary, "near in which pose?")]
        span: Span,
        /// The drive.
        #[label("hangs on `dead`, `stroke` or `time_ratio`")]
        drive_span: Span,
    },
    /// A pair that has no single point.
    #[error("`{name}` is {is}, which has no single point")]
    #[diagnostic(code("mech::geometry::no_single_point"), help("name a point of a link, as in `{example}`"))]
    NoSinglePoint {
        /// The pair.
        name: String,
        /// What it is.
        is: String,
        /// A point.
        example: String,
        /// Its place.
        #[label("which point?")]
        span: Span,
    },
    /// A side is seen from a point towards the same point.
    #[error("from `{name}` towards `{name}` is no direction")]
    #[diagnostic(
        code("mech::geometry::no_direction"),
        help("`C left of B-D` looks from B towards another point D")
    )]
    NoDirection {
        /// The point.
        name: String,
        /// The two points.
        #[label("the same point")]
        span: Span,
    },
}
