//! Many positions of one plan, several side by side.
//!
//! The assemblies are those of a reference state: nothing is followed. All operations are those of one position alone, in
//! the same order and without fused multiplications, so that every lane has the same bits. Blocks that do not fill the
//! lanes, or where a group does not close in one of them, and plans that are not [laned](Plan::laned), go one by one.

use super::state::{BodyState, DriveInput, Reaction, State};
use crate::math::{Lanes, V2, Vec2};
use crate::plan::{Level, Plan};

/// Positions that go side by side: two vectors of AVX2, so that one goes on while the other waits for a root or a quotient.
/// Registers of AVX-512, one vector, were measured to be no faster.
pub const WIDTH: usize = 8;

/// Blocks that go step by step together.
const BLOCKS: usize = 2;

/// The instructions that positions side by side go through on this machine.
#[must_use]
pub fn instructions() -> &'static str {
    #[cfg(target_arch = "x86_64")]
    if std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma") {
        return "AVX2";
    }
    "no AVX2"
}

/// Memory for positions side by side, laid out once.
#[derive(Debug)]
pub struct SideBySide<'a> {
    plan: &'a Plan,
    laned: bool,
    blocks: Vec<State<Lanes<WIDTH>>>,
    alone: State,
    arch: pulp::Arch,
}

/// One of the positions.
#[derive(Clone, Copy, Debug)]
pub enum Place<'a> {
    /// A lane of a block.
    Lane(&'a State<Lanes<WIDTH>>, usize),
    /// A position by itself; where its state has a group `open` it does not close.
    Alone(&'a State),
}

impl<'a> SideBySide<'a> {
    /// For a plan, with the assemblies of a state.
    #[must_use]
    pub fn new(plan: &'a Plan, reference: &State) -> Self {
        let mut block = State::closed(plan);
        block.branches.clone_from(&reference.branches);
        let arch = pulp::Arch::new();
        Self {
            plan,
            laned: plan.laned() && arch.dispatch(HasLanes),
            blocks: vec![block; BLOCKS],
            alone: reference.clone().ready(plan),
            arch,
        }
    }

    /// Solves motion, loads and forces, as far as the plan goes, and hands out every position with its number.
    /// Allocates nothing. Loads that are evaluated at every position, and senses of friction, are not known here and left
    /// out.
    /// # Given
    /// `inputs` of all drives at the first position, at the second, and so on.
    pub fn run(&mut self, inputs: &[DriveInput], mut each: impl FnMut(usize, Place<'_>)) {
        let drives = self.plan.drives;
        if drives == 0 {
            return;
        }
        let mut first = 0;
        for chunk in inputs.chunks(BLOCKS * WIDTH * drives) {
            let full = if self.laned { chunk.len() / (WIDTH * drives) } else { 0 };
            let (laned, rest) = chunk.split_at(full * WIDTH * drives);
            for (state, inputs) in self.blocks.iter_mut().zip(laned.chunks(WIDTH * drives)) {
                fill(&mut state.inputs, inputs, !self.plan.outer.is_empty());
            }
            solve(self.arch, self.plan, &mut self.blocks[..full]);
            for (state, inputs) in self.blocks.iter().zip(laned.chunks(WIDTH * drives)) {
                if state.open.is_none() {
                    (0..WIDTH).for_each(|lane| each(first + lane, Place::Lane(state, lane)));
                } else {
                    one_by_one(self.plan, &mut self.alone, inputs, first, &mut each);
                }
                first += WIDTH;
            }
            one_by_one(self.plan, &mut self.alone, rest, first, &mut each);
            first += rest.len() / drives;
        }
    }
}

/// The inputs of a block; velocities and accelerations of driven points where there are `points`.
fn fill(out: &mut [DriveInput<Lanes<WIDTH>>], block: &[DriveInput], points: bool) {
    let drives = out.len();
    for (drive, out) in out.iter_mut().enumerate() {
        let of = |f: fn(&DriveInput) -> f64| {
            let mut lanes = [0.0; WIDTH];
            for (lane, x) in lanes.iter_mut().enumerate() {
                *x = f(&block[lane * drives + drive]);
            }
            Lanes(lanes)
        };
        out.place = V2::new(of(|d| d.place.x), of(|d| d.place.y));
        out.value = of(|d| d.value);
        out.rate = of(|d| d.rate);
        out.acceleration = of(|d| d.acceleration);
        if points {
            out.velocity = V2::new(of(|d| d.velocity.x), of(|d| d.velocity.y));
            out.point_acceleration = V2::new(of(|d| d.point_acceleration.x), of(|d| d.point_acceleration.y));
        }
    }
}

fn one_by_one(
    plan: &Plan,
    state: &mut State,
    inputs: &[DriveInput],
    first: usize,
    each: &mut impl FnMut(usize, Place<'_>),
) {
    for (i, inputs) in inputs.chunks_exact(plan.drives).enumerate() {
        state.inputs.copy_from_slice(inputs);
        alone(plan, state);
        each(first + i, Place::Alone(state));
    }
}

// these two are not written out in `run`, of which there is one for every caller
#[inline(never)]
fn solve(arch: pulp::Arch, plan: &Plan, blocks: &mut [State<Lanes<WIDTH>>]) {
    arch.dispatch(Solve { plan, blocks });
}

/// One position by itself.
#[inline(never)]
fn alone(plan: &Plan, state: &mut State) {
    match plan.effects.level {
        Level::Positions => state.run_motion::<0>(plan),
        Level::Velocities => state.run_motion::<1>(plan),
        Level::Accelerations => state.run_motion::<2>(plan),
    }
    if plan.effects.forces {
        state.known_loads(plan);
        state.set_lines(plan);
        state.run_forces(plan);
    }
}

/// Blocks of positions, every step on all of them before the next. Compiled once per set of instructions.
struct Solve<'a> {
    plan: &'a Plan,
    blocks: &'a mut [State<Lanes<WIDTH>>],
}

impl Solve<'_> {
    #[inline(always)]
    fn motion<const LEVEL: u8>(&mut self) {
        self.blocks.iter_mut().for_each(|block| block.start(self.plan));
        for step in &self.plan.motion {
            for block in &mut *self.blocks {
                block.closed_form::<LEVEL>(step);
            }
        }
    }

    #[inline(always)]
    fn forces(&mut self) {
        for block in &mut *self.blocks {
            block.unload(self.plan);
            block.set_lines(self.plan);
        }
        for load in &self.plan.loads {
            for block in &mut *self.blocks {
                block.known_load(load);
            }
        }
        for (index, step) in self.plan.forces.iter().enumerate() {
            for block in &mut *self.blocks {
                block.force_sines[index] = block.closed_force(step);
            }
        }
    }
}

/// Whether the machine takes several numbers in one instruction.
struct HasLanes;

impl pulp::WithSimd for HasLanes {
    type Output = bool;

    fn with_simd<A: pulp::Simd>(self, _: A) -> bool {
        A::F64_LANES > 1
    }
}

impl pulp::WithSimd for Solve<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<A: pulp::Simd>(mut self, _: A) {
        // never asked for: not compiled either
        if A::F64_LANES == 1 {
            return;
        }
        match self.plan.effects.level {
            Level::Positions => self.motion::<0>(),
            Level::Velocities => self.motion::<1>(),
            Level::Accelerations => self.motion::<2>(),
        }
        if self.plan.effects.forces {
            self.forces();
        }
    }
}

