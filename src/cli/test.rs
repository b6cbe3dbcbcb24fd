//! `assur test`

use super::args::Problem;
use super::files;
use super::reply::{Printer, Reply, Status, for_each_input};
use super::screen::Screen;
use crate::exercise::Outcome;
use crate::pipeline::{FileVariants, test_document};
use assur_syntax as syntax;
use assur_text::diagnostic::Problems;
use assur_text::source::{Source, shown_in_line};
use std::cell::Cell;
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
pub fn run(args: &Problem, screen: &Screen) -> Status {
    let overrides = args.overrides();
    let inputs = files::expand(&args.files);
    let count = inputs.len();
    let total = Cell::new(Tally::default());
    let mut printer = Printer::new(screen, "");
    let status = for_each_input(inputs, &mut printer, |source, _| {
        let (document, found) = syntax::parse(source);
        let document = Arc::new(document);
        let (tally, reply) = match FileVariants::of(&document, &overrides) {
            Some(Ok(rows)) if !found.has_errors() => of_rows(rows, source, found, screen),
            _ => {
                let (solved, problems) = test_document(source, &document, found, &overrides);
                let outcomes = solved.as_ref().map(|s| s.outcomes.as_slice());
                let tally = Tally { files: 1, ..Tally::of(outcomes, &problems) };
                let words = tally.of_file(solved.is_some());
                let line = format!("{}: {words}\n", shown_in_line(&source.name));
                (tally, Reply::new(line, &problems, source, screen))
            }
        };
        let mut sum = total.get();
        sum += tally;
        total.set(sum);
        reply
    });
    let whole = count < 2 || printer.print(&total.get().of_all(count));
    status.max(Status::printed(whole))
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
