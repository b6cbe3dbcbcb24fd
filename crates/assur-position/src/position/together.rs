//! Positions that do not depend on one another, side by side in lanes, each checked.
//!
//! All operations are those of one position alone, in the same order and without fused multiplications, so that every lane has the
//! bits of [`State::run`].

use super::closed::Closed;
use super::directions::directions;
use super::kinematics::{DriveInput, Motion, Shared};
use super::residual::Residuals;
use super::state::State;
use super::statics::Forces;
use super::wrench::{Reaction, Wrench};
use crate::math::{Lanes, Scalar, V2, Vec2};
use crate::plan::{Level, Plan};

/// Positions that go side by side: one vector of AVX-512 or two of AVX2; one where there are no vectors.
pub const WIDTH: usize = if cfg!(target_family = "wasm") { 1 } else { 8 };

/// Numbers of positions side by side.
pub type F64x8 = Lanes<WIDTH>;

/// Rows of lanes that go step by step together.
const TOGETHER: usize = 2;

/// What is found of positions side by side beside their states.
#[derive(Clone, Copy, Debug, Default)]
pub struct Checked {
    /// See [`Residuals`].
    pub closure: F64x8,
    /// The same; nothing where it is not known.
    pub equilibrium: F64x8,
    pub power: F64x8,
    /// The least condition figure of all groups.
    pub condition: F64x8,
    /// Sum of the magnitudes of all answers: what is no number, or beyond all, is in it.
    pub magnitude: F64x8,
}

/// Memory for positions of plans that are [batchable](Plan::is_batchable).
#[derive(Debug, Default)]
pub struct LaneSolver {
    totals: Vec<Wrench<F64x8>>,
}

impl LaneSolver {
    /// Solves motion, loads and forces of states in which inputs and assemblies are set, and checks them. Of the drives that are
    /// `turned` the directions are found from their values. Where one has a group `open`, one of its positions does not close. Without
    /// `forces` only the closure is checked. Allocates nothing once it has run.
    pub fn run(
        &mut self,
        plan: &Plan,
        (states, turned): (&mut [State<F64x8>], &[usize]),
        checked: &mut [Checked],
        forces: bool,
    ) {
        let work = Work { plan, states, turned, checked, totals: &mut self.totals, forces };
        // AVX-512 would need all steps once more, in as much time of the compiler as everything else here
        #[cfg(target_arch = "x86_64")]
        if let Some(avx2) = pulp::x86::V3::try_new() {
            return avx2.vectorize(work);
        }
        work.all();
    }
}

struct Work<'a> {
    plan: &'a Plan,
    states: &'a mut [State<F64x8>],
    turned: &'a [usize],
    checked: &'a mut [Checked],
    totals: &'a mut Vec<Wrench<F64x8>>,
    forces: bool,
}

#[cfg(target_arch = "x86_64")]
impl pulp::NullaryFnOnce for Work<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.all();
    }
}

impl Work<'_> {
    #[cfg_attr(in_one, inline(always))]
    fn all(self) {
        let Self { plan, states, turned, checked, totals, forces } = self;
        for (states, checked) in states.chunks_mut(TOGETHER).zip(checked.chunks_mut(TOGETHER)) {
            for state in &mut *states {
                for &drive in turned {
                    let input = &mut state.motion.inputs[drive];
                    input.place = directions(input.value);
                }
            }
            Closed { plan, blocks: states }.run();
            for (state, checked) in states.iter().zip(checked) {
                let [closure, equilibrium, power] = if forces {
                    state.residuals(plan, totals)
                } else {
                    [state.closure(&plan.checks), F64x8::zero(), F64x8::zero()]
                };
                let condition = state.least_condition(plan);
                let magnitude = state.magnitude();
                *checked = Checked { closure, equilibrium, power, condition, magnitude };
            }
        }
    }
}

impl State<F64x8> {
    #[cfg_attr(in_one, inline(always))]
    fn least_condition(&self, plan: &Plan) -> F64x8 {
        let forces = if plan.effects.forces { self.forces.conditions.as_slice() } else { &[] };
        let all = self.motion.conditions.iter().chain(forces);
        all.fold(F64x8::one(), |least, c| least.min(c.abs()))
    }

