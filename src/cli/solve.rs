//! `assur solve`

use super::args::{Format, Solve};
use super::error::CliError;
use super::files;
use super::motion::MotionProgress;
#[cfg(feature = "arrow")]
use super::reply::complaint;
use super::reply::{Printer, Reply, Status, for_each_input};
use super::screen::Screen;
use super::stream;
use super::threads::Threads;
use crate::handout::{csv_row, json, json_of_row};
use crate::pipeline::{FileVariants, compile_document, file_row_words};
use crate::report::document::{Block, Column, Report, Section, Table};
use crate::report::json::Variant;
use crate::report::{self, AccuracyShown, Answers, PrintedDigits};
use assur_check::Overrides;
use assur_solve::solve::{IntegrationOptions, Method};
use assur_syntax as syntax;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use std::sync::Arc;

pub fn run(args: &Solve, screen: &Screen) -> Status {
    let overrides = args.problem.overrides();
    let inputs = files::expand(&args.problem.files);
    let several = inputs.len() > 1;
    let threads = Threads::new(args.threads);
    // a stream of Arrow goes position by position as lines of JSON do
    let format = if args.format.is_columns() { Format::Jsonl } else { args.format };
    #[cfg(feature = "arrow")]
    if args.format.is_columns()
        && let Some(error) = super::arrow::refusal(several)
    {
        screen.complain(&complaint(error, screen));
        return Status::Unusable;
    }
    let answers = Printing { args, format, screen, several, threads };
    let mut printer = Printer::new(screen, format.apart());
    let work = |source: &Source, printer: &mut Printer<'_>| answers.of_file(source, &overrides, printer);
    let status = for_each_input(inputs, &mut printer, work);
    let hint = answers.is_brief() && printer.has_results();
    let whole = !hint || printer.print("`assur solve FILE` prints one file in full.\n");
    status.max(Status::printed(whole))
}

/// How answers are printed.
struct Printing<'a> {
    args: &'a Solve,
    format: Format,
    screen: &'a Screen,
    /// The command line names several files.
    several: bool,
    threads: Threads,
}

