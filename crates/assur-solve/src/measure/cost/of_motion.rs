//! What a motion under loads costs, and what is looked at in it.

use crate::answer::WholeCycle;
use crate::measure::clock::Clock;
use crate::model::Simulation;
use crate::position::Model;
use crate::solve::{IntegrationOptions, SimulationReport, Trials};

/// A run that takes longer is not repeated, s.
const LONG: f64 = 20e-3;
const REPEATS: usize = 5;

/// What a motion took.
#[derive(Clone, Debug)]
pub struct MotionCost {
    /// What it says of itself.
    pub report: SimulationReport,
    /// All runs, s.
    pub time: f64,
    /// The part of the run that is printed which goes for functions and for events that change nothing, where there are any.
    pub watched: Option<f64>,
}

/// Follows the motion of a file; `None` where there is none, or it does not begin.
pub(super) fn of_motion(model: &Model<'_>, statics: &WholeCycle, clock: Clock) -> Option<MotionCost> {
    let mechanism = model.mechanism;
    let within = mechanism.simulation.as_ref()?.within.unwrap_or(Simulation::WITHIN);
    let trials = Trials::new(model, statics).ok()??;
    let once = |conduct: &IntegrationOptions<'_>| {
        let start = clock();
        let trial = trials.run(within, conduct).ok()?;
        Some((clock() - start, trial.report().clone()))
    };
    let (time, report) = once(&IntegrationOptions::default())?;
    let looks = !mechanism.cycles.is_empty() || mechanism.events.iter().any(|event| !event.ends);
    let least = |bare: bool| {
        let conduct =
            IntegrationOptions { alone: Some(report.tolerance), bare, ..IntegrationOptions::default() };
        let times = if time > LONG { 1 } else { REPEATS };
        (0..times).filter_map(|_| Some(once(&conduct)?.0)).reduce(f64::min)
    };
    let watched = if looks { least(false).zip(least(true)) } else { None };
    let watched = watched.map(|(all, bare)| (1.0 - bare / all).max(0.0));
    Some(MotionCost { report, time, watched })
}
