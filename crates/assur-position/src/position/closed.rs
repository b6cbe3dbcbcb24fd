//! Blocks of positions of a plan that can be batched, step by step: every step on all blocks before the next.
//!
//! The steps of one position wait for each other; those of another fill the time.

use super::state::State;
use crate::math::Scalar;
use crate::plan::{Level, Plan};

/// The plan, and blocks with the inputs of their drives.
pub(super) struct Closed<'a, S> {
    pub plan: &'a Plan,
    pub blocks: &'a mut [State<S>],
}

impl<S: Scalar> Closed<'_, S> {
    /// Motion, loads and forces, as far as the plan goes. Loads that are evaluated at every position are left out.
    #[cfg_attr(in_one, inline(always))]
    pub fn run(&mut self) {
        match self.plan.effects.level {
            Level::Positions => self.motion::<0>(),
            Level::Velocities => self.motion::<1>(),
            Level::Accelerations => self.motion::<2>(),
        }
        if self.plan.effects.forces {
            self.forces();
        }
    }

    #[cfg_attr(in_one, inline(always))]
    fn motion<const LEVEL: u8>(&mut self) {
        for block in &mut *self.blocks {
            block.start(self.plan);
        }
        for step in &self.plan.motion {
            for block in &mut *self.blocks {
                block.closed_form::<LEVEL>(step);
            }
        }
    }

    #[cfg_attr(in_one, inline(always))]
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
        // kept apart from what the steps of forces add to them: residuals and answers read them
        self.blocks.iter_mut().for_each(|block| block.forces.applied.clone_from(&block.forces.wrenches));
        for (index, step) in self.plan.forces.iter().enumerate() {
            for block in &mut *self.blocks {
                block.forces.conditions[index] = block.closed_force(step);
            }
        }
    }
}
