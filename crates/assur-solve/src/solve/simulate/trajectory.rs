//! The motion from its first instant to its last, to the accuracy wanted.

use super::compare::Compared;
use super::equations::Equations;
use super::report::{Method, SimulationReport};
use super::run::{Records, Run, run};
use super::setup::{Output, assembled, outputs};
use crate::answer::WholeCycle;
use crate::model::{Mechanism, Simulation};
use crate::position::{DriveInput, DriveValue, Model, State};
use crate::solve::failure::{Cause, Failure, Halt};
use crate::solve::inputs::Rates;

/// The tolerance of the finer run over that of the coarser one.
const FINER: f64 = 0.1;
/// Below this relative tolerance the digits of the numbers end.
const FINEST: f64 = 2e-15;
/// Where the coarser run misses the accuracy by more than this, the next pair starts anew.
const FAR: f64 = 30.0;

/// The free coordinates at every instant that is wanted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Trajectory {
    /// The instants, in order of time.
    pub outputs: Vec<Output>,
    /// Drive values, rates and accelerations at each, and where the bodies stand.
    pub records: Records,
    /// What the run says of itself.
    pub report: SimulationReport,
    /// What every drive says at the first instant.
    pub first: Vec<DriveInput>,
    /// The first instant, s.
    pub from: f64,
    /// The assembly at the first instant.
    pub start: State,
    /// Why it ends before the last instant.
    pub ended: Option<Failure>,
}

/// Finds the trajectory of a file that follows a motion.
///
/// # Errors
/// No assembly, or several, at the first instant; a start that cannot move.
pub(crate) fn trajectory(
    model: &Model<'_>,
    statics: &WholeCycle,
    rates: &Rates,
    first: &[DriveValue],
    simulation: &Simulation,
) -> Result<Trajectory, Failure> {
    let outputs = outputs(model.mechanism, simulation);
    let times: Vec<f64> = outputs.iter().map(|output| output.time).collect();
    let (state, angles) = assembled(model, rates, first)?;
    let equations =
        |state: &State| Equations::new(model, statics, rates, first, simulation.from, (state, &angles));
    let within = simulation.within.unwrap_or(Simulation::WITHIN);
    let mut tolerance = within;
    let mut spent = 0;
    let mut coarse = run(&mut equations(&state), tolerance, &times);
    loop {
        let mut fine = run(&mut equations(&state), tolerance * FINER, &times);
        spent += coarse.counts.evaluations;
        let compared = Compared::of(&mut equations(&state), &coarse.records, &fine.records);
        let out_of_reach = tolerance * FINER <= FINEST;
        if compared.error <= within || out_of_reach {
            let ended = fine.stopped.take().or_else(|| {
                let halt = Halt::Accuracy { wanted: within, reached: compared.error };
                (compared.error > within).then(|| (times.last().copied().unwrap_or_default(), halt))
            });
            let report = report(model.mechanism, within, spent, &compared, &fine);
            let ended = ended.map(|(time, halt)| Cause::Halted { time, halt }.into());
            let first = equations(&state).first;
            let (records, from) = (fine.records, simulation.from);
            return Ok(Trajectory { outputs, records, report, first, from, start: state, ended });
        }
        let missed = compared.error / within;
        if missed > FAR {
            tolerance = (tolerance / missed).max(FINEST / FINER);
            spent += fine.counts.evaluations;
            coarse = run(&mut equations(&state), tolerance, &times);
        } else {
            tolerance *= FINER;
            coarse = fine;
        }
    }
}

fn report(
    mechanism: &Mechanism,
    within: f64,
    spent: usize,
    compared: &Compared,
    fine: &Run,
) -> SimulationReport {
    let still = |d: &crate::model::Drive| d.free || (d.speed.is_none() && d.acceleration.is_none());
    let free = mechanism.drives.iter().enumerate().filter(|(_, d)| d.free);
    SimulationReport {
        method: Method::Dop853,
        steps: fine.counts.steps,
        rejected: fine.counts.rejected,
        evaluations: spent + fine.counts.evaluations,
        within,
        error: compared.error,
        worst: compared.worst,
        energy: mechanism.drives.iter().all(still).then_some(fine.energy),
        worst_condition: fine.worst_condition,
        coordinates: free.map(|(i, _)| i).collect(),
        end: fine.end,
    }
}
