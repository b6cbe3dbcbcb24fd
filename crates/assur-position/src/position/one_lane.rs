//! Positions of a plan with closed forms in one lane, in the shorter code of AVX where there is any: the operations are the same.

use super::closed::Closed;
use super::state::State;
use crate::plan::Plan;

/// Positions step by step together.
#[inline(never)]
pub(super) fn run_scalars(plan: &Plan, blocks: &mut [State]) {
    let mut closed = Closed { plan, blocks, keeps_loads: false };
    #[cfg(target_arch = "x86_64")]
    if let Some(avx) = pulp::x86::V3::try_new() {
        return avx.vectorize(closed);
    }
    closed.run();
}

#[cfg(target_arch = "x86_64")]
impl pulp::NullaryFnOnce for Closed<'_, f64> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        self.run();
    }
}

pub(super) fn run_one(plan: &Plan, state: &mut State) {
    let one = One { plan, state };
    #[cfg(target_arch = "x86_64")]
    if let Some(avx) = pulp::x86::V3::try_new() {
        return avx.vectorize(one);
    }
    without_avx(one);
}

#[inline(never)]
fn without_avx(mut one: One<'_>) {
    one.run();
}

struct One<'a> {
    plan: &'a Plan,
    state: &'a mut State,
}

impl One<'_> {
    #[cfg_attr(in_one, inline(always))]
    fn run(&mut self) {
        // that it is one is known here, so that no loop over blocks is left
        Closed { plan: self.plan, blocks: std::slice::from_mut(self.state), keeps_loads: false }.run();
    }
}

#[cfg(target_arch = "x86_64")]
impl pulp::NullaryFnOnce for One<'_> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        self.run();
    }
}
