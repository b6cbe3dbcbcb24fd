//! A run on its way: step after step, with what happens and what is wanted within each.

use super::acting::wakes;
use super::bends::Bends;
use super::change::CLOSE;
use super::compare::Kinds;
use super::coordinates::{CAREFUL, Change, Charts};
use super::corners::Corners;
use super::equations::Equations;
use super::event_detector::{AT_ONCE, EventDetector};
use super::pass::Pass;
use super::records::{Origin, Recorder};
use super::report::Holder;
use super::setup::{Outputs, scales};
use super::stop::{Stops, Touch};
use super::trace::Trace;
use super::unilateral::UnilateralConditions;
use crate::math::ode::{Integrator, Step, Stopped, System, Undefined};
use crate::model::DriveTarget;
use crate::solve::failure::Halt;

/// Below this |σ| of a group the run ends before its dead position is in the way of the digits.
const DEAD: f64 = 1e-4;
/// Other coordinates are looked for again where the condition has fallen by this.
pub(super) const AGAIN: f64 = 0.5;
/// After so many steps it is looked at how many there will be.
const LOOKED_AT: usize = 20_000;
/// What is looked at within a step turns with the bodies: none turns by more than this, rad, or what comes again would be lost.
const TURN: f64 = std::f64::consts::PI;
/// The same where what is looked at is drawn, and events are known.
const DRAWN: f64 = 2.0 * TURN;
/// The same where nothing is free, and no error bounds the steps: what is passed is to be seen.
const PRESCRIBED: f64 = 0.25;
/// Accelerations of less than one over this of their terms have lost digits.
const CANCELS: f64 = 1e3;
/// So many are never done.
const ENDLESS: f64 = 2e7;
/// Nor are so many, where a tenth of them are done.
const TOO_MANY: f64 = 2e6;

/// So many radians or extents of the mechanism are more than a bounded motion passes.
const UNBOUNDED: f64 = 1e9;

/// How a method ended.
pub(super) enum Ended {
    /// At the last instant, or at an event that ends the run.
    Done,
    /// An implicit method is cheaper.
    Stiff,
    /// It goes on in other coordinates.
    Changed(Box<Change>),
    /// This stop was hit, which another method follows.
    Struck(usize),
    /// There is no step on from where the last one ended.
    Stuck(Halt),
    Halted(Halt),
}

/// A run on its way.
pub(super) struct Integration<'m, 'o> {
    pub recorder: Recorder,
    pub watch: EventDetector<'m>,
    pub bonds: UnilateralConditions,
    pub stops: Stops,
    bends: Bends,
    pub corners: Corners,
    pub outputs: &'o Outputs<'o>,
    /// The next of the instants that are known beforehand.
    pub next: usize,
    /// The last instant that was printed at the end of a step.
    pub printed: f64,
    /// What is wanted at the end of the run is kept.
    kept_end: bool,
    /// The first instant and the last, s.
    pub begin: f64,
    pub last: f64,
    pub worst_condition: (f64, f64),
    pub ended_by: Option<usize>,
    /// What holds at rest, from when to when, s.
    pub held: Vec<(Holder, f64, Option<f64>)>,
    /// What stopped at once since friction admitted no acceleration, and when, s.
    pub jammed: Vec<(Holder, f64)>,
    /// Something changes while it rests.
    pub wakes: bool,
    /// The greatest magnitudes of each kind.
    pub kinds: Kinds,
    pub pass: Pass<'o>,
    /// No step is longer, whatever turns.
    pub longest: Option<f64>,
    /// Nor than this, so that no body turns too far.
    pub turning: Option<f64>,
    /// Where its own steps end.
    pub trace: Trace,
    /// Steps are parts of those of the run before, the next of which is this one.
    pub place: Option<usize>,
    /// It goes by energy: after an impact another method does.
    pub by_energy: bool,
    /// By how much rounding of the energy may shift the instants, s.
    pub late: f64,
    /// No first step of that is longer, s: what was hit may come back.
    pub first: f64,
    /// The condition at which other coordinates were looked for in vain.
    pub looked_at: f64,
    /// When other coordinates were taken, s, and which.
    pub changes: Vec<(f64, Vec<DriveTarget>)>,
    /// When change points were passed, s.
    pub crossed: Vec<f64>,
    /// The greatest term of the acceleration that rubs, and the greatest of what is left of all of them.
    pub terms: (f64, f64),
}

