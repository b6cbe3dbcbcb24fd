//! Positions that do not depend on one another, several side by side in one lane, each checked. Lanes gain nothing here: every
//! position is written into a state of its own, which takes longer than they save.

use super::check::Sums;
use super::closed::run_scalars;
use super::residual::Residuals;
use super::state::State;
use crate::plan::{Level, Plan};

/// Positions that go step by step together.
const TOGETHER: usize = 8;

/// Memory for positions of plans that are [batchable](Plan::is_batchable).
#[derive(Debug, Default)]
pub struct Together {
    sums: Sums<f64>,
}

impl Together {
    /// Solves motion, loads and forces of states in which inputs and assemblies are set, and checks them. Every state has the bits
    /// of [`State::run`]; where it has a group `open` it does not close. Without `forces` only the closure is checked. Allocates
    /// nothing once it has run.
    pub fn run(&mut self, plan: &Plan, states: &mut [State], residuals: &mut [Residuals], forces: bool) {
        for (states, residuals) in states.chunks_mut(TOGETHER).zip(residuals.chunks_mut(TOGETHER)) {
            run_scalars(plan, states, true);
            for (state, residuals) in states.iter().zip(residuals) {
                *residuals = if forces {
                    of_plan(plan, self.sums.residuals(plan, state))
                } else {
                    Residuals { closure: state.closure(&plan.checks), ..Residuals::default() }
                };
            }
        }
    }
}

/// Closure, equilibrium and power, as far as a plan has them.
fn of_plan(plan: &Plan, [closure, equilibrium, power]: [f64; 3]) -> Residuals {
    let forces = plan.has_forces();
    let moves = plan.effects.level >= Level::Velocities;
    Residuals {
        closure,
        equilibrium: forces.then_some(equilibrium),
        power: (forces && moves).then_some(power),
    }
}
