//! The equations of the free coordinates as a system of the first order: y holds the coordinates, their rates, and the work of
//! all loads since the first instant.

use super::chart::Chart;
use super::drives::{moves, prescribed};
use super::loads::{efforts_of_stops, loads_need_angles, sides};
use super::multi_crossing::MultiCrossing;
use super::setup::{StartState, is_length};
use super::singular_crossing::SingularCrossing;
use super::sliding_sense::Slipping;
use super::stages::Stages;
use super::walk::Walk;
use crate::answer::{Sizes, Switch, WholeCycle};
use crate::math::Vec2;
use crate::math::ode::{System, Undefined};
use crate::model::{DriveTarget, Load, LoadId, Value};
use crate::plan::LoadStep;
use crate::position::{Branch, DriveInput, Model, Motion, Reduced, State, extent};
use crate::solve::cycle::loads_name_quantities;
use crate::solve::failure::Halt;

/// The equations, with the states on which a trial stands.
pub(super) struct Equations<'a, 's> {
    pub model: &'s Model<'a>,
    /// The coordinates, where they are not those written.
    pub chart: Option<&'s Chart>,
    pub written: Vec<DriveTarget>,
    /// The assemblies at the first instant.
    pub begins: &'s [Branch],
    /// The way over the change point that is near.
    pub bridge: Option<Box<SingularCrossing>>,
    /// The same with several free coordinates.
    pub passage: Option<Box<MultiCrossing>>,
    /// When change points were passed, s.
    pub crossed: Vec<f64>,
    /// The same with the friction at rest, where it is another one.
    pub still: Option<&'s Model<'a>>,
    pub statics: &'s WholeCycle,
    /// The first instant, s.
    pub from: f64,
    /// The last one, s, as far as it is known.
    pub last: f64,
    /// What every drive says at the first instant.
    pub first: Vec<DriveInput>,
    pub reduced: Reduced,
    /// The state of the last evaluation.
    pub trial: State,
    at: (f64, Vec<f64>),
    /// The state from which the present step begins, with the angles of its bodies and its instant.
    pub accepted: (f64, State, Vec<f64>),
    /// Angles of the bodies in the last evaluation, where loads depend on them.
    pub angles: Vec<f64>,
    pub loads_need_angles: bool,
    /// The same of the conditions under which they act.
    pub conditions_need_angles: bool,
    /// Some loads are evaluated at every position.
    pub evaluates: bool,
    /// Of them by number, which are the efforts of stops; and whether all are.
    pub of_stops: (Vec<bool>, bool),
    /// Some steps of motion start from where the step began.
    pub goes_on: bool,
    /// The way to what is looked at far ahead.
    pub walk: Option<Box<Walk>>,
    /// Memory for the values of the file's quantities, where loads name them.
    pub quantities: Option<Vec<Value>>,
    /// The same for what is looked at.
    pub memory: Vec<Value>,
    pub evaluated: Vec<(LoadId, Value)>,
    /// What is not smooth in the loads, on the sides where the present step begins.
    pub switches: Vec<Switch<'a>>,
    /// Loads are taken on these sides.
    pub held: bool,
    /// On which sides guides press where the present step begins, at both ends.
    pub sides: Vec<[f64; 2]>,
    /// How everything that rubs moves.
    pub slipping: Option<Box<Slipping>>,
    /// The stops that are closed.
    pub closed: Vec<usize>,
    /// The greatest term of the accelerations where something rubs, and the greatest of what is left of all of them.
    pub terms: (f64, f64),
    /// The greatest of what results are made of, so far.
    pub sizes: Sizes,
    /// What positions, velocities and accelerations on the way over change points are not known to, of the greatest.
    pub rough: [f64; 3],
    /// What was seen of change points since the present step began.
    pub stages: Stages,
    /// Memory for unknowns within a step.
    pub within: Vec<f64>,
    /// Memory for rates that nobody looks at.
    quiet: Vec<f64>,
    /// Why the last evaluation has no value.
    pub why: Option<Halt>,
}

