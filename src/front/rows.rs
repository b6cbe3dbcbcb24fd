//! Rows of variants from columns in memory.

use super::columns::WrittenUnit;
use super::in_order::in_order;
use super::row_answers::{Cells, Line, RowAnswers, digits_count, header_line, read_row};
use super::solution::Diagnostics;
use super::workers::Workers;
use crate::exercise::table::Table;
use crate::pipeline::{Compiled, VariantSolver};
use crate::report::{NumberField, PrintedDigits, rows::AnswerColumns};
use assur_check as check;
use assur_check::{ColumnUse, Overrides, Row, RowColumn};
use assur_solve::solve::Progress;
use assur_syntax::document::Document;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, PoisonError};

/// Rows that one worker takes at a time.
const PIECE: usize = 256;
/// Rows that are looked at for the columns of the answers.
const LOOKED_AT: usize = 256;

/// A text that is solved for rows of values from outside.
#[derive(Debug)]
pub struct Rows {
    source: Source,
    document: Arc<Document>,
    overrides: Overrides,
    within: Option<f64>,
    columns: Arc<[RowColumn]>,
    /// The digits of numbers count: an expectation may take its tolerance from them.
    digits: bool,
}

/// A column of the rows that a text takes.
#[derive(Clone, Debug, PartialEq)]
pub struct RowField {
    /// Its name.
    pub name: String,
    /// The unit of its numbers; empty for plain numbers.
    pub unit: String,
    /// It names the rows.
    pub is_label: bool,
    /// It replaces a `given`, and is repeated with the answers.
    pub is_given: bool,
}

/// The columns of the answers to rows.
#[derive(Clone, Debug, Default)]
pub struct RowLayout {
    /// What heads the names of positions.
    pub pose_header: String,
    /// Names and units, in the author's units, whether each is a condition; drives first.
    pub fields: Vec<(String, WrittenUnit, bool)>,
    /// A column says which events happen at an instant.
    pub names_events: bool,
    pub(crate) answers: AnswerColumns,
    pub(super) key: bool,
}

impl RowLayout {
    /// That of a file that was compiled with one of its rows.
    pub(crate) fn of(compiled: &Compiled, key: bool) -> Self {
        let answers = AnswerColumns::of(&compiled.model());
        let answers = if key { answers.of_key() } else { answers };
        let field = |f: NumberField| (f.name, WrittenUnit::of(f.display), f.condition);
        let fields = answers.fields(&compiled.mechanism).into_iter().map(field).collect();
        let pose_header = if key { "pose" } else { answers.pose_header() }.to_owned();
        let names_events = answers.names_events() && !key;
        Self { pose_header, fields, names_events, answers, key }
    }
}

impl Rows {
    pub(super) fn new(
        source: Source,
        document: Arc<Document>,
        overrides: Overrides,
        within: Option<f64>,
        header: &[(String, Option<String>)],
    ) -> Result<Self, Diagnostics> {
        let line = header_line(&document, header);
        let table = Table::open("rows", line.as_bytes());
        let table = match table {
            Ok(Ok(table)) => table,
            Ok(Err((text, error))) => return Err(Diagnostics::of(&Problems::of([*error]), &text)),
            // a text in memory is always read
            Err(_) => return Err(Diagnostics::default()),
        };
        let (columns, problems) = check::columns(&document, &overrides, &table.columns);
        let Some(columns) = columns else {
            let own = || Diagnostics::of(&check::check(&document, &overrides).1, &source);
            let of_table = Diagnostics::of(&problems, &table.header);
            return Err(if problems.is_empty() { own() } else { of_table });
        };
        let digits = digits_count(&document);
        Ok(Self { source, document, overrides, within, columns: columns.into(), digits })
    }

    /// The columns of the rows.
    #[must_use]
    pub fn fields(&self) -> Vec<RowField> {
        let field = |column: &RowColumn| RowField {
            name: column.name.clone(),
            unit: column.unit.text.clone(),
            is_label: column.what == ColumnUse::Label,
            is_given: column.what == ColumnUse::Given,
        };
        self.columns.iter().map(field).collect()
    }

