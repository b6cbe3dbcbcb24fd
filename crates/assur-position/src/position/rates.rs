//! Rates beyond accelerations, of all bodies, group by group: the higher derivatives of the same equations that positions,
//! velocities and accelerations obey are linear in them, with the gradients of the equations as their matrix. Groups of all
//! kinds have the one way.

use super::body::BodyState;
use super::equation::At;
use super::jet::PLACES;
use super::kinematics::Motion;
use super::state::State;
use crate::math::{Lu, Vec2};
use crate::plan::Plan;
use crate::plan::equation::RateGroup;

/// Solutions of each system: the second takes out what rounding has left of the first.
const CORRECTIONS: usize = 2;
/// The first of these derivatives.
const FIRST: usize = 3;

impl State {
    /// Rates from positions, velocities and accelerations; not a number where a group has no system for them. Allocates nothing.
    pub(super) fn run_higher_rates(&mut self, plan: &Plan) {
        let (Some(groups), Some(mut work)) = (&plan.rate_groups, self.scratch.rate_work.take()) else {
            return self.set_rates(0..self.motion.bodies.len(), f64::NAN);
        };
        self.set_rates(0..self.motion.bodies.len(), 0.0);
        work.rest(&self.motion);
        for order in FIRST..PLACES {
            for &(body, _, drive) in &plan.outer {
                *self.motion.bodies[body].rate_mut(order).0 = self.motion.inputs[drive].rate_of_point(order);
            }
        }
        for (group, (system, right)) in groups.iter().zip(&mut work.groups) {
            work.resting.gradients(plan, group, system);
            if !system.factor() {
                self.set_rates(group.bodies.iter().copied(), f64::NAN);
                continue;
            }
            for order in FIRST..PLACES {
                self.solve_rates(plan, group, order, (system, right));
            }
        }
        self.scratch.rate_work = Some(work);
    }

    fn solve_rates(
        &mut self,
        plan: &Plan,
        group: &RateGroup,
        order: usize,
        (system, right): (&mut Lu, &mut [f64]),
    ) {
        for _ in 0..CORRECTIONS {
            let Motion { bodies, inputs, .. } = &self.motion;
            let at = At { plan, bodies, inputs, chosen: &self.motion };
            for (slot, (equation, _)) in right.iter_mut().zip(&group.equations) {
                *slot = at.jet(equation).0[order];
            }
            system.solve(right);
            for (&slot, less) in group.bodies.iter().zip(right.chunks_exact(3)) {
                let (origin, turn) = self.motion.bodies[slot].rate_mut(order);
                *origin -= Vec2::new(less[0], less[1]);
                *turn -= less[2];
            }
        }
    }

    fn set_rates(&mut self, slots: impl Iterator<Item = usize>, to: f64) {
        for slot in slots {
            for order in FIRST..PLACES {
                let (origin, turn) = self.motion.bodies[slot].rate_mut(order);
                (*origin, *turn) = (Vec2::new(to, to), to);
            }
        }
    }
}

impl Motion {
    /// Writes the gradients of a group's equations: what unit rates of its bodies, which are at rest, make of their rates.
    fn gradients(&mut self, plan: &Plan, group: &RateGroup, system: &mut Lu) {
        system.clear();
        for (row, (equation, own)) in group.equations.iter().enumerate() {
            for &place in own {
                let slot = group.bodies[place];
                let resting = self.bodies[slot];
                for (i, moved) in unit_rates(&resting).into_iter().enumerate() {
                    self.bodies[slot] = moved;
                    let Self { bodies, inputs, .. } = &*self;
                    let at = At { plan, bodies, inputs, chosen: self };
                    *system.at_mut(row, 3 * place + i) = at.jet(equation).0[1];
                }
                self.bodies[slot] = resting;
            }
        }
    }
}

/// A body with a unit rate of each of its coordinates.
fn unit_rates(body: &BodyState) -> [BodyState; 3] {
    [
        BodyState { v: Vec2::new(1.0, 0.0), ..*body },
        BodyState { v: Vec2::new(0.0, 1.0), ..*body },
        BodyState { omega: 1.0, ..*body },
    ]
}