impl<'a, 's> Equations<'a, 's> {
    /// From an assembled state with the angles of its bodies, at an instant, s; in the coordinates of a chart, or those written.
    pub fn new(
        model: &'s Model<'a>,
        begin: &'s StartState<'_>,
        chart: Option<&'s Chart>,
        (t, state, angles): (f64, &State, &[f64]),
    ) -> Self {
        let drives = &model.mechanism.drives;
        let first = begin.first.clone();
        let free: Vec<usize> = (0..drives.len()).filter(|&i| drives[i].free).collect();
        let moved = (0..drives.len()).any(|i| !drives[i].free && (drives[i].of_time || moves(&first[i])));
        let unknowns = 2 * free.len() + 1 + model.mechanism.works.len();
        let angles = angles.to_vec();
        let loads = || model.mechanism.loads.iter();
        let mut trial = state.clone();
        trial.motion.works.resize(model.mechanism.works.len(), 0.0);
        trial.motion.stops.resize(model.mechanism.stops.len(), 0.0);
        trial.motion.sides.clone_from(&begin.state.motion.sides);
        Self {
            model,
            chart,
            still: None,
            written: free.iter().map(|&i| begin.model.mechanism.drives[i].target).collect(),
            begins: &begin.state.branches,
            bridge: None,
            passage: None,
            crossed: Vec::new(),
            statics: begin.statics,
            from: begin.from,
            last: f64::INFINITY,
            first,
            reduced: Reduced::new(model.plan, free, moved),
            trial,
            at: (f64::NAN, vec![f64::NAN; unknowns]),
            accepted: (t, state.clone(), angles.clone()),
            angles,
            loads_need_angles: loads_need_angles(model.mechanism, loads().flat_map(Load::values)),
            conditions_need_angles: loads_need_angles(
                model.mechanism,
                loads().filter_map(|load| load.when.as_ref()),
            ),
            of_stops: efforts_of_stops(model),
            evaluates: model.plan.loads.iter().any(|load| matches!(load, LoadStep::Evaluated(_))),
            goes_on: model.plan.goes_on(),
            walk: None,
            quantities: loads_name_quantities(model.mechanism).then(Vec::new),
            memory: Vec::new(),
            evaluated: Vec::new(),
            switches: Vec::new(),
            held: false,
            sides: Vec::new(),
            slipping: None,
            closed: Vec::new(),
            terms: (0.0, 0.0),
            sizes: Sizes::new(model.mechanism.quantities.len()),
            rough: [0.0; 3],
            stages: Stages::default(),
            within: Vec::new(),
            quiet: vec![0.0; unknowns],
            why: None,
        }
    }

    pub fn order(&self) -> usize {
        self.reduced.free().len()
    }

    /// Whether there is something that rubs.
    pub fn rubs(&self) -> bool {
        self.slipping.as_ref().is_some_and(|slipping| !slipping.senses.is_empty())
    }

    /// Whether something rubs, or stands at a stop.
    fn has_contacts(&self) -> bool {
        self.rubs() || !self.closed.is_empty()
    }

    /// The unknowns at the first instant.
    pub fn start(&self) -> Vec<f64> {
        let free = self.reduced.free();
        let values = free.iter().map(|&i| self.first[i].value);
        let rates = free.iter().map(|&i| self.first[i].rate);
        let works = std::iter::repeat_n(0.0, 1 + self.model.mechanism.works.len());
        values.chain(rates).chain(works).collect()
    }

    /// A length of the mechanism's order, m: what begins far away is not known better than its digits.
    pub fn extent(&self) -> f64 {
        let drives = &self.model.mechanism.drives;
        let lengths = self.reduced.free().iter().filter(|&&i| is_length(self.model, &drives[i]));
        lengths.map(|&i| self.first[i].value.abs()).fold(extent(self.model), f64::max)
    }

    /// Where the present step begins: the instant, s, the state and the angles of its bodies.
    pub fn here(&self) -> (f64, &State, &[f64]) {
        (self.accepted.0, &self.accepted.1, &self.accepted.2)
    }

    /// Position and rate of all drives at an instant, from which steps of motion start where the step began.
    pub fn set_position(&mut self, t: f64, y: &[f64]) {
        self.start_trial();
        self.trial.motion.against.clear();
        self.set_inputs(t, y);
    }

    /// The inputs of all drives at an instant.
    pub fn set_inputs(&mut self, t: f64, y: &[f64]) {
        let motion = &mut self.trial.motion;
        let given = (&self.first[..], self.reduced.free());
        set_inputs(self.model, motion, (t, t - self.from), given, (y, sides(self.held, &self.switches)));
    }

    /// The same in the motion of another state.
    pub fn inputs_at(&self, t: f64, y: &[f64], motion: &mut Motion) {
        let given = (&self.first[..], self.reduced.free());
        set_inputs(self.model, motion, (t, t - self.from), given, (y, sides(self.held, &self.switches)));
    }