impl<'m, 'o> Integration<'m, 'o> {
    /// From where a run begins, between the first instant and the last, s.
    pub fn new(
        equations: &Equations<'m, '_>,
        (bonds, stops): (UnilateralConditions, Stops),
        outputs: &'o Outputs,
        (begin, last): (f64, f64),
        pass: Pass<'o>,
    ) -> Self {
        let mut watch = EventDetector::new(equations, (begin, last), pass.tolerance);
        watch.guard = outputs.guard;
        watch.bare = outputs.conduct.bare;
        watch.comes_again &= !watch.bare;
        outputs.conduct.drawn.iter().for_each(|drawn| watch.draw(drawn));
        Self {
            recorder: Recorder::new(equations),
            watch,
            bonds,
            stops,
            bends: Bends::default(),
            corners: Corners::new(equations, AT_ONCE * (last - begin)),
            outputs,
            next: 0,
            printed: f64::NEG_INFINITY,
            kept_end: false,
            begin,
            last,
            worst_condition: (1.0, begin),
            ended_by: None,
            held: equations.holders().into_iter().map(|holder| (holder, begin, None)).collect(),
            jammed: Vec::new(),
            wakes: wakes(equations),
            kinds: Kinds::default(),
            pass,
            longest: None,
            turning: None,
            trace: Trace::new(),
            place: None,
            by_energy: false,
            late: 0.0,
            first: f64::INFINITY,
            looked_at: CAREFUL / AGAIN,
            changes: Vec::new(),
            crossed: Vec::new(),
            terms: (0.0, 0.0),
        }
    }
}

impl Integration<'_, '_> {
    /// Integrates up to the end; `exactly` where steps end at every instant wanted, for a method whose output between steps is
    /// less accurate than its steps.
    pub fn integrate<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        (charts, exactly): (&mut Charts<'_>, bool),
    ) -> Ended {
        let last = self.last;
        loop {
            if let Err(ended) = self.advance(equations, method, exactly) {
                return ended;
            }
            let condition = equations.condition();
            if condition < self.worst_condition.0 {
                self.worst_condition = (condition, method.previous_t());
            }
            let mut happened = self.watch.first(equations, method);
            let mut turned = self.turning(equations, method);
            let mut opened = self.bonds.first(equations, method);
            let mut touched = self.stops.first(equations, method);
            let wanted = self.outputs.known.get(self.next).map_or(last, |output| output.0);
            let bound = self.watch.bound((method.previous_t(), method.t()));
            let event = happened.as_ref().map(|h| h.time);
            let instants = [event, turned, opened.map(|(t, _)| t), touched.as_ref().map(|(t, _)| *t), bound];
            let first = instants.into_iter().flatten().fold(f64::INFINITY, f64::min);
            // what happens with a turn does so where that is
            let first = turned.filter(|t| t - first <= self.at_once()).unwrap_or(first);
            let cut = (first < method.t()).then_some(first);
            let exact = (exactly && method.previous_t() < wanted && wanted < method.t()).then_some(wanted);
            if let Some(t) = [cut, exact].into_iter().flatten().reduce(f64::min) {
                // what happens with a turn, too
                let times = [
                    happened.as_mut().map(|happened| &mut happened.time),
                    opened.as_mut().map(|opened| &mut opened.0),
                    touched.as_mut().map(|touched| &mut touched.0),
                ];
                if !self.shorten(equations, method, t, (&mut turned, times)) {
                    return Ended::Halted(equations.halt());
                }
            }
            if self.pass.measures && equations.observe(method.t(), method.y(), true) {
                self.kinds.measure(equations);
            }
            self.trace.note(method.t(), method.counts().shortened);
            self.recorder.take_works(equations, method);
            let here = method.t() + self.at_once();
            let happened = happened.filter(|h| h.time <= here);
            let turned = turned.is_some_and(|t| t <= method.t());
            let opened = opened.filter(|(t, _)| *t <= here);
            let touched = self.stops.passed(equations, method, (touched, here));
            self.watch.begin();
            self.ended_by = self.watch.detect(equations, method, happened);
            // where the motion jumps what is wanted then is what was before
            let jumps = turned || touched.is_some();
            let by = if jumps { here } else { method.t() };
            let mut done = self.ended_by.is_some() || by >= last;
            if !self.keep_within(equations, method) {
                return Ended::Halted(equations.halt());
            }
            if let Some((_, (pair, bond))) = opened.filter(|_| self.ended_by.is_none()) {
                return Ended::Halted(Halt::Opens { pair, bond });
            }
            let mut y = Vec::new();
            if turned {
                if !self.keep(equations, method, (by, done)) {
                    return Ended::Halted(equations.halt());
                }
                self.watch.begin();
                // a corner at the same instant is one with it
                self.corners.turn(equations, method);
                y.extend_from_slice(method.y());
                match self.turn(equations, (method.t(), &mut y)) {
                    Ok(ended) => self.ended_by = self.ended_by.or(ended),
                    Err(halt) => return Ended::Halted(halt),
                }
                done |= self.ended_by.is_some();
            }
            if equations.is_held() {
                self.watch.rests();
            }
            if !self.keep(equations, method, (by, done)) {
                return Ended::Halted(equations.halt());
            }
            if done {
                return Ended::Done;
            }
            if turned {
                if let Err(halt) = self.go_on(equations, method, &y) {
                    return Ended::Halted(halt);
                }
            } else if self.corners.turn(equations, method) {
                match self.corner(equations, method) {
                    Ok(false) => {}
                    Ok(true) => return Ended::Done,
                    Err(halt) => return Ended::Halted(halt),
                }
            }
            if let Some(ended) = self.after_step(equations, method, touched, charts) {
                return ended;
            }
            if condition < DEAD {
                return Ended::Halted(equations.halt());
            }
        }
    }

