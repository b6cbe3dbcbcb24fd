//! Many positions of one plan, several side by side.
//!
//! The assemblies are those of a reference state: nothing is followed. All operations are those of one position alone, in
//! the same order and without fused multiplications, so that every lane has the same bits. Blocks that do not fill the
//! lanes, or where a group does not close in one of them, go in one lane; plans that are not [batchable](Plan::is_batchable) go
//! position by position.

use super::body::BodyState;
use super::closed::Closed;
use super::columns::DriveColumns;
use super::kinematics::DriveInput;
use super::one_lane::run_scalars;
use super::state::State;
use super::together::WIDTH;
use super::wrench::Reaction;
use crate::math::{Lanes, V2, Vec2};
use crate::plan::Plan;
use std::ops::Range;

/// Blocks of lanes that go step by step together.
const BLOCKS: usize = 2;

/// Positions in one lane that go step by step together.
const TOGETHER: usize = 8;

/// The instructions that positions side by side go through on this machine.
#[must_use]
pub fn instructions() -> &'static str {
    match pulp::Arch::new().dispatch(InOneInstruction) {
        1 => "no AVX2",
        2 => "Neon",
        4 => "AVX2",
        _ => "AVX-512",
    }
}

/// Memory for positions side by side, laid out once.
#[derive(Debug)]
pub struct Batch<'a> {
    plan: &'a Plan,
    arch: pulp::Arch,
    /// None where the machine or the plan has no lanes.
    lanes: Vec<State<Lanes<WIDTH>>>,
    /// One alone where the plan cannot be batched.
    scalars: Vec<State>,
}

