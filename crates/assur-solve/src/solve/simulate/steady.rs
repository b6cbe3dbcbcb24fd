//! The motion that comes again: Newton's method on the state at its begin.
//!
//! A trial follows one period from a state z to P(z), by the same run that is printed later. Wanted is P(z) = z; the
//! derivatives of P are differences of trials, and angles count without whole turns. A turn begins where its start puts the
//! link: a coordinate that is this angle is no unknown.

use super::coordinates::Charts;
use super::pass::Pass;
use super::report::SteadyReport;
use super::run::{Run, run};
use super::setup::{Outputs, StartState};
use crate::math::Lu;
use crate::math::ode::System;
use crate::model::{
    BinaryOp, DriveTarget, Event, Expr, Function, Mechanism, Positions, Query, Simulation, Steady,
};
use crate::position::{DriveInput, Model, State, extent, turns};
use crate::solve::failure::{Halt, NoCycle};
use std::f64::consts::TAU;

/// The tolerance of a trial over the wanted accuracy, and the least one.
const FINER: f64 = 1e-3;
const FINEST: f64 = 1e-13;
/// The last step of Newton's method, of the wanted accuracy.
const SETTLED: f64 = 0.05;
/// Steps that do not shrink below this are those of trials that are not accurate enough: where loads jump.
const STALLED: f64 = 1e-5;
const MOST: usize = 200;
/// Steps of Newton's method with one set of derivatives, as long as each leaves less than this part.
const FAST: f64 = 0.1;
/// A step is halved so often at most.
const HALVED: usize = 6;
/// A period lasts at most so many times what the first speed promises, or so long, s.
const PATIENCE: f64 = 50.0;
const LONGEST: f64 = 100.0;
/// The begin of a cycle is passed again by rounding within this part of it.
const GUARD: f64 = 0.1;

/// A motion that comes again.
pub(super) struct Found {
    pub state: State,
    pub angles: Vec<f64>,
    pub first: Vec<DriveInput>,
    pub report: SteadyReport,
}

/// An unknown: its place in the state, what it is measured by, and whether whole turns of it count for nothing.
#[derive(Clone, Copy)]
struct Unknown {
    at: usize,
    scale: f64,
    turns: bool,
}

struct Search<'s> {
    begin: StartState<'s>,
    charts: Charts<'s>,
    from: f64,
    within: f64,
    unknowns: Vec<Unknown>,
    horizon: f64,
    guard: Option<f64>,
    trials: usize,
}

/// Finds the steady motion from the starts as a first guess.
pub(super) fn steady(
    begin: &StartState<'_>,
    simulation: &Simulation,
    after: Steady,
) -> Result<Found, (f64, Halt)> {
    let mut mechanism = begin.model.mechanism.clone();
    mechanism.cycles.clear();
    mechanism.events = vec![end(begin.model.mechanism, simulation, after, &begin.angles)];
    let model = &Model { mechanism: &mechanism, ..*begin.model };
    let (first, state, angles) = (begin.first.clone(), begin.state.clone(), begin.angles.clone());
    let begin = StartState { model, first, state, angles, ..*begin };
    let charts = Charts::new(model, begin.statics);
    let mut search = Search {
        begin,
        charts,
        from: simulation.from,
        within: simulation.within.unwrap_or(Simulation::WITHIN),
        unknowns: Vec::new(),
        horizon: LONGEST,
        guard: None,
        trials: 0,
    };
    let mut z = search.begin.equations().start();
    search.unknowns = search.all_unknowns(after, &z);
    if let Steady::Turns { link, count } = after {
        let mut equations = search.begin.equations();
        if equations.observe(search.from, &z, false) {
            let speed = equations.trial.motion.bodies[link.index()].omega.abs();
            if speed > 0.0 {
                search.horizon = PATIENCE * TAU * f64::from(count) / speed;
            }
        }
    } else {
        // to the first time that it happens
        let tolerance = search.tolerance();
        let (at, time) = search.trial(&z, tolerance)?;
        z = at;
        search.guard = Some(1e-3 * time);
    }
    search.newton(z)
}

