//! `assur solve`

use super::args::{Format, Solve};
use super::reply::{Reply, Status, for_each_file};
use super::screen::Screen;
use super::stream;
use crate::pipeline::{Compiled, Solved};
use crate::pipeline::{FileVariants, SolvedRow, compile_document, file_row_words, is_long};
use crate::report::document::{Column, Table};
use crate::report::json::Variant;
use crate::report::{self, Answers, Precision};
use assur_check::RowColumn;
use assur_syntax as syntax;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use assur_text::units::significant;
use std::sync::Arc;

/// Prints the answers.
pub fn run(args: &Solve, screen: &Screen) -> Status {
    let overrides = args.problem.overrides();
    let apart = match args.format {
        Format::Json | Format::Jsonl => "",
        Format::Csv => "\r\n",
        Format::Table | Format::Markdown | Format::Latex => "\n",
    };
    for_each_file(&args.problem.files, screen, apart, |source, printer| {
        let (document, found) = syntax::parse(source);
        let document = Arc::new(document);
        match FileVariants::of(&document, &overrides) {
            Some(Ok(rows)) if !found.has_errors() => {
                return of_rows(args.format, apart, source, rows.within(args.within), found, screen);
            }
            Some(Err(problems)) if !found.has_errors() => {
                let line = || json(source, Err(None), &problems);
                let results = if args.format == Format::Json { line() } else { String::new() };
                return Reply::new(results, &problems, source, screen);
            }
            _ => {}
        }
        let (compiled, mut problems) = compile_document(source, &document, found, &overrides);
        let compiled = match compiled {
            Some(compiled) if !problems.has_errors() && by_position(args, &compiled) => {
                return stream::positions(args.format, source, compiled, problems, screen, printer);
            }
            compiled => compiled,
        };
        let solved = match compiled {
            Some(compiled) if !problems.has_errors() => {
                let (solved, found) = crate::pipeline::solve_within(compiled, args.within);
                problems.append(found);
                solved.map_err(Some)
            }
            compiled => Err(compiled),
        };
        let results = match (args.format, &solved) {
            (Format::Json, Ok(solved)) => json(source, Ok(solved), &problems),
            (Format::Json, Err(compiled)) => json(source, Err(compiled.as_ref()), &problems),
            (format, Ok(solved)) => answers(format, source, solved, screen),
            (_, Err(_)) => String::new(),
        };
        Reply::new(results, &problems, source, screen)
    })
}

/// Whether positions are written one after another.
fn by_position(args: &Solve, compiled: &Compiled) -> bool {
    let forgets = args.format == Format::Jsonl || args.format == Format::Csv && is_long(&compiled.model());
    forgets && args.within.is_none()
}

/// All rows of a table of variants, one below the other.
fn of_rows(
    format: Format,
    apart: &str,
    source: &Source,
    rows: FileVariants<'_>,
    mut problems: Problems,
    screen: &Screen,
) -> Reply {
    let columns = rows.columns().to_vec();
    let mut results = Vec::new();
    let mut table = Table::default();
    for row in rows.solve(false) {
        let solved = row.solved.as_ref().map(|s| s.answers(Precision::READABLE));
        match (format, &solved) {
            (Format::Csv, solved) => csv_row(&mut table, &columns, &row, solved.as_ref()),
            (Format::Json, solved) => {
                let variant = Some(Variant::of(row.number, row.row.label.clone(), &row.row.row));
                let views = row.problems.views(source);
                let model = solved.as_ref().map(|s| s.model);
                let line =
                    report::json::render_row(&source.name, variant, model.as_ref(), solved.as_ref(), &views);
                results.push(line + "\n");
            }
            (Format::Jsonl, solved) => {
                let variant = Variant::of(row.number, row.row.label.clone(), &row.row.row);
                results.extend(solved.as_ref().map(|s| positions(source, Some(&variant), s)));
            }
            (format, Some(solved)) => {
                let mut report = report::of_answers(&source.name, solved);
                report.title = format!("{}: {}", report.title, file_row_words(&row.row, row.number));
                results.extend(format.page(screen.look()).map(|page| page.render(&report)));
            }
            (_, None) => {}
        }
        problems.append(row.problems);
    }
    if format == Format::Csv {
        results.push(report::csv::render(&table));
    }
    Reply::new(results.join(apart), &problems, source, screen)
}

/// The poses of a row after its number and its givens; a row without solution has no answers.
fn csv_row(table: &mut Table, columns: &[RowColumn], row: &SolvedRow, solved: Option<&Answers<'_>>) {
    let cells =
        row.row.row.entries().map(|(c, cell)| significant(c.unit.from_si(cell.value), report::rows::FULL));
    let head: Vec<String> = std::iter::once(row.number.to_string()).chain(cells).collect();
    let poses = solved.map(report::table_of_poses).unwrap_or_default();
    if table.columns.len() <= head.len() {
        table.columns = std::iter::once(Column::words("row"))
            .chain(columns.iter().map(|c| Column::numbers(c.header())))
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

/// One line per position.
fn positions(source: &Source, variant: Option<&Variant>, answers: &Answers<'_>) -> String {
    let poses: Vec<_> = answers.poses().map(Some).collect();
    let poses = if poses.is_empty() { vec![None] } else { poses };
    let line = |pose| report::json::render_position(&source.name, variant, answers, pose) + "\n";
    poses.into_iter().map(line).collect()
}

fn answers(format: Format, source: &Source, solved: &Solved, screen: &Screen) -> String {
    let answers = solved.answers(Precision::READABLE);
    match format {
        Format::Csv => report::csv::render(&report::table_of_poses(&answers)),
        Format::Jsonl => positions(source, None, &answers),
        format => {
            let page = format.page(screen.look());
            page.map_or_else(String::new, |page| page.render(&report::of_answers(&source.name, &answers)))
        }
    }
}

/// One line, whatever was reached.
fn json(source: &Source, solved: Result<&Solved, Option<&Compiled>>, problems: &Problems) -> String {
    let diagnostics = problems.views(source);
    let line = match solved {
        Ok(solved) => {
            let answers = solved.answers(Precision::READABLE);
            report::json::render(&source.name, Some(&answers.model), Some(&answers), &diagnostics)
        }
        Err(compiled) => {
            let model = compiled.map(Compiled::model);
            report::json::render(&source.name, model.as_ref(), None, &diagnostics)
        }
    };
    line + "\n"
}
