//! What a motion under loads says of itself.

use crate::model::{DriveTarget, LoadId, Mechanism, PairId, Situation};

/// How the equations are integrated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// The pair of order 8(5,3) of Dormand and Prince, as Hairer, Nørsett and Wanner give it.
    #[default]
    Dop853,
    /// The kinetic energy from the work of forces that depend on the one coordinate alone, and time from it.
    Energy,
    /// Radau IIA of order 5, of Hairer and Wanner, from where the explicit method is held up by stability.
    Radau,
}

/// What a run says of itself.
#[derive(Clone, Debug, Default)]
pub struct SimulationReport {
    /// How it was integrated.
    pub method: Method,
    /// Why it does not follow from the energy, where that was looked at.
    pub why: Option<NotByEnergy>,
    /// Accepted steps of the finer run.
    pub steps: usize,
    /// Rejected steps of the finer run.
    pub rejected: usize,
    /// Evaluations of the equations in all runs.
    pub evaluations: usize,
    /// Those of the finer run, which is printed.
    pub printed: usize,
    /// The tolerance of the run that is printed.
    pub tolerance: f64,
    pub within: f64,
    /// The estimated error, the worst of all kinds, relative to the greatest of its kind.
    pub error: f64,
    /// The kind that has it.
    pub worst: &'static str,
    /// Energy, where no drive that is prescribed moves.
    pub energy: Option<Energy>,
    /// The least condition figure of a group, and its instant, s.
    pub worst_condition: (f64, f64),
    /// Free coordinates, by drive.
    pub coordinates: Vec<usize>,
    /// Instants of every event of the mechanism, s.
    pub events: Vec<Vec<f64>>,
    /// What holds at rest, from when to when, s.
    pub held: Vec<(Holder, f64, Option<f64>)>,
    /// What stopped at once since friction admitted no acceleration, and when, s.
    pub jammed: Vec<(Holder, f64)>,
    /// When other coordinates were taken, since a group came near a dead position of those before, s, and which: by drive.
    pub changes: Vec<(f64, Vec<DriveTarget>)>,
    /// When change points had been passed, s.
    pub crossed: Vec<f64>,
    /// When each stop of the mechanism is closed, and when it opens again, s.
    pub closed: Vec<Vec<(f64, Option<f64>)>>,
    /// How a steady motion was found.
    pub steady: Option<SteadyReport>,
    /// The event that ended the run.
    pub ended_by: Option<usize>,
    /// The last instant that was reached, s.
    pub end: f64,
}

impl SimulationReport {
    /// Two runs that differ by more of the greatest of a kind say nothing of the motion.
    pub const NOTHING: f64 = 1e-2;

    /// What the motion is in, and from when to when, s.
    pub(super) fn situations(&self, mechanism: &Mechanism) -> Vec<(Situation, f64, Option<f64>)> {
        let stops = mechanism.stops.iter().zip(&self.closed);
        let closed = stops.flat_map(|(stop, times)| {
            times.iter().map(|(begin, end)| (Situation::Rests(stop.pair), *begin, *end))
        });
        let held = self.held.iter().filter_map(|(holder, begin, end)| match holder {
            Holder::Pair(pair) => Some((Situation::Sticks(*pair), *begin, *end)),
            Holder::Load(_) => None,
        });
        closed.chain(held).collect()
    }
}

/// What keeps something from moving.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Holder {
    /// Friction in a pair, or the losses of a transmission.
    Pair(PairId),
    /// A load against the motion.
    Load(LoadId),
}

/// How a motion that comes again was found.
#[derive(Clone, Copy, Debug, Default)]
pub struct SteadyReport {
    /// After what time it comes again, s.
    pub period: f64,
    /// Periods that were followed to find it.
    pub trials: usize,
    /// The estimated error of the state at its begin, of the greatest of its kind.
    pub error: f64,
}

/// What becomes of energy.
#[derive(Clone, Copy, Debug, Default)]
pub struct Energy {
    /// Kinetic energy at the first instant, J.
    pub begin: f64,
    /// At the last, J.
    pub end: f64,
    /// Work of all loads, weights and springs between them, J.
    pub work: f64,
    /// What is missing at the worst instant, over the greatest energy exchanged.
    pub balance: f64,
}

/// Why a motion does not follow from the energy alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NotByEnergy {
    /// So many coordinates are free.
    Coordinates(usize),
    /// A drive moves, whatever the loads.
    Drive(DriveTarget),
    /// There is friction in a pair.
    Friction(PairId),
    /// A transmission loses power.
    Losses(PairId),
    /// A spring is damped, by its place among them.
    Damper(usize),
    /// A wheel is driven in steps.
    Geneva(PairId),
    /// A load depends on something else.
    Load(LoadId, On),
    /// A stop, by its place among them, is hit or rests.
    Stop(usize),
    /// Mass or force have no value so far ahead as its steps look.
    Beyond,
}

/// What a load depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum On {
    /// The sense of the motion.
    Sense,
    Time,
    /// Speeds, accelerations or forces.
    Speeds,
}