/// The event that ends a period.
fn end(mechanism: &Mechanism, simulation: &Simulation, after: Steady, angles: &[f64]) -> Event {
    match after {
        Steady::Cycle(event) => Event { name: None, ends: true, ..mechanism.events[event].clone() },
        Steady::Turns { link, count } => {
            let angle = || Box::new(Expr::Query(Query::Angle(link)));
            let first = || Box::new(Expr::number(angles[link.index()]));
            let ways = vec![
                Expr::Binary(BinaryOp::Sub, angle(), first()),
                Expr::Binary(BinaryOp::Sub, first(), angle()),
            ];
            let turned = Box::new(Expr::Call(Function::Max, ways));
            let whole = Box::new(Expr::number(TAU * f64::from(count)));
            let value = Expr::Binary(BinaryOp::Sub, turned, whole);
            Event {
                name: None,
                span: simulation.span,
                value,
                rising: Some(true),
                strict: false,
                dimension: None,
                ends: true,
                situation: None,
            }
        }
    }
}

impl Search<'_> {
    fn tolerance(&self) -> f64 {
        (FINER * self.within).max(FINEST)
    }

    /// Begins with these coordinates and rates.
    fn begin_with(&mut self, z: &[f64]) {
        let equations = self.begin.equations();
        let n = equations.order();
        let free = equations.reduced.free().to_vec();
        for (i, drive) in free.into_iter().enumerate() {
            (self.begin.first[drive].value, self.begin.first[drive].rate) = (z[i], z[n + i]);
        }
    }

    fn all_unknowns(&self, after: Steady, z: &[f64]) -> Vec<Unknown> {
        let equations = self.begin.equations();
        let free = equations.reduced.free();
        let n = free.len();
        let drives = &self.begin.model.mechanism.drives;
        let size = |drive: usize| {
            if turns(self.begin.model, &drives[drive]) { 1.0 } else { extent(self.begin.model) }
        };
        let fastest = (0..n).map(|i| z[n + i].abs() / size(free[i])).fold(0.0, f64::max);
        let fastest = if fastest > 0.0 { fastest } else { 1.0 };
        let fixed = |drive: usize| match after {
            Steady::Turns { link, .. } => drives[drive].target == DriveTarget::Link(link),
            Steady::Cycle(_) => false,
        };
        let placed = |drive: usize| !matches!(drives[drive].positions, Positions::None) && !fixed(drive);
        let coordinates = (0..n).filter(|i| placed(free[*i])).map(|i| Unknown {
            at: i,
            scale: size(free[i]),
            turns: turns(self.begin.model, &drives[free[i]]),
        });
        let rates = (0..n).map(|i| Unknown { at: n + i, scale: fastest * size(free[i]), turns: false });
        coordinates.chain(rates).collect()
    }

    /// Follows one period; the state at its end, and how long it lasts, s.
    fn trial(&mut self, z: &[f64], tolerance: f64) -> Result<(Vec<f64>, f64), (f64, Halt)> {
        self.trials += 1;
        let outputs = Outputs { guard: self.guard.map(|guard| (0, self.from + guard)), ..Outputs::default() };
        self.begin_with(z);
        let last = self.from + self.horizon;
        let Run { records, ended_by, stopped, end, .. } =
            run(&self.begin, &mut self.charts, Pass::in_short_steps(tolerance), &outputs, last);
        if let Some(stopped) = stopped {
            return Err(stopped);
        }
        if ended_by.is_none() || records.count == 0 {
            return Err((end, Halt::NoCycle(NoCycle::NotReached(self.horizon))));
        }
        let mut after = z.to_vec();
        let reached = records.state(records.count - 1);
        after[..reached.len()].copy_from_slice(reached);
        Ok((after, end - self.from))
    }

    /// By how much the end of a period differs from its begin, over what each is measured by.
    fn difference(&self, begin: &[f64], end: &[f64]) -> Vec<f64> {
        let of = |unknown: &Unknown| {
            let difference = end[unknown.at] - begin[unknown.at];
            let whole = if unknown.turns { TAU * (difference / TAU).round() } else { 0.0 };
            (difference - whole) / unknown.scale
        };
        self.unknowns.iter().map(of).collect()
    }

    fn moved(&self, z: &[f64], step: &[f64], part: f64) -> Vec<f64> {
        let mut moved = z.to_vec();
        for (unknown, step) in self.unknowns.iter().zip(step) {
            moved[unknown.at] += part * step * unknown.scale;
        }
        moved
    }

    /// The factors of I − P′, by differences.
    fn derivatives(&mut self, z: &[f64], difference: &[f64]) -> Result<Lu, (f64, Halt)> {
        let m = self.unknowns.len();
        let tolerance = self.tolerance();
        let small = tolerance.sqrt();
        let mut factors = Lu::new(m);
        for column in 0..m {
            let mut step = vec![0.0; m];
            step[column] = small;
            let beside = self.moved(z, &step, 1.0);
            let (end, _) = self.trial(&beside, tolerance)?;
            for (row, (then, now)) in self.difference(&beside, &end).iter().zip(difference).enumerate() {
                *factors.at_mut(row, column) = (now - then) / small;
            }
        }
        if factors.factor() { Ok(factors) } else { Err(self.not_found(difference)) }
    }

    fn not_found(&self, difference: &[f64]) -> (f64, Halt) {
        let by = greatest(difference);
        (self.from, Halt::NoCycle(NoCycle::Differs { trials: self.trials, by }))
    }

    fn newton(&mut self, mut z: Vec<f64>) -> Result<Found, (f64, Halt)> {
        let tolerance = self.tolerance();
        let (mut end, mut period) = self.trial(&z, tolerance)?;
        let mut difference = self.difference(&z, &end);
        let (mut factors, mut before): (Option<Lu>, f64) = (None, f64::INFINITY);
        loop {
            self.horizon = PATIENCE * period;
            self.guard = self.guard.map(|_| GUARD * period);
            let mut known = match factors.take() {
                Some(known) => known,
                None => self.derivatives(&z, &difference)?,
            };
            let mut step = difference.clone();
            known.solve(&mut step);
            let (last, mut part) = (greatest(&difference), 1.0);
            let size = greatest(&step);
            let mut halved = 0;
            loop {
                let next = self.moved(&z, &step, part);
                let tried = self.trial(&next, tolerance);
                let better = tried.as_ref().ok().map(|(end, _)| self.difference(&next, end));
                let better = better.filter(|found| greatest(found) < 2.0 * last || size < STALLED);
                if let (Ok((found, time)), Some(found_difference)) = (tried, better) {
                    (z, end, period, difference) = (next, found, time, found_difference);
                    break;
                }
                (part, halved) = (0.5 * part, halved + 1);
                if halved > HALVED || self.trials > MOST {
                    return Err(self.not_found(&difference));
                }
            }
            let stalled = size < STALLED && size > 0.5 * before;
            if part == 1.0 && (size <= SETTLED * self.within || stalled) {
                let least = if stalled { size } else { 0.0 };
                return self.found(&z, (&end, period), &mut known, least);
            }
            before = size;
            if self.trials > MOST {
                return Err(self.not_found(&difference));
            }
            if part == 1.0 && greatest(&difference) < FAST * last {
                factors = Some(known);
            }
        }
    }

    /// The motion that was found; a trial of another tolerance says how well.
    fn found(
        &mut self,
        z: &[f64],
        (end, period): (&[f64], f64),
        factors: &mut Lu,
        least: f64,
    ) -> Result<Found, (f64, Halt)> {
        let (other, _) = self.trial(z, 10.0 * self.tolerance())?;
        let mut error = self.difference(end, &other);
        factors.solve(&mut error);
        self.begin_with(z);
        let mut equations = self.begin.equations();
        let y = equations.start();
        let mut rates = vec![0.0; y.len()];
        if equations.rates(self.from, &y, &mut rates).is_err() {
            return Err((self.from, equations.halt()));
        }
        equations.follow_angles(self.from);
        let report = SteadyReport { period, trials: self.trials, error: greatest(&error).max(least) };
        Ok(Found {
            state: equations.trial.clone(),
            angles: equations.angles.clone(),
            first: equations.first.clone(),
            report,
        })
    }
}

fn greatest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most, x| if x.is_nan() { f64::INFINITY } else { x.abs().max(most) })
}
