//! The motion from its first instant to its last, to the accuracy wanted.

use super::compare::{Compared, Kinds, Outcome};
use super::coordinates::Charts;
use super::estimate::estimate;
use super::functions::OverRun;
use super::options::IntegrationOptions;
use super::pass::Pass;
use super::records::Records;
use super::refining::{Found, until_kept};
use super::report::SimulationReport;
use super::run::{Run, run};
use super::setup::{StartState, at_rest, begin, outputs, scales};
use super::starting;
use super::steady::steady;
use crate::answer::{CycleAnswer, Undefined, WholeCycle};
use crate::math::lobatto::Short;
use crate::model::{Mechanism, Simulation, Steady};
use crate::position::{Branch, DriveInput, DriveValue, Model, State};
use crate::solve::failure::{Cause, Failure, Halt};
use crate::solve::inputs::Rates;
use crate::solve::note::Note;

/// The free coordinates at every instant that is wanted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Trajectory {
    /// The free coordinates at every instant, in order of time.
    pub records: Records,
    /// How many printed instants were handed out.
    pub handed_out: usize,
    /// Functions over the run.
    pub functions: Vec<OverRun>,
    /// Their series, where they are drawn.
    pub courses: Vec<Vec<Short>>,
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
        ends.map(|(event, _)| Note::NeverEnded { event, at: self.report.end }).collect()
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
    pub fn report_to(&self, mechanism: &Mechanism, statics: &mut WholeCycle) {
        statics.events.clone_from(&self.report.events);
        statics.sizes.clone_from(&self.kinds.sizes);
        statics.period = self.report.steady.map(|steady| steady.period);
        statics.situations = self.report.situations(mechanism);
        let answer = |&OverRun { value, scale, at, lost, .. }: &OverRun| CycleAnswer {
            why: lost.map(Undefined::Then),
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
    conduct: &IntegrationOptions<'_>,
) -> Result<Trajectory, Failure> {
    let known = conduct.drawn.and_then(|drawn| drawn.start);
    let mut begin = begin(model, statics, rates, (first, known), simulation.from)?;
    let at_rest = at_rest(model);
    let still = at_rest.as_ref().map(|(mechanism, plan)| Model { mechanism, plan, ..*model });
    begin.still = still.as_ref();
    let mut charts = Charts::new(model, statics);
    let halted = |halt| Cause::Halted { time: simulation.from, halt };
    starting::check_dead_position(&begin, &mut charts).map_err(halted)?;
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
    let run = |pass: Pass<'_>| run(&begin, &mut charts, pass, &outputs, simulation.to);
    let within = simulation.within.unwrap_or(Simulation::WITHIN);
    let scales = scales(&begin.equations());
    let conserved = is_conserved(model.mechanism);
    let mut least = f64::INFINITY;
    let compare = |(coarse, fine): (&Run, &Run), kinds: &Kinds| {
        let difference = Compared::of(&mut begin.equations(), coarse.outcome(), fine.outcome(), kinds);
        let mut compared = estimate(difference, (coarse, fine), &mut least, &scales, conserved);
        if let Some(found) = &steady {
            compared.steady(found.error);
        }
        compared
    };
    let (found, spent) = until_kept(run, compare, within, conduct.alone);
    let Found { run: printed, kinds, compared } = found;
    let report = report(model.mechanism, within, spent, &compared, &printed);
    let report = SimulationReport { steady, ..report };
    Ok(ended(printed, kinds, report, begin))
}

/// Whether no drive that is prescribed moves: then all energy is that of loads.
fn is_conserved(mechanism: &Mechanism) -> bool {
    mechanism.drives.iter().all(|d| d.free || (d.speed.is_none() && d.acceleration.is_none()))
}

/// What a run has found, with what its drives say at the first instant, s, and its assembly there.
fn ended(
    run: Run,
    kinds: Kinds,
    report: SimulationReport,
    StartState { first, from, state: start, .. }: StartState<'_>,
) -> Trajectory {
    let ended = run.stopped.map(|(time, halt)| Cause::Halted { time, halt }.into());
    let (records, functions, courses) = (run.records, run.functions, run.courses);
    let assemblies = start.branches.clone();
    Trajectory {
        records,
        handed_out: 0,
        functions,
        courses,
        kinds,
        report,
        first,
        from,
        start,
        assemblies,
        ended,
    }
}

fn report(
    mechanism: &Mechanism,
    within: f64,
    spent: usize,
    compared: &Compared,
    fine: &Run,
) -> SimulationReport {
    let free = mechanism.drives.iter().enumerate().filter(|(_, d)| d.free);
    SimulationReport {
        method: fine.method,
        why: fine.why,
        steps: fine.counts.steps,
        rejected: fine.counts.rejected,
        evaluations: spent,
        printed: fine.counts.evaluations,
        tolerance: fine.tolerance,
        within,
        error: compared.error,
        worst: compared.worst,
        energy: is_conserved(mechanism).then_some(fine.energy),
        worst_condition: fine.worst_condition,
        coordinates: free.map(|(i, _)| i).collect(),
        events: fine.events.clone(),
        held: fine.held.clone(),
        jammed: fine.jammed.clone(),
        changes: fine.changes.clone(),
        crossed: fine.crossed.clone(),
        closed: fine.closed.clone(),
        steady: None,
        ended_by: fine.ended_by,
        end: fine.end,
    }
}
