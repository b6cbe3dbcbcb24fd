//! Rows of variants that differ from one another in numbers alone: their mechanism, structure and plan stay, and take the
//! numbers of each row.

use super::compile::Compiled;
use super::followed::followed;
use super::solved::Solved;
use crate::exercise;
use assur_check::{Row, RowPatches};
use assur_position::plan;
use assur_solve::solve::{Again, Conduct, Reads, Solution};
use assur_text::diagnostic::Problems;

/// What rows with the same columns have in common.
pub struct QuickRows {
    patches: RowPatches,
    /// The joints whose numbers depend on the row.
    differ: Vec<bool>,
    solved: Solved,
    /// Where it has one position, and nothing is to be said of it.
    again: Option<Again>,
    reads: Reads,
}

impl QuickRows {
    /// For a file that was compiled with one of its rows, of which nothing was to be said; `None` where a row may change more
    /// than numbers.
    pub fn new(patches: RowPatches, compiled: Compiled, reads: Reads) -> Option<Self> {
        if !compiled.structure.is_renumbered(&compiled.mechanism) || compiled.origin.is_some() {
            return None;
        }
        let again = Again::of(&compiled.model(), reads);
        let differ = compiled.structure.joints_of(patches.pairs());
        let solved = Solved { compiled, solution: Solution::default(), outcomes: Vec::new(), reached: None };
        Some(Self { patches, differ, solved, again, reads })
    }

    /// Puts a row into the mechanism, its structure and its plan; `None` where it takes more.
    pub fn compile(&mut self, row: &Row) -> Option<&Compiled> {
        let Compiled { mechanism, structure, plan, .. } = &mut self.solved.compiled;
        if !self.patches.put(row, mechanism) {
            return None;
        }
        structure.renumber(mechanism, &self.differ);
        if plan.is_renumbered() {
            plan.renumber_steps(mechanism, structure, &self.differ);
            if self.reads.residuals {
                plan.renumber_balance(mechanism, structure);
            }
        } else {
            *plan = plan::plan(mechanism, structure);
        }
        Some(&self.solved.compiled)
    }

    /// The solution of the row that was compiled last, and all that was found on the way.
    pub fn solve(&mut self, conduct: &Conduct<'_>) -> (Option<&Solved>, Problems) {
        let Solved { compiled, solution, outcomes, .. } = &mut self.solved;
        let mut problems = Problems::new();
        let again = self.again.as_mut();
        if !again.is_some_and(|again| again.solve(&compiled.model(), solution)) {
            let Compiled { mechanism, structure, plan, .. } = &mut *compiled;
            if plan.is_renumbered() && !self.reads.residuals {
                plan.renumber_balance(mechanism, structure);
            }
            let model = compiled.model();
            match followed(&model, None, None, conduct) {
                Ok(Some((found, said))) => (*solution, problems) = (found, said),
                Ok(None) => return (None, problems),
                Err(problems) => return (None, problems),
            }
        }
        *outcomes = exercise::evaluate(&compiled.model(), solution, &mut problems);
        (Some(&self.solved), problems)
    }
}
