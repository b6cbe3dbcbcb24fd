//! A file that is solved with one row of variants after another: what depends on no value is done once.

use super::compile::{Compiled, Origin, plan_mechanism};
use super::followed::followed;
use super::solved::{Solved, solve_conducted};
use crate::exercise;
use assur_check as check;
use assur_check::{Overrides, Row, RowPatches, Template};
use assur_model::structure::Structure;
use assur_position::plan;
use assur_solve::solve::{IntegrationOptions, Method, PoseOutputs, Progress, ReusedSolver, Solution};
use assur_syntax::document::Document;
use assur_text::diagnostic::Problems;
use std::sync::Arc;

/// A document that many rows of variants are solved for. Every row comes out as the file with these values would.
pub struct VariantSolver<'a> {
    document: &'a Arc<Document>,
    overrides: &'a Overrides,
    template: Option<Template<'a>>,
    /// The structure of the last row, where nothing was to be said of it.
    structure: Option<Structure>,
    /// The accuracy that is wanted.
    within: Option<f64>,
    /// How motions under loads are integrated.
    conduct: IntegrationOptions<'a>,
    /// What is read of rows beside their answers.
    reads: PoseOutputs,
    /// What rows have in common where they differ in numbers alone.
    quick: FastPath,
    /// The last row that was solved as a whole.
    last: Option<Solved>,
}

/// Rows that differ in numbers alone.
enum FastPath {
    /// Not looked for yet: this number of rows went before.
    After(usize),
    /// Looked for in vain.
    None,
    Rows(Box<FastRows>),
}

/// To look for them takes as long as some rows.
const ROWS_BEFORE: usize = 16;

impl<'a> VariantSolver<'a> {
    /// A document that could be read, with values that replace those of all rows.
    #[must_use]
    pub fn new(document: &'a Arc<Document>, overrides: &'a Overrides) -> Self {
        let template = Template::new(document, overrides);
        let (structure, within, quick, last) = (None, None, FastPath::After(0), None);
        let (conduct, reads) = (IntegrationOptions::default(), PoseOutputs::ALL);
        Self { document, overrides, template, structure, within, conduct, reads, quick, last }
    }

    /// With settings that keep an accuracy, row by row.
    #[must_use]
    pub fn within(self, within: Option<f64>) -> Self {
        Self { within, ..self }
    }

    /// With motions under loads that are integrated by a method.
    #[must_use]
    pub fn by(self, method: Option<Method>) -> Self {
        Self { conduct: IntegrationOptions { method, ..self.conduct }, ..self }
    }

    /// With motions under loads that are watched, and ended where that is wanted.
    #[must_use]
    pub fn watched(self, watch: &'a Progress<'a>) -> Self {
        Self { conduct: IntegrationOptions { watch: Some(watch), ..self.conduct }, ..self }
    }

    /// With rows of which nothing but their answers is read.
    #[must_use]
    pub fn for_answers(self) -> Self {
        Self { reads: PoseOutputs::ANSWERS, ..self }
    }

    /// The mechanism of a row with its structure and its plan, and all that was found on the way.
    pub fn compile(&mut self, row: &Row) -> (Option<Compiled>, Problems) {
        let origin = Overrides { values: self.overrides.values.clone(), row: row.clone() };
        let (mechanism, problems) = match &mut self.template {
            Some(template) => template.check(row),
            None => check::check(self.document, &origin),
        };
        let Some(mechanism) = mechanism else { return (None, problems) };
        let alike = self.structure.as_ref().and_then(|s| s.with_numbers_of(&mechanism));
        let origin =
            mechanism.asks_again().then(|| Origin { document: Arc::clone(self.document), overrides: origin });
        let known = alike.is_some();
        let (compiled, problems) = plan_mechanism(mechanism, alike, problems, origin, None);
        if let Some(compiled) = &compiled
            && !known
        {
            self.structure = problems.is_empty().then(|| compiled.structure.clone());
        }
        (compiled, problems)
    }

