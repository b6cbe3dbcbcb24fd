//! The equations of motion of the free coordinates, M q̈ = Q, without any reaction.
//!
//! With the velocities K of all bodies for a unit rate of each free coordinate, and their accelerations a₀ where no free
//! coordinate accelerates, the principle of virtual power gives
//!
//! M = Σ Kᵀ m K,  Q = Σ Kᵀ (F − m a₀),
//!
//! the sums taken over all bodies, with forces F and masses m as six numbers each (Parviz Nikravesh, Planar multibody dynamics,
//! chapter 14, with columns K in place of the matrix B).

use super::kinematics::DriveInput;
use super::model::Model;
use super::state::State;
use super::virtual_power::{Along, Loads};
use crate::math::{Lu, Vec2};
use crate::model::{LoadId, Value};
use crate::plan::{LoadStep, Plan};

/// What positions of bodies that are found twice may differ by.
const SAME_PLACE: f64 = 1e-9;

/// Velocity of a body, as for a unit rate of a coordinate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Column {
    /// Of the body's origin.
    pub v: Vec2,
    pub omega: f64,
}

/// The equations of the free coordinates at one instant. All memory is taken once.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// Slots of the drives that are free.
    free: Vec<usize>,
    /// No other drive moves: everything goes with the one rate, or its square.
    alone: bool,
    /// Velocities of the bodies by free coordinate.
    columns: Vec<Vec<Column>>,
    /// What the drives say, while the unit rates are tried.
    inputs: Vec<DriveInput>,
    /// M, by rows.
    mass: Vec<f64>,
    factors: Lu,
    /// The masses and the loads that are numbers.
    known: Loads,
    /// Of a coordinate that is alone: the sums of the masses at the unit rate.
    unit: Along,
    /// Q, and what of it is of loads.
    forces: Vec<f64>,
    loads: Vec<f64>,
}

impl Reduced {
    /// For these free drives of a plan; `moved` where other drives move.
    #[must_use]
    pub fn new(plan: &Plan, free: Vec<usize>, moved: bool) -> Self {
        let n = free.len();
        let still = Column { v: Vec2::zero(), omega: 0.0 };
        Self {
            alone: n == 1 && !moved,
            columns: vec![vec![still; plan.bodies]; n],
            inputs: Vec::with_capacity(plan.drives),
            mass: vec![0.0; n * n],
            factors: Lu::new(n),
            known: Loads::of(plan),
            unit: Along::default(),
            forces: vec![0.0; n],
            loads: vec![0.0; n],
            free,
        }
    }

    /// M and the velocities for unit rates at the position of a state; none where its inputs do not lead there. A dead position
    /// that was passed in other coordinates may have changed assemblies.
    #[must_use]
    pub fn at(plan: &Plan, free: &[usize], there: &State) -> Option<Self> {
        let mut state = there.clone();
        state.assemble_as(plan, there);
        let mut reduced = Self::new(plan, free.to_vec(), true);
        reduced.several(plan, &mut state);
        if state.motion.open.is_some() || !state.is_at(there) {
            return None;
        }
        reduced.sum_up(&state);
        Some(reduced)
    }

    /// Slots of the drives that are free.
    #[must_use]
    pub fn free(&self) -> &[usize] {
        &self.free
    }

    /// Moves the bodies as the inputs of a state say, no free coordinate accelerating, and finds what they do for a unit rate
    /// of each. A group that does not close is left in `open`. Allocates nothing.
    pub fn run_motion(&mut self, plan: &Plan, state: &mut State) {
        if self.alone {
            self.one_coordinate(plan, state);
        } else {
            self.several(plan, state);
        }
    }

    /// One pass at unit rate has both: velocities go with the rate, accelerations with its square.
    fn one_coordinate(&mut self, plan: &Plan, state: &mut State) {
        state.motion.inputs[self.free[0]].acceleration = 0.0;
        self.move_at_unit_rate::<2>(plan, state);
        self.scale_unit(state);
    }

    /// Moves the bodies at a unit rate of the one free coordinate where it is alone, at the inputs of a state, without accelerations.
    /// A group that does not close is left in `open`. Allocates nothing.
    pub fn run_at_unit_rate(&mut self, plan: &Plan, state: &mut State) {
        self.move_at_unit_rate::<1>(plan, state);
        self.take_velocities(state);
    }

