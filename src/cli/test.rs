//! `assur test`

use super::args::{Format, Test};
use super::files;
use super::motion::MotionProgress;
use super::reply::{Printer, Reply, Status, for_each_input};
use super::screen::Screen;
use crate::exercise::Outcome;
use crate::pipeline::{FileVariants, test_document};
use crate::report::document::{Column, Report, Section, Table};
use assur_solve::solve::IntegrationOptions;
use assur_syntax as syntax;
use assur_text::diagnostic::Problems;
use assur_text::source::{Source, shown_in_line};
use std::cell::{Cell, RefCell};
use std::ops::AddAssign;
use std::sync::Arc;

/// The code of expectations that are not met; they are counted apart.
const MISMATCH: &str = "mech::expect::mismatch";

/// What is counted over all files.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    /// Files that were tested.
    files: usize,
    /// Rows of tables of variants.
    rows: usize,
    /// Expectations that are met.
    met: usize,
    /// Expectations that are not met.
    failed: usize,
    /// Files without a table, and rows, that have no solution.
    unsolved: usize,
    /// Errors other than expectations that are not met.
    errors: usize,
}

/// Holds solutions against their answer keys: one line per file, a diagnostic per `expect` that fails, and the totals of
/// several files.
///
/// In another form than lines of text these are the rows of one table.
pub fn run(args: &Test, screen: &Screen) -> Status {
    let overrides = args.problem.overrides();
    let inputs = files::expand(&args.problem.files);
    let count = inputs.len();
    let total = Cell::new(Tally::default());
    let lines = args.format == Format::Table;
    let table = RefCell::new(table());
    let mut printer = Printer::new(screen, "");
    let status = for_each_input(inputs, &mut printer, |source, _| {
        let (document, found) = syntax::parse(source);
        let document = Arc::new(document);
        let (tally, reply) = match FileVariants::of(&document, &overrides) {
            Some(Ok(rows)) if !found.has_errors() => of_rows(rows, source, found, screen),
            _ => {
                let way = MotionProgress::shown(&source.name);
                let watch = |reached: f64, last: f64| way.goes_on(reached, last);
                let conduct = IntegrationOptions { watch: Some(&watch), ..IntegrationOptions::default() };
                let (solved, problems) = test_document(source, &document, found, &overrides, &conduct);
                drop(way);
                let outcomes = solved.as_ref().map(|s| s.outcomes.as_slice());
                let tally = Tally { files: 1, ..Tally::of(outcomes, &problems) };
                let words = tally.of_file(solved.is_some());
                let line = format!("{}: {words}\n", shown_in_line(&source.name));
                (tally, Reply::new(line, &problems, source, screen))
            }
        };
        let reply = if lines { reply } else { Reply { results: String::new(), ..reply } };
        table.borrow_mut().row(tally.cells(&source.name));
        let mut sum = total.get();
        sum += tally;
        total.set(sum);
        reply
    });
    let end = if lines {
        total.get().of_all(count)
    } else {
        let mut section = Section::new("Expectations");
        section.table(table.into_inner());
        let report = Report { title: "Test".to_owned(), notes: Vec::new(), sections: vec![section] };
        args.format.page(screen.look()).render(&report)
    };
    let whole = lines && count < 2 || printer.print(&end);
    status.max(Status::printed(whole))
}

/// The table of all files, without rows.
fn table() -> Table {
    let counts = ["rows", "met", "failed", "not solved", "errors"].map(Column::numbers);
    Table::new(std::iter::once(Column::words("file")).chain(counts).collect(), 1)
}

/// One line for all rows of a table of variants.
fn of_rows(
    rows: FileVariants<'_>,
    source: &Source,
    mut problems: Problems,
    screen: &Screen,
) -> (Tally, Reply) {
    let mut tally = Tally { files: 1, ..Tally::default() };
    for row in rows.solve(true) {
        let outcomes = row.solved.as_ref().map(|s| s.outcomes.as_slice());
        tally += Tally { rows: 1, ..Tally::of(outcomes, &row.problems) };
        problems.append(row.problems);
    }
    let line = format!("{}: {}\n", shown_in_line(&source.name), tally.of_rows());
    let mut reply = Reply::new(line, &problems, source, screen);
    if tally.rows == 0 {
        reply.status = Status::Wrong;
    }
    (tally, reply)
}

fn plural(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

impl Tally {
    /// The outcomes of one solution, if there is one.
    fn of(outcomes: Option<&[Outcome]>, problems: &Problems) -> Self {
        let all = outcomes.unwrap_or_default();
        let met = all.iter().filter(|o| o.passed).count();
        let errors = problems.errors() - problems.errors_of(MISMATCH);
        let unsolved = usize::from(outcomes.is_none());
        Self { met, failed: all.len() - met, unsolved, errors, ..Self::default() }
    }

    /// A row of the table of all files.
    fn cells(self, file: &str) -> Vec<String> {
        let counts = [self.rows, self.met, self.failed, self.unsolved, self.errors].map(|n| n.to_string());
        std::iter::once(file.to_owned()).chain(counts).collect()
    }

    /// A file without a table of variants.
    fn of_file(self, solved: bool) -> String {
        let mut parts = vec![match (solved, self.met + self.failed + self.errors) {
            (false, _) => "not solved".to_owned(),
            (true, 0) => "solved, no expectations".to_owned(),
            (true, _) => self.expectations(),
        }];
        parts.extend((self.failed > 0).then(|| format!("{} failed", self.failed)));
        parts.extend((self.errors > 0).then(|| plural(self.errors, "error")));
        parts.join(", ")
    }

    /// A table of variants.
    fn of_rows(self) -> String {
        let none = self.met + self.failed + self.unsolved + self.errors == 0;
        let first = if none { "no expectations".to_owned() } else { self.expectations() };
        let mut parts = vec![first];
        parts.extend((self.failed > 0).then(|| format!("{} failed", self.failed)));
        parts.extend((self.unsolved > 0).then(|| format!("{} not solved", plural(self.unsolved, "row"))));
        parts.extend((self.errors > 0).then(|| plural(self.errors, "error")));
        format!("{} in {}", parts.join(", "), plural(self.rows, "row"))
    }

    fn expectations(self) -> String {
        format!("{} met", plural(self.met, "expectation"))
    }

    /// All files that the command line names.
    fn of_all(self, count: usize) -> String {
        let mut parts = vec![plural(count, "file")];
        parts.extend((self.rows > 0).then(|| plural(self.rows, "row")));
        parts.push(self.expectations());
        parts.push(format!("{} failed", self.failed));
        parts.extend((self.unsolved > 0).then(|| format!("{} not solved", self.unsolved)));
        parts.extend((self.errors > 0).then(|| plural(self.errors, "error")));
        let untested = count.saturating_sub(self.files);
        parts.extend((untested > 0).then(|| format!("{} not tested", plural(untested, "file"))));
        format!("total: {}\n", parts.join(", "))
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.files += other.files;
        self.rows += other.rows;
        self.met += other.met;
        self.failed += other.failed;
        self.unsolved += other.unsolved;
        self.errors += other.errors;
    }
}
