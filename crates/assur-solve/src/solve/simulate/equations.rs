//! The equations of the free coordinates as a system of the first order: y holds the coordinates, their rates, and the work of
//! all loads since the first instant.

use super::drives::prescribed;
use super::rubbing::Mode;
use crate::answer::{PoseAnswers, WholeCycle};
use crate::math::Vec2;
use crate::math::ode::{System, Undefined};
use crate::model::{Expr, LoadId, Value};
use crate::plan::LoadStep;
use crate::position::{DriveInput, DriveValue, Model, Reduced, State};
use crate::solve::cycle::loads_name_quantities;
use crate::solve::failure::Halt;
use crate::solve::inputs::Rates;
use std::f64::consts::TAU;

/// The equations, with the states on which a trial stands.
pub(super) struct Equations<'a, 's> {
    pub model: &'s Model<'a>,
    statics: &'s WholeCycle,
    /// The first instant, s.
    pub from: f64,
    /// What every drive says at the first instant.
    pub first: Vec<DriveInput>,
    pub reduced: Reduced,
    /// The state of the last evaluation.
    pub trial: State,
    /// Its unknowns.
    at: (f64, Vec<f64>),
    /// The state from which the present step begins, with the angles of its bodies and its instant.
    accepted: (f64, State, Vec<f64>),
    /// Angles of the bodies in the last evaluation, where loads depend on them.
    pub angles: Vec<f64>,
    loads_need_angles: bool,
    /// Whether a step of motion starts from where its bodies stand.
    goes_on: bool,
    /// Memory for the values of the file's quantities, where loads name them.
    quantities: Option<Vec<Value>>,
    pub evaluated: Vec<(LoadId, Value)>,
    /// How the coordinate moves, where something depends on the sense of its motion.
    pub mode: Option<Mode>,
    /// Memory for rates that nobody looks at.
    quiet: Vec<f64>,
    /// Why the last evaluation has no value.
    pub why: Option<Halt>,
}

impl<'a, 's> Equations<'a, 's> {
    /// From an assembled state with the angles of its bodies, at the first instant.
    pub fn new(
        model: &'s Model<'a>,
        statics: &'s WholeCycle,
        rates: &Rates,
        values: &[DriveValue],
        from: f64,
        (state, angles): (&State, &[f64]),
    ) -> Self {
        let drives = &model.mechanism.drives;
        let mut first = vec![DriveInput::default(); drives.len()];
        rates.at(values, &mut first);
        let free: Vec<usize> = (0..drives.len()).filter(|&i| drives[i].free).collect();
        let moves = |i: usize| first[i].rate != 0.0 || first[i].acceleration != 0.0;
        let moved = (0..drives.len()).any(|i| !drives[i].free && moves(i));
        let unknowns = 2 * free.len() + 1;
        let angles = angles.to_vec();
        Self {
            model,
            statics,
            from,
            first,
            reduced: Reduced::new(model.plan, free, moved),
            trial: state.clone(),
            at: (f64::NAN, vec![f64::NAN; unknowns]),
            accepted: (from, state.clone(), angles.clone()),
            angles,
            loads_need_angles: loads_need_angles(model),
            goes_on: model.plan.goes_on(),
            quantities: loads_name_quantities(model.mechanism).then(Vec::new),
            evaluated: Vec::new(),
            mode: None,
            quiet: vec![0.0; unknowns],
            why: None,
        }
    }

    /// Free coordinates.
    pub fn order(&self) -> usize {
        self.reduced.free().len()
    }

    /// The unknowns at the first instant.
    pub fn start(&self) -> Vec<f64> {
        let free = self.reduced.free();
        let values = free.iter().map(|&i| self.first[i].value);
        let rates = free.iter().map(|&i| self.first[i].rate);
        values.chain(rates).chain([0.0]).collect()
    }

    /// Position and rate of all drives at an instant, from which steps of motion start where the step began.
    pub fn set_position(&mut self, t: f64, y: &[f64]) {
        if self.goes_on {
            self.trial.start_from(&self.accepted.1);
        }
        self.set_inputs(t, y);
    }

    /// The inputs of all drives at an instant.
    fn set_inputs(&mut self, t: f64, y: &[f64]) {
        let state = &mut self.trial;
        state.motion.time = t;
        let elapsed = t - self.from;
        for (input, first) in state.motion.inputs.iter_mut().zip(&self.first) {
            let (value, rate, _) = prescribed(first, elapsed);
            *input = DriveInput { rate, ..*first };
            set_value(input, value);
        }
        let (q, rest) = y.split_at(self.reduced.free().len());
        for ((&drive, q), rate) in self.reduced.free().iter().zip(q).zip(rest) {
            let input = &mut state.motion.inputs[drive];
            set_value(input, *q);
            (input.rate, input.acceleration) = (*rate, 0.0);
        }
    }

