//! A `.mech` text, compiled once, and its plan run over the text's positions through the public interface.
#![allow(dead_code)] // every bench uses some of it

pub mod turn;

use assur::internals::Compiled;
use assur::internals::check::Overrides;
use assur::internals::plan::Plan;
use assur::internals::solve::{Checked, DriveInput, F64x8, LaneSolver, State, WIDTH, solve};
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

    /// Memory for the same in lanes.
    pub fn side_by_side(&self) -> SideBySide {
        let plan = &self.compiled.plan;
        let mut row = State::closed(plan);
        row.branches.clone_from(&self.state.branches);
        let mut inputs = vec![DriveInput::default(); plan.drives * self.positions().div_ceil(WIDTH)];
        for (i, input) in self.inputs.iter().enumerate() {
            let (position, drive) = (i / plan.drives, i % plan.drives);
            inputs[position / WIDTH * plan.drives + drive].set_lane(position % WIDTH, input);
        }
        SideBySide {
            rows: vec![row; ROWS],
            checked: vec![Checked::default(); ROWS],
            inputs,
            ..SideBySide::default()
        }
    }
}

/// Rows of lanes that are solved at once: what they hold stays in the nearest cache.
const ROWS: usize = 2;

/// All positions of a text, side by side.
#[derive(Default)]
pub struct SideBySide {
    rows: Vec<State<F64x8>>,
    checked: Vec<Checked>,
    solver: LaneSolver,
    /// All drives of the first row of positions, of the second, and so on.
    pub inputs: Vec<DriveInput<F64x8>>,
}

impl SideBySide {
    /// Solves them; directions of drives that are `turned` are found from their angles.
    pub fn all(&mut self, plan: &Plan, turned: &[usize], mut each: impl FnMut(usize, &State<F64x8>)) {
        let rows = self.inputs.len() / plan.drives;
        for first in (0..rows).step_by(ROWS) {
            let count = ROWS.min(rows - first);
            let (states, checked) = (&mut self.rows[..count], &mut self.checked[..count]);
            for (state, inputs) in
                states.iter_mut().zip(self.inputs[first * plan.drives..].chunks(plan.drives))
            {
                state.motion.inputs.copy_from_slice(inputs);
            }
            self.solver.run(plan, (states, turned), checked, false);
            self.rows[..count].iter().enumerate().for_each(|(i, row)| each(first + i, row));
        }
    }

    /// The same with directions given; the sum of something of every row, so that nothing is left out.
    pub fn sum(&mut self, plan: &Plan) -> f64 {
        let mut sum = 0.0;
        self.all(plan, &[], |_, row| {
            sum += row.motion.bodies[1].p.x.0[0];
            if plan.effects.forces {
                sum += row.forces.efforts[0].0[0];
            }
        });
        sum
    }
}

/// The text with other requests: everything from its first `find` on is left out.
pub fn asking(text: &str, find: &str) -> String {
    let (machine, _) = text.split_once("\nfind ").expect("a model that asks for something");
    format!("{machine}\nfind {find}\n")
}
