//! Solves the mechanism anywhere on the sweep.

use super::super::assemble::assemble;
use super::super::failure::Cause;
use super::super::inputs::Rates;
use super::super::steps::StepLimit;
use super::super::track::{Tracker, continued};
use super::depends::{
    asks_for_angles, asks_for_ideal, depends_on_forces, is_ideal, loads_name_quantities, names_quantity,
};
use super::interval::Interval;
use super::switches::Switch;
use crate::answer::{LeftCurve, Measured, PoseAnswers, Sizes, Undefined, WholeCycle, balanced, is_zero};
use crate::model::{Expr, Harmonic, LoadId, Value};
use crate::plan::{Level, Settings};
use crate::position::{BodyState, Branch, DEAD, DriveValue, Model, State, extent};
use std::collections::HashMap;

/// The fewest intervals between places where the mechanism is known beforehand.
const FEWEST: f64 = 64.0;

/// A place where the mechanism is known that lies so near to a change point, as a part of an interval, is on neither side of it.
const AT_CHANGE: f64 = 1e-3;
/// Below this |σ| rates have lost digits that a picture shows.
const BLURRED: f64 = 1e-4;
/// What they lose before that, in ε/σ³.
const BLURS: f64 = 16.0;

/// A place where the mechanism is known: its assemblies, its bodies and their angles.
struct Anchor {
    branches: Vec<Branch>,
    bodies: Vec<BodyState>,
    angles: Vec<f64>,
}

impl Anchor {
    fn of(tracker: &Tracker) -> Self {
        Self {
            branches: tracker.state.branches.clone(),
            bodies: tracker.state.motion.bodies.clone(),
            angles: tracker.angles.clone(),
        }
    }
}

/// How much is computed at a place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Need {
    forces: bool,
    ideal: bool,
    quantities: bool,
}

impl Need {
    fn of(model: &Model<'_>, expr: &Expr) -> Self {
        let forces = depends_on_forces(model.mechanism, expr);
        Self {
            forces,
            ideal: forces
                && model.plan.effects.loses()
                && (asks_for_ideal(model.mechanism) || is_ideal(model.mechanism, expr)),
            // rounding of forces is small against the loads
            quantities: names_quantity(model.mechanism, expr)
                || (forces && loads_name_quantities(model.mechanism)),
        }
    }

    const fn covers(self, other: Self) -> bool {
        (self.forces || !other.forces)
            && (self.ideal || !other.ideal)
            && (self.quantities || !other.quantities)
    }
}

/// A number at a place, with its size.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub value: f64,
    pub size: f64,
}

/// Solves the mechanism at places of the sweep.
pub(super) struct Sampler<'a> {
    model: Model<'a>,
    pub interval: &'a Interval,
    /// What a series may leave off, of the greatest value, where it is as long as the sweep.
    pub tolerance: f64,
    /// What is no greater than this is rounding, SI.
    pub rounding: f64,
    rates: Rates,
    anchors: Vec<Anchor>,
    /// At the last place that closed, where the sweep does not up to its end.
    stuck: Option<Tracker>,
    /// Where a group changes to its other assembly.
    changes: Vec<f64>,
    /// Intervals between the anchors of the whole sweep.
    intervals: f64,
    /// Memory for the drives.
    values: Vec<DriveValue>,
    state: State,
    angles: Vec<f64>,
    evaluated: Vec<(LoadId, Value)>,
    quantities: Vec<Value>,
    sizes: Sizes,
    ideal: Option<(State, Vec<Value>)>,
    with_angles: bool,
    loads_name_quantities: bool,
    /// Beyond this place the mechanism does not close.
    open: Option<f64>,
    last: Option<(f64, Need)>,
    /// Numbers that are computed at every place together, and kept.
    shared: Vec<Expr>,
    need: Need,
    /// How much is computed for the other numbers.
    needs: Vec<(Expr, Need)>,
    kept: HashMap<u64, (usize, f64)>,
    /// The least |σ| of the groups where a number was found last.
    conditioning: f64,
    numbers: Vec<Measured>,
    /// The numbers are drawn.
    drawn: bool,
    /// Positions looked at since `begin`.
    pub samples: usize,
    /// Roots of functions that switch, as far as they are known.
    pub switched: Vec<(Switch, Vec<f64>)>,
    /// The numbers are multiplied by this term of a Fourier series.
    pub term: Option<Harmonic>,
    /// The first curve that was needed beyond its table.
    pub left: Option<LeftCurve>,
}