    #[cfg_attr(in_one, inline(always))]
    fn magnitude(&self) -> F64x8 {
        let of = |v: V2<F64x8>| v.x.abs() + v.y.abs();
        let mut sum = F64x8::zero();
        for b in &self.motion.bodies {
            // several sums at a time, as none waits for another
            let [places, motion] = [of(b.p) + of(b.u), of(b.v) + of(b.a)];
            sum = sum + ((places + motion) + (b.omega.abs() + b.alpha.abs()));
        }
        for r in &self.forces.reactions {
            sum = sum + (of(r.force) + r.couple.abs());
        }
        self.forces.efforts.iter().fold(sum, |sum, effort| sum + effort.abs())
    }

    /// Writes one of the positions.
    pub fn write_lane(&self, lane: usize, out: &mut State) {
        out.branches.clone_from(&self.branches);
        self.motion.write_lane(lane, &mut out.motion);
        self.forces.write_lane(lane, &mut out.forces);
    }
}

impl Checked {
    /// The residuals of one of the positions, as far as a plan has them; without `forces` the closure alone.
    #[must_use]
    pub fn residuals(&self, plan: &Plan, lane: usize, forces: bool) -> Residuals {
        let forces = forces && plan.has_forces();
        let moves = plan.effects.level >= Level::Velocities;
        Residuals {
            closure: self.closure.0[lane],
            equilibrium: forces.then_some(self.equilibrium.0[lane]),
            power: (forces && moves).then_some(self.power.0[lane]),
        }
    }
}

impl DriveInput<F64x8> {
    /// Sets one of the positions.
    pub fn set_lane(&mut self, lane: usize, input: &DriveInput) {
        let set = |v: &mut V2<F64x8>, x: Vec2| (v.x.0[lane], v.y.0[lane]) = (x.x, x.y);
        set(&mut self.place, input.place);
        set(&mut self.velocity, input.velocity);
        set(&mut self.point_acceleration, input.point_acceleration);
        self.value.0[lane] = input.value;
        (self.rate.0[lane], self.acceleration.0[lane]) = (input.rate, input.acceleration);
    }
}

impl Motion<F64x8> {
    fn write_lane(&self, lane: usize, out: &mut Motion) {
        write(&self.inputs, &mut out.inputs, |input| input.map(|x| x.0[lane]));
        write(&self.bodies, &mut out.bodies, |body| body.map(|x| x.0[lane]));
        write(&self.conditions, &mut out.conditions, |c| c.0[lane]);
        out.certificates.clone_from(&self.certificates);
        out.touches.clone_from(&self.touches);
        out.open = None;
        write(&self.shared, &mut out.shared, |shared| Shared {
            r_1: vector(shared.r_1, lane),
            second: vector(shared.second, lane),
            inverse: shared.inverse.0[lane],
        });
    }
}

impl Forces<F64x8> {
    fn write_lane(&self, lane: usize, out: &mut Forces) {
        let wrench = |w: &Wrench<F64x8>| Wrench { force: vector(w.force, lane), moment: w.moment.0[lane] };
        write(&self.applied, &mut out.applied, wrench);
        write(&self.wrenches, &mut out.wrenches, wrench);
        write(&self.reactions, &mut out.reactions, |r| Reaction {
            force: vector(r.force, lane),
            couple: r.couple.0[lane],
        });
        write(&self.efforts, &mut out.efforts, |x| x.0[lane]);
        write(&self.lines, &mut out.lines, |(p, n)| (vector(*p, lane), vector(*n, lane)));
        write(&self.conditions, &mut out.conditions, |c| c.0[lane]);
    }
}

fn write<A, B>(from: &[A], to: &mut [B], one: impl Fn(&A) -> B) {
    to.iter_mut().zip(from).for_each(|(to, from)| *to = one(from));
}

fn vector(v: V2<F64x8>, lane: usize) -> Vec2 {
    Vec2::new(v.x.0[lane], v.y.0[lane])
}