    /// Motion and, where it is `deep`, accelerations and forces; `false` where there are none.
    pub fn observe(&mut self, t: f64, y: &[f64], deep: bool) -> bool {
        let mut dy = std::mem::take(&mut self.quiet);
        let known = self.rates(t, y, &mut dy).is_ok();
        let n = self.order();
        // where something rubs, accelerations and forces are there already
        if known && deep && !self.has_contacts() {
            self.reduced.accelerate(&mut self.trial, &dy[n..2 * n]);
            self.force();
        }
        if known {
            self.follow_angles(t);
        }
        self.quiet = dy;
        // what is deep has accelerations that no stage leaves
        if deep || !known {
            self.forget();
        }
        known
    }

    /// The forces, where the file asks for any.
    fn force(&mut self) {
        if self.model.plan.effects.forces {
            self.trial.run_loads_and_forces(self.model, &self.evaluated);
        }
    }

    /// Whether a state was evaluated last.
    pub fn is_at(&self, t: f64, y: &[f64]) -> bool {
        self.at.0.to_bits() == t.to_bits() && self.at.1 == y
    }

    /// What was evaluated last is no state that a step ended with.
    pub const fn forget(&mut self) {
        self.at.0 = f64::NAN;
    }

    /// The greatest angular velocity of a body, rad/s, where the present step begins.
    pub fn fastest_accepted(&self) -> f64 {
        self.fastest_in(&self.accepted.1)
    }

    /// The same at another instant; nothing where the equations have no value.
    pub fn fastest(&mut self, t: f64, y: &[f64]) -> f64 {
        if self.observe(t, y, false) { self.fastest_in(&self.trial) } else { 0.0 }
    }

    /// The same in the state that was evaluated last.
    pub fn fastest_seen(&self) -> f64 {
        self.fastest_in(&self.trial)
    }

    fn fastest_in(&self, state: &State) -> f64 {
        // where nothing is free no step is short for its error: what is at rest for an instant turns soon
        let prescribed = self.order() == 0;
        let soon = |alpha: f64| if prescribed { alpha.abs().sqrt() } else { 0.0 };
        let turning = state.motion.bodies.iter().map(|body| body.omega.abs().max(soon(body.alpha)));
        turning.fold(0.0, f64::max)
    }

    /// Why the equations have no value where the last step ended: the group nearest to a dead position, or the last cause met.
    pub fn halt(&mut self) -> Halt {
        let conditions = self.accepted.1.motion.conditions.iter().enumerate();
        let least = conditions.min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        match (least, self.why.take()) {
            // near a dead position reactions grow, and with them what rubs
            (Some((group, condition)), Some(Halt::Jam)) if condition.abs() < JAMS => {
                Halt::Dead { group, condition: condition.abs() }
            }
            (
                _,
                Some(
                    halt @ (Halt::NoInertia
                    | Halt::NotANumber
                    | Halt::Jam
                    | Halt::StopsAtOnce { .. }
                    | Halt::Shaken { .. }),
                ),
            ) => halt,
            (Some((group, condition)), _) if condition.abs() < NEAR_DEAD => {
                Halt::Dead { group, condition: condition.abs() }
            }
            (_, Some(halt)) => halt,
            (_, None) => Halt::NoStep,
        }
    }

    /// Why M q̈ = Q has no solution: a load, or velocities of a dead position, or no mass.
    pub fn without_acceleration(&self) -> Halt {
        if self.evaluated.iter().any(|(_, value)| !value.is_defined()) {
            return Halt::NotANumber;
        }
        if self.reduced.is_loaded() {
            return Halt::NoInertia;
        }
        let conditions = self.trial.motion.conditions.iter().enumerate();
        let least = conditions.min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        least.map_or(Halt::NotANumber, |(group, _)| Halt::Open { group })
    }

    /// Moves to the position and rates that are set, with the loads there, and finds the accelerations that go with them where nothing
    /// rubs.
    pub fn accelerations_without_friction(&mut self, out: &mut [f64]) -> Result<(), Halt> {
        self.reduced.run_motion(self.model.plan, &mut self.trial);
        if let Some(group) = self.trial.motion.open {
            return Err(Halt::Open { group });
        }
        self.take_against();
        let time = self.trial.motion.time;
        self.evaluate_loads(time);
        self.reduced.load(self.model, &mut self.trial, &self.evaluated);
        match self.reduced.accelerations(out) {
            Some(_) => Ok(()),
            None => Err(self.without_acceleration()),
        }
    }

    /// The least condition figure of the state that was evaluated last.
    pub fn trial_condition(&self) -> f64 {
        least_condition(&self.trial)
    }

