//! The iteration of a group with friction once more, step by step, for those who want to read it.

use super::friction_work::FrictionWork;
use super::scratch::Scratch;
use super::state::State;
use crate::plan::{ForceStep, Plan};

/// Sees the steps of an iteration; `()` sees nothing, and costs nothing.
pub(super) trait FrictionLog {
    /// An iteration begins where this presses in the pairs: another before it came to nothing.
    fn begin(&mut self, presses: impl FnOnce() -> Vec<f64>);
    /// A step of it.
    fn step(&mut self, presses: impl FnOnce() -> Vec<f64>);
}

impl FrictionLog for () {
    #[inline(always)]
    fn begin(&mut self, _: impl FnOnce() -> Vec<f64>) {}
    #[inline(always)]
    fn step(&mut self, _: impl FnOnce() -> Vec<f64>) {}
}

impl FrictionLog for Vec<Vec<f64>> {
    fn begin(&mut self, presses: impl FnOnce() -> Vec<f64>) {
        self.clear();
        self.push(presses());
    }

    fn step(&mut self, presses: impl FnOnce() -> Vec<f64>) {
        self.push(presses());
    }
}

impl State {
    /// What presses in the pairs of a group with friction, in the order of its elements, N: without friction, then after every
    /// step of the iteration. Nothing for a group without friction and for one that needs no iteration, or does it with wheels.
    #[must_use]
    pub fn friction_steps(&self, plan: &Plan, index: usize) -> Vec<Vec<f64>> {
        let mut seen: Vec<Vec<f64>> = Vec::new();
        let Some(ForceStep::Friction { plain, group }) = plan.forces.get(index) else { return seen };
        // beside contacts that part the run gives the friction of all
        if plan.friction.iter().any(|element| element.stop.is_some()) {
            return seen;
        }
        let mut state = self.clone();
        // kept states have no memory of this
        state.scratch = Scratch::of(plan);
        state.forces.wrenches.clone_from(&self.forces.applied);
        state.bear_loads(plan);
        state.forces.locked = false;
        for (i, step) in plan.forces[..index].iter().enumerate() {
            match step {
                ForceStep::Friction { plain, group } => state.force_friction(plan, i, plain, group),
                plain => state.force_step(plan, plain),
            };
        }
        match &group.reduced {
            Some(elements) => {
                state.force_reduced(plan, plain, elements, (&mut 0, &mut seen));
                let place = |element: &usize| elements.iter().position(|e| *e == Some(*element));
                let places: Vec<Option<usize>> = group.elements.iter().map(place).collect();
                let own = |presses: Vec<f64>| places.iter().map(|p| p.map_or(0.0, |p| presses[p])).collect();
                seen.into_iter().map(own).collect()
            }
            None if group.laws.is_empty() => {
                let mut work = FrictionWork::new(group);
                state.save(group, &mut work.saved);
                state.rub(plan, plain, group, &mut work, &mut seen);
                seen
            }
            None => seen,
        }
    }
}
