//! The rows of a file's own table of variants.

use super::compile::{Compiled, compile_document, first_row};
use super::followed::{is_long, most_written, too_many};
use super::solved::Solved;
use super::variant_solver::VariantSolver;
use crate::exercise::mismatches;
use assur_check as check;
use assur_check::{FileRow, Overrides, RowColumn};
use assur_solve::message::{self, failures};
use assur_solve::solve::{Method, Model, not_chosen, refusals};
use assur_syntax::document::Document;
use assur_text::diagnostic::{Diagnosis, Problems};
use assur_text::source::Source;
use std::sync::Arc;

/// A file with a table of variants.
pub struct FileVariants<'a> {
    solver: VariantSolver<'a>,
    rows: Vec<FileRow>,
    columns: Arc<[RowColumn]>,
}

/// A row of it, solved or not, with all that is to be said of it.
pub struct SolvedRow {
    pub row: FileRow,
    /// Counted from 1.
    pub number: usize,
    pub solved: Option<Solved>,
    /// What was found on the way; it names the row.
    pub problems: Problems,
}

impl<'a> FileVariants<'a> {
    /// Reads the table of a document; `None` where it has none. What is wrong with the table stands in its place.
    #[must_use]
    pub fn of(document: &'a Arc<Document>, overrides: &'a Overrides) -> Option<Result<Self, Problems>> {
        let table = check::table(document)?;
        let (columns, problems) = check::columns(document, overrides, table);
        let Some(columns) = columns else {
            // where the table is fine, the `given` that it replaces is not
            let whole = || check::check(document, overrides).1;
            return Some(Err(if problems.is_empty() { whole() } else { problems }));
        };
        let columns: Arc<[RowColumn]> = columns.into();
        let rows = check::file_rows(table, &columns);
        let mut solver = VariantSolver::new(document, overrides);
        if let Some(problems) = of_every_row(&mut solver, &rows) {
            return Some(Err(problems));
        }
        Some(Ok(Self { solver, rows, columns }))
    }

    /// With settings that keep an accuracy, row by row.
    #[must_use]
    pub fn within(self, within: Option<f64>) -> Self {
        Self { solver: self.solver.within(within), ..self }
    }

    /// With motions under loads that are integrated by a method.
    #[must_use]
    pub fn by(self, method: Option<Method>) -> Self {
        Self { solver: self.solver.by(method), ..self }
    }

    #[must_use]
    pub fn columns(&self) -> &[RowColumn] {
        &self.columns
    }

    /// What all rows are, as far as it is known before one is solved: the first that can be, and all that is to be said.
    pub fn analyze(mut self) -> (Option<Compiled>, Problems) {
        let (mut first, mut problems) = (None, Problems::new());
        for (i, row) in self.rows.iter().enumerate() {
            let (compiled, found) = looked_at(&mut self.solver, row);
            problems.append(found.of_row(&file_row_words(row, i + 1), Some(row.span)));
            first = first.or(compiled);
        }
        (first, problems)
    }

    /// Solves all rows in order. Where they are tested, an expectation that is not met is a problem.
    pub fn solve(mut self, test: bool) -> impl Iterator<Item = SolvedRow> + use<'a> {
        self.rows.into_iter().enumerate().map(move |(i, row)| {
            let (solved, mut problems) = self.solver.solve(&row.row);
            if test {
                problems.extend(solved.iter().flat_map(|s| mismatches(&s.outcomes)));
            }
            let problems = problems.of_row(&file_row_words(&row, i + 1), Some(row.span));
            SolvedRow { row, number: i + 1, solved, problems }
        })
    }
}

/// What is wrong with the file whatever the row: the first and the last row have the same errors.
fn of_every_row(solver: &mut VariantSolver<'_>, rows: &[FileRow]) -> Option<Problems> {
    let [first, .., last] = rows else { return None };
    let (_, problems) = looked_at(solver, first);
    (problems.has_errors() && problems.is_alike(&looked_at(solver, last).1)).then_some(problems)
}

/// A row before it is solved, with all that refuses it.
fn looked_at(solver: &mut VariantSolver<'_>, row: &FileRow) -> (Option<Compiled>, Problems) {
    let (compiled, mut problems) = solver.compile(&row.row);
    if let Some(compiled) = compiled.as_ref().filter(|_| !problems.has_errors()) {
        problems.extend(refused(compiled));
    }
    (compiled, problems)
}

/// What cannot be answered of a compiled file at any position.
fn refused(compiled: &Compiled) -> Vec<Diagnosis> {
    let model = compiled.model();
    failures(&model, &refusals(&model)).collect()
}

/// A file before anything is solved, with all that makes `solve` refuse it: row by row where it has a table of variants.
#[must_use]
pub fn look_at(source: &Source, overrides: &Overrides) -> (Option<Compiled>, Problems) {
    let (document, mut found) = assur_syntax::parse(source);
    let document = Arc::new(document);
    let rows = if found.has_errors() { None } else { FileVariants::of(&document, overrides) };
    match rows {
        Some(Ok(rows)) => {
            let (compiled, problems) = rows.analyze();
            found.append(problems);
            (compiled, found)
        }
        Some(Err(problems)) => (None, of_first_row(source, &document, overrides).unwrap_or(problems)),
        None => {
            let (compiled, mut problems) = compile_document(source, &document, found, overrides);
            if let Some(compiled) = compiled.as_ref().filter(|_| !problems.has_errors()) {
                problems.extend(refused(compiled));
                if !problems.has_errors() {
                    problems.extend(known_early(&compiled.model()));
                }
            }
            (compiled, problems)
        }
    }
}

/// What is wrong with a file whatever the row, as with the values of the first: with all that a help can try in the text.
fn of_first_row(source: &Source, document: &Arc<Document>, overrides: &Overrides) -> Option<Problems> {
    let overrides = Overrides { row: first_row(document)?, ..overrides.clone() };
    let (_, problems) = compile_document(source, document, Problems::new(), &overrides);
    problems.has_errors().then_some(problems)
}

/// What `solve` would find at once, as warnings, since the structure is sound: that `assemble` is missing, and more positions than a
/// table has.
fn known_early(model: &Model<'_>) -> Vec<Diagnosis> {
    let mut found = not_chosen(model)
        .map(|failure| message::failure(model, &failure).as_warning())
        .into_iter()
        .collect::<Vec<_>>();
    let positions = is_long(model).then(|| too_many(model, most_written(model)).as_warning());
    found.extend(positions);
    found
}

/// A row of a file in words: `row 3 (r = 120 mm)`, `row 3, variant 7 (r = 120 mm)`.
#[must_use]
pub fn file_row_words(row: &FileRow, number: usize) -> String {
    row_words(number, row.label.as_deref(), &row.row.words())
}

/// A row in words.
#[must_use]
pub fn row_words(number: usize, label: Option<&str>, values: &str) -> String {
    let label = label.map_or_else(String::new, |label| format!(", variant {label}"));
    format!("row {number}{label} ({values})")
}
