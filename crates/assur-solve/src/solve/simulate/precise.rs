//! A motion under loads with twice the digits, where closed forms and loads that are numbers make all of it: the reference of
//! what accuracy costs.

use super::records::Records;
use crate::math::ode::{Extrapolation, Integrator, Step, System, Tolerance, Undefined};
use crate::math::{Double, Scalar, V2, Vec2};
use crate::model::DriveTarget;
use crate::plan::{LoadStep, Plan};
use crate::position::{DriveInput, Model, State};

/// The tolerance: far below the digits of `f64`.
const TOLERANCE: f64 = 1e-18;
/// A motion that takes more evaluations has no such reference.
const MOST: usize = 400_000;

/// The equations of the free coordinates, as [`crate::position::Reduced`] has them in `f64`.
struct Equations<'m> {
    plan: &'m Plan,
    /// The first instant, s.
    from: f64,
    /// What every drive says there.
    first: &'m [DriveInput],
    free: Vec<usize>,
    state: State<Double>,
    /// Velocities of all bodies for a unit rate of each coordinate.
    columns: Vec<Vec<(V2<Double>, Double)>>,
    mass: Vec<Double>,
}

/// Puts the numbers with twice the digits in the place of those of `f64` at the same instants; `false` where there are none.
pub(super) fn refine(
    model: &Model<'_>,
    (first, from, start): (&[DriveInput], f64, &State),
    records: &mut Records,
) -> bool {
    let drives = &model.mechanism.drives;
    let free: Vec<usize> = (0..drives.len()).filter(|&i| drives[i].free).collect();
    let closed = model.plan.is_batchable() && model.plan.laws.is_empty();
    // an impact is no differential equation
    let points = drives.iter().any(|drive| matches!(drive.target, DriveTarget::Point(..)));
    if points || !closed || !model.mechanism.stops.is_empty() || free.is_empty() || records.count == 0 {
        return false;
    }
    let n = free.len();
    let mut state = State::<Double>::closed(model.plan);
    state.branches.clone_from(&start.branches);
    let still = (V2::new(Double::zero(), Double::zero()), Double::zero());
    let mut equations = Equations {
        plan: model.plan,
        from,
        first,
        state,
        columns: vec![vec![still; model.plan.bodies]; n],
        mass: vec![Double::zero(); n * n],
        free,
    };
    integrate(&mut equations, records).is_some()
}

fn integrate(equations: &mut Equations<'_>, records: &mut Records) -> Option<()> {
    let n = equations.free.len();
    let (first, free) = (equations.first, &equations.free);
    let y: Vec<Double> = free
        .iter()
        .map(|&i| first[i].value)
        .chain(free.iter().map(|&i| first[i].rate))
        .map(Double::of)
        .collect();
    let mut method: Extrapolation<Double> =
        Extrapolation::new(Tolerance::uniform(2 * n, TOLERANCE, TOLERANCE));
    let end = *records.times.last()?;
    method.start(equations, Double::of(equations.from), &y, Double::of(end)).ok()?;
    let (mut at, mut dy) = (y.clone(), y);
    let mut next = 0;
    // the first instant is the begin of the first step
    while next < records.count {
        let step = if end > equations.from { method.step(equations).ok()? } else { Step::Last };
        method.prepare_dense(equations).ok()?;
        while next < records.count && (records.times[next] <= method.t().rounded() || step == Step::Last) {
            let time = Double::of(records.times[next]);
            if records.times[next] == method.t().rounded() {
                at.copy_from_slice(method.y());
            } else {
                method.dense(time, &mut at);
            }
            equations.rates(time, &at, &mut dy).ok()?;
            let numbers = at.iter().chain(&dy[n..]).map(|x| x.rounded());
            records.numbers.splice(3 * n * next..3 * n * (next + 1), numbers);
            next += 1;
        }
        if method.counts().evaluations > MOST {
            return None;
        }
    }
    Some(())
}

