//! A `.mech` text, compiled once, and its plan run over the text's positions through the public interface.
#![allow(dead_code)] // every bench uses some of it

#[cfg(feature = "lanes")]
pub mod turn;

use assur::internals::Compiled;
use assur::internals::check::Overrides;
#[cfg(feature = "lanes")]
use assur::internals::solve::{Batch, DriveColumns};
use assur::internals::solve::{DriveInput, State, solve};
use assur::internals::source::Source;

/// A text ready to be run.
pub struct Run {
    pub compiled: Compiled,
    /// Assembled at the first position.
    pub state: State,
    /// All drives at the first position, at the second, and so on.
    pub inputs: Vec<DriveInput>,
}

impl Run {
    /// Compiles a text, solves it once, and keeps where its drives stand. What is run again keeps the assembly of the first
    /// position.
    pub fn of(text: &str) -> Self {
        let (compiled, problems) =
            assur::internals::compile(&Source::new("scene.mech", text.to_owned()), &Overrides::none());
        assert!(!problems.has_errors(), "the model is sound");
        let compiled = compiled.expect("the model compiles");
        let solution = solve(&compiled.model()).expect("the model is solved");
        let states: Vec<&State> = solution
            .poses
            .iter()
            .map(|p| &p.outcome.as_ref().expect("every position closes").state)
            .collect();
        assert!(states.iter().all(|s| s.branches == states[0].branches), "no change points");
        let inputs = states.iter().flat_map(|s| s.motion.inputs.clone()).collect();
        Self { state: states[0].clone().ready(&compiled.plan), inputs, compiled }
    }

    pub fn positions(&self) -> usize {
        self.inputs.len() / self.compiled.plan.drives
    }

    /// Everything that the plan holds, at one position.
    #[inline]
    pub fn at(&mut self, inputs: &[DriveInput]) {
        self.state.motion.inputs.iter_mut().zip(inputs).for_each(|(to, from)| *to = *from);
        self.state.run(&self.compiled.plan);
    }

    /// All positions, one by one; the sum of something of every position, so that nothing is left out.
    pub fn one_by_one(&mut self) -> f64 {
        let inputs = std::mem::take(&mut self.inputs);
        let mut sum = 0.0;
        for input in inputs.chunks_exact(self.compiled.plan.drives) {
            self.at(input);
            if self.compiled.plan.effects.forces {
                sum += self.state.forces.efforts[0];
            }
            sum += self.state.motion.bodies[1].p.x;
        }
        self.inputs = inputs;
        sum
    }

    #[cfg(feature = "lanes")]
    /// The same side by side, in lanes or in one, with the inputs as it reads them.
    pub fn together(&self, in_lanes: bool) -> (Batch<'_>, DriveColumns) {
        let plan = &self.compiled.plan;
        let new = if in_lanes { Batch::new } else { Batch::in_one_lane };
        (new(plan, &self.state), DriveColumns::of(&self.inputs, plan.drives))
    }
}

/// One round of positions side by side.
#[cfg(feature = "lanes")]
pub fn side_by_side(lanes: &mut Batch<'_>, inputs: &DriveColumns, forces: bool) -> f64 {
    let mut sum = 0.0;
    lanes.run(inputs, |_, place| {
        sum += place.body(1).p.x;
        if forces {
            sum += place.effort(0);
        }
    });
    sum
}

/// The text with other requests: everything from its first `find` on is left out.
pub fn asking(text: &str, find: &str) -> String {
    let (machine, _) = text.split_once("\nfind ").expect("a model that asks for something");
    format!("{machine}\nfind {find}\n")
}
