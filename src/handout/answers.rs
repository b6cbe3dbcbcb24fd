//! Answers as files: all that is known as JSON, a table of positions as CSV.

use crate::pipeline::{self, Compiled, FileVariants, Solved, SolvedRow};
use crate::report::document::{Column, Table};
use crate::report::json::Variant;
use crate::report::{self, Answers, PrintedDigits};
use assur_check::{ColumnUse, Overrides, RowColumn};
use assur_syntax::parse;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use assur_text::units::significant;
use std::sync::Arc;

/// What `assur solve --format json` prints of a text: one line, or one for every row of its table.
#[must_use]
pub fn solution(source: &Source) -> String {
    let (document, found) = parse(source);
    let (document, overrides) = (Arc::new(document), Overrides::none());
    match FileVariants::of(&document, &overrides) {
        Some(Ok(rows)) if !found.has_errors() => {
            return rows.solve(false).map(|row| json_of_row(source, &row)).collect();
        }
        Some(Err(problems)) if !found.has_errors() => return json(source, Err(None), &problems),
        _ => {}
    }
    let (compiled, mut problems) = pipeline::compile_document(source, &document, found, &overrides);
    let solved = match compiled {
        Some(compiled) if !problems.has_errors() => {
            let (solved, found) = pipeline::solve(compiled);
            problems.append(found);
            solved.map_err(Some)
        }
        compiled => Err(compiled),
    };
    json(source, solved.as_ref().map_err(Option::as_ref), &problems)
}

/// A table of the positions of a text, of all rows of its table.
#[must_use]
pub fn poses(source: &Source) -> String {
    let (document, found) = parse(source);
    let (document, overrides) = (Arc::new(document), Overrides::none());
    let mut table = Table::default();
    if let Some(Ok(rows)) = FileVariants::of(&document, &overrides) {
        let columns = rows.columns().to_vec();
        for row in rows.solve(false) {
            let solved = row.solved.as_ref().map(|solved| solved.answers(PrintedDigits::READABLE));
            csv_row(&mut table, &columns, &row, solved.as_ref());
        }
        return report::csv::render(&table);
    }
    let (compiled, problems) = pipeline::compile_document(source, &document, found, &overrides);
    let compiled = compiled.filter(|_| !problems.has_errors());
    let solved = compiled.and_then(|compiled| pipeline::solve(compiled).0.ok());
    let answers = solved.as_ref().map(|solved| solved.answers(PrintedDigits::READABLE));
    answers.as_ref().map(|answers| report::csv::render(&report::table_of_poses(answers))).unwrap_or_default()
}

/// One line, whatever was reached.
#[must_use]
pub fn json(source: &Source, solved: Result<&Solved, Option<&Compiled>>, problems: &Problems) -> String {
    let diagnostics = problems.views(source);
    let line = match solved {
        Ok(solved) => {
            let answers = solved.answers(PrintedDigits::READABLE);
            report::json::render(&source.name, Some(&answers.model), Some(&answers), &diagnostics)
        }
        Err(compiled) => {
            let model = compiled.map(Compiled::model);
            report::json::render(&source.name, model.as_ref(), None, &diagnostics)
        }
    };
    line + "\n"
}

/// The line of a row of variants.
#[must_use]
pub fn json_of_row(source: &Source, row: &SolvedRow) -> String {
    let answers = row.solved.as_ref().map(|solved| solved.answers(PrintedDigits::READABLE));
    let variant = Some(Variant::of(row.number, row.row.label.clone(), &row.row.row));
    let model = answers.as_ref().map(|answers| answers.model);
    let views = row.problems.views(source);
    report::json::render_row(&source.name, variant, model.as_ref(), answers.as_ref(), &views) + "\n"
}

/// The poses of a row after its number and its givens; a row without solution has no answers.
pub fn csv_row(table: &mut Table, columns: &[RowColumn], row: &SolvedRow, solved: Option<&Answers<'_>>) {
    let cells = row.row.row.entries().map(|(c, cell)| match c.what {
        ColumnUse::Label => row.row.label.clone().unwrap_or_default(),
        _ => significant(c.unit.from_si(cell.value), report::rows::FULL),
    });
    let head: Vec<String> = std::iter::once(row.number.to_string()).chain(cells).collect();
    let poses = solved.map(report::table_of_poses).unwrap_or_default();
    if table.columns.len() <= head.len() {
        table.columns = std::iter::once(Column::words("row"))
            .chain(columns.iter().map(row_column))
            .chain(poses.columns)
            .collect();
        // rows without solution came before
        let width = table.columns.len();
        table.rows.iter_mut().for_each(|row| row.resize(width, String::new()));
    }
    if poses.rows.is_empty() {
        table.row(head.clone());
    }
    for pose in poses.rows {
        table.row(head.iter().cloned().chain(pose).collect());
    }
}

/// The column of a table of variants.
fn row_column(column: &RowColumn) -> Column {
    match column.what {
        ColumnUse::Label => Column::words(column.header()),
        _ => Column::numbers(column.header()),
    }
}
