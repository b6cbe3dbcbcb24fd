//! The motion from its first instant to its last, to the accuracy wanted.

use super::compare::{Compared, Kinds, Outcome};
use super::conduct::Conduct;
use super::coordinates::Charts;
use super::functions::OverRun;
use super::records::Records;
use super::report::SimulationReport;
use super::run::{Run, run};
use super::setup::{Begin, at_rest, begin, outputs, scales};
use super::steady::steady;
use crate::answer::{CycleAnswer, WholeCycle};
use crate::model::{Mechanism, Simulation, Steady};
use crate::position::{Branch, DriveInput, DriveValue, Model, State};
use crate::solve::failure::{Cause, Failure, Halt};
use crate::solve::inputs::Rates;
use crate::solve::note::Note;

/// The tolerance of the finer run over that of the coarser one.
const FINER: f64 = 0.1;
/// The tolerance of the first run over the wanted accuracy: errors of smooth motions are far below their tolerance.
const LOOSER: f64 = 10.0;
/// What two runs differ by is an estimate: so much of the accuracy it may take.
const SURE: f64 = 0.5;
/// Two runs may agree by chance: the error is not said to be less than this part of the finer one's tolerance, or of what its series
/// leave off.
const LEAST: f64 = 0.2;
/// A looser tolerance makes steps so long that what two runs differ by says nothing of their error.
const LOOSEST: f64 = 1e-5;
/// Below this relative tolerance the digits of the numbers end.
const FINEST: f64 = 2e-15;
/// Rounding is not said to grow more than by this condition.
const LEAST_CONDITION: f64 = 1e-3;
/// At this tolerance rounding may be greater than what the method leaves.
const ROUNDING: f64 = 1e-11;
/// Evaluations of all runs: no finer run is begun that would take more.
const MOST: usize = 12_000_000;
/// Where the coarser run misses the accuracy by more than this, the next pair starts anew.
const FAR: f64 = 30.0;