impl<'a> Sampler<'a> {
    /// Follows the sweep once, in small steps.
    pub(crate) fn new(
        model: &Model<'a>,
        statics: &WholeCycle,
        interval: &'a Interval,
    ) -> Result<Self, Cause> {
        let rates = Rates::of(model, statics);
        let mut state = State::new(model.plan);
        rates.at(&interval.from, &mut state.motion.inputs);
        let state = assemble(model, state)?;
        let mut tracker = Tracker::new(model, state.clone(), &interval.from);
        let count = StepLimit::of(model).steps(&interval.from, &interval.to).max(FEWEST);
        let mut anchors = vec![Anchor::of(&tracker)];
        let mut values = interval.from.clone();
        let (mut open, mut changes) = (None, Vec::new());
        let mut done = 0.0;
        while done < count {
            done += 1.0;
            values.clear();
            values.extend(interval.values(done / count));
            match tracker.advance_to(model, &rates, &values) {
                Ok(switched) => changes.extend(switched.iter().filter_map(|s| interval.share(&s.at))),
                Err(_) => {
                    open = Some(done / count);
                    break;
                }
            }
            anchors.push(Anchor::of(&tracker));
        }
        Ok(Self {
            model: *model,
            interval,
            tolerance: model.plan.settings.samples,
            rounding: 0.0,
            rates,
            anchors,
            changes,
            intervals: count,
            values,
            angles: tracker.angles.clone(),
            stuck: open.map(|_| tracker),
            state,
            evaluated: Vec::new(),
            quantities: Vec::new(),
            sizes: Sizes::new(model.mechanism.quantities.len()),
            ideal: None,
            with_angles: asks_for_angles(model.mechanism),
            loads_name_quantities: loads_name_quantities(model.mechanism),
            open,
            last: None,
            shared: Vec::new(),
            need: Need::default(),
            needs: Vec::new(),
            kept: HashMap::new(),
            conditioning: 1.0,
            numbers: Vec::new(),
            drawn: false,
            samples: 0,
            switched: Vec::new(),
            term: None,
            left: None,
        })
    }

    /// For pictures: goes on over places where the mechanism does not close, as the positions of the sweep do; whether there are none.
    pub(super) fn draw(&mut self, model: &Model<'a>) -> bool {
        self.drawn = true;
        let Some(mut tracker) = self.stuck.take() else { return true };
        self.open = None;
        let mut gap = 0;
        #[allow(clippy::cast_precision_loss)] // up to 20,000
        while self.anchors.len() as f64 <= self.intervals {
            let values: Vec<DriveValue> =
                self.interval.values(self.anchors.len() as f64 / self.intervals).collect();
            let closes = gap == 0 && tracker.advance_to(model, &self.rates, &values).is_ok();
            if closes {
                self.anchors.push(Anchor::of(&tracker));
            } else if tracker.jump(model, &self.rates, &values).is_ok() {
                // places before it are nearer to it than to where the gap began
                if gap > 0 {
                    self.anchors.pop();
                    self.anchors.push(Anchor::of(&tracker));
                }
                self.anchors.push(Anchor::of(&tracker));
                gap = 0;
            } else {
                self.anchors.push(Anchor::of(&tracker));
                gap += 1;
            }
        }
        false
    }

    /// Whether the bodies stand at the sweep's end as at its beginning.
    pub(super) fn comes_again(&self) -> bool {
        let (Some(first), Some(last)) = (self.anchors.first(), self.anchors.last()) else { return false };
        let near = 1e-9 * extent(&self.model);
        let mut bodies = first.bodies.iter().zip(&last.bodies);
        bodies.all(|(a, b)| (a.p - b.p).norm() <= near && (a.u - b.u).norm() <= 1e-9)
    }

    /// Waves of that term over the sweep, and turns.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // at most some 1e4
    pub(super) fn waves(&self) -> Option<[usize; 2]> {
        let turns = self.interval.turns.unwrap_or(0.0).abs();
        self.term.map(|term| [0.5 * f64::from(term.halves) * turns, turns].map(|x| x.ceil() as usize))
    }

    /// How accurately places are found.
    pub(super) fn settings(&self) -> Settings {
        self.model.plan.settings
    }

