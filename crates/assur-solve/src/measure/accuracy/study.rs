//! Every kind of setting of one problem, measured.

use super::answer::{Answer, Source};
use super::choice::{PositionChoice, choices, recommended};
use super::error::{errors, scales};
use super::setting::{Kind, NotApplicable, Row, Setting, not_closed};
use super::{Error, Scales};
use crate::math::Double;
use crate::measure::clock::{Clock, micros};
use crate::measure::cost::costs;
use crate::measure::price::Price;
use crate::plan::{Plan, Settings};
use crate::solve::{DriveInput, Edge, Model, Replay, Solution, State, WholeCycle, over_cycle};
use std::hint::black_box;

/// The most positions that are solved again.
const MOST: usize = 360;
/// ε of double-double.
const DOUBLE: f64 = 4.0 * f64::EPSILON * f64::EPSILON;

/// What accuracy costs in one problem.
#[derive(Clone, Debug)]
pub struct AccuracyStudy {
    /// Positions that were solved again.
    pub positions: usize,
    /// Positions of the file.
    pub count: usize,
    /// What answers are held against.
    pub source: Source,
    /// Its own error, estimated.
    pub floor: f64,
    /// What errors are relative to.
    pub scales: Scales,
    /// Errors of the solver as it stands, kind by kind.
    pub full: Error,
    /// What can be set.
    pub knobs: Vec<Setting>,
    pub absent: Vec<NotApplicable>,
    /// Microseconds per position of each effect on top of those before it.
    pub effects: Vec<(&'static str, f64)>,
    /// What a sample of the functions over the sweep takes.
    pub sample: Price,
    /// What can be asked for: the file as it is first.
    pub choices: Vec<PositionChoice>,
    /// The error that is wanted.
    pub wanted: f64,
    /// What to ask for to keep it.
    pub recommendation: Option<usize>,
}

/// The positions of a problem with the reference.
pub(super) struct Measured<'a, 's> {
    pub(super) model: &'s Model<'a>,
    pub(super) again: Replay<'a>,
    pub(super) inputs: Vec<DriveInput>,
    pub(super) exact: Vec<Answer>,
    pub(super) scales: Scales,
    pub(super) clock: Clock,
}

/// Measures a solved file.
#[must_use]
pub fn study<'a>(model: &Model<'a>, solution: &'a Solution, wanted: f64, clock: Clock) -> AccuracyStudy {
    let mut again = Replay::new(model, solution, MOST);
    let mut source = Source::DoubleDouble;
    let (mut exact, mut off) = (Vec::new(), 0.0_f64);
    for i in 0..again.len() {
        let got = Answer::of(again.run(model.plan, i));
        exact.push(match again.reference() {
            Some(found) => {
                off = off.max(found.closure).max(found.equilibrium);
                Answer::reference(found)
            }
            None => {
                source = Source::Full;
                got
            }
        });
    }
    let inputs = again.inputs();
    let scales = scales(model, &exact);
    let mut all = Measured { model, again, inputs, exact, scales, clock };
    let full = all.error(model.plan);
    let condition = solution
        .poses
        .iter()
        .filter_map(|p| p.outcome.as_ref().ok())
        .map(|s| s.condition)
        .fold(1.0, f64::min);
    let floor = match source {
        // what its own equations are off, or its rounding
        Source::DoubleDouble => off.max(DOUBLE),
        Source::Full => f64::EPSILON,
    } / condition;
    let mut study = AccuracyStudy {
        positions: all.again.len(),
        count: solution.poses.iter().filter(|pose| pose.outcome.is_ok()).count(),
        source,
        floor,
        scales,
        full,
        knobs: Vec::new(),
        absent: Vec::new(),
        effects: Vec::new(),
        sample: Price::default(),
        choices: Vec::new(),
        wanted,
        recommendation: None,
    };
    if !all.again.is_empty() {
        study.knobs.push(all.scalars(floor, source, &mut study.absent));
        for kind in [Kind::Friction, Kind::Newton, Kind::Triad] {
            match kind.absent(model.plan) {
                Some(why) => study.absent.push(NotApplicable { what: kind.name(), why }),
                None => study.knobs.push(all.tolerances(kind, floor)),
            }
        }
    }
    over_the_cycle(model, &solution.statics, &mut study, clock);
    study.effects = effects(model, clock);
    study.choices = choices(&mut all, &solution.statics, &study);
    study.recommendation = recommended(&study.choices, wanted);
    study
}