/// The free coordinates at every instant that is wanted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Trajectory {
    /// The free coordinates at every instant, in order of time.
    pub records: Records,
    /// How many printed instants were handed out.
    pub handed_out: usize,
    /// Functions over the run.
    pub functions: Vec<OverRun>,
    /// The greatest magnitudes of each kind.
    pub kinds: Kinds,
    /// What the run says of itself.
    pub report: SimulationReport,
    /// What every drive says at the first instant.
    pub first: Vec<DriveInput>,
    /// The first instant, s.
    pub from: f64,
    /// The assembly at the first instant.
    pub start: State,
    /// How its groups stand there.
    pub assemblies: Vec<Branch>,
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

    /// What it has found.
    pub fn outcome(&self) -> Outcome<'_> {
        let halt = self.ended.as_ref().map(|failure| &failure.cause);
        Outcome {
            records: &self.records,
            events: &self.report.events,
            functions: &self.functions,
            kinds: &self.kinds,
            opens: match halt {
                Some(Cause::Halted { time, halt: Halt::Opens { .. } }) => Some(*time),
                _ => None,
            },
            halted: halt
                .is_some_and(|cause| !matches!(cause, Cause::Halted { halt, .. } if halt.is_inaccurate())),
            end: self.report.end,
        }
    }

    /// Puts what the run has found beside its instants to what needs no position.
    pub fn tell(&self, mechanism: &Mechanism, statics: &mut WholeCycle) {
        statics.events.clone_from(&self.report.events);
        statics.period = self.report.steady.map(|steady| steady.period);
        statics.situations = self.report.situations(mechanism);
        let answer = |&OverRun { value, scale, at }: &OverRun| CycleAnswer {
            value,
            scale,
            at,
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
    conduct: &Conduct<'_>,
) -> Result<Trajectory, Failure> {
    let mut begin = begin(model, statics, rates, first, simulation.from)?;
    let at_rest = at_rest(model);
    let still = at_rest.as_ref().map(|(mechanism, plan)| Model { mechanism, plan, ..*model });
    begin.still = still.as_ref();
    let steady = match simulation.steady {
        Some(after) => {
            let found = steady(&begin, simulation, after);
            let found = found.map_err(|(time, halt)| Cause::Halted { time, halt })?;
            (begin.state, begin.angles) = (found.state, found.angles);
            begin.first = found.first;
            Some(found.report)
        }
        None => None,
    };
    let to = steady.map_or(simulation.to, |found| simulation.from + found.period);
    let simulation = &Simulation { to, ..simulation.clone() };
    let mut outputs = outputs(model.mechanism, simulation);
    outputs.conduct = *conduct;
    if let Some(Steady::Cycle(event)) = simulation.steady {
        outputs.guard = Some((event, f64::INFINITY));
    }
    let mut charts = Charts::new(model, statics);
    let mut run =
        |tolerance, measures| run(&begin, &mut charts, tolerance, &outputs, simulation.to, measures);
    let within = simulation.within.unwrap_or(Simulation::WITHIN);
    let mut tolerance = conduct.alone.unwrap_or((LOOSER * within).min(LOOSEST));
    let mut best = Compared::UNKNOWN;
    let mut coarse = run(tolerance, true);
    let mut spent = coarse.counts.evaluations;
    let scales = scales(&begin.equations());
    let (printed, kinds, compared) = loop {
        let ended = matches!(coarse.stopped, Some((_, Halt::TooManySteps | Halt::Interrupted)));
        if ended || conduct.alone.is_some() {
            // a finer run takes more
            break (coarse, Kinds::default(), Compared { error: 1.0, ..Compared::UNKNOWN });
        }
        if spent + coarse.counts.evaluations > MOST {
            let compared = at_most_all(best);
            let kinds = coarse.kinds.clone();
            break (missed(coarse, within, &compared), kinds, compared);
        }
        let fine = run(tolerance * FINER, false);
        spent += fine.counts.evaluations;
        let mut compared =
            Compared::of(&mut begin.equations(), coarse.outcome(), fine.outcome(), &coarse.kinds);
        if let Some(found) = &steady {
            compared.steady(found.error);
        }
        compared.error = compared.error.max(LEAST * fine.floor).max(rounding(&fine, &scales));
        let interrupted = matches!(fine.stopped, Some((_, Halt::Interrupted)));
        if compared.error <= SURE * within || interrupted {
            break (fine, coarse.kinds, compared);
        }
        if tolerance <= ROUNDING && compared.error >= best.error {
            // a finer tolerance does not help: rounding is what is left, and the run before has less of it
            let kinds = coarse.kinds.clone();
            break (missed(coarse, within, &best), kinds, best);
        }
        if tolerance * FINER <= FINEST {
            break (missed(fine, within, &compared), coarse.kinds, compared);
        }
        if spent + fine.counts.evaluations > MOST {
            let compared = at_most_all(compared);
            break (missed(fine, within, &compared), coarse.kinds, compared);
        }
        let away = compared.error / within;
        if away > FAR {
            // of runs that do not agree at all nothing is known
            let factor = if away.is_finite() { away } else { 1.0 / (FINER * FINER) };
            tolerance = (tolerance / factor).max(FINEST / FINER);
            best = Compared::UNKNOWN;
            coarse = run(tolerance, true);
            spent += coarse.counts.evaluations;
        } else {
            tolerance *= FINER;
            best = compared;
            let kinds = coarse.kinds;
            coarse = Run { kinds, ..fine };
        }
    };
    let report = report(model.mechanism, within, spent, &compared, &printed);
    let report = SimulationReport { steady, ..report };
    Ok(ended(printed, kinds, report, begin))
}

/// Where two runs do not agree at all, or there is one alone: all of what there is.
fn at_most_all(compared: Compared) -> Compared {
    Compared { error: compared.error.min(1.0), ..compared }
}

/// What rounding makes of a run at least: that of the greatest coordinate adds up as a random walk, and grows near dead positions.
/// `scales` are what is much for each coordinate.
#[allow(clippy::cast_precision_loss)] // far below 2^52
fn rounding(run: &Run, scales: &[f64]) -> f64 {
    let kept = (0..run.records.count).flat_map(|index| run.records.state(index).iter().zip(scales));
    let greatest = kept.map(|(q, scale)| q.abs() / scale).fold(1.0, f64::max);
    let steps = (run.counts.steps as f64).sqrt();
    f64::EPSILON * greatest * steps / run.worst_condition.0.max(LEAST_CONDITION)
}

/// A run that is not as accurate as is wanted, if it is not.
fn missed(run: Run, within: f64, compared: &Compared) -> Run {
    let halt = Halt::Accuracy { wanted: within, reached: compared.error };
    let missed = (compared.error > within).then_some((run.end, halt));
    Run { stopped: run.stopped.or(missed), ..run }
}

/// What a run has found, with what its drives say at the first instant, s, and its assembly there.
fn ended(
    run: Run,
    kinds: Kinds,
    report: SimulationReport,
    Begin { first, from, state: start, .. }: Begin<'_>,
) -> Trajectory {
    let ended = run.stopped.map(|(time, halt)| Cause::Halted { time, halt }.into());
    let (records, functions) = (run.records, run.functions);
    let assemblies = start.branches.clone();
    Trajectory { records, handed_out: 0, functions, kinds, report, first, from, start, assemblies, ended }
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
        evaluations: spent,
        printed: fine.counts.evaluations,
        tolerance: fine.tolerance,
        within,
        error: compared.error,
        worst: compared.worst,
        energy: mechanism.drives.iter().all(still).then_some(fine.energy),
        worst_condition: fine.worst_condition,
        coordinates: free.map(|(i, _)| i).collect(),
        events: fine.events.clone(),
        rests: fine.rests.clone(),
        held: fine.held.clone(),
        changes: fine.changes.clone(),
        crossed: fine.crossed.clone(),
        closed: fine.closed.clone(),
        steady: None,
        ended_by: fine.ended_by,
        end: fine.end,
    }
}
