//! Functions over a run: extremes, means and integrals, from series over its steps.

use super::equations::Equations;
use super::event_detector::{AT_ONCE, EventDetector};
use super::part::{is_known, part};
use super::records::within_step;
use crate::answer::{OF_FORCES, OF_MOTION};
use crate::math::lobatto::{PLACES, Short};
use crate::math::ode::Integrator;
use crate::model::{Bound, Cycle, CycleFunction, Part};
use std::f64::consts::TAU;

/// What the series of a function leaves off is less than this part of its greatest value, or of the tolerance of that, or its part
/// of a step is halved, so often at most.
pub(super) const SMOOTH: f64 = 1e-11;
pub(super) const OF_TOLERANCE: f64 = 0.02;
const HALVED: u32 = 2;
/// What changes by no more than this part of its greatest value stays but for rounding.
const DIGITS: f64 = 16.0 * f64::EPSILON;
/// What the series leaves off does not make an extreme greater than by so many times its last terms.
const SURPASSED: f64 = 10.0;

/// A function over the run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OverRun {
    /// Its value, SI.
    pub value: f64,
    /// The greatest magnitude in play.
    pub scale: f64,
    /// Where its extreme is, s; NaN where it is none.
    pub at: f64,
    /// Values that differ by no more are the same but for rounding.
    pub rounding: f64,
    /// Where it was seen to have no value, s.
    pub lost: Option<f64>,
}

/// A function over the run as far as it is known.
pub(super) struct Function<'m> {
    pub(super) cycle: &'m Cycle,
    /// The first function of the same expression.
    source: usize,
    /// Integral, or the extreme.
    value: f64,
    /// Where the extreme is, s.
    at: f64,
    greatest: f64,
    /// How long it was taken, s.
    lasted: f64,
    /// What the series leave off that its value is of, of the greatest.
    left_off: f64,
    /// Where it was seen to have no value, s: from there on it is not looked at.
    lost: Option<f64>,
    /// The extreme is one of a part that does not change.
    stays: bool,
    /// What its series may leave off, however small it is: where it is drawn a part of what is seen, otherwise what is zero of it
    /// but for rounding.
    pub(super) rounding: f64,
    /// All its series, where it is drawn.
    course: Vec<Short>,
}

impl<'m> Function<'m> {
    /// The functions of a file.
    pub fn all(cycles: &'m [Cycle]) -> Vec<Self> {
        let same =
            |c: &Cycle, i: usize| c.expr == cycles[i].expr && c.how.harmonic() == cycles[i].how.harmonic();
        let source = |i: usize| cycles[..i].iter().position(|c| same(c, i)).unwrap_or(i);
        cycles.iter().enumerate().map(|(i, cycle)| Self::new(cycle, source(i))).collect()
    }

    fn new(cycle: &'m Cycle, source: usize) -> Self {
        Self {
            cycle,
            source,
            value: match cycle.how {
                CycleFunction::Max | CycleFunction::Argmax => f64::NEG_INFINITY,
                CycleFunction::Min => f64::INFINITY,
                CycleFunction::Mean | CycleFunction::Integral | CycleFunction::Harmonic(_) => 0.0,
            },
            at: f64::NAN,
            greatest: 0.0,
            lasted: 0.0,
            left_off: 0.0,
            lost: None,
            stays: false,
            rounding: 0.0,
            course: Vec::new(),
        }
    }
}

impl Function<'_> {
    /// The sign with which the extreme that is looked for is the greatest, or nothing.
    const fn sign(&self) -> Option<f64> {
        match self.cycle.how {
            CycleFunction::Max | CycleFunction::Argmax => Some(1.0),
            CycleFunction::Min => Some(-1.0),
            CycleFunction::Mean | CycleFunction::Integral | CycleFunction::Harmonic(_) => None,
        }
    }

    /// Whether the series over a part of a step, through these values, says all there is to say of it.
    fn is_known(&self, series: &Short, values: &[f64; PLACES], smooth: f64) -> bool {
        let smooth = if self.cycle.how == CycleFunction::Argmax { SMOOTH } else { smooth };
        let greatest = greatest(values).max(self.greatest);
        if series.tail() <= (smooth * greatest).max(self.rounding) {
            return true;
        }
        // an extreme that is known already is not surpassed
        self.sign().is_some_and(|sign| {
            let surpasses = |most: f64| sign * self.value > most + SURPASSED * series.tail();
            let most = || {
                let mut most = f64::NEG_INFINITY;
                extremes(series, values, |_, x| most = most.max(sign * x));
                most
            };
            surpasses(most_possible(sign, series)) || surpasses(most())
        })
    }

    /// Takes a part of a step.
    fn take(&mut self, series: &Short, values: &[f64; PLACES], drawn: bool) {
        self.lasted += series.to - series.from;
        self.greatest = self.greatest.max(greatest(values));
        let nothing = if drawn { 0.0 } else { self.rounding };
        let rounding = nothing.max(DIGITS * self.greatest);
        let left_off = if series.tail() > rounding { series.tail() / self.greatest } else { 0.0 };
        let Some(sign) = self.sign() else {
            self.value += series.integral();
            self.left_off = self.left_off.max(left_off);
            return;
        };
        if most_possible(sign, series) < sign * self.value {
            return;
        }
        let stays = varies(series) <= rounding;
        extremes(series, values, |t, x| {
            // of what does not change the first instant counts
            let by = if stays || self.stays { rounding } else { 0.0 };
            if sign * x > sign * self.value + by {
                (self.value, self.at, self.left_off, self.stays) = (x, t, left_off, stays);
            }
        });
    }
}

