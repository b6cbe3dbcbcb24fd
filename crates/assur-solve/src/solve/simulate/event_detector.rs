//! Events of a run.

use super::depends::{Kept, comes_again, is_deep, is_kept, is_linkage};
use super::equations::Equations;
use super::functions::{Function, Memory, OF_TOLERANCE, SMOOTH};
use super::kinks::Kinks;
use super::lookout::Lookout;
use super::options::Drawn;
use super::records::within_step;
use crate::answer::{OF_FORCES, OF_MOTION};
use crate::math::lobatto::Extremes;
use crate::math::ode::Integrator;
use crate::math::ode::event::{Crossing, Touching, first_crossing_or_touch};
use crate::model::{Event, Expr, Mechanism, Situation};

/// Events nearer to each other than this part of the run happen at once.
pub(super) const AT_ONCE: f64 = 1e-12;

/// What rounding leaves of a value that is zero, of its greatest.
const ROUNDING: f64 = 1e-11;

/// An event that was passed is not passed again so soon, times the tolerance, of the run, with values so small in between, of its
/// greatest: a step that ends at a corner ends a little beside it.
const AGAIN: f64 = 10.0;

/// The way in which a value leaves zero is looked at after this part of the step.
const SOON: f64 = 1.0 / 256.0;

/// In shorter steps than this over the greatest angular velocity what is small may be on its way.
const SHORT: f64 = 1e-6;

/// Crossings of one event within a step that are passed over at most.
const MOST_TRIES: usize = 4;

/// What is looked at within every step.
pub(super) struct EventDetector<'m> {
    events: &'m [Event],
    pub(super) functions: Vec<Function<'m>>,
    pub(super) kinks: Kinks,
    /// An event depends on accelerations or forces.
    deep: bool,
    pub(super) deep_functions: bool,
    /// Something looked at may come again with the turns of a body, however smooth its speed is.
    pub comes_again: bool,
    pub(super) places: Extremes,
    /// What series of functions may leave off, of the greatest value.
    pub(super) smooth: f64,
    /// Functions are drawn: their series are kept, and events that change nothing are not looked for.
    pub drawn: bool,
    /// Functions are not taken, and events that change nothing are not looked for.
    pub bare: bool,
    /// Instants of every event, s.
    pub times: Vec<Vec<f64>>,
    /// The way in which an event was passed where the present step begins.
    passed: Vec<Option<bool>>,
    /// What kept the value of an event where it was has ended where the present step begins.
    left: Vec<bool>,
    /// An event that does not count before this instant, s.
    pub guard: Option<(usize, f64)>,
    /// The greatest value of every event.
    greatest: Vec<f64>,
    /// When the value of every event passed zero last, in whatever way, s.
    crossed: Vec<f64>,
    /// Which values are far from zero.
    lookouts: Vec<Lookout>,
    /// Below this part values and times are those of the same event.
    again: f64,
    /// What values are known to, of the greatest.
    known: f64,
    pub(super) y: Vec<f64>,
    pub(super) memory: Memory,
    /// Further halvings of the parts of a step: a term of a high order turns within them.
    pub(super) finer: u32,
    /// How often every event had happened where the last step began.
    begun: Vec<usize>,
    /// The length of the run, s.
    pub(super) length: f64,
    pub(super) begin: f64,
}

/// What ends a step early.
pub(super) struct Happened {
    /// The instant, s.
    pub time: f64,
    /// The events that happen there, and whether their values are above zero behind it.
    events: Vec<(usize, bool)>,
}

