//! The same plan with the numbers of another mechanism, in the memory that it has.

use super::force_step::ForceStep;
use super::planned::Plan;
use super::step::MotionStep;
use super::{forces, loads, motion};
use crate::model::Mechanism;
use crate::structure::Structure;

impl Plan {
    /// Whether [`Plan::renumber_steps`] knows all of its steps: closed forms without friction, laws and driven points.
    #[must_use]
    pub fn is_renumbered(&self) -> bool {
        let motion = |step: &MotionStep| {
            !matches!(
                step,
                MotionStep::Train { .. }
                    | MotionStep::Triad { .. }
                    | MotionStep::Cam { .. }
                    | MotionStep::CamTurned { .. }
                    | MotionStep::Geneva { .. }
                    | MotionStep::General { .. }
            )
        };
        let force = |step: &ForceStep| {
            !matches!(
                step,
                ForceStep::Train { .. }
                    | ForceStep::Triad(_)
                    | ForceStep::General { .. }
                    | ForceStep::Sequence(_)
                    | ForceStep::Friction { .. }
            )
        };
        self.outer.is_empty()
            && self.parts.is_empty()
            && !self.effects.beyond
            && self.laws.is_empty()
            && self.friction.is_empty()
            && self.motion.iter().all(motion)
            && self.forces.iter().all(force)
    }

    /// Takes over the numbers of a mechanism that calls for the same steps, see [`Plan::is_renumbered`]. The equations by which the
    /// balance of forces is checked are left out.
    pub fn renumber_steps(&mut self, mechanism: &Mechanism, structure: &Structure) {
        for (branch, group) in structure.motion.iter().enumerate() {
            if let Some(step) = motion::closed(structure, group, branch) {
                self.motion[branch] = step;
            }
        }
        if self.effects.forces {
            self.renumber_forces(mechanism, structure);
        }
        self.checks.renumber_joints(structure);
    }

    /// The equations by which the balance of forces is checked.
    pub fn renumber_balance(&mut self, mechanism: &Mechanism, structure: &Structure) {
        let mut checks = std::mem::take(&mut self.checks);
        checks.renumber_forces(mechanism, structure, self);
        self.checks = checks;
    }

    fn renumber_forces(&mut self, mechanism: &Mechanism, structure: &Structure) {
        loads::plan(mechanism, &self.effects, &mut self.loads);
        loads::lines(mechanism, structure, &mut self.lines);
        let mut first = 0;
        for (index, group) in structure.forces.iter().enumerate() {
            let moved_by = match &self.forces[index] {
                ForceStep::Rrr { motion, .. } | ForceStep::Rrp { motion, .. } => *motion,
                _ => None,
            };
            if let Some(step) = forces::closed(structure, group, first, self, moved_by) {
                self.forces[index] = step;
            }
            first += group.joints.len();
        }
    }
}