/// One of the positions.
#[derive(Clone, Copy, Debug)]
pub enum Place<'a> {
    /// A lane of a block.
    Lane(&'a State<Lanes<WIDTH>>, usize),
    /// A position by itself; where its state has a group `open` it does not close.
    Alone(&'a State),
}

impl<'a> Batch<'a> {
    /// For a plan, with the assemblies of a state.
    #[must_use]
    pub fn new(plan: &'a Plan, reference: &State) -> Self {
        let arch = pulp::Arch::new();
        let laned = plan.is_batchable() && arch.dispatch(InOneInstruction) > 1;
        let mut block = State::closed(plan);
        block.branches.clone_from(&reference.branches);
        Self { lanes: vec![block; if laned { BLOCKS } else { 0 }], ..Self::in_one_lane(plan, reference) }
    }

    /// The same in one lane, whatever the machine has.
    #[must_use]
    pub fn in_one_lane(plan: &'a Plan, reference: &State) -> Self {
        let together = if plan.is_batchable() { TOGETHER } else { 1 };
        let scalars = vec![reference.clone().ready(plan); together];
        Self { plan, arch: pulp::Arch::new(), lanes: Vec::new(), scalars }
    }

    /// Solves motion, loads and forces, as far as the plan goes, and hands out every position with its number.
    /// Allocates nothing. Loads that are evaluated at every position, and senses of friction, are not known here and left
    /// out.
    pub fn run(&mut self, inputs: &DriveColumns, mut each: impl FnMut(usize, Place<'_>)) {
        // quantities that no column holds are not read again
        self.lanes.iter_mut().for_each(|block| block.motion.inputs.fill(DriveInput::default()));
        self.scalars.iter_mut().for_each(|state| state.motion.inputs.fill(DriveInput::default()));
        let mut first = 0;
        while first < inputs.len() {
            let left = inputs.len() - first;
            let full = (left / WIDTH).min(self.lanes.len());
            let count = if full > 0 { full * WIDTH } else { left };
            if full > 0 {
                self.in_lanes(inputs, first, full, &mut each);
            } else {
                self.one_by_one(inputs, first..first + count, &mut each);
            }
            first += count;
        }
    }

    #[inline(always)]
    fn in_lanes(
        &mut self,
        inputs: &DriveColumns,
        first: usize,
        full: usize,
        each: &mut impl FnMut(usize, Place<'_>),
    ) {
        let closed = Closed { plan: self.plan, blocks: &mut self.lanes[..full], keeps_loads: false };
        run_lanes(self.arch, InLanes { closed, inputs, first });
        for i in 0..full {
            let (block, first) = (&self.lanes[i], first + i * WIDTH);
            if block.motion.open.is_none() {
                (0..WIDTH).for_each(|lane| each(first + lane, Place::Lane(block, lane)));
            } else {
                self.one_by_one(inputs, first..first + WIDTH, each);
            }
        }
    }

    #[inline(always)]
    fn one_by_one(
        &mut self,
        inputs: &DriveColumns,
        mut places: Range<usize>,
        each: &mut impl FnMut(usize, Place<'_>),
    ) {
        while !places.is_empty() {
            let count = places.len().min(self.scalars.len());
            let states = &mut self.scalars[..count];
            for (state, i) in states.iter_mut().zip(places.clone()) {
                inputs.read(i, &mut state.motion.inputs);
            }
            match &mut *states {
                [state] => alone(self.plan, state),
                states => run_scalars(self.plan, states),
            }
            states.iter().zip(&mut places).for_each(|(state, i)| each(i, Place::Alone(state)));
        }
    }
}

// these three are not written out in `run`, of which there is one for every caller
#[inline(never)]
fn run_lanes(arch: pulp::Arch, laned: InLanes<'_>) {
    arch.dispatch(laned);
}

/// The first [`WIDTH`] positions in AVX2 and nothing else, which a machine with AVX-512 never takes by itself; none where the
/// machine has no AVX2.
#[cfg(target_arch = "x86_64")]
#[must_use]
pub fn block_in_avx2(plan: &Plan, reference: &State, inputs: &DriveColumns) -> Option<State<Lanes<WIDTH>>> {
    let avx2 = pulp::x86::V3::try_new()?;
    let mut block = State::closed(plan);
    block.branches.clone_from(&reference.branches);
    let mut blocks = [block];
    let closed = Closed { plan, blocks: &mut blocks, keeps_loads: false };
    pulp::Simd::vectorize(avx2, InLanes { closed, inputs, first: 0 });
    let [block] = blocks;
    Some(block)
}

/// One position by itself, of any plan.
#[inline(never)]
fn alone(plan: &Plan, state: &mut State) {
    state.run(plan);
}

/// How many numbers the machine takes in one instruction.
struct InOneInstruction;

impl pulp::WithSimd for InOneInstruction {
    type Output = usize;

    fn with_simd<A: pulp::Simd>(self, _: A) -> usize {
        A::F64_LANES
    }
}

/// Blocks of lanes, and the inputs of their positions from the `first` on. Compiled once per set of instructions.
struct InLanes<'a> {
    closed: Closed<'a, Lanes<WIDTH>>,
    inputs: &'a DriveColumns,
    first: usize,
}

impl pulp::WithSimd for InLanes<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<A: pulp::Simd>(mut self, _: A) {
        // never asked for without lanes: not compiled either
        if A::F64_LANES == 1 {
            return;
        }
        for (i, block) in self.closed.blocks.iter_mut().enumerate() {
            // read here: a vector stored in halves is slow to load as a whole
            self.inputs.read_lanes(self.first + i * WIDTH, &mut block.motion.inputs);
        }
        self.closed.run();
    }
}

impl Place<'_> {
    /// Motion of a body.
    #[inline]
    #[must_use]
    pub fn body(&self, slot: usize) -> BodyState {
        match self {
            Self::Alone(state) => state.motion.bodies[slot],
            Self::Lane(state, i) => {
                let b = &state.motion.bodies[slot];
                BodyState {
                    p: vector(b.p, *i),
                    u: vector(b.u, *i),
                    v: vector(b.v, *i),
                    omega: b.omega.0[*i],
                    a: vector(b.a, *i),
                    alpha: b.alpha.0[*i],
                    turned: b.turned.0[*i],
                }
            }
        }
    }

    /// Reaction of a slot.
    #[inline]
    #[must_use]
    pub fn reaction(&self, slot: usize) -> Reaction {
        match self {
            Self::Alone(state) => state.forces.reactions[slot],
            Self::Lane(state, i) => {
                let r = &state.forces.reactions[slot];
                Reaction { force: vector(r.force, *i), couple: r.couple.0[*i] }
            }
        }
    }

    /// Unknown effort of a slot, N or N m.
    #[inline]
    #[must_use]
    pub fn effort(&self, slot: usize) -> f64 {
        match self {
            Self::Alone(state) => state.forces.efforts[slot],
            Self::Lane(state, i) => state.forces.efforts[slot].0[*i],
        }
    }

    /// Signed condition figure of a group of motion.
    #[inline]
    #[must_use]
    pub fn conditioning(&self, group: usize) -> f64 {
        match self {
            Self::Alone(state) => state.motion.conditions[group],
            Self::Lane(state, i) => state.motion.conditions[group].0[*i],
        }
    }

    /// Signed condition figure of a group of forces.
    #[inline]
    #[must_use]
    pub fn force_conditioning(&self, group: usize) -> f64 {
        match self {
            Self::Alone(state) => state.forces.conditions[group],
            Self::Lane(state, i) => state.forces.conditions[group].0[*i],
        }
    }

    /// The first group that does not close: what follows it has no meaning.
    #[inline]
    #[must_use]
    pub fn open(&self) -> Option<usize> {
        match self {
            Self::Alone(state) => state.motion.open,
            Self::Lane(..) => None,
        }
    }
}

#[inline]
fn vector(v: V2<Lanes<WIDTH>>, lane: usize) -> Vec2 {
    Vec2::new(v.x.0[lane], v.y.0[lane])
}
