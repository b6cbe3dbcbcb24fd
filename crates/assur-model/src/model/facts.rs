//! What there is to know of a question before anything is solved: what it needs and what its answer is.

use super::{FlywheelPart, LinkId, LoadId, PairId, PointRef, Query, SubstitutionPart};
use assur_text::language::Function;

/// How far motion is followed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    #[default]
    Positions,
    Velocities,
    Accelerations,
}

/// The kind of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    Number,
    Vector,
    /// A condition, true or false.
    Condition,
    /// What the load is: a vector for a force on a link, else a number.
    Load(LoadId),
}

/// The subject of a question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum About {
    Link(LinkId),
    /// The links of a pair.
    Pair(PairId),
    Point(PointRef),
}

/// The needs of a question, and the kind of its answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facts {
    /// How far motion must be followed.
    pub level: Level,
    /// It is the same at any speed: a drive without one moves at unit speed for it.
    pub geometric: bool,
    /// It needs rates beyond accelerations.
    pub beyond: bool,
    /// It needs reactions or efforts.
    pub forces: bool,
    /// It has one answer for the whole motion.
    pub poseless: bool,
    /// It is found from all positions of the motion, or from other solutions of the file.
    pub of_solution: bool,
    /// The kind of the answer.
    pub answer: Answer,
    /// Its name, if it is found from the loads.
    pub from_loads: Option<&'static str>,
    /// The bodies that must have a position, with the question.
    pub placed: Option<(About, &'static str)>,
    /// The bodies that must have a determined rotation.
    pub turned: Option<About>,
    /// The link or pair whose angle is continuous over the sweep.
    pub continuous: Option<About>,
    /// The pair whose reaction must have a known place.
    pub reaction: Option<PairId>,
    /// The pair whose couple must be determined.
    pub couple: Option<PairId>,
    /// The pair whose extremes over a turn of the drive are needed, with the function, and which of two.
    pub extreme: Option<(PairId, Function, Option<u8>)>,
}

/// A number that needs positions alone.
const NUMBER: Facts = Facts {
    level: Level::Positions,
    geometric: false,
    beyond: false,
    forces: false,
    poseless: false,
    of_solution: false,
    answer: Answer::Number,
    from_loads: None,
    placed: None,
    turned: None,
    continuous: None,
    reaction: None,
    couple: None,
    extreme: None,
};
/// A vector that needs positions alone.
const VECTOR: Facts = Facts { answer: Answer::Vector, ..NUMBER };
/// A number that needs velocities.
const RATE: Facts = Facts { level: Level::Velocities, ..NUMBER };
/// A number that is known once all positions are.
const OF_SOLUTION: Facts = Facts { poseless: true, of_solution: true, ..NUMBER };
const POWER: Facts = Facts { from_loads: Some("a power"), ..RATE };
/// A number of the events of a motion.
const EVENT: Facts = of_motion("an event of the motion", Answer::Number);
/// A number that needs accelerations.
const SECOND_RATE: Facts = Facts { level: Level::Accelerations, ..NUMBER };
/// A number that needs jerks.
const THIRD_RATE: Facts = Facts { beyond: true, ..SECOND_RATE };

/// A number that needs forces.
const fn force(what: &'static str) -> Facts {
    Facts { forces: true, from_loads: Some(what), ..NUMBER }
}

/// A place that is followed through whole turns.
const fn followed(about: About, what: &'static str) -> Facts {
    Facts { placed: Some((about, what)), turned: Some(about), continuous: Some(about), ..NUMBER }
}

/// Something of a pair's extremes.
const fn extreme(pair: PairId, function: Function, which: Option<u8>) -> Facts {
    Facts { turned: Some(About::Pair(pair)), extreme: Some((pair, function, which)), ..NUMBER }
}

/// A force in a link that has a place.
const fn force_in(link: LinkId, what: &'static str) -> Facts {
    Facts { placed: Some((About::Link(link), what)), ..force(what) }
}