impl<'m> EventDetector<'m> {
    pub fn new(equations: &Equations<'m, '_>, (begin, end): (f64, f64), tolerance: f64) -> Self {
        let mechanism = equations.model.mechanism;
        let functions = Function::all(&mechanism.cycles);
        let events = mechanism.events.iter().map(|event| &event.value);
        let all = events.chain(functions.iter().map(|f| &f.cycle.expr));
        let all: Vec<&Expr> = all.collect();
        let deep = mechanism.events.iter().any(|event| is_deep(mechanism, &event.value));
        let deep_functions = functions.iter().any(|f| is_deep(mechanism, &f.cycle.expr));
        let comes_again =
            (!all.is_empty() && is_linkage(mechanism)) || all.iter().any(|expr| comes_again(mechanism, expr));
        let count = mechanism.events.len();
        let terms = mechanism.cycles.iter().filter_map(|c| c.how.harmonic());
        let finest = terms.map(|term| term.halves).max().unwrap_or(0);
        Self {
            events: &mechanism.events,
            functions,
            kinks: Kinks::of(mechanism, &mechanism.cycles, deep_functions, equations.start()),
            deep,
            deep_functions,
            comes_again,
            places: Extremes::new(),
            smooth: SMOOTH.max(OF_TOLERANCE * tolerance),
            drawn: false,
            bare: false,
            times: vec![Vec::new(); count],
            passed: vec![None; count],
            left: vec![false; count],
            guard: None,
            greatest: vec![0.0; count],
            crossed: vec![f64::NEG_INFINITY; count],
            lookouts: vec![Lookout::NEW; count],
            again: AT_ONCE.max(AGAIN * tolerance),
            known: ROUNDING.max(tolerance),
            y: equations.start(),
            memory: Memory::default(),
            finer: finest.checked_ilog2().unwrap_or(0),
            begun: vec![0; count],
            length: end - begin,
            begin,
        }
    }

    /// Functions are found as it takes to draw them.
    pub fn draw(&mut self, drawn: &Drawn<'_>) {
        self.drawn = true;
        self.smooth = self.smooth.max(drawn.smooth);
        for (function, rounding) in self.functions.iter_mut().zip(drawn.roundings) {
            function.rounding = *rounding;
        }
    }

    /// Whether an event is known, and changes nothing.
    fn is_left_out(&self, event: usize) -> bool {
        (self.drawn || self.bare) && !self.events[event].ends
    }