    /// The masses are summed up as soon as they are placed: that goes on beside the roots of the next group.
    fn move_at_unit_rate<const LEVEL: u8>(&mut self, plan: &Plan, state: &mut State) {
        let drive = self.free[0];
        let rate = std::mem::replace(&mut state.motion.inputs[drive].rate, 1.0);
        state.start(plan);
        let mut sum = Along::default();
        for (index, step) in plan.motion.iter().enumerate() {
            state.step::<LEVEL>(plan, step);
            self.known.add_placed::<LEVEL>(index, &state.motion.bodies, &mut sum);
        }
        self.unit = sum;
        state.motion.inputs[drive].rate = rate;
    }

    /// Takes over how the bodies move for a unit rate of the one free coordinate, without accelerations.
    pub fn take_unit_velocities(&mut self, state: &State) {
        self.take_velocities(state);
        self.unit = self.known.at_unit_rate::<1>(&state.motion.bodies);
    }

    fn take_velocities(&mut self, state: &State) {
        for (column, body) in self.columns[0].iter_mut().zip(&state.motion.bodies) {
            *column = Column { v: body.v, omega: body.omega };
        }
    }

    /// Mass and force along the one free coordinate, of bodies that move at its unit rate, under the loads that are numbers and the
    /// values of the others.
    pub fn mass_and_force(
        &mut self,
        model: &Model<'_>,
        state: &mut State,
        evaluated: &[(LoadId, Value)],
    ) -> (f64, f64) {
        self.sum_unit(state, 0.0);
        self.add_evaluated(model, state, evaluated);
        (self.mass[0], self.forces[0])
    }

    /// Takes over how the bodies move for a unit rate of the one free coordinate, and moves them at the rate there is.
    pub fn take_unit(&mut self, state: &mut State) {
        self.unit = self.known.at_unit_rate::<2>(&state.motion.bodies);
        self.scale_unit(state);
    }

    fn scale_unit(&mut self, state: &mut State) {
        let rate = state.motion.inputs[self.free[0]].rate;
        let square = rate * rate;
        for (column, body) in self.columns[0].iter_mut().zip(&mut state.motion.bodies) {
            *column = Column { v: body.v, omega: body.omega };
            body.v = body.v * rate;
            body.omega *= rate;
            body.a = body.a * square;
            body.alpha *= square;
        }
    }

    fn several(&mut self, plan: &Plan, state: &mut State) {
        self.inputs.clone_from(&state.motion.inputs);
        for (column, &drive) in self.columns.iter_mut().zip(&self.free) {
            for (input, actual) in state.motion.inputs.iter_mut().zip(&self.inputs) {
                *input = DriveInput { place: actual.place, value: actual.value, ..DriveInput::default() };
            }
            state.motion.inputs[drive].rate = 1.0;
            state.run_motion::<1>(plan);
            if state.motion.open.is_some() {
                return;
            }
            for (column, body) in column.iter_mut().zip(&state.motion.bodies) {
                *column = Column { v: body.v, omega: body.omega };
            }
        }
        state.motion.inputs.clone_from(&self.inputs);
        self.free.iter().for_each(|&drive| state.motion.inputs[drive].acceleration = 0.0);
        state.run_motion::<2>(plan);
    }

    /// Finds M and Q in the state that was moved last, under the loads that are numbers and the values of the others. Returns the power
    /// of the loads, W. Allocates nothing.
    pub fn load(&mut self, model: &Model<'_>, state: &mut State, evaluated: &[(LoadId, Value)]) -> f64 {
        if self.alone {
            let rate = state.motion.inputs[self.free[0]].rate;
            self.sum_unit(state, rate * rate);
            self.add_evaluated(model, state, evaluated);
            return self.loads[0] * rate;
        }
        self.sum_up(state);
        self.add_evaluated(model, state, evaluated);
        state.power_of_loads(model, evaluated)
    }