impl Measured<'_, '_> {
    fn error(&mut self, plan: &Plan) -> Error {
        let got: Vec<Answer> = (0..self.again.len()).map(|i| Answer::of(self.again.run(plan, i))).collect();
        errors(self.model, &self.scales, got.iter().zip(&self.exact))
    }

    /// Microseconds per position of the solver with a plan's settings.
    fn micros(&mut self, plan: &Plan) -> f64 {
        let count = self.again.len();
        let all = micros(self.clock, || {
            for i in 0..count {
                black_box(self.again.run(plan, i).motion.open);
            }
        });
        all / count as f64
    }

    pub(super) fn with(&mut self, settings: Settings) -> (f64, f64) {
        let plan = Plan { settings, ..self.model.plan.clone() };
        (self.micros(&plan), self.error(&plan).greatest())
    }

    fn tolerances(&mut self, kind: Kind, floor: f64) -> Setting {
        let row = |&tolerance: &f64| {
            let settings = kind.setting(tolerance);
            let (micros, error) = self.with(settings);
            let is_floor = error < floor;
            let error = Some(error.max(floor)).filter(|e| e.is_finite());
            let setting = power(tolerance);
            Row { setting, samples: None, micros, error, is_floor, settings: Some(settings) }
        };
        Setting { kind, rows: kind.tolerances().iter().map(row).collect() }
    }

    fn scalars(&mut self, floor: f64, source: Source, absent: &mut Vec<NotApplicable>) -> Setting {
        let mut rows = Vec::new();
        if self.model.plan.is_batchable() {
            let (micros, error) = self.closed::<f64>();
            rows.push(Row::scalar("f64", micros, error, false));
            let (micros, error) = self.closed::<Double>();
            rows.push(Row::scalar("double-double", micros, error.max(floor), error < floor));
        } else {
            let plan = self.model.plan;
            let (micros, error) = (self.micros(plan), self.error(plan).greatest());
            rows.push(Row::scalar("f64", micros, error.max(floor), source == Source::Full));
            if source == Source::DoubleDouble {
                rows.push(Row::scalar("double-double", self.reference_micros(), floor, true));
            } else {
                absent.push(NotApplicable { what: "double-double", why: not_closed(plan) });
            }
        }
        Setting { kind: Kind::Scalar, rows }
    }

    fn reference_micros(&mut self) -> f64 {
        let (plan, count) = (self.model.plan, self.again.len());
        let all = micros(self.clock, || {
            for i in 0..count {
                self.again.run(plan, i);
                drop(black_box(self.again.reference()));
            }
        });
        all / count as f64
    }

    /// The closed forms in a scalar, one position after another.
    pub(super) fn closed<S: Edge>(&mut self) -> (f64, f64) {
        let plan = self.model.plan;
        let mut state = State::<S>::closed(plan);
        let inputs: Vec<DriveInput<S>> = self.inputs.iter().map(DriveInput::in_scalar).collect();
        let count = self.again.len();
        let run = |i: usize, state: &mut State<S>| {
            state.branches.copy_from_slice(self.again.branches(i));
            state.motion.inputs.copy_from_slice(&inputs[plan.drives * i..][..plan.drives]);
            state.run_closed(plan);
        };
        let mut got = Vec::new();
        for i in 0..count {
            run(i, &mut state);
            got.push(Answer::of(&state));
        }
        let error = errors(self.model, &self.scales, got.iter().zip(&self.exact));
        let all = micros(self.clock, || {
            for i in 0..count {
                run(i, &mut state);
                black_box(state.motion.open);
            }
        });
        (all / count as f64, error.greatest())
    }
}

/// `1e-6`
fn power(tolerance: f64) -> String {
    format!("{tolerance:.0e}")
}