/// What a series, or its opposite, is at most.
fn most_possible(sign: f64, series: &Short) -> f64 {
    let (least, greatest) = series.bounds();
    if sign > 0.0 { greatest } else { -least }
}

fn greatest(values: &[f64; PLACES]) -> f64 {
    values.iter().fold(0.0_f64, |most, x| most.max(x.abs()))
}

/// How much a series changes at most, up or down from its middle.
fn varies(series: &Short) -> f64 {
    series.coefficients()[1..].iter().map(|c| c.abs()).sum()
}

/// Tells of both ends and where a series turns, with the value there.
fn extremes(series: &Short, values: &[f64; PLACES], mut found: impl FnMut(f64, f64)) {
    found(series.from, values[0]);
    series.turns(&mut found);
    found(series.to, values[PLACES - 1]);
}

/// Memory for the functions over a part of a step.
#[derive(Default)]
pub(super) struct Memory {
    /// Parts of the step that are to be looked at, each with how often it may be halved.
    parts: Vec<(f64, f64, u32)>,
    /// Functions that count there.
    asked: Vec<usize>,
    /// The first functions of their expressions.
    sets: Vec<usize>,
    /// Of each function that counts, which of those.
    set_of: Vec<usize>,
    /// Values of each expression.
    values: Vec<[f64; PLACES]>,
    series: Vec<Short>,
}