    /// What a stop that is hit does, and whether the run goes on in other coordinates or by another method.
    fn after_step<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        touched: Option<Touch>,
        charts: &mut Charts<'_>,
    ) -> Option<Ended> {
        let struck = touched.as_ref().filter(|_| self.by_energy).map(Touch::stop);
        match self.touch(equations, method, touched) {
            Ok(false) => {}
            Ok(true) => return Some(Ended::Done),
            Err(halt) => return Some(Ended::Halted(halt)),
        }
        if let Some(stop) = struck {
            return Some(Ended::Struck(stop));
        }
        let change = self.better(equations, (method.t(), method.y()), charts)?;
        Some(Ended::Changed(Box::new(change)))
    }

    /// Ends the step at an instant, where the motion turns exactly there, and so do the times of what happens with it. False where
    /// it is not defined there.
    fn shorten<M: Integrator<f64>>(
        &self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        t: f64,
        (turned, times): (&mut Option<f64>, [Option<&mut f64>; 3]),
    ) -> bool {
        let end = method.t();
        if method.shorten(equations, t).is_err() {
            return false;
        }
        if *turned != Some(t) {
            return true;
        }
        let Ok(exact) = Self::turn_exactly(equations, method, end) else { return false };
        *turned = Some(exact);
        let with = times.into_iter().flatten().filter(|time| (**time - t).abs() <= self.at_once());
        with.for_each(|time| *time = exact);
        true
    }

    /// One step, no longer than what is looked at within it allows, unless the run has taken enough.
    fn advance<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        exactly: bool,
    ) -> Result<(), Ended> {
        self.step(equations, method, exactly)?;
        if is_endless(method, self.begin, self.last) || method.counts().evaluations > self.pass.most {
            return Err(Ended::Halted(too_many(equations, method)));
        }
        if !self.outputs.conduct.goes_on(method.t(), self.last) {
            return Err(Ended::Halted(Halt::Interrupted));
        }
        let short = self.bends.keep_short(equations, method, self.pass.tolerance);
        let short = short.and_then(|()| self.keep_short(equations, method));
        if short.and_then(|()| self.corners.shorten(equations, method)).is_err() {
            return Err(Ended::Halted(equations.halt()));
        }
        self.springs(equations, method)?;
        // after what is taken on its sides: beyond them nothing is what it seems
        self.keep_assemblies(equations, method).map_err(Ended::Halted)?;
        self.terms = (self.terms.0.max(equations.terms.0), self.terms.1.max(equations.terms.1));
        Ok(())
    }

    /// One step within its bounds; an implicit method takes over where it did in the run before.
    fn step<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        exactly: bool,
    ) -> Result<(), Ended> {
        if !exactly && self.place.is_some() && self.pass.is_stiff(method.t()) {
            return Err(Ended::Stiff);
        }
        self.bound(method);
        let step = method.step(equations);
        if matches!(step, Err(Stopped::Undefined | Stopped::StepTooSmall))
            && let Some(drive) = unbounded(equations, method.y(), method.t() - self.begin)
        {
            return Err(Ended::Halted(Halt::Unbounded { drive }));
        }
        match step {
            Ok(Step::Within | Step::Last) => Ok(()),
            Err(Stopped::Stiff) if exactly => Ok(()),
            Err(Stopped::Stiff) => Err(Ended::Stiff),
            Err(Stopped::TooManySteps) => Err(Ended::Halted(too_many(equations, method))),
            Err(Stopped::Undefined) => Err(Ended::Stuck(equations.halt())),
            Err(Stopped::StepTooSmall) => Err(Ended::Stuck(too_small(equations))),
        }
    }

    /// What rounding makes of accelerations that are small differences of their terms, near the limit of locking.
    pub fn cancelled(&self) -> f64 {
        let (term, left) = self.terms;
        if term > CANCELS * left && left > 0.0 { f64::EPSILON * term / left } else { 0.0 }
    }

    /// The time in which things happen together, s.
    pub fn at_once(&self) -> f64 {
        AT_ONCE * (self.last - self.begin)
    }

    /// Better coordinates where a group comes near a dead position of the present ones.
    pub fn better(
        &mut self,
        equations: &mut Equations<'_, '_>,
        (t, y): (f64, &[f64]),
        charts: &mut Charts<'_>,
    ) -> Option<Change> {
        equations.accepted(t, y);
        let condition = equations.condition();
        if condition >= CAREFUL {
            self.looked_at = CAREFUL;
            return None;
        }
        if condition > AGAIN * self.looked_at {
            return None;
        }
        self.looked_at = condition;
        let Some(found) = charts.better(equations, y) else {
            if equations.cross(y) && condition < CLOSE {
                // what the formulas have said here has few digits
                equations.forget();
                equations.accepted(t, y);
            }
            return None;
        };
        self.looked_at = CAREFUL / AGAIN;
        Some(found)
    }
}