    /// Intervals between equally spaced places where the mechanism is known beforehand.
    pub(super) fn intervals(&self) -> f64 {
        self.intervals
    }

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 0 to 20,000
    fn nearest(&self, s: f64) -> usize {
        let mut index = (s * self.intervals).round().max(0.0) as usize;
        let last = self.anchors.len() - 1;
        for change in &self.changes {
            let apart = index as f64 - change * self.intervals;
            // at the change itself both assemblies are one
            if s > *change && apart < AT_CHANGE {
                index = (change * self.intervals + AT_CHANGE).ceil() as usize;
            } else if s < *change && apart > -AT_CHANGE {
                index = (change * self.intervals - AT_CHANGE).floor().max(0.0) as usize;
            }
        }
        index.min(last)
    }

    /// From now on these numbers are computed together. What they depend on must be known.
    pub(super) fn share(&mut self, exprs: impl Iterator<Item = Expr>) {
        self.shared.clear();
        for expr in exprs {
            if !self.shared.contains(&expr) {
                self.shared.push(expr);
            }
        }
        self.need = self.shared.iter().map(|e| Need::of(&self.model, e)).fold(Need::default(), |a, b| Need {
            forces: a.forces || b.forces,
            ideal: a.ideal || b.ideal,
            quantities: a.quantities || b.quantities,
        });
        self.kept.clear();
        self.numbers.clear();
        self.last = None;
    }

    /// How much is computed for a number.
    pub(super) fn need_of(&mut self, expr: &Expr) -> Need {
        if let Some(known) = self.needs.iter().find(|known| known.0 == *expr) {
            return known.1;
        }
        let need = Need::of(&self.model, expr);
        self.needs.push((expr.clone(), need));
        need
    }

    pub(super) const fn begin(&mut self) {
        self.samples = 0;
        self.last = None;
    }

    /// The value of a number at a place of the sweep, with its size.
    pub(super) fn sample(&mut self, statics: &WholeCycle, s: f64, expr: &Expr) -> Result<Sample, Undefined> {
        let found = self.found(statics, s, expr)?;
        match found.value {
            Value::Scalar(value) if value.is_finite() && !found.size.is_nan() => {
                let weight = self.term.map_or(1.0, |term| term.weight(self.interval.value(s)));
                return Ok(Sample { value: weight * value, size: found.size });
            }
            _ => {}
        }
        if self.model.mechanism.has_curves && self.left.is_none() {
            let need = self.need_of(expr);
            self.solve(statics, s, need)?;
            let view = self.view(statics);
            self.left = view.left_curve(expr).or_else(|| view.left_by_loads());
        }
        Err(Undefined::At(self.interval.place(s)))
    }

    fn found(&mut self, statics: &WholeCycle, s: f64, expr: &Expr) -> Result<Measured, Undefined> {
        match self.shared.iter().position(|e| e == expr) {
            Some(which) => self.together(statics, s, which),
            None => {
                let need = self.need_of(expr);
                self.measured(statics, s, expr, need)
            }
        }
    }

    /// A number at a place of the sweep: 0 where it is rounding, infinite at a pole, not a number where it has no value and where a
    /// change point is so near that it has lost its digits.
    pub(super) fn number(&mut self, statics: &WholeCycle, s: f64, expr: &Expr) -> f64 {
        match self.found(statics, s, expr) {
            Ok(Measured { value: Value::Scalar(x), size })
                if self.conditioning > BLURRED && !(x.is_finite() && size.is_nan()) =>
            {
                // the error of accelerations grows as 1/σ³
                let blurs = BLURS * f64::EPSILON / self.conditioning.powi(3);
                let is_rounding = is_zero(x, size) || x.abs() <= self.rounding.max(blurs * size);
                if is_rounding { 0.0 } else { x }
            }
            _ => f64::NAN,
        }
    }

    /// One of the shared numbers: all are computed at a place that is new.
    fn together(&mut self, statics: &WholeCycle, s: f64, which: usize) -> Result<Measured, Undefined> {
        let known = self.kept.get(&s.to_bits()).copied();
        let first = match known {
            Some((first, conditioning)) => {
                self.samples += 1;
                self.conditioning = conditioning;
                first
            }
            None => {
                self.solve(statics, s, self.need)?;
                let first = self.numbers.len();
                let mut numbers = std::mem::take(&mut self.numbers);
                let view = self.view(statics);
                numbers.extend(self.shared.iter().map(|e| view.measured(e, &self.sizes)));
                self.numbers = numbers;
                self.conditioning = self.least_conditioning();
                self.kept.insert(s.to_bits(), (first, self.conditioning));
                first
            }
        };
        Ok(self.numbers[first + which])
    }

