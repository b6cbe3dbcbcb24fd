//! Rows of variants from columns in memory.

use super::columns::WrittenUnit;
use super::row_answers::{Cells, Line, RowAnswers, digits_count, header_line, read_row};
use super::solution::Diagnostics;
use super::stages::{InOrder, Stages, work};
use super::workers::Workers;
use crate::exercise::table::Table;
use crate::pipeline::{Compiled, VariantSolver};
use crate::report::{NumberField, PrintedDigits, rows::AnswerColumns};
use assur_check as check;
use assur_check::{ColumnUse, Overrides, Row, RowColumn};
use assur_solve::solve::{NumberColumns, Progress};
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
        let answers = if key { answers.without_drives() } else { answers };
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
        let solving = Solving { rows: self, layout, cells, count, watch: &watch, idle: Mutex::default() };
        let mut all = RowsInOrder { answers: RowAnswers::with_room(layout, count), workers };
        work(workers, count.div_ceil(PIECE), &solving, &mut all).then_some(all.answers)
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
            let Worker { solver, columns, numbers } = &mut *worker;
            let (solved, problems, quick) = solver.solve_quickly(row);
            let answers = solved.map(|solved| solved.answers(PrintedDigits::READABLE));
            let columns = answers.filter(|_| quick && !layout.key).and_then(|answers| {
                columns.get_or_insert_with(|| layout.answers.in_quick_rows(&answers.model)).as_ref()
            });
            let mut line = Line { layout, index, numbers, columns, out };
            line.all(answers.as_ref(), &first_error(&problems));
        }));
        if found.is_err() {
            // what the row left behind is not to be used again
            *worker = Worker::of(self.solver(watch));
            out.truncate(before);
            let mut line = Line { layout, index, numbers: &mut worker.numbers, columns: None, out };
            line.without_answers("internal error: please report this row with the file");
        }
    }
}

/// Rows that are being solved.
struct Solving<'s, 'r> {
    rows: &'r Rows,
    layout: &'s RowLayout,
    cells: &'s [Cells<'s>],
    count: usize,
    watch: &'r Progress<'r>,
    /// Solvers that wait for rows.
    idle: Mutex<Vec<Worker<'r>>>,
}

impl Stages for Solving<'_, '_> {
    type Piece = RowAnswers;

    fn piece(&self) -> RowAnswers {
        RowAnswers::with_room(self.layout, PIECE)
    }

    fn begin(&self, number: usize, piece: &mut RowAnswers) {
        let &Self { rows, layout, watch, .. } = self;
        let lock = || self.idle.lock().unwrap_or_else(PoisonError::into_inner);
        let mut worker = lock().pop().unwrap_or_else(|| Worker::of(rows.solver(watch)));
        let mut row = Row::default();
        for index in number * PIECE..((number + 1) * PIECE).min(self.count) {
            match read_row(&rows.columns, self.cells, index, rows.digits, &mut row) {
                Ok(()) => rows.one(&row, (&mut worker, watch), (layout, index, piece)),
                Err(missing) => {
                    let numbers = &mut worker.numbers;
                    let mut line = Line { layout, index, numbers, columns: None, out: piece };
                    line.without_answers(&missing.to_string());
                }
            }
        }
        lock().push(worker);
    }

    fn is_finished(&self, _: &RowAnswers) -> bool {
        true
    }

    fn finish(&self, _: &mut RowAnswers) {}
}

/// The answers in the order of the rows.
struct RowsInOrder<'w> {
    answers: RowAnswers,
    workers: &'w dyn Workers,
}

impl InOrder<RowAnswers> for RowsInOrder<'_> {
    fn between(&mut self, _: &mut RowAnswers) -> bool {
        true
    }

    fn end(&mut self, piece: &mut RowAnswers) -> bool {
        self.answers.append(piece);
        self.workers.goes_on()
    }
}

/// A solver with what it leaves from row to row.
struct Worker<'r> {
    solver: VariantSolver<'r>,
    /// The columns of rows that differ in numbers alone, once they were looked for.
    columns: Option<Option<NumberColumns>>,
    /// Memory for the numbers of a line.
    numbers: Vec<f64>,
}

impl<'r> Worker<'r> {
    const fn of(solver: VariantSolver<'r>) -> Self {
        Self { solver, columns: None, numbers: Vec::new() }
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