impl Equations<'_> {
    /// What all drives say at an instant; without rates, they stand still.
    fn set(&mut self, t: Double, y: &[Double], moves: bool) {
        let elapsed = t - Double::of(self.from);
        for (input, first) in self.state.motion.inputs.iter_mut().zip(self.first) {
            *input = first.in_scalar();
            let (rate, acceleration) = (input.rate, input.acceleration);
            input.value = input.value + (rate + acceleration * Double::of(0.5) * elapsed) * elapsed;
            input.place = input.value.as_direction();
            input.rate = rate + acceleration * elapsed;
        }
        let n = self.free.len();
        for (k, &drive) in self.free.iter().enumerate() {
            let input = &mut self.state.motion.inputs[drive];
            (input.value, input.place) = (y[k], y[k].as_direction());
            (input.rate, input.acceleration) = (y[n + k], Double::zero());
        }
        if !moves {
            for input in &mut self.state.motion.inputs {
                (input.rate, input.acceleration) = (Double::zero(), Double::zero());
            }
        }
    }

    /// M and Q; M by rows.
    fn sum_up(&mut self, q: &mut [Double]) {
        let n = self.free.len();
        self.mass.fill(Double::zero());
        for load in &self.plan.loads {
            let LoadStep::Mass { body, centre, mass, moment_of_inertia, .. } = load else { continue };
            let u = self.state.motion.bodies[*body].u;
            let arm = V2::of(centre.map_or(Vec2::zero(), |at| at)).turned(u).perp();
            let at =
                |column: &[(V2<Double>, Double)]| (column[*body].0 + arm * column[*body].1, column[*body].1);
            for i in 0..n {
                let (v_i, omega_i) = at(&self.columns[i]);
                for j in 0..n {
                    let (v_j, omega_j) = at(&self.columns[j]);
                    let moved =
                        Double::of(*mass) * v_i.dot(v_j) + Double::of(*moment_of_inertia) * omega_i * omega_j;
                    self.mass[i * n + j] = self.mass[i * n + j] + moved;
                }
            }
        }
        for (q, column) in q.iter_mut().zip(&self.columns) {
            let bodies = column.iter().zip(&self.state.forces.wrenches).skip(1);
            let power = bodies.map(|((v, omega), w)| w.force.dot(*v) + w.moment * *omega);
            *q = power.fold(Double::zero(), |sum, power| sum + power);
        }
    }

    /// Solves M x = q in place: M is positive definite.
    fn solve(&mut self, q: &mut [Double]) {
        let (n, m) = (q.len(), &mut self.mass);
        for k in 0..n {
            for i in k + 1..n {
                let factor = m[i * n + k] / m[k * n + k];
                for j in k..n {
                    m[i * n + j] = m[i * n + j] - factor * m[k * n + j];
                }
                q[i] = q[i] - factor * q[k];
            }
        }
        for k in (0..n).rev() {
            for j in k + 1..n {
                q[k] = q[k] - m[k * n + j] * q[j];
            }
            q[k] = q[k] / m[k * n + k];
        }
    }
}

impl System<Double> for Equations<'_> {
    fn rates(&mut self, t: Double, y: &[Double], dy: &mut [Double]) -> Result<(), Undefined> {
        let n = self.free.len();
        for k in 0..n {
            self.set(t, y, false);
            self.state.motion.inputs[self.free[k]].rate = Double::one();
            self.state.run_closed_loads(self.plan);
            for (column, body) in self.columns[k].iter_mut().zip(&self.state.motion.bodies) {
                *column = (body.v, body.omega);
            }
        }
        self.set(t, y, true);
        self.state.run_closed_loads(self.plan);
        let (rates, accelerations) = dy.split_at_mut(n);
        rates.copy_from_slice(&y[n..2 * n]);
        self.sum_up(accelerations);
        self.solve(accelerations);
        let known = self.state.motion.open.is_none() && accelerations.iter().all(|a| a.rounded().is_finite());
        known.then_some(()).ok_or(Undefined)
    }
}