    /// The value of an expression at a place of the sweep, with its size.
    pub(super) fn measured(
        &mut self,
        statics: &WholeCycle,
        s: f64,
        expr: &Expr,
        need: Need,
    ) -> Result<Measured, Undefined> {
        self.solve(statics, s, need)?;
        self.conditioning = self.least_conditioning();
        Ok(self.view(statics).measured(expr, &self.sizes))
    }

    fn least_conditioning(&self) -> f64 {
        self.state.motion.conditions.iter().fold(1.0, |least: f64, c| least.min(c.abs()))
    }

    fn view<'v>(&'v self, statics: &'v WholeCycle) -> PoseAnswers<'v> {
        let ideal = self.ideal.as_ref().map(|(state, values)| (state, values.as_slice()));
        let view = PoseAnswers::new(&self.model, &self.state, &self.angles, statics);
        PoseAnswers { quantities: &self.quantities, frictionless: ideal, ..view }
    }

    fn solve(&mut self, statics: &WholeCycle, s: f64, need: Need) -> Result<(), Undefined> {
        if self.last.is_some_and(|(at, done)| at == s && done.covers(need)) {
            return Ok(());
        }
        self.last = None;
        if self.open.is_some_and(|open| s >= open) {
            return Err(Undefined::Open(self.interval.place(s)));
        }
        self.samples += 1;
        let model = self.model;
        self.start(s);
        self.state.run_planned_motion(model.plan);
        if self.state.motion.open.is_some() {
            return Err(Undefined::Open(self.interval.place(s)));
        }
        let singular = |conditions: &[f64]| conditions.iter().any(|c| c.abs() <= DEAD);
        if model.plan.effects.level > Level::Positions && singular(&self.state.motion.conditions) {
            return Err(Undefined::At(self.interval.place(s)));
        }
        if self.with_angles {
            self.follow_angles(s);
        }
        if need.forces {
            let quantities = self.loads_name_quantities;
            balanced(&model, statics, &mut self.state, &self.angles, &mut self.evaluated, quantities);
            if self.state.forces.locked {
                return Err(Undefined::Locked(self.interval.place(s)));
            }
            if singular(&self.state.forces.conditions) {
                return Err(Undefined::At(self.interval.place(s)));
            }
        }
        self.ideal = need.ideal.then(|| self.without_friction(statics));
        // none of another place
        self.quantities.clear();
        if need.quantities {
            let memory = std::mem::take(&mut self.quantities);
            self.quantities = self.view(statics).all_quantities_in(memory);
        }
        // what is drawn has no size of where it has lost its digits
        if !self.drawn || self.least_conditioning() > BLURRED {
            let mut sizes = std::mem::take(&mut self.sizes);
            sizes.update_max(&self.view(statics));
            self.sizes = sizes;
        }
        self.last = Some((s, need));
        Ok(())
    }

    fn without_friction(&self, statics: &WholeCycle) -> (State, Vec<Value>) {
        let mut state = self.state.clone();
        state.run_again_without_friction(self.model.plan);
        let values = PoseAnswers::new(&self.model, &state, &self.angles, statics).all_quantities();
        (state, values)
    }

    /// Puts the state at the nearest place that is known, with the drives where they are asked for.
    fn start(&mut self, s: f64) {
        let anchor = &self.anchors[self.nearest(s)];
        self.state.branches.clone_from_slice(&anchor.branches);
        self.state.motion.bodies.clone_from_slice(&anchor.bodies);
        self.state.motion.open = None;
        self.state.forces.locked = false;
        self.values.clear();
        self.values.extend(self.interval.values(s));
        self.rates.at(&self.values, &mut self.state.motion.inputs);
    }

    /// Angles carried on from the nearest place that is known.
    fn follow_angles(&mut self, s: f64) {
        let anchor = &self.anchors[self.nearest(s)];
        let known = anchor.bodies.iter().zip(&anchor.angles);
        for (angle, (body, (old, before))) in
            self.angles.iter_mut().zip(self.state.motion.bodies.iter().zip(known))
        {
            *angle = continued(*before, old.u, body.u);
        }
    }
}