/// What each effect takes on top of those before it, µs.
fn effects(model: &Model<'_>, clock: Clock) -> Vec<(&'static str, f64)> {
    let found = costs(model, clock).ok().flatten();
    found.map_or_else(Vec::new, |c| c.effects.into_iter().map(|(name, time)| (name, time * 1e6)).collect())
}

fn over_the_cycle(model: &Model<'_>, found: &WholeCycle, study: &mut AccuracyStudy, clock: Clock) {
    if found.cycles.is_empty() && found.flywheels.is_empty() {
        study.absent.push(NotApplicable { what: Kind::Samples.name(), why: "no functions over the cycle" });
        return;
    }
    let samples = cycle_knob(model, found, Kind::Samples, clock);
    study.sample = Price::of(samples.rows.iter().filter_map(|row| Some((row.samples?, row.micros))));
    study.knobs.push(samples);
    let mut splits = found.cycles.iter().map(|c| &c.splits).chain(found.flywheels.iter().map(|f| &f.splits));
    if splits.any(|s| !s.is_empty()) {
        study.knobs.push(cycle_knob(model, found, Kind::Root, clock));
    } else {
        study
            .absent
            .push(NotApplicable { what: Kind::Root.name(), why: "all functions are smooth over the cycle" });
    }
}

fn cycle_knob(model: &Model<'_>, full: &WholeCycle, kind: Kind, clock: Clock) -> Setting {
    // the reference is the finest setting: its own error is estimated
    let floor = estimated(full);
    let row = |&tolerance: &f64| {
        let settings = kind.setting(tolerance);
        let plan = Plan { settings, ..model.plan.clone() };
        let plan = Model { plan: &plan, ..*model };
        let micros = micros(clock, || drop(black_box(over_cycle(&plan, full))));
        let (error, samples) = sampled(model, full, settings);
        let is_floor = error.is_some_and(|e| e < floor) || settings == Settings::FULL;
        let error = error.map(|e| e.max(floor));
        Row { setting: power(tolerance), samples, micros, error, is_floor, settings: Some(settings) }
    };
    Setting { kind, rows: kind.tolerances().iter().map(row).collect() }
}

/// Error and samples of all functions over the sweep.
pub(in crate::measure) fn sampled(
    model: &Model<'_>,
    full: &WholeCycle,
    settings: Settings,
) -> (Option<f64>, Option<usize>) {
    let plan = Plan { settings, ..model.plan.clone() };
    let Ok(found) = over_cycle(&Model { plan: &plan, ..*model }, full) else { return (None, None) };
    let samples = found.cycles.iter().map(|c| c.samples).chain(found.flywheels.iter().map(|f| f.samples));
    let error = if settings == Settings::FULL { estimated(full) } else { cycle_error(&found, full) };
    (Some(error).filter(|e| e.is_finite()), samples.max())
}

/// The greatest difference over its scale.
fn cycle_error(found: &WholeCycle, full: &WholeCycle) -> f64 {
    let over = |x: f64, y: f64, scale: f64| {
        let difference = (x - y).abs();
        if difference.is_nan() { f64::INFINITY } else { difference / scale.max(f64::MIN_POSITIVE) }
    };
    let known = full.cycles.iter().zip(&found.cycles).filter(|(a, _)| a.value.is_finite());
    let cycles = known.map(|(a, b)| over(a.value, b.value, a.scale));
    let wheels = full.flywheels.iter().zip(&found.flywheels).map(|(a, b)| {
        let most = a.mean_torque.abs().max(a.fluctuation / a.interval.1.abs());
        let work = over(a.fluctuation, b.fluctuation, a.fluctuation);
        work.max(over(a.mean_torque, b.mean_torque, most))
    });
    cycles.chain(wheels).fold(0.0, f64::max)
}

/// The greatest estimated error over its scale.
pub(super) fn estimated(found: &WholeCycle) -> f64 {
    let over = |error: f64, scale: f64| error / scale.max(f64::MIN_POSITIVE);
    let known = found.cycles.iter().filter(|c| c.value.is_finite()).map(|c| over(c.error, c.scale));
    let wheels = found.flywheels.iter().map(|f| over(f.error, f.fluctuation));
    known.chain(wheels).fold(0.0, f64::max)
}
