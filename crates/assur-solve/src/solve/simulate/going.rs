//! A run on its way: step after step, with what happens and what is wanted within each.

use super::compare::Kinds;
use super::equations::Equations;
use super::records::{Origin, Recorder, within_step};
use super::rubbing::Mode;
use super::setup::Outputs;
use super::watch::{AT_ONCE, Watch};
use crate::math::ode::event::first_crossing;
use crate::math::ode::{Integrator, Step, Stopped, Undefined};
use crate::solve::failure::Halt;

/// Where something else than the error bounds the steps, those of the finer run are shorter by this: equal ones would say
/// nothing of their error.
pub(super) const SHORTER: f64 = 0.7;
/// Below this |σ| of a group the run ends before its dead position is in the way of the digits.
const DEAD: f64 = 1e-6;
/// After so many steps it is looked at how many there will be.
const LOOKED_AT: usize = 20_000;
/// What is looked at within a step turns with the bodies: none turns by more than this, rad, or what comes again would be lost.
const TURN: f64 = std::f64::consts::PI;
/// So many are never done.
const ENDLESS: f64 = 2e7;

/// How a method ended.
pub(super) enum Ended {
    /// At the last instant, or at an event that ends the run.
    Done,
    /// An implicit method is cheaper.
    Stiff,
    Halted(Halt),
}

/// A run on its way.
pub(super) struct Going<'m, 'o> {
    pub recorder: Recorder,
    pub watch: Watch<'m>,
    pub outputs: &'o Outputs,
    /// The next of the instants that are known beforehand.
    pub next: usize,
    /// The first instant and the last, s.
    pub begin: f64,
    pub last: f64,
    pub worst_condition: (f64, f64),
    pub ended_by: Option<usize>,
    /// When the coordinate comes to rest by friction, and when it leaves again, s.
    pub rests: Vec<(f64, Option<f64>)>,
    /// Something changes while it rests.
    pub wakes: bool,
    /// The greatest magnitudes of each kind.
    pub kinds: Kinds,
    pub measures: bool,
    /// No step is longer, whatever turns.
    pub longest: Option<f64>,
}

impl Going<'_, '_> {
    /// Integrates up to the end; `exactly` where steps end at every instant wanted, for a method whose output between steps is
    /// less accurate than its steps.
    pub fn integrate<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        exactly: bool,
    ) -> Ended {
        let last = self.last;
        loop {
            match method.step(equations) {
                Ok(Step::Within | Step::Last) => {}
                Err(Stopped::Stiff) if !exactly => return Ended::Stiff,
                Err(Stopped::Stiff) => {}
                Err(Stopped::TooManySteps) => return Ended::Halted(Halt::TooManySteps),
                Err(Stopped::StepTooSmall | Stopped::Undefined) => return Ended::Halted(equations.halt()),
            }
            if is_endless(method, self.begin, last) {
                return Ended::Halted(Halt::TooManySteps);
            }
            if self.keep_short(equations, method).is_err() {
                return Ended::Halted(equations.halt());
            }
            let condition = equations.condition();
            if condition < self.worst_condition.0 {
                self.worst_condition = (condition, method.previous_t());
            }
            let happened = self.watch.first(equations, method);
            let turned = self.turning(equations, method);
            let wanted = self.outputs.known.get(self.next).map_or(last, |output| output.0);
            let first =
                happened.as_ref().map(|h| h.time).into_iter().chain(turned).fold(f64::INFINITY, f64::min);
            let cut = (first < method.t()).then_some(first);
            let exact = (exactly && method.previous_t() < wanted && wanted < method.t()).then_some(wanted);
            let early = match (cut, exact) {
                (Some(event), Some(wanted)) => Some(event.min(wanted)),
                (event, wanted) => event.or(wanted),
            };
            if let Some(t) = early
                && method.shorten(equations, t).is_err()
            {
                return Ended::Halted(equations.halt());
            }
            if self.measures && equations.observe(method.t(), method.y(), true) {
                self.kinds.measure(equations);
            }
            self.recorder.look(method.y()[2 * equations.order()]);
            let here = method.t() + AT_ONCE * (last - self.begin);
            let happened = happened.filter(|h| h.time <= here);
            let turned = turned.is_some_and(|t| t <= method.t());
            let begun = self.watch.counts();
            self.ended_by = self.watch.look(equations, method, happened);
            let done = self.ended_by.is_some() || method.t() >= last;
            // within the step it moves as before
            if !self.keep_within(equations, method) {
                return Ended::Halted(equations.halt());
            }
            let mut y = Vec::new();
            if turned {
                y.extend_from_slice(method.y());
                y[1] = 0.0;
                let chosen = match equations.mode {
                    Some(Mode::Resting) => equations.leave(method.t(), &y),
                    _ => equations.choose_mode(method.t(), &y),
                };
                if let Err(halt) = chosen {
                    return Ended::Halted(halt);
                }
                self.note_rest(equations, method.t());
            }
            if equations.mode == Some(Mode::Resting) {
                self.watch.rests();
            }
            if !self.keep(equations, method, (&begun, done)) {
                return Ended::Halted(equations.halt());
            }
            if done {
                return Ended::Done;
            }
            if turned && method.restart(equations, &y, last).is_err() {
                return Ended::Halted(equations.halt());
            }
            if condition < DEAD {
                return Ended::Halted(equations.halt());
            }
        }
    }
}