    /// The first events within the last step.
    pub fn first<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) -> Option<Happened> {
        let mut found: Vec<(usize, Crossing<f64>)> = Vec::new();
        let kept = if self.events.is_empty() { Kept::default() } else { equations.kept() };
        for index in 0..self.events.len() {
            let way = self.events[index].rising;
            let step = (method.previous_t(), method.t());
            let passed = self.sense_at_begin(equations, method, index);
            // what it is in is told, not looked for
            let told = self.events[index].situation.is_some();
            if told || self.is_left_out(index) || self.too_early(index, step.1) {
                continue;
            }
            let stands = is_kept(equations.model.mechanism, &kept, &self.events[index].value);
            if stands || (!kept.is_empty() && self.stays(equations, method, index)) {
                continue;
            }
            if passed.is_none() && self.is_far(equations, method, index) {
                continue;
            }
            let crossing = self.crossing(equations, method, index, step, passed);
            if crossing.is_some() && self.is_nothing(equations, method, index) {
                continue;
            }
            // the other way does not count, but what follows it in the same step may
            let (mut counted, mut tries) = (crossing, 0);
            while let Some(crossing) = counted {
                let known = self.is_known(equations, method, index, (step.0, crossing.t));
                // at a touch a strict condition becomes true nowhere
                let other = way.is_some_and(|rising| rising != crossing.rising)
                    || (crossing.touches && self.events[index].strict);
                if !known && !other && !self.too_early(index, crossing.t) {
                    break;
                }
                if !known {
                    self.crossed[index] = crossing.t;
                }
                let rest = (crossing.t, step.1);
                tries += 1;
                counted = if tries < MOST_TRIES && rest.0 < rest.1 {
                    self.crossing(equations, method, index, rest, Some(crossing.leads_up()))
                } else {
                    None
                };
            }
            found.extend(counted.map(|crossing| (index, crossing)));
        }
        let earliest =
            |of: &mut dyn Iterator<Item = &Crossing<f64>>| of.map(|c| c.t).fold(f64::INFINITY, f64::min);
        let first = earliest(&mut found.iter().map(|(_, c)| c));
        // a touch is found to fewer digits: it has the time of a crossing so near
        let near = self.again * self.length;
        let crossed =
            earliest(&mut found.iter().map(|(_, c)| c).filter(|c| !c.touches && c.t - first <= near));
        let time = if crossed.is_finite() { crossed } else { first };
        let at_once = |crossing: &Crossing<f64>| {
            crossing.t - time <= if crossing.touches { near } else { AT_ONCE * self.length }
        };
        let events = found.iter().filter(|(_, c)| at_once(c)).map(|(i, c)| (*i, c.leads_up())).collect();
        time.is_finite().then_some(Happened { time, events })
    }

    /// Whether a value stays zero in the last step but for rounding: it is one of what rests.
    fn stays<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        index: usize,
    ) -> bool {
        let most = ROUNDING * self.greatest[index];
        self.stays_below(equations, method, (index, most))
    }

    /// Whether it stays below what rounding makes of the terms it is made of.
    fn is_nothing<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        index: usize,
    ) -> bool {
        let value = &self.events[index].value;
        self.value(equations, method, method.t(), value);
        equations.look_at_sizes();
        let grows = if self.deep { OF_FORCES } else { OF_MOTION };
        let most = equations.nothing(value, grows);
        // in a step of no length nothing changes: there it must have been nothing all the time
        let short = (method.t() - method.previous_t()) * equations.sizes.turning() < SHORT;
        (!short || self.greatest[index] <= most) && self.stays_below(equations, method, (index, most))
    }

    fn stays_below<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        (index, most): (usize, f64),
    ) -> bool {
        let (from, to) = (method.previous_t(), method.t());
        let value = &self.events[index].value;
        [from, from + 0.4 * (to - from), to]
            .into_iter()
            .all(|t| self.value(equations, method, t, value).abs() <= most)
    }

    fn crossing<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        index: usize,
        step: (f64, f64),
        passed: Option<bool>,
    ) -> Option<Crossing<f64>> {
        let value = &self.events[index].value;
        let touching = Touching { part: self.known, greatest: self.greatest[index] };
        let (from, length) = (method.previous_t(), method.t() - method.previous_t());
        first_crossing_or_touch(step, passed, touching, |t| {
            let value = self.value(equations, method, t, value);
            self.greatest[index] = self.greatest[index].max(value.abs());
            self.lookouts[index].note((t - from) / length, value);
            value
        })
    }

    /// Whether a value stays far from zero in the last step.
    fn is_far<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &M,
        index: usize,
    ) -> bool {
        let (expr, deep) = (&self.events[index].value, self.deep);
        self.lookouts[index].is_far(equations, method, |equations, t, y| {
            if equations.observe_again(t, y, deep) { equations.value(expr) } else { f64::NAN }
        })
    }

    /// Whether an event at an instant is the one that happened last: its value has stayed as good as zero since.
    fn is_known<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        index: usize,
        (from, t): (f64, f64),
    ) -> bool {
        let last = self.crossed[index];
        if t - last > self.again * self.length {
            return false;
        }
        let middle = 0.5 * (last.max(from) + t);
        let value = self.value(equations, method, middle, &self.events[index].value);
        value.abs() <= self.again * self.greatest[index]
    }

    fn value<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        t: f64,
        expr: &Expr,
    ) -> f64 {
        let known =
            within_step(equations, method, t, &mut self.y) && equations.observe(t, &self.y, self.deep);
        if known { equations.value(expr) } else { f64::NAN }
    }

    /// In which way an event was passed where the last step begins; where its value was kept until then, the way in which it leaves.
    fn sense_at_begin<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        index: usize,
    ) -> Option<bool> {
        if !self.left[index] {
            return self.passed[index];
        }
        let (from, to) = (method.previous_t(), method.t());
        let value = &self.events[index].value;
        let soon = self.value(equations, method, from + SOON * (to - from), value);
        Some(soon > 0.0)
    }

    /// These pairs move again from here on: what they kept zero leaves it, and is not passed.
    pub fn moves_again(&mut self, mechanism: &Mechanism, kept: &Kept) {
        for (event, left) in self.events.iter().zip(&mut self.left) {
            *left |= !kept.is_empty() && is_kept(mechanism, kept, &event.value);
        }
    }

    /// From here nothing moves: what is zero stays so and was not passed.
    pub fn rests(&mut self) {
        self.passed.fill(None);
    }

    /// The value of every event.
    pub fn values(&mut self, equations: &mut Equations<'_, '_>, t: f64, y: &[f64]) -> Vec<f64> {
        let known = !self.events.is_empty() && equations.observe(t, y, self.deep);
        let value = |event: &Event| if known { equations.value(&event.value) } else { f64::NAN };
        let values: Vec<f64> = self.events.iter().map(value).collect();
        for (greatest, value) in self.greatest.iter_mut().zip(&values) {
            *greatest = greatest.max(value.abs());
        }
        values
    }

    /// The state has jumped: what passed zero by it happens, what was zero turns back. Returns the event that ends the run.
    pub fn jumped(
        &mut self,
        equations: &mut Equations<'_, '_>,
        (t, y): (f64, &[f64]),
        (before, kept): (&[f64], &Kept),
    ) -> Option<usize> {
        let mechanism = equations.model.mechanism;
        let after = self.values(equations, t, y);
        let mut ends = None;
        for (index, (before, after)) in before.iter().zip(&after).enumerate() {
            if self.is_left_out(index) {
                continue;
            }
            if let Some(passed) = self.passed[index] {
                // it was reached with the stop, and is left as the stop is
                self.passed[index] = if equations.is_held() { None } else { Some(!passed) };
                continue;
            }
            let rising = after > before;
            let event = &self.events[index];
            let stays = after.abs() <= ROUNDING * self.greatest[index];
            let left = is_kept(mechanism, kept, &event.value);
            if before * after < 0.0 && !stays && !left && event.rising.is_none_or(|way| way == rising) {
                self.times[index].push(t);
                ends = ends.or(event.ends.then_some(index));
            }
        }
        ends
    }

    fn too_early(&self, event: usize, t: f64) -> bool {
        self.guard.is_some_and(|(guarded, from)| event == guarded && t < from)
    }

    /// The motion comes into a situation, or out of it. Returns the event that ends the run.
    pub fn situation(&mut self, situation: Situation, begins: bool, t: f64) -> Option<usize> {
        let mut ends = None;
        for (index, event) in self.events.iter().enumerate() {
            if event.situation == Some((situation, begins)) && !self.too_early(index, t) {
                self.times[index].push(t);
                ends = ends.or(event.ends.then_some(index));
            }
        }
        ends
    }

    /// What happens from now on is new.
    pub fn begin(&mut self) {
        self.begun.iter_mut().zip(&self.times).for_each(|(begun, times)| *begun = times.len());
    }

    /// Whether an event has happened since.
    pub fn happened(&self, event: usize) -> bool {
        self.times[event].len() > self.begun[event]
    }

    pub fn any_happened(&self) -> bool {
        (0..self.times.len()).any(|event| self.happened(event))
    }

    /// A step has ended, at events or not. Returns the event that ends the run.
    pub fn detect<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        happened: Option<Happened>,
    ) -> Option<usize> {
        self.functions_in(equations, method);
        self.passed.fill(None);
        self.left.fill(false);
        let mut ends = None;
        for (index, rising) in happened.into_iter().flat_map(|h| h.events) {
            // at rest a value stays where it is
            self.passed[index] = Some(rising);
            self.times[index].push(method.t());
            self.crossed[index] = method.t();
            if self.events[index].ends {
                ends = ends.or(Some(index));
            }
        }
        ends
    }
}