impl EventDetector<'_> {
    /// Takes all functions over the last step.
    pub(super) fn functions_in<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) {
        if self.functions.is_empty() || self.bare {
            return;
        }
        let mut memory = std::mem::take(&mut self.memory);
        self.kinks.find(equations, method);
        // the first part is the last one in
        let mut to = method.t();
        for from in self.kinks.found.iter().rev().copied().chain([method.previous_t()]) {
            memory.parts.push((from, to, HALVED + self.finer));
            to = from;
        }
        while let Some((from, to, left)) = memory.parts.pop() {
            let known = self.functions_between(equations, method, ((from, to), left == 0), &mut memory);
            if !known {
                let middle = 0.5 * (from + to);
                memory.parts.extend([(middle, to, left - 1), (from, middle, left - 1)]);
            }
        }
        self.memory = memory;
    }

    /// Takes all functions over a part of the last step; `false`, and nothing is taken, where it is too long for their series. With
    /// `anyway` it is taken however long it is.
    fn functions_between<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        ((from, to), anyway): ((f64, f64), bool),
        memory: &mut Memory,
    ) -> bool {
        self.ask((from, to), memory);
        if memory.asked.is_empty() {
            return true;
        }
        // first few places: most parts are far from an extreme
        for (first, apart, step) in [(0, 4, 4), (2, 4, 2), (1, 2, 1)] {
            for place in (first..PLACES).step_by(apart) {
                let t = self.places.at(from, to, place);
                if within_step(equations, method, t, &mut self.y) {
                    self.note(equations, (t, place), memory);
                }
            }
            let Memory { asked, set_of, values, series, .. } = memory;
            series.clear();
            series.extend(values.iter().map(|values| self.places.series(from, to, values, step)));
            let each = || asked.iter().zip(&*set_of).map(|(&f, &set)| (f, &series[set], &values[set]));
            let known = each().all(|(f, series, values)| {
                let function = &self.functions[f];
                function.lost.is_some() || function.is_known(series, values, self.smooth)
            });
            if known || (anyway && step == 1) {
                for (f, series, values) in each() {
                    let function = &mut self.functions[f];
                    if function.lost.is_some() {
                        continue;
                    }
                    function.take(series, values, self.drawn);
                    if self.drawn && function.source == f {
                        function.course.push(*series);
                    }
                }
                return true;
            }
        }
        false
    }

    /// Which functions count over a part of the last step, without values yet.
    fn ask(&self, (from, to): (f64, f64), memory: &mut Memory) {
        let near = AT_ONCE * self.length;
        let counts = |function: &Function<'_>| {
            let (after, before) = part(function.cycle, &self.times);
            from >= after - near && to <= before + near
        };
        let Memory { asked, sets, set_of, values, .. } = memory;
        asked.clear();
        let looked_at = |f: &usize| self.functions[*f].lost.is_none() && counts(&self.functions[*f]);
        asked.extend((0..self.functions.len()).filter(looked_at));
        // several functions may be of one expression
        sets.clear();
        set_of.clear();
        for &f in asked.iter() {
            let source = self.functions[f].source;
            set_of.push(sets.iter().position(|&set| set == source).unwrap_or_else(|| {
                sets.push(source);
                sets.len() - 1
            }));
        }
        values.clear();
        values.resize(sets.len(), [f64::NAN; PLACES]);
    }

    /// Notes the values of what counts at a place of the step, where they have any with the unknowns there.
    fn note(&mut self, equations: &mut Equations<'_, '_>, (t, place): (f64, usize), memory: &mut Memory) {
        if equations.observe(t, &self.y, self.deep_functions) {
            if place == 0 && !self.drawn {
                self.look_at_rounding(equations, memory);
            }
            for (values, &source) in memory.values.iter_mut().zip(&memory.sets) {
                let cycle = self.functions[source].cycle;
                let share = (t - self.begin) / self.length;
                let weight = cycle.how.harmonic().map_or(1.0, |term| term.weight(TAU * share));
                values[place] = weight * equations.value(&cycle.expr);
            }
            for (&f, &set) in memory.asked.iter().zip(&memory.set_of) {
                if !memory.values[set][place].is_finite() {
                    let lost = &mut self.functions[f].lost;
                    *lost = Some(lost.map_or(t, |before| before.min(t)));
                }
            }
        }
    }

    /// What is zero of the functions that count but for rounding.
    fn look_at_rounding(&mut self, equations: &mut Equations<'_, '_>, memory: &Memory) {
        equations.look_at_sizes();
        let grows = if self.deep_functions { OF_FORCES } else { OF_MOTION };
        for &f in &memory.asked {
            let function = &mut self.functions[f];
            let nothing = equations.nothing(&function.cycle.expr, grows);
            function.rounding = function.rounding.max(nothing);
        }
    }

    /// What the series of all functions leave off that their values are of, of the greatest.
    pub fn left_off(&self) -> f64 {
        let counts = |function: &&Function<'_>| self.drawn || function.greatest > function.rounding;
        self.functions.iter().filter(counts).map(|function| function.left_off).fold(0.0, f64::max)
    }

    /// The first instant within a step at which the part of a function begins or ends.
    pub fn bound(&self, (from, to): (f64, f64)) -> Option<f64> {
        let near = AT_ONCE * self.length;
        let bounds = self.functions.iter().flat_map(|f| [f.cycle.part.after, f.cycle.part.before]);
        let instants = bounds.flatten().filter_map(|bound| match bound {
            Bound::At(t) => Some(t),
            Bound::Event(..) => None,
        });
        instants.filter(|t| from + near < *t && *t < to - near).min_by(f64::total_cmp)
    }

    /// The series of each function that is drawn, in order of time.
    pub fn courses(&self) -> Vec<Vec<Short>> {
        self.functions.iter().map(|function| self.functions[function.source].course.clone()).collect()
    }

    /// The functions over the run up to its end.
    pub fn functions(&self, end: f64) -> Vec<OverRun> {
        let whole = |f: &Function<'_>| f.cycle.part == Part::default();
        let length = |f: &Function<'_>| if whole(f) { end - self.begin } else { f.lasted };
        let value = |f: &Function<'_>| match f.cycle.how {
            _ if f.lost.is_some() => f64::NAN,
            _ if !whole(f) && !is_known(f.cycle, &self.times) => f64::NAN,
            CycleFunction::Mean => f.value / length(f),
            CycleFunction::Harmonic(_) => 2.0 * f.value / length(f),
            CycleFunction::Argmax => f.at,
            CycleFunction::Max | CycleFunction::Min | CycleFunction::Integral => f.value,
        };
        // what its value, its greatest magnitude and its rounding are multiplied by
        let times = |f: &Function<'_>| if f.cycle.how == CycleFunction::Integral { length(f) } else { 1.0 };
        let over = |f: &Function<'_>| {
            let (found, lost) = (value(f), f.lost);
            // of what is zero everywhere the first instant counts
            let nothing = !self.drawn && f.greatest <= f.rounding;
            let at = if nothing { self.begin } else { f.at };
            if f.cycle.how == CycleFunction::Argmax {
                let value = if nothing && !found.is_nan() { at } else { found };
                return OverRun { value, scale: end - self.begin, at, rounding: 0.0, lost };
            }
            let rounding = if self.drawn { 0.0 } else { f.rounding * times(f) };
            let value = if found.abs() <= rounding { 0.0 } else { found };
            OverRun { value, scale: f.greatest * times(f), at, rounding, lost }
        };
        self.functions.iter().map(over).collect()
    }
}