    /// Motion at given accelerations of the free coordinates, as in a solution, and forces where they are planned.
    pub fn place(&mut self, t: f64, y: &[f64], accelerations: &[f64], stand: Option<&[(Vec2, Vec2)]>) {
        if let Some(stand) = stand {
            for (body, (p, u)) in self.trial.motion.bodies.iter_mut().zip(stand) {
                (body.p, body.u) = (*p, *u);
            }
        }
        self.set_inputs(t, y);
        for (&drive, a) in self.reduced.free().iter().zip(accelerations) {
            self.trial.motion.inputs[drive].acceleration = *a;
        }
        self.trial.run_motion::<2>(self.model.plan);
        if self.model.plan.effects.forces {
            self.evaluate_loads(t);
            self.trial.run_loads_and_forces(self.model, &self.evaluated);
        }
    }

    /// Motion and, where it is `deep`, accelerations and forces; `false` where there are none.
    pub fn observe(&mut self, t: f64, y: &[f64], deep: bool) -> bool {
        let mut dy = std::mem::take(&mut self.quiet);
        let known = self.rates(t, y, &mut dy).is_ok();
        // where something rubs, accelerations and forces are there already
        if known && deep && self.mode.is_none_or(|mode| mode == Mode::Resting) {
            let n = self.order();
            self.place(t, y, &dy[n..2 * n], None);
        }
        if known {
            self.take_rates(y);
            self.follow_angles(t);
        }
        self.quiet = dy;
        // what was evaluated last is no state that a step ended with
        self.at.0 = f64::NAN;
        known
    }

    /// The greatest angular velocity of a body, rad/s, where the present step begins.
    pub fn fastest_accepted(&self) -> f64 {
        fastest(&self.accepted.1)
    }

    /// The same at another instant; nothing where the equations have no value.
    pub fn fastest(&mut self, t: f64, y: &[f64]) -> f64 {
        if self.observe(t, y, false) { fastest(&self.trial) } else { 0.0 }
    }

    /// The value of an expression in the state that is observed.
    pub fn value(&mut self, expr: &Expr) -> f64 {
        let view = PoseAnswers::new(self.model, &self.trial, &self.angles, self.statics);
        if self.model.mechanism.quantities.is_empty() {
            return view.scalar(expr);
        }
        let quantities = view.all_quantities();
        PoseAnswers { quantities: &quantities, ..view }.scalar(expr)
    }

    pub fn evaluate_loads(&mut self, t: f64) {
        self.evaluated.clear();
        if !self.model.plan.loads.iter().any(|load| matches!(load, LoadStep::Evaluated(_))) {
            return;
        }
        if self.loads_need_angles {
            self.follow_angles(t);
        }
        let view = PoseAnswers::new(self.model, &self.trial, &self.angles, self.statics);
        match self.quantities.take() {
            None => view.evaluated_loads(&mut self.evaluated),
            Some(memory) => {
                let quantities = view.all_quantities_in(memory);
                let view = PoseAnswers { quantities: &quantities, ..view };
                view.evaluated_loads(&mut self.evaluated);
                self.quantities = Some(quantities);
            }
        }
    }

    /// Angles of the bodies of the last evaluation, carried on from where the step began.
    pub fn follow_angles(&mut self, t: f64) {
        let (began, accepted, angles) = &self.accepted;
        let h = t - began;
        let bodies = accepted.motion.bodies.iter().zip(&self.trial.motion.bodies);
        for ((angle, before), (old, new)) in self.angles.iter_mut().zip(angles).zip(bodies) {
            // the mean speed is near enough to tell the whole turns, the rest is read off the direction itself
            let estimate = before + 0.5 * h * (old.omega + new.omega);
            let principal = new.u.angle();
            *angle = principal + TAU * ((estimate - principal) / TAU).round();
        }
        for (&drive, effort) in self.reduced.free().iter().zip(driven_bodies(self.model, self.reduced.free()))
        {
            if let Some(body) = effort {
                self.angles[body] = self.trial.motion.inputs[drive].value;
            }
        }
        for &body in &self.model.plan.turning {
            self.angles[body] = self.trial.motion.bodies[body].turned;
        }
    }

