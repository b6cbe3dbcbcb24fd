//! Welded links: they move with their bodies, and each is in equilibrium with what its weld does to it.

use super::free_body::Action;
use super::state::State;
use super::wrench::{Reaction, Wrench};
use crate::math::Scalar;
use crate::plan::Plan;

impl<S: Scalar> State<S> {
    /// Moves the parts of the bodies that this step of motion moves; without one those of bodies of known motion.
    #[inline]
    pub fn carry_parts(&mut self, plan: &Plan, after: Option<usize>) {
        for part in plan.parts.iter().filter(|part| part.after == after) {
            self.motion.bodies[part.part] = self.motion.bodies[part.body].carried(part);
        }
    }
}

impl State {
    /// Starts from the loads of all links: bodies bear those of their parts.
    pub fn bear_loads(&mut self, plan: &Plan) {
        for part in &plan.parts {
            let Wrench { force, moment } = self.forces.wrenches[part.part];
            let r = self.motion.bodies[part.part].p - self.motion.bodies[part.body].p;
            let body = &mut self.forces.wrenches[part.body];
            body.force += force;
            body.moment += moment + r.cross(force);
        }
    }

    /// What welds do, from the equilibrium of the links that they carry, outermost first.
    pub fn find_weld_reactions(&mut self, plan: &Plan) {
        if plan.welds.is_empty() {
            return;
        }
        for weld in &plan.welds {
            self.forces.reactions[weld.slot] = Reaction::default();
        }
        let mut totals = std::mem::take(&mut self.scratch.totals);
        totals.clone_from(&self.forces.applied);
        self.acts(plan, &mut |action| {
            for Action { on, at, force, couple, .. } in
                [Some(action), action.opposite()].into_iter().flatten()
            {
                totals[on].force += force;
                totals[on].moment += (at - self.motion.bodies[on].p).cross(force) + couple;
            }
        });
        for weld in plan.welds.iter().rev() {
            let (part, base) = (&self.motion.bodies[weld.part.body], &self.motion.bodies[weld.base]);
            let Wrench { force, moment } = totals[weld.part.body];
            let couple = moment - (part.position(weld.part.at) - part.p).cross(force);
            totals[weld.base].force += force;
            totals[weld.base].moment += moment + (part.p - base.p).cross(force);
            self.forces.reactions[weld.slot] = Reaction { force: -force, couple: -couple };
        }
        self.scratch.totals = totals;
    }
}