impl Integration<'_, '_> {
    /// Keeps what is wanted before the end of the last step.
    fn keep_within<M: Integrator<f64>>(&mut self, equations: &mut Equations<'_, '_>, method: &mut M) -> bool {
        let mut kept = true;
        while let Some(output) = self.outputs.known.get(self.next).filter(|output| output.0 < method.t()) {
            kept &= self.recorder.keep(equations, method, *output);
            self.next += 1;
        }
        kept
    }

    /// Keeps all that is wanted at the end of the last step and up to an instant as good as there, s, events that happened there
    /// among it.
    pub fn keep<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        (by, done): (f64, bool),
    ) -> bool {
        let mut kept = true;
        while let Some(output) = self.outputs.known.get(self.next).filter(|output| output.0 <= by) {
            kept &= self.recorder.keep(equations, method, *output);
            if output.1 == Origin::Printed {
                self.printed = output.0;
            }
            self.next += 1;
        }
        let here = method.t();
        // the end of the run is printed, wherever it is
        if self.printed < here && (done || (self.watch.any_happened() && self.outputs.prints_events)) {
            kept &= self.recorder.keep(equations, method, (here, Origin::Printed));
            self.printed = here;
        }
        for &(event, which, expect) in &self.outputs.events {
            if self.watch.happened(event) && self.watch.times[event].len() == which {
                kept &= self.recorder.keep(equations, method, (here, Origin::Expected(expect)));
            }
        }
        let ends = done && !std::mem::replace(&mut self.kept_end, done);
        for &expect in self.outputs.end.iter().filter(|_| ends) {
            kept &= self.recorder.keep(equations, method, (here, Origin::Expected(expect)));
        }
        kept
    }
}