impl Query {
    /// Its needs, and the kind of its answer.
    #[must_use]
    pub const fn facts(&self) -> Facts {
        match *self {
            Self::Position(p) => of_point(p, Level::Positions, "a position"),
            Self::Velocity(p) => of_point(p, Level::Velocities, "the velocity of a point"),
            Self::Acceleration(p) => of_point(p, Level::Accelerations, "the acceleration of a point"),
            Self::Jerk(p) => {
                Facts { beyond: true, ..of_point(p, Level::Accelerations, "the jerk of a point") }
            }
            Self::CurvatureRadius(p) => Facts { answer: Answer::Number, ..of_path(p) },
            Self::CurvatureCentre(p) => of_path(p),
            Self::Angle(link) => followed(About::Link(link), "an angle"),
            Self::LinkDirection(link) => {
                let about = About::Link(link);
                Facts { placed: Some((about, "an angle")), turned: Some(about), ..VECTOR }
            }
            Self::Period | Self::EventTime(..) | Self::EventDrive(..) | Self::EventCount(_) => EVENT,
            Self::StopsEffort(_) => Facts { from_loads: Some("the force of a stop"), ..SECOND_RATE },
            Self::Impulse(_) => Facts { from_loads: Some("an impulse"), ..RATE },
            Self::In(_) => of_motion("what rests or sticks", Answer::Condition),
            Self::Time | Self::PotentialEnergy | Self::StopEffort(_) => NUMBER,
            Self::KineticEnergy => RATE,
            Self::Omega(link) | Self::Turning(link, _) => Facts { turned: Some(About::Link(link)), ..RATE },
            Self::Alpha(link) | Self::InertiaTorque(link) => {
                Facts { turned: Some(About::Link(link)), ..SECOND_RATE }
            }
            Self::AngularJerk(link) => Facts { turned: Some(About::Link(link)), ..THIRD_RATE },
            Self::InertiaForce(link) => {
                let about = About::Link(link);
                let placed = Some((about, "the acceleration of a point"));
                Facts { placed, answer: Answer::Vector, ..SECOND_RATE }
            }
            Self::InertiaArm(_) => SECOND_RATE,
            Self::StaticSubstitution(_, _, _, part) | Self::DynamicSubstitution(_, _, part) => {
                of_substitution(part)
            }
            Self::Displacement(pair) | Self::TorsionEnergy(_, pair) => {
                followed(About::Pair(pair), "a position")
            }
            Self::RelativeVelocity(pair) | Self::Sliding(pair) => {
                Facts { turned: Some(About::Pair(pair)), ..RATE }
            }
            Self::RelativeAcceleration(pair) => Facts { turned: Some(About::Pair(pair)), ..SECOND_RATE },
            Self::RelativeJerk(pair) => Facts { turned: Some(About::Pair(pair)), ..THIRD_RATE },
            Self::Coriolis(_) => Facts { answer: Answer::Vector, ..RATE },
            Self::TransmissionAngle(_) => NUMBER,
            Self::PressureAngle(_) => RATE,
            Self::Travel(pair) => {
                let about = About::Pair(pair);
                let placed = Some((about, "a position"));
                Facts { placed, continuous: Some(about), ..extreme(pair, Function::Travel, None) }
            }
            Self::Stroke(pair) => Facts { poseless: true, ..extreme(pair, Function::Stroke, None) },
            Self::TimeRatio(pair) => Facts { poseless: true, ..extreme(pair, Function::TimeRatio, None) },
            Self::Dead(pair, which) => Facts { poseless: true, ..extreme(pair, Function::Dead, Some(which)) },
            Self::Reaction(pair, _) => {
                Facts { reaction: Some(pair), answer: Answer::Vector, ..force("a reaction") }
            }
            Self::Moment(pair, _) => {
                Facts { reaction: Some(pair), couple: Some(pair), ..force("a moment in a pair") }
            }
            Self::Axial(link) => force_in(link, "an axial force"),
            Self::Internal(asked) => force_in(asked.link, "a force inside a link"),
            Self::Normal(pair, _) => Facts { reaction: Some(pair), ..force("a normal force") },
            Self::ContactForce(pair, _) => {
                Facts { reaction: Some(pair), couple: Some(pair), ..force("a normal force") }
            }
            Self::LineOffset(pair) => {
                Facts { reaction: Some(pair), couple: Some(pair), ..force("the position of a reaction") }
            }
            Self::Friction(..) => force("a friction force"),
            Self::TangentialForce(..) | Self::ToothForce(..) => force("a force between teeth"),
            Self::Tension(..) => force("the pull of a rope"),
            Self::TightSide(_) | Self::SlackSide(_) => force("the pull of a belt"),
            Self::Capacity(_) => Facts { poseless: true, ..NUMBER },
            Self::Slips(_) => Facts { answer: Answer::Condition, ..force("the force of a belt or clutch") },
            Self::Balance(_) => force("an unknown load"),
            Self::Effort(_) => force("the effort of a drive"),
            Self::Load(id) => Facts { answer: Answer::Load(id), ..NUMBER },
            Self::Work(_) => Facts { from_loads: Some("a work"), ..POWER },
            Self::SpringPower(_) | Self::LoadPower(_) => POWER,
            Self::BalancePower(_) | Self::EffortPower(_) | Self::FrictionPower(_) => {
                Facts { level: Level::Velocities, ..force("a power") }
            }
            Self::Efficiency => Facts { level: Level::Velocities, ..force("the efficiency") },
            Self::Locked => {
                Facts { level: Level::Velocities, answer: Answer::Condition, ..force("the efficiency") }
            }
            Self::Vibration(..) => NUMBER,
            Self::Stable => Facts { answer: Answer::Condition, ..NUMBER },
            Self::Critical(_) => Facts { poseless: true, of_solution: true, ..force("a critical value") },
            Self::Cycle(_) => OF_SOLUTION,
            Self::Flywheel(_, part) => Facts {
                level: Level::Velocities,
                forces: !matches!(part, FlywheelPart::LinksInertia),
                poseless: part.needs_no_pose(),
                of_solution: true,
                from_loads: Some("a flywheel"),
                ..NUMBER
            },
        }
    }
}

/// What is known of a motion once all of it is.
const fn of_motion(what: &'static str, answer: Answer) -> Facts {
    let poseless = matches!(answer, Answer::Number);
    Facts { from_loads: Some(what), of_solution: true, poseless, answer, ..NUMBER }
}

/// A vector of a point.
const fn of_point(point: PointRef, level: Level, what: &'static str) -> Facts {
    let (PointRef::Fixed(link, _) | PointRef::Under(link, _)) = point;
    let placed = Some((About::Link(link), what));
    Facts { level, placed, turned: Some(About::Point(point)), ..VECTOR }
}

/// The curvature of the path of a point.
const fn of_path(point: PointRef) -> Facts {
    Facts { geometric: true, ..of_point(point, Level::Accelerations, "the path of a point") }
}

/// A part of a mass substitution.
const fn of_substitution(part: SubstitutionPart) -> Facts {
    use SubstitutionPart::{A2, DJ, F1, F2, L2, M1, M2, P2};
    match part {
        M1 | M2 | L2 | DJ => NUMBER,
        P2 => VECTOR,
        A2 | F1 | F2 => Facts { level: Level::Accelerations, ..VECTOR },
    }
}
