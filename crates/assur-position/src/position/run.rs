//! One position as far as its plan goes: the one place that orders motion, loads, lines of forces and forces.

use super::model::Model;
use super::state::State;
use crate::model::{LoadId, Value};
use crate::plan::{Level, Plan};

impl State {
    /// Motion, loads and forces, with the drives' inputs and the branches set. Loads that are evaluated at every position
    /// are left out. Allocates nothing.
    pub fn run(&mut self, plan: &Plan) {
        self.run_planned_motion(plan);
        if plan.effects.forces {
            self.known_loads(plan);
            self.run_balance(plan);
        }
    }

    /// Motion as far as the plan follows it. Allocates nothing.
    pub fn run_planned_motion(&mut self, plan: &Plan) {
        match plan.effects.level {
            Level::Positions => self.run_motion::<0>(plan),
            Level::Velocities => self.run_motion::<1>(plan),
            Level::Accelerations => self.run_motion::<2>(plan),
        }
        if plan.effects.beyond {
            self.run_higher_rates(plan);
            for part in &plan.parts {
                self.motion.bodies[part.part] = self.motion.bodies[part.body].carried(part);
            }
        }
    }

    /// Loads and forces of a state whose motion is known, with the values of the loads that are evaluated at every
    /// position, see [`State::run_loads`].
    pub fn run_loads_and_forces(&mut self, model: &Model<'_>, evaluated: &[(LoadId, Value)]) {
        self.run_loads(model, evaluated);
        self.run_balance(model.plan);
    }

    /// Forces from the loads in `wrenches`, which are kept for the residuals.
    fn run_balance(&mut self, plan: &Plan) {
        self.forces.applied.clone_from(&self.forces.wrenches);
        self.bear_loads(plan);
        self.set_lines(plan);
        if self.is_gripped() {
            self.run_gripped_forces(plan);
        } else {
            if plan.effects.friction {
                self.set_senses(plan);
            }
            self.run_forces(plan);
        }
        self.find_weld_reactions(plan);
    }

    /// The forces again from the same loads, without friction and losses.
    pub fn run_again_without_friction(&mut self, plan: &Plan) {
        self.forces.wrenches.clone_from(&self.forces.applied);
        self.bear_loads(plan);
        self.forces.frictions.fill(0.0);
        self.forces.locked = false;
        self.run_forces_without_friction(plan);
        self.find_weld_reactions(plan);
    }
}