impl Integration<'_, '_> {
    /// Ends a step where a body has turned too far for what is looked at within it, and bounds the next one.
    fn keep_short<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) -> Result<(), Undefined> {
        let free = equations.order() > 0;
        if free && !self.watch.comes_again {
            return Ok(());
        }
        let (from, to) = (method.previous_t(), method.t());
        let before = equations.fastest_accepted();
        let after = equations.fastest(to, method.y());
        let turned = (to - from) * before.max(after);
        let most = match self.watch.drawn {
            _ if !free => PRESCRIBED,
            true => self.pass.shorter * DRAWN,
            false => self.pass.shorter * TURN,
        };
        if turned > most {
            method.shorten(equations, from + (to - from) * (most / turned))?;
        }
        let fastest = if turned > most { equations.fastest(method.t(), method.y()) } else { after };
        self.turning = (fastest > 0.0).then(|| most / fastest);
        Ok(())
    }

    /// Bounds the next step.
    pub fn bound<M: Integrator<f64>>(&mut self, method: &mut M) {
        let before = self.pass.before.zip(self.place.as_mut());
        let length = before.and_then(|((trace, part), next)| trace.part(part, next, method.t()));
        let bounds = [self.longest, self.turning, length];
        method.progress_mut().longest = bounds.into_iter().flatten().reduce(f64::min);
    }
}

/// Why no step is short enough where everything has a value.
fn too_small(equations: &mut Equations<'_, '_>) -> Halt {
    match equations.halt() {
        Halt::NotANumber => Halt::NoStep,
        halt => halt,
    }
}

/// The drive of a coordinate that passes in this time, s, a multiple of what is much for it that no motion does.
fn unbounded(equations: &Equations<'_, '_>, y: &[f64], passed: f64) -> Option<usize> {
    let rates = y[equations.order()..].iter().zip(scales(equations));
    let mut rates = rates.zip(equations.reduced.free());
    rates.find(|((rate, scale), _)| rate.abs() * passed > UNBOUNDED * scale).map(|(_, drive)| *drive)
}

/// How far it has come, and at which rate something changes: of the coordinates that of a vibration, of the rates that of a decay.
fn too_many<M: Integrator<f64>>(equations: &Equations<'_, '_>, method: &M) -> Halt {
    let (n, counts) = (equations.order(), method.counts());
    let change = |list: &[f64], before: &[f64], i: usize| (list[i] - before[i]).abs();
    let over = |a: f64, b: f64| if b > 0.0 { a / b } else { 0.0 };
    let rate = (0..n).map(|i| {
        let acceleration = change(method.rates(), method.previous_rates(), n + i);
        let [way, speed] = [i, n + i].map(|i| change(method.y(), method.previous_y(), i));
        over(acceleration, way).sqrt().max(over(acceleration, speed))
    });
    Halt::TooManySteps { steps: counts.steps + counts.rejected, rate: rate.fold(0.0, f64::max) }
}

/// Whether the steps are so short that the run would never come to its end.
#[allow(clippy::cast_precision_loss)] // far below 2^52
fn is_endless<M: Integrator<f64>>(method: &M, first: f64, last: f64) -> bool {
    let counts = method.counts();
    let steps = counts.steps + counts.rejected;
    // what the first steps show of the others is less sure
    let most = (ENDLESS * LOOKED_AT as f64 / steps as f64).max(TOO_MANY);
    steps >= LOOKED_AT && steps as f64 * (last - first) > most * (method.t() - first)
}