impl Place<'_> {
    /// Motion of a body.
    #[inline]
    #[must_use]
    pub fn body(&self, slot: usize) -> BodyState {
        match self {
            Self::Alone(state) => state.bodies[slot],
            Self::Lane(state, i) => {
                let b = &state.bodies[slot];
                BodyState {
                    p: vector(b.p, *i),
                    u: vector(b.u, *i),
                    v: vector(b.v, *i),
                    omega: b.omega.0[*i],
                    a: vector(b.a, *i),
                    alpha: b.alpha.0[*i],
                    way: b.way.0[*i],
                }
            }
        }
    }

    /// Reaction of a slot.
    #[inline]
    #[must_use]
    pub fn reaction(&self, slot: usize) -> Reaction {
        match self {
            Self::Alone(state) => state.reactions[slot],
            Self::Lane(state, i) => {
                let r = &state.reactions[slot];
                Reaction { force: vector(r.force, *i), couple: r.couple.0[*i] }
            }
        }
    }

    /// Unknown effort of a slot, N or N m.
    #[inline]
    #[must_use]
    pub fn effort(&self, slot: usize) -> f64 {
        match self {
            Self::Alone(state) => state.efforts[slot],
            Self::Lane(state, i) => state.efforts[slot].0[*i],
        }
    }

    /// Signed condition figure of a group of motion.
    #[inline]
    #[must_use]
    pub fn sine(&self, group: usize) -> f64 {
        match self {
            Self::Alone(state) => state.sines[group],
            Self::Lane(state, i) => state.sines[group].0[*i],
        }
    }

    /// Signed condition figure of a group of forces.
    #[inline]
    #[must_use]
    pub fn force_sine(&self, group: usize) -> f64 {
        match self {
            Self::Alone(state) => state.force_sines[group],
            Self::Lane(state, i) => state.force_sines[group].0[*i],
        }
    }

    /// The first group that does not close: what follows it has no meaning.
    #[inline]
    #[must_use]
    pub fn open(&self) -> Option<usize> {
        match self {
            Self::Alone(state) => state.open,
            Self::Lane(..) => None,
        }
    }
}

#[inline]
fn vector(v: V2<Lanes<WIDTH>>, lane: usize) -> Vec2 {
    Vec2::new(v.x.0[lane], v.y.0[lane])
}