    fn add_evaluated(&mut self, model: &Model<'_>, state: &mut State, evaluated: &[(LoadId, Value)]) {
        let nothing = |value: &Value| *value == Value::Scalar(0.0) || *value == Value::Vector(Vec2::zero());
        if evaluated.iter().all(|(_, value)| nothing(value)) {
            return;
        }
        state.run_evaluated_loads(model, evaluated);
        for ((q, loads), column) in self.forces.iter_mut().zip(&mut self.loads).zip(&self.columns) {
            let bodies = column.iter().zip(&state.forces.wrenches).skip(1);
            let power: f64 = bodies.map(|(k, w)| w.force.dot(k.v) + w.moment * k.omega).sum();
            *q += power;
            *loads += power;
        }
    }

    /// Whether Q is finite.
    #[must_use]
    pub fn is_loaded(&self) -> bool {
        self.forces.iter().all(|q| q.is_finite())
    }

    /// The accelerations of the free coordinates from M and Q. Returns the condition of M, in (0, 1], and nothing where M has no
    /// inverse. Allocates nothing.
    pub fn accelerations(&mut self, out: &mut [f64]) -> Option<f64> {
        out.copy_from_slice(&self.forces);
        let n = self.free.len();
        if n == 1 {
            let m = self.mass[0];
            out[0] /= m;
            return (m > 0.0 && out[0].is_finite()).then_some(1.0);
        }
        for (i, x) in out.iter_mut().enumerate() {
            for j in 0..n {
                // rows and columns in units in which the diagonal is 1
                *self.factors.at_mut(i, j) = self.mass[i * n + j] * self.scale(i) * self.scale(j);
            }
            *x *= self.scale(i);
        }
        if !self.factors.factor() {
            return None;
        }
        let condition = self.factors.least_pivot();
        self.factors.solve(out);
        for (i, x) in out.iter_mut().enumerate() {
            *x *= self.scale(i);
        }
        out.iter().all(|x| x.is_finite()).then_some(condition)
    }

    /// Accelerates the bodies that were moved last with the free coordinates. Forces are not found anew.
    pub fn accelerate(&self, state: &mut State, accelerations: &[f64]) {
        for ((&drive, column), &a) in self.free.iter().zip(&self.columns).zip(accelerations) {
            state.motion.inputs[drive].acceleration = a;
            for (k, body) in column.iter().zip(&mut state.motion.bodies) {
                body.a += k.v * a;
                body.alpha += k.omega * a;
            }
        }
    }

    /// Solves M x = b in place, with the factors that the accelerations were found by.
    pub fn solve(&mut self, x: &mut [f64]) {
        if let [x] = x {
            *x /= self.mass[0];
            return;
        }
        for (i, x) in x.iter_mut().enumerate() {
            *x *= self.scale(i);
        }
        self.factors.solve(x);
        for (i, x) in x.iter_mut().enumerate() {
            *x *= self.scale(i);
        }
    }

    /// What a number that is linear in velocities is for a unit rate of a free coordinate, in the state that was moved last.
    pub fn at_unit_rate(&self, i: usize, state: &mut State, number: impl Fn(&State) -> f64) -> f64 {
        let before: Vec<_> = state.motion.bodies.iter().map(|body| (body.v, body.omega)).collect();
        for (body, column) in state.motion.bodies.iter_mut().zip(&self.columns[i]) {
            (body.v, body.omega) = (column.v, column.omega);
        }
        let found = number(state);
        for (body, (v, omega)) in state.motion.bodies.iter_mut().zip(before) {
            (body.v, body.omega) = (v, omega);
        }
        found
    }

    /// The unit of a free coordinate in which its own mass is 1.
    #[must_use]
    pub fn scale(&self, i: usize) -> f64 {
        1.0 / self.mass[i * self.free.len() + i].sqrt()
    }

    /// M, and Q of inertia forces and of the loads that are numbers.
    fn sum_up(&mut self, state: &State) {
        let (n, bodies) = (self.free.len(), &state.motion.bodies);
        for i in 0..n {
            let Along { mass, inertia, loads } = self.known.of_masses(bodies, &self.columns[i]);
            let loads = loads + self.known.of_others(bodies, &self.columns[i]);
            self.mass[i * n + i] = mass;
            (self.forces[i], self.loads[i]) = (loads - inertia, loads);
            for j in 0..i {
                let mass = self.known.mass_between(bodies, [&self.columns[i], &self.columns[j]]);
                (self.mass[i * n + j], self.mass[j * n + i]) = (mass, mass);
            }
        }
    }

