//! The motion from its first instant to its last, to the accuracy wanted.

use super::compare::Compared;
use super::equations::Equations;
use super::records::Records;
use super::report::SimulationReport;
use super::run::{Run, run};
use super::setup::{assembled, outputs};
use crate::answer::{CycleAnswer, WholeCycle};
use crate::model::{Mechanism, Simulation};
use crate::position::{DriveInput, DriveValue, Model, State};
use crate::solve::failure::{Cause, Failure, Halt};
use crate::solve::inputs::Rates;
use crate::solve::note::Note;

/// The tolerance of the finer run over that of the coarser one.
const FINER: f64 = 0.1;
/// The tolerance of the first run over the wanted accuracy: errors of smooth motions are far below their tolerance.
const LOOSER: f64 = 10.0;
/// What two runs differ by is an estimate: so much of the accuracy it may take.
const SURE: f64 = 0.5;
/// Two runs may agree by chance: the error is not said to be less than this part of the finer one's tolerance.
const LEAST: f64 = 0.2;
/// A looser tolerance makes steps so long that what two runs differ by says nothing of their error.
const LOOSEST: f64 = 1e-5;
/// Below this relative tolerance the digits of the numbers end.
const FINEST: f64 = 2e-15;
/// Where the coarser run misses the accuracy by more than this, the next pair starts anew.
const FAR: f64 = 30.0;

/// The free coordinates at every instant that is wanted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Trajectory {
    /// The free coordinates at every instant, in order of time.
    pub records: Records,
    /// How many printed instants were handed out.
    pub handed_out: usize,
    /// Functions over the run, each with the greatest magnitude in play.
    pub functions: Vec<(f64, f64)>,
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

impl Trajectory {
    /// The ends that the run did not come to, where it came to none.
    pub fn never_ended(&self, mechanism: &Mechanism) -> Vec<Note> {
        let open = self.ended.is_none() && self.report.ended_by.is_none();
        let ends = mechanism.events.iter().enumerate().filter(|(_, event)| open && event.ends);
        ends.map(|(event, _)| Note::NeverEnded { event, time: self.report.end }).collect()
    }

    /// Puts what the run has found beside its instants to what needs no position.
    pub fn tell(&self, statics: &mut WholeCycle) {
        statics.events.clone_from(&self.report.events);
        let answer = |&(value, scale): &(f64, f64)| CycleAnswer {
            value,
            scale,
            error: self.report.error * scale,
            samples: self.report.evaluations,
            ..CycleAnswer::default()
        };
        statics.cycles = self.functions.iter().map(answer).collect();
    }
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
    let span = (simulation.from, simulation.to);
    let (state, angles) = assembled(model, rates, first)?;
    let equations =
        |state: &State| Equations::new(model, statics, rates, first, simulation.from, (state, &angles));
    let within = simulation.within.unwrap_or(Simulation::WITHIN);
    let mut tolerance = (LOOSER * within).min(LOOSEST);
    let mut spent = 0;
    let mut coarse = run(&mut equations(&state), tolerance, &outputs, span, true);
    loop {
        if matches!(coarse.stopped, Some((_, Halt::TooManySteps))) {
            // a finer run takes more
            let compared = Compared { error: 1.0, worst: "positions" };
            let report = report(model.mechanism, within, spent, &compared, &coarse);
            return Ok(ended(coarse, report, (equations(&state).first, simulation.from, state)));
        }
        let mut fine = run(&mut equations(&state), tolerance * FINER, &outputs, span, false);
        spent += coarse.counts.evaluations;
        let mut compared = Compared::of(&mut equations(&state), &coarse, &fine);
        compared.error = compared.error.max(LEAST * FINER * tolerance);
        let out_of_reach = tolerance * FINER <= FINEST;
        if compared.error <= SURE * within || out_of_reach {
            let halt = Halt::Accuracy { wanted: within, reached: compared.error };
            let missed = (compared.error > within).then_some((fine.end, halt));
            fine.stopped = fine.stopped.or(missed);
            let report = report(model.mechanism, within, spent, &compared, &fine);
            return Ok(ended(fine, report, (equations(&state).first, simulation.from, state)));
        }
        let missed = compared.error / within;
        if missed > FAR {
            // of runs that do not agree at all nothing is known
            let factor = if missed.is_finite() { missed } else { 1.0 / (FINER * FINER) };
            tolerance = (tolerance / factor).max(FINEST / FINER);
            spent += fine.counts.evaluations;
            coarse = run(&mut equations(&state), tolerance, &outputs, span, true);
        } else {
            tolerance *= FINER;
            let kinds = coarse.kinds;
            coarse = Run { kinds, ..fine };
        }
    }
}

/// What a run has found, with what its drives say at the first instant, s, and its assembly there.
fn ended(
    run: Run,
    report: SimulationReport,
    (first, from, start): (Vec<DriveInput>, f64, State),
) -> Trajectory {
    let ended = run.stopped.map(|(time, halt)| Cause::Halted { time, halt }.into());
    let (records, functions) = (run.records, run.functions);
    Trajectory { records, handed_out: 0, functions, report, first, from, start, ended }
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
        method: fine.method,
        steps: fine.counts.steps,
        rejected: fine.counts.rejected,
        evaluations: spent + fine.counts.evaluations,
        within,
        error: compared.error,
        worst: compared.worst,
        energy: mechanism.drives.iter().all(still).then_some(fine.energy),
        worst_condition: fine.worst_condition,
        coordinates: free.map(|(i, _)| i).collect(),
        events: fine.events.clone(),
        rests: fine.rests.clone(),
        ended_by: fine.ended_by,
        end: fine.end,
    }
}