    /// Why the equations have no value where the last step ended: the group nearest to a dead position, or the last cause met.
    pub fn halt(&mut self) -> Halt {
        let conditions = self.accepted.1.motion.conditions.iter().enumerate();
        let least = conditions.min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        match (least, self.why.take()) {
            (_, Some(halt @ (Halt::NoInertia | Halt::NotANumber | Halt::Jam))) => halt,
            (Some((group, condition)), _) if condition.abs() < NEAR_DEAD => {
                Halt::Dead { group, condition: condition.abs() }
            }
            (_, Some(halt)) => halt,
            (_, None) => Halt::NotANumber,
        }
    }

    /// Why M q̈ = Q has no solution: a load, or velocities of a dead position, or no mass.
    pub fn without_acceleration(&self) -> Halt {
        if self.evaluated.iter().any(|(_, value)| !value.is_defined()) {
            return Halt::NotANumber;
        }
        if self.trial.forces.wrenches.iter().all(|w| w.moment.is_finite()) {
            return Halt::NoInertia;
        }
        let conditions = self.trial.motion.conditions.iter().enumerate();
        let least = conditions.min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        least.map_or(Halt::NotANumber, |(group, _)| Halt::Open { group })
    }

    /// The least condition figure of the state from which the present step begins.
    pub fn condition(&self) -> f64 {
        self.accepted.1.motion.conditions.iter().fold(1.0, |least, c| least.min(c.abs()))
    }
}

/// Below this condition figure a run that cannot go on stands before a dead position.
const NEAR_DEAD: f64 = 0.1;

impl System<f64> for Equations<'_, '_> {
    fn rates(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Undefined> {
        let n = self.order();
        self.set_position(t, y);
        if let Some(mode) = self.mode {
            let found = self.rubbing_rates(mode, y, dy);
            self.why = found.err();
            self.at.0 = t;
            self.at.1.copy_from_slice(y);
            return if self.why.is_none() { Ok(()) } else { Err(Undefined) };
        }
        self.reduced.run_motion(self.model.plan, &mut self.trial);
        if let Some(group) = self.trial.motion.open {
            self.why = Some(Halt::Open { group });
            return Err(Undefined);
        }
        self.evaluate_loads(t);
        self.trial.run_loads(self.model, &self.evaluated);
        let (rates, rest) = dy.split_at_mut(n);
        let (accelerations, work) = rest.split_at_mut(n);
        rates.copy_from_slice(&y[n..2 * n]);
        work[0] = self.trial.power_of_loads(self.model, &self.evaluated);
        if self.reduced.accelerations(self.model.plan, &self.trial, accelerations).is_none() {
            self.why = Some(self.without_acceleration());
            return Err(Undefined);
        }
        self.at.0 = t;
        self.at.1.copy_from_slice(y);
        Ok(())
    }

    fn accepted(&mut self, t: f64, y: &[f64]) {
        if self.at.0.to_bits() != t.to_bits() || self.at.1 != y {
            let mut dy = std::mem::take(&mut self.quiet);
            let known = self.rates(t, y, &mut dy).is_ok();
            self.quiet = dy;
            if !known {
                return;
            }
        }
        self.follow_angles(t);
        self.accepted.0 = t;
        self.accepted.1.start_from(&self.trial);
        self.accepted.2.clone_from(&self.angles);
    }
}

/// The greatest angular velocity of a body, rad/s.
fn fastest(state: &State) -> f64 {
    state.motion.bodies.iter().map(|body| body.omega.abs()).fold(0.0, f64::max)
}

fn set_value(input: &mut DriveInput, value: f64) {
    input.value = value;
    input.place = Vec2::direction(value);
}

/// The body whose angle each of these drives gives.
fn driven_bodies<'m>(model: &'m Model<'_>, drives: &'m [usize]) -> impl Iterator<Item = Option<usize>> + 'm {
    drives.iter().map(|&drive| match model.mechanism.drives[drive].target {
        crate::model::DriveTarget::Link(link) => Some(link.index()),
        _ => None,
    })
}

/// Whether the value of a load depends on an angle that is followed.
fn loads_need_angles(model: &Model<'_>) -> bool {
    let mechanism = model.mechanism;
    let mut needed = false;
    let mut look = |expr: &Expr| {
        expr.queries(&mut |query| needed |= query.facts().continuous.is_some());
    };
    mechanism.loads.iter().flat_map(crate::model::Load::expressions).for_each(&mut look);
    mechanism.quantities.iter().for_each(|quantity| look(&quantity.expr));
    needed
}
