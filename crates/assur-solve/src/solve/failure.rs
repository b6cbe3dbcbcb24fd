//! Why a file, or one of its positions, has no solution: data alone, of which `message` makes the sentences.

use super::clause::{Clause, NamedPoint};
use super::gap::{GroupGap, TurnGap};
use super::refusal::Refusal;
use crate::answer::{LeftCurve, NoExtreme, NoFlywheel, NoSweep};
use crate::language::Function;
use crate::model::{DriveTarget, PairId, UnilateralCondition};
use crate::position::PoseRequest;
use crate::structure::{BodyId, Group, Structure};

/// Why a file, or one of its positions, has no solution.
#[derive(Clone, Debug)]
pub struct Failure {
    /// The position; absent where the cause concerns none, or a position that the file does not name.
    pub pose: Option<Box<PoseRequest>>,
    pub cause: Cause,
}

/// The cause of a failure.
#[derive(Clone, Debug)]
pub enum Cause {
    /// It cannot be answered at any position.
    Refused(Refusal),
    /// A group has no assembly.
    DoesNotClose {
        /// Index into [`Structure::motion`].
        group: usize,
        /// By how much it does not close.
        gap: GroupGap,
    },
    /// The search for an assembly of a general group found none.
    NotFound {
        /// Index into [`Structure::motion`].
        group: usize,
        /// A point of the group that a clause of `assemble` can name.
        point: Option<NamedPoint>,
        /// The pairs of the group let it move, or are too many, wherever its links are.
        never_regular: bool,
    },
    /// Several assemblies are left.
    Ambiguous {
        /// The number of assemblies.
        count: usize,
        /// The groups in which they differ, each with the clauses that choose.
        groups: Vec<(usize, Vec<Clause>)>,
    },
    /// No assembly is as a clause of `assemble` says.
    HintNotMet {
        /// Index into [`crate::model::Mechanism::hints`].
        hint: usize,
        /// Index into [`Structure::motion`].
        group: usize,
        /// The assemblies of the group: the clause that chooses each, and the coordinate on which the hint sets a bound.
        assemblies: Vec<(Clause, Option<f64>)>,
    },
    /// The position is too far from the one before.
    TooFar,
    /// Velocities and forces do not exist: the determinant of a group vanishes.
    Dead { group: GroupId, condition: f64 },
    /// An unknown effort cannot hold the links of its group.
    CannotHold {
        /// Index into [`Structure::forces`].
        group: usize,
        condition: f64,
    },
    /// The ends of a spring are at one place, so that its force has no direction.
    SpringAtZero {
        /// Index into [`crate::model::Mechanism::springs`].
        spring: usize,
    },
    /// A result has no digit left.
    Lost(Lost),
    /// A curve has no value at the argument it is asked for.
    CurveLeft(LeftCurve),
    /// The search for consistent forces was given up.
    Undecided,
    /// Power runs backwards through a belt whose slip is given.
    SlipBackwards(PairId),
    /// No direction of the power is consistent with the losses of transmissions.
    Blocked,
    /// The coordinate of a pair has no extremes.
    NoExtreme {
        pair: PairId,
        /// The function that needs them.
        function: Function,
        /// Which of the two extremes it names.
        which: Option<u8>,
        /// Why there are none.
        why: NoExtreme,
        /// What keeps the drive from turning fully, where a number is known.
        gap: Option<Box<TurnGap>>,
    },
    /// There is no sweep to take a function over.
    NoSweep(NoSweep),
    /// A motion under loads cannot go on.
    Halted {
        /// The instant, s.
        time: f64,
        halt: Halt,
    },
    /// A flywheel cannot be found.
    NoFlywheel {
        /// Index into [`crate::model::Mechanism::flywheels`].
        flywheel: usize,
        why: NoFlywheel,
    },
}

