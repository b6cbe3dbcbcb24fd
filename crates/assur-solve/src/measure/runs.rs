//! What accuracy costs in a motion under loads: the accuracy wanted against the error that is left, the error that is
//! reported, evaluations and time, for every method.
//!
//! An error is the difference from the same motion with twice the digits, or, where closed forms do not make all of it, at
//! the finest tolerances in other steps than those measured.

use super::choice::Choice;
use super::clock::{Clock, micros};
use super::price::Price;
use crate::model::Simulation;
use crate::position::Model;
use crate::solve::{Failure, IntegrationOptions, KINDS, Method, STATES, Solution, Trial, Trials};
use std::hint::black_box;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};

/// The coarsest accuracy and the finest, as powers of ten.
const COARSEST: i32 = -3;
const FINEST: i32 = -13;
/// The accuracies of which the reference has one, the best is the one that says so; and steps at least, others than those of any
/// run that is measured, and of each other.
const REFERENCES: [(f64, f64); 3] = [(1e-14, 333.0), (1e-13, 347.0), (1e-12, 361.0)];
/// An accuracy that takes more steps in one run is left out, and the finer ones.
const MOST: usize = 100_000;
/// The fastest of so many times.
const REPEATS: usize = 3;
/// A run that takes so long, s, is not repeated for its time.
const LONG: f64 = 0.1;