    /// The least condition figure of the state from which the present step begins.
    pub fn condition(&self) -> f64 {
        least_condition(&self.accepted.1)
    }
}

fn least_condition(state: &State) -> f64 {
    state.motion.conditions.iter().fold(1.0, |least, c| least.min(c.abs()))
}

/// Below this one friction does so since the position is dead.
const JAMS: f64 = 0.02;
/// Below this condition figure a run that cannot go on stands before a dead position.
const NEAR_DEAD: f64 = 0.1;

impl System<f64> for Equations<'_, '_> {
    fn rates(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Undefined> {
        let n = self.order();
        if let Err(halt) = self.walk_to(y[0]) {
            self.why = Some(halt);
            return Err(Undefined);
        }
        self.set_position(t, y);
        self.trial.motion.stops.fill(0.0);
        if self.has_contacts() {
            self.why = self.slipping_rates(y, dy).err();
            self.stages.note(self.trial_condition());
            self.at.0 = t;
            self.at.1.copy_from_slice(y);
            return if self.why.is_none() { Ok(()) } else { Err(Undefined) };
        }
        self.reduce(y[0]);
        self.stages.note(self.trial_condition());
        if let Some(group) = self.trial.motion.open {
            self.why = Some(Halt::Open { group });
            return Err(Undefined);
        }
        self.evaluate_loads(t);
        let power = self.reduced.load(self.model, &mut self.trial, &self.evaluated);
        let (rates, rest) = dy.split_at_mut(n);
        let (accelerations, work) = rest.split_at_mut(n);
        rates.copy_from_slice(&y[n..2 * n]);
        work[0] = power;
        if self.reduced.accelerations(accelerations).is_none() {
            self.why = Some(self.without_acceleration());
            return Err(Undefined);
        }
        self.powers(&mut work[1..], 1.0);
        self.at.0 = t;
        self.at.1.copy_from_slice(y);
        Ok(())
    }

    fn along(&mut self, q: f64, out: &mut [f64]) -> Result<bool, Undefined> {
        self.mass_and_force(q, out)
    }

    fn accepted(&mut self, t: f64, y: &[f64]) {
        if !self.is_at(t, y) {
            let mut dy = std::mem::take(&mut self.quiet);
            let known = self.rates(t, y, &mut dy).is_ok();
            self.quiet = dy;
            if !known {
                return;
            }
        }
        if let Some(bridge) = self.bridge.take_if(|bridge| bridge.is_left(y[0])) {
            // from here on the assemblies are those on this side
            self.trial.branches.copy_from_slice(bridge.branches(y[0]));
            if bridge.is_behind(y[0]) {
                self.crossed.push(t);
            }
        }
        if let Some(behind) = self.passage.as_mut().and_then(|passage| passage.accept()) {
            self.passage = None;
            if behind {
                self.crossed.push(t);
            }
        }
        self.follow_angles(t);
        if let Some(mut slipping) = self.slipping.take() {
            self.let_go_on(&mut slipping);
            self.slipping = Some(slipping);
        }
        self.accepted.0 = t;
        self.accepted.1.start_from(&self.trial);
        self.accepted.2.clone_from(&self.angles);
        self.stages = Stages::begin(self.condition());
        self.walk_begins(y[0]);
    }
}

/// The inputs of all drives at an instant, s, so long after the first one, from what they say there and from the unknowns.
fn set_inputs(
    model: &Model<'_>,
    motion: &mut Motion,
    (t, elapsed): (f64, f64),
    (first, free): (&[DriveInput], &[usize]),
    (y, switches): (&[f64], &[Switch<'_>]),
) {
    motion.time = t;
    let drives = &model.mechanism.drives;
    for ((input, first), drive) in motion.inputs.iter_mut().zip(first).zip(drives) {
        if drive.free {
            *input = *first;
            continue;
        }
        *input = prescribed(drive, first, (t, elapsed), switches);
    }
    if let Some(works) = y.get(2 * free.len() + 1..) {
        // a state that no trial stands on has no place for them yet
        motion.works.resize(works.len().max(motion.works.len()), 0.0);
        motion.works[..works.len()].copy_from_slice(works);
    }
    let (q, rest) = y.split_at(free.len());
    for ((&drive, q), rate) in free.iter().zip(q).zip(rest) {
        let input = &mut motion.inputs[drive];
        set_value(input, *q);
        (input.rate, input.acceleration) = (*rate, 0.0);
    }
}

fn set_value(input: &mut DriveInput, value: f64) {
    input.value = value;
    input.place = Vec2::direction(value);
}