impl Going<'_, '_> {
    /// Where, in the last step, a coordinate that rubs comes to rest or leaves it.
    fn turning<M: Integrator<f64>>(&self, equations: &mut Equations<'_, '_>, method: &mut M) -> Option<f64> {
        let step = (method.previous_t(), method.t());
        let mode = equations.mode?;
        let mut y = method.y().to_vec();
        match mode {
            Mode::Moving(sense) => {
                let begins_at_rest = (method.previous_y()[1] == 0.0).then_some(true);
                let rate = |t: f64| {
                    within_step(equations, method, t, &mut y);
                    sense * y[1]
                };
                first_crossing(step, begins_at_rest, rate).filter(|c| !c.rising).map(|c| c.t)
            }
            Mode::Resting if self.wakes => {
                first_crossing(step, Some(false), |t| equations.leaving(t, &y)).map(|c| c.t)
            }
            Mode::Resting => None,
        }
    }

    fn note_rest(&mut self, equations: &Equations<'_, '_>, time: f64) {
        let resting = equations.mode == Some(Mode::Resting);
        match self.rests.last_mut() {
            Some(rest) if rest.1.is_none() && !resting => rest.1 = Some(time),
            Some(rest) if rest.1.is_none() => {}
            _ if resting => self.rests.push((time, None)),
            _ => {}
        }
    }

    /// Keeps what is wanted before the end of the last step.
    fn keep_within<M: Integrator<f64>>(&mut self, equations: &mut Equations<'_, '_>, method: &mut M) -> bool {
        let mut kept = true;
        while let Some(output) = self.outputs.known.get(self.next).filter(|output| output.0 < method.t()) {
            kept &= self.recorder.keep(equations, method, *output);
            self.next += 1;
        }
        kept
    }

    /// Keeps all that is wanted at the end of the last step; `begun` counts the events before it.
    fn keep<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        (begun, done): (&[usize], bool),
    ) -> bool {
        let mut printed = f64::NAN;
        let mut kept = true;
        while let Some(output) = self.outputs.known.get(self.next).filter(|output| output.0 <= method.t()) {
            kept &= self.recorder.keep(equations, method, *output);
            if output.1 == Origin::Printed {
                printed = output.0;
            }
            self.next += 1;
        }
        let here = method.t();
        let counts = self.watch.counts();
        let happened = |event: usize| counts[event] > begun[event];
        let any = (0..counts.len()).any(happened);
        // the end of the run is printed, wherever it is
        if printed != here && (done || (any && self.outputs.prints_events)) {
            kept &= self.recorder.keep(equations, method, (here, Origin::Printed));
        }
        for &(event, which, expect) in &self.outputs.events {
            if happened(event) && counts[event] == which {
                kept &= self.recorder.keep(equations, method, (here, Origin::Expected(expect)));
            }
        }
        for &expect in self.outputs.end.iter().filter(|_| done) {
            kept &= self.recorder.keep(equations, method, (here, Origin::Expected(expect)));
        }
        kept
    }
}

impl Going<'_, '_> {
    /// Ends a step where a body has turned too far for what is looked at within it, and bounds the next one.
    fn keep_short<M: Integrator<f64>>(
        &self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) -> Result<(), Undefined> {
        if !self.watch.comes_again {
            return Ok(());
        }
        let (from, to) = (method.previous_t(), method.t());
        let before = equations.fastest_accepted();
        let after = equations.fastest(to, method.y());
        let turned = (to - from) * before.max(after);
        let most = if self.measures { TURN } else { SHORTER * TURN };
        if turned > most {
            method.shorten(equations, from + (to - from) * (most / turned))?;
        }
        let fastest = equations.fastest(method.t(), method.y());
        let turning = if fastest > 0.0 { most / fastest } else { f64::INFINITY };
        let longest = self.longest.unwrap_or(f64::INFINITY).min(turning);
        method.progress_mut().longest = (longest < f64::INFINITY).then_some(longest);
        Ok(())
    }
}

/// Whether the steps are so short that the run would never come to its end.
#[allow(clippy::cast_precision_loss)] // far below 2^52
fn is_endless<M: Integrator<f64>>(method: &M, first: f64, last: f64) -> bool {
    let steps = method.counts().steps;
    steps >= LOOKED_AT && steps as f64 * (last - first) > ENDLESS * (method.t() - first)
}
