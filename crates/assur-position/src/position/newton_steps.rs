//! The iteration of a group that has no closed form once more, step by step, for those who want to read it.

use super::general::to_start;
use super::state::State;
use crate::group::NewtonStep;
use crate::group::general::InitialGuess;
use crate::group::triad::modes;
use crate::plan::{MotionStep, Plan};

impl State {
    /// The steps by which a group comes from where its bodies stand to where they belong; the group stands there afterwards.
    /// Of a group that is followed in parts those of the last part. Nothing for a closed form, and where the group does not close.
    #[must_use]
    pub fn newton_steps(&mut self, plan: &Plan, index: usize) -> Vec<NewtonStep> {
        let mut seen = Vec::new();
        match plan.motion.get(index) {
            Some(MotionStep::Triad { branch, triad }) => {
                self.triad::<0>(*branch, triad, plan.settings.triad, &mut seen);
            }
            Some(MotionStep::General { branch, problem }) => {
                let (group, small) = (&plan.general[*problem], plan.settings.newton);
                self.general::<0>(*branch, *problem, group, small, &mut seen);
            }
            _ => {}
        }
        if self.motion.open.is_some() { Vec::new() } else { seen }
    }

    /// The steps by which the search for the assemblies of a group comes first to how its bodies stand.
    #[must_use]
    pub fn search_steps(
        &mut self,
        plan: &Plan,
        index: usize,
        search: (usize, Option<&InitialGuess>),
    ) -> Vec<NewtonStep> {
        match plan.motion.get(index) {
            Some(MotionStep::Triad { triad, .. }) => {
                let ends = self.triad_ends(triad);
                let mut seen = Vec::new();
                if let Some(start) = modes::start_of(&triad.plate, &ends, &self.triad_pose(triad)) {
                    let found = triad.plate.uncertified(&ends, &start, &mut seen);
                    seen.truncate(if found.is_some() { seen.len() } else { 0 });
                }
                seen
            }
            Some(MotionStep::General { branch, problem })
                if to_start(self, *branch, *problem, &plan.general[*problem], search) =>
            {
                self.newton_steps(plan, index)
            }
            _ => Vec::new(),
        }
    }
}