    /// As [`VariantSolver::solve`], in the memory of the rows before.
    pub fn solve_in_place(&mut self, row: &Row) -> (Option<&Solved>, Problems) {
        self.look_for_quick(row);
        let ready = match &mut self.quick {
            FastPath::Rows(quick) => quick.compile(row).is_some(),
            FastPath::After(_) | FastPath::None => false,
        };
        if !ready {
            // it takes more than numbers
            let (solved, problems) = self.solve(row);
            self.last = solved;
            return (self.last.as_ref(), problems);
        }
        let FastPath::Rows(quick) = &mut self.quick else { return (None, Problems::new()) };
        let problems = quick.solve(&self.conduct);
        // whether slides fit each other is looked at with the structure
        if problems.has_errors() && quick.solved.compiled.structure.has_slides() {
            let (solved, problems) = self.solve(row);
            self.last = solved;
            return (self.last.as_ref(), problems);
        }
        let FastPath::Rows(quick) = &self.quick else { return (None, problems) };
        (quick.is_solved.then_some(&quick.solved), problems)
    }

    /// Looks at once for what rows like this one have in common; whether they differ in numbers alone.
    pub fn prepare(&mut self, row: &Row) -> bool {
        self.quick = self.found_quick(row);
        matches!(self.quick, FastPath::Rows(_))
    }

    /// Looks for what rows have in common once there are some.
    fn look_for_quick(&mut self, row: &Row) {
        let FastPath::After(rows) = &mut self.quick else { return };
        *rows += 1;
        if *rows <= ROWS_BEFORE {
            return;
        }
        self.quick = if self.within.is_none() { self.found_quick(row) } else { FastPath::None };
    }

    fn found_quick(&mut self, row: &Row) -> FastPath {
        let (compiled, problems) = self.compile(row);
        let Some(compiled) = compiled else { return FastPath::After(0) };
        // a row with a message goes the general way, so that the message keeps its place
        if !problems.is_empty() {
            return FastPath::After(0);
        }
        let patches = self.template.as_mut().and_then(|template| template.patches(row));
        let quick = patches.and_then(|patches| FastRows::new(patches, compiled, self.reads));
        quick.map_or(FastPath::None, |quick| FastPath::Rows(Box::new(quick)))
    }

    /// The solution of a row, and all that was found on the way.
    pub fn solve(&mut self, row: &Row) -> (Option<Solved>, Problems) {
        let (compiled, mut problems) = self.compile(row);
        let Some(compiled) = compiled.filter(|_| !problems.has_errors()) else { return (None, problems) };
        let (solved, found) = solve_conducted(compiled, self.within, &self.conduct);
        problems.append(found);
        (solved.ok(), problems)
    }
}

// Rows of variants that differ from one another in numbers alone: their mechanism, structure and plan stay, and take the
// numbers of each row.

/// What rows with the same columns have in common.
pub struct FastRows {
    patches: RowPatches,
    solved: Solved,
    is_solved: bool,
    /// Where it has one position, and nothing is to be said of it.
    again: Option<ReusedSolver>,
    reads: PoseOutputs,
}

impl FastRows {
    /// For a file that was compiled with one of its rows, of which nothing was to be said; `None` where a row may change more
    /// than numbers.
    pub fn new(patches: RowPatches, compiled: Compiled, reads: PoseOutputs) -> Option<Self> {
        if !compiled.structure.is_renumbered(&compiled.mechanism) || compiled.origin.is_some() {
            return None;
        }
        let again = ReusedSolver::of(&compiled.model(), reads);
        let solved = Solved { compiled, solution: Solution::default(), outcomes: Vec::new(), reached: None };
        Some(Self { patches, solved, is_solved: false, again, reads })
    }

    /// Puts a row into the mechanism, its structure and its plan; `None` where it takes more.
    pub fn compile(&mut self, row: &Row) -> Option<&Compiled> {
        let Compiled { mechanism, structure, plan, .. } = &mut self.solved.compiled;
        if !self.patches.put(row, mechanism) {
            return None;
        }
        structure.renumber(mechanism);
        if plan.is_renumbered() {
            plan.renumber_steps(mechanism, structure);
            if self.reads.residuals {
                plan.renumber_balance(mechanism, structure);
            }
        } else {
            *plan = plan::plan(mechanism, structure);
        }
        Some(&self.solved.compiled)
    }

    /// Solves the row that was compiled last; returns all that was found on the way.
    pub fn solve(&mut self, conduct: &IntegrationOptions<'_>) -> Problems {
        self.is_solved = false;
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
                Ok(None) => return problems,
                Err(problems) => return problems,
            }
        }
        *outcomes = exercise::evaluate(&compiled.model(), solution, &mut problems);
        self.is_solved = true;
        problems
    }
}
