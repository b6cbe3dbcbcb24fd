//! A text that is checked once, and solved at any positions.

use super::columns::Columns;
use super::filling::{Blank, Filling};
use super::positions::{self, Drive, GivenPositions, PositionsError};
use super::solution::{Diagnostics, Expectation};
use super::workers::{OnePosition, Workers};
use crate::exercise;
use crate::pipeline::{Compiled, followed, solve_conducted};
use crate::report::{Answers, PrintedDigits};
use assur_model::model::Mechanism;
use assur_solve::solve::{IntegrationOptions, Model, Progress};
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use std::sync::{Mutex, OnceLock};
use thiserror::Error;

/// A text without errors, ready to be solved.
#[derive(Debug)]
pub struct Checked {
    source: Source,
    compiled: Compiled,
    /// Warnings of the check.
    problems: Problems,
    within: Option<f64>,
    blank: OnceLock<Blank>,
    one: Mutex<Option<OnePosition>>,
}

/// Why there are no columns.
#[derive(Debug, Error)]
pub enum ColumnsError {
    /// The text cannot be solved.
    #[error("{0}")]
    Diagnostics(Diagnostics),
    /// The positions cannot be used.
    #[error(transparent)]
    Positions(#[from] PositionsError),
    /// The workers did not want to go on.
    #[error("stopped")]
    Stopped,
}

impl Checked {
    pub(super) fn new(source: Source, compiled: Compiled, problems: Problems, within: Option<f64>) -> Self {
        let (blank, one) = (OnceLock::new(), Mutex::new(None));
        Self { source, compiled, problems, within, blank, one }
    }

    /// The drives, in the order of the text.
    #[must_use]
    pub fn drives(&self) -> Vec<Drive> {
        positions::drives(&self.compiled.mechanism)
    }

    /// Solves the text at all its positions.
    ///
    /// # Errors
    /// The diagnostics of a text that cannot be solved. Positions without a solution are listed in [`Columns::failures`].
    pub fn columns(&self, workers: &dyn Workers) -> Result<Columns, ColumnsError> {
        self.filled(&self.compiled.mechanism, 0, workers)
    }

    /// Solves the text at other positions: by the names of its drives, without a name for the only one. A drive that is not named keeps
    /// its position, if it has one. Poses and expectations of the text are left out.
    ///
    /// # Errors
    /// Positions that cannot be used, and as [`Checked::columns`].
    pub fn columns_at(&self, given: GivenPositions, workers: &dyn Workers) -> Result<Columns, ColumnsError> {
        let lengths = given.iter().map(|(_, positions)| positions.len());
        let (least, most) = (lengths.clone().min().unwrap_or(0), lengths.max().unwrap_or(0));
        if (least, most) == (1, 1) && self.within.is_none() {
            let filling = self.filling(workers, &|_, _| true);
            if let Some(columns) = self.at_one(given.clone(), filling)? {
                return Ok(Columns { diagnostics: Diagnostics::of(&self.problems, &self.source), ..columns });
            }
        }
        let empty = !given.is_empty() && least == 0;
        let moved = positions::moved(&self.compiled.mechanism, given)?;
        if empty {
            return Ok(self.filling(workers, &|_, _| true).end());
        }
        self.filled(&moved, most, workers)
    }

    /// In the memory of the last position, if nobody else uses it.
    fn at_one(&self, given: GivenPositions, filling: Filling<'_>) -> Result<Option<Columns>, PositionsError> {
        let Ok(mut one) = self.one.try_lock() else { return Ok(None) };
        let one = one.get_or_insert_with(|| OnePosition::of(&self.compiled));
        one.solve(&self.compiled, given, filling)
    }

    fn filling<'w>(&self, workers: &'w dyn Workers, watch: &'w Progress<'w>) -> Filling<'w> {
        let blank = self.blank.get_or_init(|| Blank::of(&self.compiled.model()));
        Filling::of(blank.clone(), workers, watch)
    }

    const fn model<'m>(&'m self, mechanism: &'m Mechanism) -> Model<'m> {
        Model { mechanism, structure: &self.compiled.structure, plan: &self.compiled.plan }
    }

    fn filled(
        &self,
        mechanism: &Mechanism,
        count: usize,
        workers: &dyn Workers,
    ) -> Result<Columns, ColumnsError> {
        let watch = |_: f64, _: f64| workers.goes_on();
        let model = self.model(mechanism);
        let mut filling = self.filling(workers, &watch);
        filling.make_room(count);
        let (found, mut problems) = match self.within {
            None => self.each_position(&model, &mut filling),
            Some(within) => self.accurate(mechanism, within, &mut filling),
        };
        if !filling.goes_on || !workers.goes_on() {
            return Err(ColumnsError::Stopped);
        }
        let mut all = self.problems.clone();
        all.append(std::mem::take(&mut problems));
        let diagnostics = Diagnostics::of(&all, &self.source);
        match found {
            Some(expectations) => Ok(Columns { expectations, diagnostics, ..filling.end() }),
            None => Err(ColumnsError::Diagnostics(diagnostics)),
        }
    }

    /// One position after another: none is kept.
    fn each_position(
        &self,
        model: &Model<'_>,
        filling: &mut Filling<'_>,
    ) -> (Option<Vec<Expectation>>, Problems) {
        let origin = self.compiled.origin.as_ref();
        match followed(model, origin, Some(filling), &IntegrationOptions::default()) {
            Err(problems) => (None, problems),
            Ok(None) => (None, Problems::new()),
            Ok(Some((solution, mut problems))) => {
                let outcomes = exercise::evaluate(model, &solution, &mut problems);
                let precision = PrintedDigits::READABLE;
                let answers = Answers {
                    model: *model,
                    solution: &solution,
                    outcomes: &outcomes,
                    reached: None,
                    precision,
                };
                if filling.is_empty() {
                    filling.add_without_pose(&answers);
                }
                (Some(outcomes.iter().map(Expectation::of).collect()), problems)
            }
        }
    }

    /// With the settings that keep an accuracy: all positions are kept to find them.
    fn accurate(
        &self,
        mechanism: &Mechanism,
        within: f64,
        filling: &mut Filling<'_>,
    ) -> (Option<Vec<Expectation>>, Problems) {
        let Compiled { structure, plan, origin, .. } = &self.compiled;
        let compiled = Compiled {
            mechanism: mechanism.clone(),
            structure: structure.clone(),
            plan: plan.clone(),
            origin: origin.clone(),
        };
        let (solved, problems) = solve_conducted(compiled, Some(within), &IntegrationOptions::default());
        let Ok(solved) = solved else { return (None, problems) };
        let answers = solved.answers(PrintedDigits::READABLE);
        for pose in answers.poses() {
            crate::pipeline::Sink::add(filling, &answers, pose);
        }
        if filling.is_empty() {
            filling.add_without_pose(&answers);
        }
        (Some(solved.outcomes.iter().map(Expectation::of).collect()), problems)
    }
}