/// Why a motion under loads cannot go on.
#[derive(Clone, Debug)]
pub enum Halt {
    /// A group stands in a dead position of the free coordinates.
    Dead {
        /// Index into [`Structure::motion`].
        group: usize,
        condition: f64,
    },
    /// A group does not close however short the step.
    Open {
        /// Index into [`Structure::motion`].
        group: usize,
    },
    /// A coordinate starts with a speed in its dead position.
    NoRate {
        /// Index into [`crate::model::Mechanism::drives`].
        drive: usize,
        /// A coordinate that has a speed there, and its value.
        other: DriveTarget,
        value: f64,
    },
    /// A start in a change point.
    TwoMotions {
        /// Index into [`crate::model::Mechanism::drives`].
        drive: usize,
        /// A value next to it, rad or m, where the two motions differ, and the rate that is written.
        value: f64,
        /// rad/s or m/s.
        rate: f64,
        /// Index into [`Structure::motion`]: a group that changes.
        group: usize,
        /// What chooses each motion.
        ways: Vec<Clause>,
    },
    /// The length of a spring passes zero, or begins there.
    SpringAtZero {
        /// Index into [`crate::model::Mechanism::springs`].
        spring: usize,
    },
    /// A free coordinate moves no mass.
    NoInertia,
    /// The starts leave freedom, and no contacts that part are closed at the first instant.
    NothingTouches,
    /// Friction admits no acceleration of a free coordinate, or one in either sense.
    Jam,
    /// Nothing is free, and something rubs or there is a stop.
    NothingFree {
        /// The stop.
        stop: usize,
    },
    /// Friction would hold a cam on its follower, so that they roll on each other.
    Rolls { pair: PairId },
    /// Forces act as a pair does not take them: a contact would have to pull, a rope to push.
    Opens {
        pair: PairId,
        /// What it does no more.
        bond: UnilateralCondition,
    },
    /// A motion that comes again was not found.
    NoCycle(NoCycle),
    /// A coordinate starts beyond its stop.
    StopPassed {
        /// Index into [`crate::model::Mechanism::stops`].
        stop: usize,
        /// By how much, m or rad.
        by: f64,
    },
    /// Several stops are hit at once.
    StopsAtOnce {
        /// Indices into [`crate::model::Mechanism::stops`].
        stops: Vec<usize>,
    },
    /// Rebounds that become lower and lower let friction hold in some of them and slide in others.
    Shaken {
        /// Index into [`crate::model::Mechanism::stops`].
        stop: usize,
    },
    /// A load is not a number.
    NotANumber,
    /// The most steps are done, or the run would never come to its end.
    TooManySteps {
        /// Those that were tried.
        steps: usize,
        /// The greatest rate at which something in it changes, as the last step shows, 1/s.
        rate: f64,
    },
    /// No step is short enough.
    NoStep,
    /// A coordinate and its rate grow without bound.
    Unbounded { drive: usize },
    /// It was asked to end.
    Interrupted,
    /// The accuracy is not reached with the digits there are.
    Accuracy { wanted: f64, reached: f64 },
}

impl Halt {
    /// Whether nothing is wrong but its accuracy.
    #[must_use]
    pub const fn is_inaccurate(&self) -> bool {
        matches!(self, Self::Accuracy { .. })
    }
}

/// Why no motion was found that comes again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoCycle {
    /// Its end is not reached in this time, s.
    NotReached(f64),
    /// After so many trials the state at the end still differs from that at the begin by this part.
    Differs {
        trials: usize,
        /// By how much, of the greatest of its kind.
        by: f64,
    },
}

/// A group of one of the two lists of a structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GroupId {
    /// Index into [`Structure::motion`].
    Motion(usize),
    /// Index into [`Structure::forces`].
    Forces(usize),
}

/// A result that is not finite, or that rounding has made meaningless.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lost {
    /// The position of a body.
    Position(BodyId),
    Velocity(BodyId),
    Acceleration(BodyId),
    /// The reaction in a pair.
    Reaction(PairId),
    Effort,
    /// The pairs do not meet.
    Closure,
    /// A residual of the forces is not a number.
    Equilibrium,
}

impl Failure {
    /// A cause at a position.
    pub(super) fn at(pose: &PoseRequest, cause: Cause) -> Self {
        Self { pose: Some(Box::new(pose.clone())), cause }
    }
}

impl From<Cause> for Failure {
    fn from(cause: Cause) -> Self {
        Self { pose: None, cause }
    }
}

impl From<Refusal> for Failure {
    fn from(refusal: Refusal) -> Self {
        Cause::Refused(refusal).into()
    }
}

impl Cause {
    /// Whether the mechanism does not close, or no assembly was found.
    #[must_use]
    pub const fn is_open(&self) -> bool {
        matches!(self, Self::DoesNotClose { .. } | Self::NotFound { .. })
    }
}

impl GroupId {
    #[must_use]
    pub fn of(self, structure: &Structure) -> &Group {
        match self {
            Self::Motion(index) => &structure.motion[index],
            Self::Forces(index) => &structure.forces[index],
        }
    }
}
