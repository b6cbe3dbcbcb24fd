//! One motion integrated again and again, to several accuracies and by several methods.

use super::compare::{Compared, KINDS};
use super::options::IntegrationOptions;
use super::precise::refine;
use super::report::SimulationReport;
use super::setup::{StartState, begin};
use super::trajectory::{Trajectory, trajectory};
use crate::answer::WholeCycle;
use crate::model::Simulation;
use crate::position::{DriveValue, Model};
use crate::solve::failure::{Cause, Failure};
use crate::solve::inputs::Rates;
use crate::solve::positions::Sweep;

/// The motion of a solved file, to be integrated again.
pub struct Trials<'a, 's> {
    model: &'s Model<'a>,
    statics: &'s WholeCycle,
    simulation: &'s Simulation,
    rates: Rates,
    first: Vec<DriveValue>,
    begin: StartState<'s>,
}

/// The motion as it comes out for one accuracy.
pub struct Trial(Trajectory);

impl Trial {
    /// What it says of itself.
    #[must_use]
    pub const fn report(&self) -> &SimulationReport {
        &self.0.report
    }

    /// How many instants are printed or named by an expectation.
    #[must_use]
    pub const fn instants(&self) -> usize {
        self.0.records.count
    }

    /// The greatest coordinate, rad or m: it is rounded to the digits of `f64`.
    #[must_use]
    pub fn greatest_coordinate(&self) -> f64 {
        let records = &self.0.records;
        let all = (0..records.count).flat_map(|i| &records.state(i)[..records.order]);
        all.fold(0.0, |most, q| most.max(q.abs()))
    }

    /// Why it ended early.
    #[must_use]
    pub const fn ended(&self) -> Option<&Failure> {
        self.0.ended.as_ref()
    }

    /// Whether it kept its accuracy, as far as it came.
    #[must_use]
    pub fn is_kept(&self) -> bool {
        let halt = |failure: &Failure| match &failure.cause {
            Cause::Halted { halt, .. } => halt.is_inaccurate(),
            _ => true,
        };
        !self.0.ended.as_ref().is_some_and(halt)
    }
}

impl<'a, 's> Trials<'a, 's> {
    /// Of a file that was solved: what needs no position is taken from its solution. `None` where it follows no motion.
    ///
    /// # Errors
    /// No assembly, or several, at the first instant.
    pub fn new(model: &'s Model<'a>, statics: &'s WholeCycle) -> Result<Option<Self>, Failure> {
        let Some(simulation) = &model.mechanism.simulation else { return Ok(None) };
        let rates = Rates::of(model, statics);
        let first = Sweep::of(model, statics).at(0).drives;
        let begin = begin(model, statics, &rates, (&first, None), simulation.from)?;
        Ok(Some(Self { model, statics, simulation, rates, first, begin }))
    }

    /// All runs that an answer within an accuracy takes.
    ///
    /// # Errors
    /// A start that cannot move.
    pub fn run(&self, within: f64, conduct: &IntegrationOptions<'_>) -> Result<Trial, Failure> {
        let simulation = Simulation { within: Some(within), ..self.simulation.clone() };
        trajectory(self.model, self.statics, &self.rates, &self.first, &simulation, conduct).map(Trial)
    }

    /// The same motion with twice the digits at the same instants; `None` where closed forms do not make all of it, in the
    /// coordinates written. Instants of events and functions over the run stay as they are.
    #[must_use]
    pub fn refined(&self, trial: &Trial) -> Option<Trial> {
        let mut found = trial.0.clone();
        let first = found.first.clone();
        let start = (&first[..], found.from, &self.begin.state);
        // where a steady motion begins is found in `f64`, and so is what a drive says of time
        let timed = self.model.mechanism.drives.iter().any(|drive| drive.of_time);
        let plain = !timed && found.report.steady.is_none();
        (found.records.is_as_written() && plain).then_some(())?;
        refine(self.model, start, &mut found.records).then_some(Trial(found))
    }

    /// What a trial differs by from another one that counts as exact, kind by kind as [`KINDS`] names them, relative to
    /// the greatest magnitude of the kind in the exact one.
    #[must_use]
    pub fn errors(&self, trial: &Trial, exact: &Trial) -> [f64; KINDS.len()] {
        let mut equations = self.begin.equations();
        let (trial, exact) = (trial.0.outcome(), exact.0.outcome());
        let found = Compared::of(&mut equations, trial, exact, exact.kinds);
        // instants that only one of them has
        let missing = found.error.is_infinite() && found.each.iter().all(|e| e.is_finite());
        if missing { [f64::INFINITY; KINDS.len()] } else { found.each }
    }
}
