//! What deserves a warning or a note in a solution: data alone, of which `message` makes the sentences.

use super::failure::GroupId;
use crate::model::{DriveId, LinkId, LoadId, PairId, Query, SpringId};
use crate::position::{DriveValue, PoseRequest};

/// Something that deserves a warning, or a note.
#[derive(Clone, Debug)]
pub enum Note {
    /// A group changes to its other assembly between two positions of the sweep.
    Switched {
        /// Index into [`crate::structure::Structure::motion`].
        group: usize,
        /// Drive values of the change.
        at: Vec<DriveValue>,
        /// Name of the position before.
        from: String,
        /// Name of the position after.
        to: String,
    },
    /// After whole turns of the drive the mechanism is not where it began; that position is left out of the sweep.
    Elsewhere {
        /// The link that is farthest from where it began.
        link: LinkId,
        /// By how much its origin is elsewhere, m.
        off: f64,
        /// By how much it is turned, rad.
        turned: f64,
        /// Drive values of the position.
        drives: Vec<DriveValue>,
        /// The range after which all links are back, if it was found.
        whole: Option<WholeCycleRange>,
    },
    /// A motion under loads, or a sweep, comes to its last position without the end that `until` names.
    NeverEnded {
        /// Index into [`crate::model::Mechanism::events`].
        event: usize,
        /// The last instant, s, or the last value of the swept drive, rad or m.
        at: f64,
    },
    /// The load cannot drive the mechanism.
    SelfLocking {
        pose: PoseRequest,
        /// The number of others.
        more: usize,
    },
    /// Several states of the forces are consistent with friction or losses.
    SeveralBalances {
        /// The number of states.
        count: usize,
        /// The one reported is reached continuously from that without friction and losses.
        followed: bool,
        pose: PoseRequest,
        /// The number of others.
        more: usize,
    },
    RopePushes(Pull),
    /// A belt or a clutch must transmit more than its friction can.
    Slips(Pull),
    ContactPulls(Pull),
    /// The sweep closes over a part only.
    PartialSweep {
        /// The numbers of positions.
        closing: Closing,
        /// Where it does not close.
        gaps: Vec<Gap>,
        /// The number of gaps that are not kept.
        more: usize,
    },
    /// The group with the fewest digits left.
    IllConditioned {
        pose: PoseRequest,
        group: GroupId,
        /// Its condition figure σ.
        condition: f64,
        digits: u32,
        /// What loses the others.
        loss: Loss,
    },
    /// A group was solved by iteration, and no theorem says that this is a solution.
    NotCertified(Uncertified),
    /// A flywheel is not needed.
    NeedlessFlywheel {
        /// Index into [`crate::model::Mechanism::flywheels`].
        flywheel: usize,
        /// Mean reduced moment of inertia of the links, kg m².
        have: f64,
        /// Moment of inertia needed in all, kg m².
        needed: f64,
    },
    /// Dampers where no drive has a speed or a sense.
    NoDamping {
        drive: DriveId,
        /// The springs with damping.
        springs: Vec<SpringId>,
        /// The same of springs in pairs.
        loads: Vec<LoadId>,
    },
    /// Forces depend on speeds, and the drive has a sense alone.
    UnitSpeed {
        drive: DriveId,
        /// The springs with damping.
        springs: Vec<SpringId>,
        /// Loads that depend on speeds.
        loads: Vec<LoadId>,
    },
    /// Nothing slides in a pair with friction.
    NoSliding {
        pair: PairId,
        pose: PoseRequest,
        /// The number of others.
        more: usize,
    },
    /// Friction locks the mechanism.
    Locked(Locking),
    /// An instant centre is asked for where nothing turns, or a curvature where a path has none.
    NoCentre {
        /// Index into [`crate::model::Mechanism::finds`].
        find: usize,
        /// The rate, or the curvature.
        of: Query,
        pose: PoseRequest,
        /// The number of others.
        more: usize,
    },
    /// A locked mechanism has no value for results that are asked for.
    NoEffort {
        /// Indices into [`crate::model::Mechanism::finds`].
        finds: Vec<usize>,
        pose: PoseRequest,
        /// The number of others.
        more: usize,
    },
}

/// A force that a contact or a rope cannot take.
#[derive(Clone, Debug)]
pub struct Pull {
    pub pair: PairId,
    /// Normal force of the contact, or tension of the rope, where it is least, N; of what slips the force (N) or torque
    /// (N m) wanted, with a minus.
    pub least: f64,
    /// The position where it is least.
    pub pose: PoseRequest,
    /// The number of positions with such a force.
    pub poses: usize,
}

/// The worst position of those whose certificate fails.
#[derive(Clone, Debug)]
pub struct Uncertified {
    pub pose: PoseRequest,
    /// Index into [`crate::structure::Structure::motion`].
    pub group: usize,
    /// The figure h of Newton and Kantorovich.
    pub h: f64,
    /// The condition figure σ of the group.
    pub sigma: f64,
    /// The number of such positions.
    pub poses: usize,
}

/// Drive values between which a sweep does not close; absent at its ends.
#[derive(Clone, Debug, Default)]
pub struct Gap {
    /// The last values that close.
    pub from: Option<Vec<DriveValue>>,
    /// The first values that close again.
    pub to: Option<Vec<DriveValue>>,
}

/// How many positions of the sweep there are, and how many of them do not close.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Closing {
    /// The number of positions.
    pub swept: usize,
    /// How many of them do not close.
    pub open: usize,
    /// One of them has several assemblies.
    pub ambiguous: bool,
}

/// What loses digits near a dead position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loss {
    Velocities,
    Accelerations,
    Forces,
    /// Forces that friction multiplies.
    ForcesNearLocking,
}

/// The first position at which friction locks the mechanism.
#[derive(Clone, Debug)]
pub struct Locking {
    pub pose: PoseRequest,
    /// The number of others.
    pub more: usize,
    /// The pairs that lock, that with the greatest loss first; with the part of its friction below which the mechanism moves.
    pub pairs: Vec<(PairId, Option<f64>)>,
    /// The part of all friction below which it moves.
    pub part: f64,
    /// The efficiency; absent where no effort moves the mechanism.
    pub efficiency: Option<f64>,
    /// Values at which locking begins, by index into [`crate::model::Mechanism::criticals`].
    pub criticals: Vec<f64>,
}

/// A range of the swept drive, rad, at whose end all links are where they began.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WholeCycleRange {
    pub from: f64,
    pub to: f64,
    pub steps: usize,
}