impl Printing<'_> {
    fn of_file(&self, source: &Source, overrides: &Overrides, printer: &mut Printer<'_>) -> Reply {
        let (document, found) = syntax::parse(source);
        let document = Arc::new(document);
        let method = self.args.method.map(Method::from);
        match FileVariants::of(&document, overrides) {
            #[cfg(feature = "arrow")]
            Some(Ok(_)) if self.args.format.is_columns() => {
                let diagnostics = complaint(CliError::OneStream, self.screen);
                return Reply { diagnostics, status: Status::Unusable, ..Reply::default() };
            }
            Some(Ok(rows)) if !found.has_errors() => {
                return self.of_rows(source, rows.within(self.args.within).by(method), found);
            }
            Some(Err(problems)) if !found.has_errors() => {
                let line = || json(source, Err(None), &problems);
                let results = if self.format == Format::Json { line() } else { String::new() };
                return Reply::new(results, &problems, source, self.screen);
            }
            _ => {}
        }
        let (compiled, mut problems) = compile_document(source, &document, found, overrides);
        problems.extend(
            compiled.as_ref().filter(|_| self.in_lines()).and_then(|c| CliError::left_out(&c.mechanism)),
        );
        #[cfg(feature = "arrow")]
        let compiled = match compiled {
            Some(compiled) if !problems.has_errors() && self.args.format.is_columns() => {
                let to = (printer, &self.threads);
                return super::arrow::positions(source, compiled, problems, self.screen, to, method);
            }
            compiled => compiled,
        };
        let compiled = match compiled {
            Some(compiled) if !problems.has_errors() && self.by_position() => {
                let file = self.several.then_some(source.name.as_str());
                let (form, to) = ((self.format, file), (printer, &self.threads));
                return stream::positions(form, source, compiled, problems, self.screen, to, method);
            }
            compiled => compiled,
        };
        let solved = match compiled {
            Some(compiled) if !problems.has_errors() => {
                let way = MotionProgress::of(&source.name, &compiled.mechanism);
                let watch = |reached: f64, last: f64| way.as_ref().is_none_or(|w| w.goes_on(reached, last));
                let conduct =
                    IntegrationOptions { watch: Some(&watch), method, ..IntegrationOptions::default() };
                let (solved, found) = crate::pipeline::solve_conducted(compiled, self.args.within, &conduct);
                problems.append(found);
                solved.map_err(Some)
            }
            compiled => Err(compiled),
        };
        let results = match (self.format, &solved) {
            (Format::Json, Ok(solved)) => json(source, Ok(solved), &problems),
            (Format::Json, Err(compiled)) => json(source, Err(compiled.as_ref()), &problems),
            (_, Ok(solved)) => self.answers(source, &solved.answers(PrintedDigits::READABLE)),
            (_, Err(_)) => String::new(),
        };
        Reply::new(results, &problems, source, self.screen)
    }

    /// Whether positions are written one after another.
    fn by_position(&self) -> bool {
        self.in_lines() && self.args.within.is_none()
    }

    fn in_lines(&self) -> bool {
        matches!(self.format, Format::Jsonl | Format::Csv)
    }

    fn answers(&self, source: &Source, answers: &Answers<'_>) -> String {
        match self.format {
            Format::Csv => self.csv(report::table_of_poses(answers), source),
            Format::Jsonl => positions(source, None, answers),
            _ if self.is_brief() => self.section(&self.brief(source, answers)),
            _ => self.page(&report::of_answers(&source.name, answers, self.accuracy())),
        }
    }

    /// Several files are printed in a few lines each, unless all is asked for.
    fn is_brief(&self) -> bool {
        self.several && self.format == Format::Table && !self.args.accuracy
    }

    fn brief(&self, source: &Source, answers: &Answers<'_>) -> Section {
        report::brief(&source.name, answers, self.screen.look().width)
    }

    fn section(&self, section: &Section) -> String {
        report::text::section(section, self.screen.look())
    }

    /// A report in the form that is asked for.
    fn page(&self, report: &Report) -> String {
        self.format.page(self.screen.look()).render(report)
    }

    const fn accuracy(&self) -> AccuracyShown {
        if self.args.accuracy { AccuracyShown::EveryPose } else { AccuracyShown::Worst }
    }

    /// A table as CSV; of several files every row begins with the file's name.
    fn csv(&self, mut table: Table, source: &Source) -> String {
        if self.several {
            table.columns.insert(0, Column::words("file"));
            table.rows.iter_mut().for_each(|row| row.insert(0, source.name.clone()));
        }
        report::csv::render(&table)
    }

    /// All rows of a table of variants, one below the other.
    fn of_rows(&self, source: &Source, rows: FileVariants<'_>, mut problems: Problems) -> Reply {
        let columns = rows.columns().to_vec();
        let mut results = Vec::new();
        let mut table = Table::default();
        let mut first = None;
        let mut count = 0;
        for row in rows.solve(false) {
            count += 1;
            if let Some(solved) = row.solved.as_ref().filter(|_| count == 1 && self.in_lines()) {
                problems.extend(CliError::left_out(&solved.compiled.mechanism));
            }
            let solved = row.solved.as_ref().map(|s| s.answers(PrintedDigits::READABLE));
            match (self.format, &solved) {
                (Format::Csv, solved) => csv_row(&mut table, &columns, &row, solved.as_ref()),
                (Format::Json, _) => results.push(json_of_row(source, &row)),
                (Format::Jsonl, solved) => {
                    let variant = Variant::of(row.number, row.row.label.clone(), &row.row.row);
                    results.extend(solved.as_ref().map(|s| positions(source, Some(&variant), s)));
                }
                (_, Some(solved)) if self.is_brief() => {
                    first.get_or_insert_with(|| (row.number, self.brief(source, solved)));
                }
                (_, Some(solved)) => {
                    let mut report = report::of_answers(&source.name, solved, self.accuracy());
                    report.title = format!("{}: {}", report.title, file_row_words(&row.row, row.number));
                    results.push(self.page(&report));
                }
                (_, None) => {}
            }
            problems.append(row.problems);
        }
        if self.format == Format::Csv {
            results.push(self.csv(table, source));
        }
        if let Some((row, mut section)) = first {
            section.blocks.insert(0, Block::Text(format!("row {row} of {count}")));
            results.push(self.section(&section));
        }
        Reply::new(results.join(self.format.apart()), &problems, source, self.screen)
    }
}

/// One line per position.
fn positions(source: &Source, variant: Option<&Variant>, answers: &Answers<'_>) -> String {
    let poses: Vec<_> = answers.poses().map(Some).collect();
    let poses = if poses.is_empty() { vec![None] } else { poses };
    let line = |pose| report::json::render_position(&source.name, variant, answers, pose) + "\n";
    poses.into_iter().map(line).collect()
}
