//! Who does work that can be divided.

use super::columns::Columns;
use super::filling::Filling;
use super::positions::{GivenPositions, PositionsError, place};
use crate::pipeline::{Compiled, Sink};
use crate::report::{Answers, PrintedDigits};
use assur_model::model::{Mechanism, Positions};
use assur_solve::solve::{Model, PoseOutputs, ReusedSolver, Solution};

/// Who solves positions and rows that do not depend on one another: the caller alone, or several threads of its own.
///
/// The results are the same, bit by bit, whoever does the work.
pub trait Workers: Sync {
    /// On how many threads positions and rows are solved, with the caller's: see [`Workers::beside`].
    fn threads(&self) -> usize {
        1
    }

    /// Calls `help` on every other thread, while `own` runs on the caller's; comes back when all have ended. Fewer threads are
    /// enough: what nobody helps with is done by `own`.
    fn beside(&self, _help: &(dyn Fn() + Sync), own: &mut dyn FnMut()) {
        own();
    }

    /// Whether to go on. It is asked now and then, on the caller's thread.
    fn goes_on(&self) -> bool {
        true
    }

    /// Whether [`Workers::goes_on`] was denied, for work on any thread.
    fn is_stopped(&self) -> bool {
        false
    }
}

/// The caller alone.
#[derive(Clone, Copy, Debug, Default)]
pub struct Alone;

impl Workers for Alone {}

// One position after another, each in the memory of the last.

/// Memory for one position at a time.
pub(super) struct OnePosition {
    mechanism: Mechanism,
    /// Once it was looked for; `None` in it where a position takes more than this memory.
    again: Option<Option<ReusedSolver>>,
    solution: Solution,
}

/// Columns show the residuals.
const READS: PoseOutputs = PoseOutputs { residuals: true, angles: false };

impl std::fmt::Debug for OnePosition {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("OnePosition").field("solution", &self.solution).finish_non_exhaustive()
    }
}

impl OnePosition {
    pub fn of(compiled: &Compiled) -> Self {
        let mut mechanism = compiled.mechanism.clone();
        (mechanism.poses, mechanism.expects) = (Vec::new(), Vec::new());
        Self { mechanism, again: None, solution: Solution::default() }
    }

    /// The columns of a position; `None` where it takes more than this memory.
    pub fn solve(
        &mut self,
        compiled: &Compiled,
        given: GivenPositions,
        mut filling: Filling<'_>,
    ) -> Result<Option<Columns>, PositionsError> {
        place(&compiled.mechanism, given, &mut self.mechanism)?;
        let Compiled { structure, plan, .. } = compiled;
        let model = Model { mechanism: &self.mechanism, structure, plan };
        if !is_one(&self.mechanism) {
            return Ok(None);
        }
        let Some(again) = self.again.get_or_insert_with(|| ReusedSolver::of(&model, READS)) else {
            return Ok(None);
        };
        if !again.solve(&model, &mut self.solution) {
            return Ok(None);
        }
        let solution = &self.solution;
        let precision = PrintedDigits::READABLE;
        let answers = Answers { model, solution, outcomes: &[], reached: None, precision };
        for pose in &solution.poses {
            filling.add(&answers, pose);
        }
        Ok(Some(filling.end()))
    }
}

/// Whether every drive has one position.
fn is_one(mechanism: &Mechanism) -> bool {
    let one = |positions: &Positions| matches!(positions, Positions::List(list) if list.len() == 1);
    mechanism.drives.iter().all(|drive| one(&drive.positions))
}
