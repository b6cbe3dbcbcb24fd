//! One run of the integrator at one tolerance, with what it leaves at the instants wanted.

use super::equations::Equations;
use super::report::Energy;
use crate::math::Vec2;
use crate::math::ode::{Counts, Dop853, Integrator, Step, Stopped, System, Tolerance};
use crate::model::DriveTarget;
use crate::position::{extent, turns};
use crate::solve::failure::Halt;

/// Below this |σ| of a group the run ends before its dead position is in the way of the digits.
const DEAD: f64 = 1e-6;

/// The free coordinates at each instant, one after another.
#[derive(Clone, Debug, Default)]
pub(crate) struct Records {
    /// Free coordinates.
    pub order: usize,
    /// How many instants were reached.
    pub count: usize,
    /// The instants, s.
    pub times: Vec<f64>,
    /// Coordinates, rates and accelerations: three times `order` numbers each.
    pub numbers: Vec<f64>,
    /// Angles of the bodies, rad, continuous over the run.
    pub angles: Vec<f64>,
    /// Where the bodies stand, for steps of motion that start from there.
    pub stands: Vec<(Vec2, Vec2)>,
    /// Bodies.
    pub bodies: usize,
}

impl Records {
    /// Coordinates and rates at an instant.
    pub fn state(&self, index: usize) -> &[f64] {
        &self.numbers[3 * self.order * index..][..2 * self.order]
    }

    /// Accelerations at an instant.
    pub fn accelerations(&self, index: usize) -> &[f64] {
        &self.numbers[3 * self.order * index + 2 * self.order..][..self.order]
    }

    /// Angles of the bodies at an instant.
    pub fn angles(&self, index: usize) -> &[f64] {
        let each = self.angles.len() / self.count.max(1);
        &self.angles[each * index..][..each]
    }

    /// Where the bodies stand, if that is kept.
    pub fn stand(&self, index: usize) -> Option<&[(Vec2, Vec2)]> {
        self.stands.get(self.bodies * index..)?.get(..self.bodies).filter(|s| !s.is_empty())
    }
}

/// After so many steps it is looked at how many there will be.
const LOOKED_AT: usize = 20_000;
/// So many are never done.
const ENDLESS: f64 = 2e7;

/// A run.
pub(super) struct Run {
    pub records: Records,
    pub counts: Counts,
    pub energy: Energy,
    pub worst_condition: (f64, f64),
    /// Why it ended early, and when, s.
    pub stopped: Option<(f64, Halt)>,
    /// The last instant that was reached, s.
    pub end: f64,
}

/// Integrates from the first of the instants, s, to the last.
pub(super) fn run(equations: &mut Equations<'_, '_>, tolerance: f64, times: &[f64]) -> Run {
    let (first, last) = (times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(0.0));
    let y = equations.start();
    let mut method = Dop853::new(allowed(equations, tolerance, last - first));
    let mut recorder = Recorder::new(equations);
    let mut run = Run {
        records: Records::default(),
        counts: Counts::default(),
        energy: Energy::default(),
        worst_condition: (1.0, first),
        stopped: None,
        end: first,
    };
    if method.start(equations, first, &y, last).is_err() {
        equations.accepted(first, &y);
        run.stopped = Some((first, equations.halt()));
        return run;
    }
    let mut next = 0;
    let mut last_step = false;
    while !last_step {
        match method.step(equations) {
            Ok(step) => last_step = step == Step::Last,
            Err(Stopped::Stiff) => {}
            Err(stopped) => {
                run.stopped = Some((method.t(), why(equations, stopped)));
                break;
            }
        }
        if is_endless(&method, first, last) {
            run.stopped = Some((method.t(), Halt::TooManySteps));
            break;
        }
        let condition = equations.condition();
        if condition < run.worst_condition.0 {
            run.worst_condition = (condition, method.previous_t());
        }
        while next < times.len() && times[next] <= method.t() {
            if !recorder.at(equations, &mut method, times[next]) {
                run.stopped = Some((method.previous_t(), equations.halt()));
                break;
            }
            next += 1;
        }
        if run.stopped.is_some() {
            break;
        }
        if condition < DEAD {
            run.stopped = Some((method.previous_t(), equations.halt()));
            break;
        }
    }
    run.counts = method.counts();
    run.end = method.t();
    (run.records, run.energy) = recorder.end();
    run
}