    /// The same of a coordinate that is alone, from the sums at the unit rate, at a rate with this square.
    fn sum_unit(&mut self, state: &State, square: f64) {
        let Along { mass, inertia, loads } = self.unit;
        let loads = loads + self.known.of_others(&state.motion.bodies, &self.columns[0]);
        self.mass[0] = mass;
        (self.forces[0], self.loads[0]) = (loads - inertia * square, loads);
    }

    /// The sum of magnitudes whose sum is the power of the loads for a unit rate of a free coordinate: what rounding leaves of
    /// it is relative to this.
    #[must_use]
    pub fn greatest_power(&self, coordinate: usize, plan: &Plan, state: &State) -> f64 {
        let columns = &self.columns[coordinate];
        let of = |k: &Column, force: f64, moment: f64| force * k.v.norm() + (moment * k.omega).abs();
        let bodies = columns.iter().zip(&state.forces.applied).skip(1);
        let all: f64 = bodies.map(|(k, w)| of(k, w.force.norm(), w.moment)).sum();
        // where a body falls, its weight and its inertia cancel
        let inertia = plan.loads.iter().map(|load| match load {
            LoadStep::Mass { body, centre, mass, moment_of_inertia, inertia: true, .. } => {
                let moves = &state.motion.bodies[*body];
                let force = moves.acceleration(centre.unwrap_or_default()).norm() * mass;
                of(&columns[*body], force, moment_of_inertia * moves.alpha)
            }
            _ => 0.0,
        });
        all + inertia.sum::<f64>()
    }

    /// Velocity of a body's origin and angular velocity for a unit rate of a free coordinate.
    #[must_use]
    pub fn unit_motion(&self, coordinate: usize, body: usize) -> (Vec2, f64) {
        let Column { v, omega } = self.columns[coordinate][body];
        (v, omega)
    }

    /// Sets the velocity of a body's origin and its angular velocity for a unit rate of a free coordinate.
    pub fn set_unit_motion(&mut self, coordinate: usize, body: usize, (v, omega): (Vec2, f64)) {
        self.columns[coordinate][body] = Column { v, omega };
    }

    /// The greatest speed of a body for a unit rate of a free coordinate, lengths over `extent`; a unit of each coordinate is one
    /// of these scales.
    pub fn greatest_speed(&self, extent: f64, scales: impl Iterator<Item = f64>) -> f64 {
        let each = self.columns.iter().zip(scales).flat_map(|(column, scale)| {
            column.iter().map(move |k| scale * k.omega.abs().max(k.v.norm() / extent))
        });
        // what is not a number is the greatest there is
        each.fold(0.0, |most, speed| if speed.is_nan() { f64::INFINITY } else { speed.max(most) })
    }

    /// Whether there is one free coordinate, and nothing else moves.
    #[must_use]
    pub const fn is_alone(&self) -> bool {
        self.alone
    }

    /// M, by rows.
    #[must_use]
    pub fn mass(&self) -> &[f64] {
        &self.mass
    }
}

impl State {
    /// Gives every group that has two assemblies the one in which its bodies stand in another state.
    fn assemble_as(&mut self, plan: &Plan, there: &Self) {
        self.start(plan);
        for (index, step) in plan.motion.iter().enumerate() {
            self.step::<0>(plan, step);
            if step.has_two_roots() && !self.is_at(there) {
                self.branches[index].root = -self.branches[index].root;
                self.step::<0>(plan, step);
            }
        }
    }

    /// Whether all bodies stand as they do in another state.
    fn is_at(&self, there: &Self) -> bool {
        let bodies = self.motion.bodies.iter().zip(&there.motion.bodies);
        let far = bodies.map(|(a, b)| ((a.p - b.p).norm() / (1.0 + b.p.norm())).max((a.u - b.u).norm()));
        far.fold(0.0, f64::max) < SAME_PLACE
    }
}