    /// The columns of the answers, found with the text as it is written, else with the first rows.
    ///
    /// # Errors
    /// The diagnostics of a text that is wrong whatever the row.
    pub fn layout(&self, cells: &[Cells<'_>], count: usize, key: bool) -> Result<RowLayout, Diagnostics> {
        let mut solver = self.solver(&|_, _| true);
        let (mut compiled, problems) = solver.compile(&Row::default());
        for index in 0..count.min(LOOKED_AT) {
            if compiled.is_some() {
                break;
            }
            let mut row = Row::default();
            let read = read_row(&self.columns, cells, index, self.digits, &mut row);
            compiled = read.ok().and_then(|()| solver.compile(&row).0);
        }
        let Some(compiled) = compiled else { return Err(Diagnostics::of(&problems, &self.source)) };
        Ok(RowLayout::of(&compiled, key))
    }

    /// Solves rows; `None` where the workers did not want to go on.
    #[must_use]
    pub fn solve(
        &self,
        layout: &RowLayout,
        cells: &[Cells<'_>],
        count: usize,
        workers: &dyn Workers,
    ) -> Option<RowAnswers> {
        let watch = |_: f64, _: f64| !workers.is_stopped();
        // solvers that wait for rows
        let idle = Mutex::new(Vec::new());
        let lock = || idle.lock().unwrap_or_else(PoisonError::into_inner);
        let work = |number: usize, piece: &mut RowAnswers| {
            let waiting = lock().pop();
            let mut worker = waiting.unwrap_or_else(|| Worker::of(self.solver(&watch)));
            let mut row = Row::default();
            for index in number * PIECE..((number + 1) * PIECE).min(count) {
                match read_row(&self.columns, cells, index, self.digits, &mut row) {
                    Ok(()) => self.one(&row, (&mut worker, &watch), (layout, index, piece)),
                    Err(missing) => {
                        let numbers = &mut worker.numbers;
                        let mut line = Line { layout, index, numbers, out: piece };
                        line.without_answers(&missing.to_string());
                    }
                }
            }
            lock().push(worker);
        };
        let mut all = RowAnswers::with_room(layout, count);
        let new = || RowAnswers::with_room(layout, PIECE);
        let goes_on = in_order(workers, count.div_ceil(PIECE), &new, work, |piece| {
            all.append(piece);
            workers.goes_on()
        });
        goes_on.then_some(all)
    }

    fn solver<'r>(&'r self, watch: &'r Progress<'r>) -> VariantSolver<'r> {
        VariantSolver::new(&self.document, &self.overrides).within(self.within).watched(watch).for_answers()
    }

    /// Solves a row. An error of our own ends one row, not the batch.
    fn one<'r>(
        &'r self,
        row: &Row,
        (worker, watch): (&mut Worker<'r>, &'r Progress<'r>),
        (layout, index, out): (&RowLayout, usize, &mut RowAnswers),
    ) {
        let before = out.len();
        let found = catch_unwind(AssertUnwindSafe(|| {
            let Worker { solver, numbers } = &mut *worker;
            let (solved, problems) = solver.solve_in_place(row);
            let answers = solved.map(|solved| solved.answers(PrintedDigits::READABLE));
            let mut line = Line { layout, index, numbers, out };
            line.all(answers.as_ref(), &first_error(&problems));
        }));
        if found.is_err() {
            // what the row left behind is not to be used again
            *worker = Worker::of(self.solver(watch));
            out.truncate(before);
            let mut line = Line { layout, index, numbers: &mut worker.numbers, out };
            line.without_answers("internal error: please report this row with the file");
        }
    }
}

/// A solver with what it leaves from row to row.
struct Worker<'r> {
    solver: VariantSolver<'r>,
    /// Memory for the numbers of a line.
    numbers: Vec<f64>,
}

impl<'r> Worker<'r> {
    const fn of(solver: VariantSolver<'r>) -> Self {
        Self { solver, numbers: Vec::new() }
    }
}

fn first_error(problems: &Problems) -> String {
    if problems.is_empty() {
        return String::new();
    }
    let is_error = |p: &&dyn assur_text::diagnostic::Problem| {
        matches!(p.severity(), None | Some(miette::Severity::Error))
    };
    problems.sorted().into_iter().find(is_error).map(ToString::to_string).unwrap_or_default()
}