/// Whether the steps are so short that the run would never come to its end.
#[allow(clippy::cast_precision_loss)] // far below 2^52
fn is_endless(method: &Dop853<f64>, first: f64, last: f64) -> bool {
    let steps = method.counts().steps;
    steps >= LOOKED_AT && steps as f64 * (last - first) > ENDLESS * (method.t() - first)
}

fn why(equations: &mut Equations<'_, '_>, stopped: Stopped) -> Halt {
    match stopped {
        Stopped::TooManySteps => Halt::TooManySteps,
        Stopped::StepTooSmall | Stopped::Undefined | Stopped::Stiff => equations.halt(),
    }
}

/// The errors allowed: of coordinates absolute, since angles and places are read off them whatever their turns; of rates
/// relative, and where they pass zero by what would move a coordinate in the time of the run. The work is not judged.
fn allowed(equations: &Equations<'_, '_>, tolerance: f64, length: f64) -> Tolerance<f64> {
    let model = equations.model;
    let scale = |&drive: &usize| {
        let drive = &model.mechanism.drives[drive];
        let lengths = !matches!(drive.target, DriveTarget::Point(..)) && !turns(model, drive);
        if lengths { extent(model) } else { 1.0 }
    };
    let scales: Vec<f64> = equations.reduced.free().iter().map(scale).collect();
    let coordinates = scales.iter().map(|scale| (0.0, tolerance * scale));
    let rates = scales.iter().map(|scale| (tolerance, tolerance * scale / length));
    let each: Vec<(f64, f64)> = coordinates.chain(rates).chain([(0.0, f64::MAX)]).collect();
    Tolerance::each(&each)
}

/// Keeps what is wanted at an instant.
struct Recorder {
    records: Records,
    y: Vec<f64>,
    dy: Vec<f64>,
    goes_on: bool,
    begin: Option<f64>,
    end: f64,
    work: f64,
    missing: f64,
    exchanged: f64,
}

impl Recorder {
    fn new(equations: &Equations<'_, '_>) -> Self {
        let order = equations.order();
        Self {
            records: Records { order, bodies: equations.model.plan.bodies, ..Records::default() },
            y: vec![0.0; 2 * order + 1],
            dy: vec![0.0; 2 * order + 1],
            goes_on: equations.model.plan.goes_on(),
            begin: None,
            end: 0.0,
            work: 0.0,
            missing: 0.0,
            exchanged: 0.0,
        }
    }

    /// Within the last step, or at one of its ends.
    fn at(&mut self, equations: &mut Equations<'_, '_>, method: &mut Dop853<f64>, time: f64) -> bool {
        if time == method.t() {
            self.y.copy_from_slice(method.y());
        } else if time == method.previous_t() {
            self.y.copy_from_slice(method.previous_y());
        } else {
            if method.prepare_dense(equations).is_err() {
                return false;
            }
            method.dense(time, &mut self.y);
        }
        if equations.rates(time, &self.y, &mut self.dy).is_err() {
            return false;
        }
        equations.follow_angles(time);
        let (n, records) = (self.records.order, &mut self.records);
        records.count += 1;
        records.times.push(time);
        records.numbers.extend_from_slice(&self.y[..2 * n]);
        records.numbers.extend_from_slice(&self.dy[n..2 * n]);
        records.angles.extend_from_slice(&equations.angles);
        if self.goes_on {
            records.stands.extend(equations.trial.motion.bodies.iter().map(|b| (b.p, b.u)));
        }
        self.energy(equations);
        true
    }

    fn energy(&mut self, equations: &Equations<'_, '_>) {
        let kinetic = equations.trial.kinetic_energy(equations.model.plan);
        let begin = *self.begin.get_or_insert(kinetic);
        self.work = self.y[2 * self.records.order];
        self.end = kinetic;
        self.missing = self.missing.max((kinetic - begin - self.work).abs());
        self.exchanged = self.exchanged.max(kinetic).max(self.work.abs());
    }

    fn end(self) -> (Records, Energy) {
        let balance = if self.exchanged > 0.0 { self.missing / self.exchanged } else { 0.0 };
        let energy = Energy { begin: self.begin.unwrap_or(0.0), end: self.end, work: self.work, balance };
        (self.records, energy)
    }
}