/// What accuracy costs in a motion.
#[derive(Clone, Debug)]
pub struct RunStudy {
    /// How many instants are compared.
    pub instants: usize,
    /// The last instant that was reached, s.
    pub end: f64,
    /// What kinds of results were compared.
    pub kinds: [&'static str; KINDS.len()],
    /// The error of the reference: in `f64` what it reports, or differs by from the next best run.
    pub floor: f64,
    /// The reference has twice the digits.
    pub precise: bool,
    /// The method of the best run in `f64`.
    pub reference: Method,
    /// Every method with its accuracies.
    pub methods: Vec<MethodStudy>,
    /// The accuracy that the file asks for.
    pub asked: f64,
    /// The error that is wanted.
    pub wanted: f64,
    /// What to ask for to keep it.
    pub recommendation: Option<Choice>,
}

#[derive(Clone, Debug)]
pub struct MethodStudy {
    /// The method that does all of it; else the solver's own choice.
    pub asked: Option<Method>,
    /// The method that does the end of the motion.
    pub method: Method,
    /// From coarse to fine.
    pub rows: Vec<RunRow>,
    /// Its finer accuracies take too many steps.
    pub cut: bool,
    /// What its evaluations take.
    pub price: Price,
}

#[derive(Clone, Debug)]
pub struct RunRow {
    /// The loosest accuracy that has this run.
    pub within: f64,
    pub finest: f64,
    /// Accepted steps of the run that is printed.
    pub steps: usize,
    pub rejected: usize,
    /// Evaluations of the run that is printed.
    pub printed: usize,
    /// Evaluations of all runs.
    pub evaluations: usize,
    /// Microseconds of all runs, the estimate of the error among them, by the [price](MethodStudy::price) of its evaluations.
    pub micros: f64,
    /// What the clock said of them.
    pub measured: f64,
    pub error: f64,
    /// The error of each kind.
    pub each: [f64; KINDS.len()],
    /// The error that is reported.
    pub reported: f64,
    /// The error is no greater than that of the reference.
    pub is_floor: bool,
    /// It says that it does not keep the accuracy.
    pub missed: bool,
}

/// Measures a solved file; `None` where it follows no motion.
///
/// # Errors
/// The motion does not begin.
pub fn study_runs(
    model: &Model<'_>,
    solution: &Solution,
    wanted: Option<f64>,
    clock: Clock,
    conduct: &IntegrationOptions<'_>,
) -> Result<Option<RunStudy>, Failure> {
    let asked = model.mechanism.simulation.as_ref().and_then(|s| s.within).unwrap_or(Simulation::WITHIN);
    let Some(trials) = Trials::new(model, &solution.statics)? else { return Ok(None) };
    let Some(exact) = reference(&trials, conduct)? else { return Ok(None) };
    let within = &accuracies(asked);
    let mut methods = Vec::new();
    for method in [None, Some(Method::Dop853), Some(Method::Radau)] {
        // by the solver's own choice it may be done already
        let own = methods.first().map(|own: &MethodStudy| own.method);
        if method != Some(Method::Dop853) || own == Some(Method::Energy) {
            methods.push(measured(&trials, &exact, (method, within, conduct), clock)?);
        }
    }
    let report = exact.trial.report();
    let mut study = RunStudy {
        instants: exact.trial.instants(),
        end: report.end,
        kinds: KINDS,
        floor: exact.floor,
        precise: exact.precise,
        reference: report.method,
        methods,
        asked,
        wanted: wanted.unwrap_or(asked),
        recommendation: None,
    };
    study.recommendation = study.recommended();
    Ok(Some(study))
}

/// The motion that counts as exact.
struct Exact {
    trial: Trial,
    floor: f64,
    /// It has twice the digits.
    precise: bool,
}

/// The motion that counts as exact: of several runs by both methods the one that reports the least error, where that can be with
/// twice the digits at its instants.
fn reference(trials: &Trials<'_, '_>, conduct: &IntegrationOptions<'_>) -> Result<Option<Exact>, Failure> {
    let mut all = Vec::new();
    for method in [None, Some(Method::Radau)] {
        for (within, steps) in REFERENCES {
            all.extend(bounded(trials, within, IntegrationOptions { method, steps, ..*conduct })?);
        }
    }
    all.sort_by(|a: &Trial, b| a.report().error.total_cmp(&b.report().error));
    let mut all = all.into_iter();
    let Some(best) = all.next() else { return Ok(None) };
    let apart = all.next().map_or([0.0; KINDS.len()], |next| trials.errors(&next, &best));
    Ok(Some(match trials.refined(&best) {
        Some(trial) => {
            // its coordinates are handed on in `f64`; events and functions over the run are those of the best run
            let rounding = f64::EPSILON * trial.greatest_coordinate().max(1.0);
            Exact { floor: rounding.max(greatest(&apart[STATES..])), trial, precise: true }
        }
        None => Exact { floor: best.report().error.max(greatest(&apart)), trial: best, precise: false },
    }))
}

/// A trial that does not take too many steps.
pub(super) fn bounded(
    trials: &Trials<'_, '_>,
    within: f64,
    conduct: IntegrationOptions<'_>,
) -> Result<Option<Trial>, Failure> {
    let (steps, reached) = (AtomicUsize::new(0), AtomicU64::new(0));
    let few = |time: f64, last: f64| {
        let before = f64::from_bits(reached.swap(time.to_bits(), Ordering::Relaxed));
        if time < before {
            // a run begins anew
            steps.store(0, Ordering::Relaxed);
        }
        conduct.goes_on(time, last) && steps.fetch_add(1, Ordering::Relaxed) < MOST
    };
    let trial = trials.run(within, &IntegrationOptions { watch: Some(&few), ..conduct })?;
    Ok((steps.into_inner() <= MOST).then_some(trial))
}

fn greatest(errors: &[f64]) -> f64 {
    errors.iter().fold(0.0, |most, error| most.max(*error))
}

/// The accuracies that are tried, from coarse to fine: the file's own among them.
fn accuracies(asked: f64) -> Vec<f64> {
    let mut all: Vec<f64> = (FINEST..=COARSEST).map(|power| libm::pow(10.0, f64::from(power))).collect();
    if all.iter().all(|within| (within / asked - 1.0).abs() > 1e-3) {
        all.push(asked);
    }
    all.sort_by(|a, b| b.total_cmp(a));
    all
}

/// One method to all accuracies.
fn measured(
    trials: &Trials<'_, '_>,
    exact: &Exact,
    (asked, all, conduct): (Option<Method>, &[f64], &IntegrationOptions<'_>),
    clock: Clock,
) -> Result<MethodStudy, Failure> {
    let conduct = IntegrationOptions { method: asked, ..*conduct };
    let alone = IntegrationOptions { watch: None, ..conduct };
    let (method, rows, price) = (Method::default(), Vec::new(), Price::default());
    let mut study = MethodStudy { asked, method, rows, cut: false, price };
    let mut last = None;
    for &within in all {
        let begun = clock();
        let Some(trial) = bounded(trials, within, conduct)? else {
            study.cut = true;
            break;
        };
        let first = clock() - begun;
        let report = trial.report();
        study.method = report.method;
        // a looser accuracy may have been kept so well that this one is the same run
        let same = last.replace((report.steps, report.printed)) == Some((report.steps, report.printed));
        if let (true, true, Some(row)) = (same, trial.is_kept(), study.rows.last_mut()) {
            row.finest = within;
            continue;
        }
        let each = trials.errors(&trial, &exact.trial);
        let error = greatest(&each);
        let time = |_| micros(clock, || drop(black_box(trials.run(within, &alone))));
        let repeats = if first > LONG { 0 } else { REPEATS };
        let measured = (0..repeats).map(time).fold(first * 1e6, f64::min);
        study.rows.push(RunRow {
            within,
            finest: within,
            steps: report.steps,
            rejected: report.rejected,
            printed: report.printed,
            evaluations: report.evaluations,
            micros: measured,
            measured,
            error: error.max(exact.floor),
            each,
            reported: report.error,
            is_floor: error <= exact.floor,
            missed: !trial.is_kept(),
        });
    }
    study.price = Price::of(study.rows.iter().map(|row| (row.evaluations, row.measured)));
    study.rows.iter_mut().for_each(|row| row.micros = study.price.time(row.evaluations));
    Ok(study)
}
