//! One row: solved and written.

use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::super::args::Format;
use super::filled::{Cited, Filled};
use super::job::Job;
use super::layout::Layout;
use super::rows::Input;
use crate::exercise::table::{Fault, TableError};
use crate::pipeline::Solved;
use crate::pipeline::{VariantSolver, row_words};
use crate::report::csv::LINE_END;
use crate::report::json::{self, Variant};
use crate::report::rows::{AnswerColumns, FULL, write_text};
use crate::report::{Answers, PrintedDigits};
use assur_solve::measure::accuracy::AchievedAccuracy;
use assur_solve::message::failure;
use assur_text::diagnostic::{Problem, Problems};
use assur_text::source::Source;
use assur_text::units::write_significant;

/// Where a row is written.
pub struct RowWriter<'a, 'f> {
    pub job: &'a Job,
    pub format: Format,
    pub layout: &'a Layout,
    /// Those of the key, where one is wanted.
    pub key: Option<&'a Layout>,
    /// The lines of answers.
    pub out: &'a mut String,
    /// The columns of answers, where they are written as such.
    pub filled: Option<&'a mut Filled<'f>>,
    /// The lines of the key.
    pub key_out: &'a mut String,
    /// Memory for the cells before the answers.
    pub head: &'a mut String,
    /// Memory for the answers of a line.
    pub cells: &'a mut Vec<u8>,
}

/// The messages about a row.
#[derive(Default)]
pub struct RowMessages {
    /// Why it failed: a code.
    pub failed: Option<String>,
    /// An expectation is not met.
    pub unmet: bool,
    /// Codes of its warnings.
    pub warned: Vec<String>,
    /// The accuracy that was wanted and reached, where one was.
    pub reached: Option<AchievedAccuracy>,
    /// All of it, with the text it is about where that is not the file's.
    pub problems: Option<(Option<Source>, Problems)>,
}

impl RowMessages {
    /// Whether there are none.
    pub const fn is_nothing(&self) -> bool {
        self.failed.is_none() && !self.unmet && self.warned.is_empty()
    }
}

/// Solves a row and writes its lines: one per pose, and one without answers where there are none.
pub fn write_row<'f>(
    job: &'f Job,
    written: &mut RowWriter<'_, 'f>,
    family: &mut VariantSolver<'f>,
    input: &Input<'_>,
) -> RowMessages {
    let (written_before, key_before) = (written.out.len(), written.key_out.len());
    let filled_before = written.filled.as_ref().map_or(0, |filled| filled.answers.len());
    let found = catch_unwind(AssertUnwindSafe(|| {
        let (solved, problems) = family.solve_in_place(&input.row);
        written.row(input, solved, problems)
    }));
    found.unwrap_or_else(|_| {
        // what the last row left behind is not to be used again
        *family = job.family(Some(written.format));
        written.out.truncate(written_before);
        written.key_out.truncate(key_before);
        written.filled.iter_mut().for_each(|filled| filled.truncate(filled_before));
        written.panicked(input)
    })
}

impl RowWriter<'_, '_> {
    fn row(&mut self, input: &Input<'_>, solved: Option<&Solved>, problems: Problems) -> RowMessages {
        let mut said = RowMessages::default();
        if !problems.is_empty() {
            said = sorted(&problems);
        }
        said.reached = solved.and_then(|s| s.reached);
        said.unmet = solved.is_some_and(|s| s.outcomes.iter().any(|o| !o.passed));
        let error = if said.failed.is_some() { first_error(&problems) } else { String::new() };
        let answers = solved.map(|s| s.answers(PrintedDigits::READABLE));
        if let Some(filled) = &mut self.filled {
            filled.row(self.job, &input.cited(), answers.as_ref(), &error);
        } else if matches!(self.format, Format::Json | Format::Jsonl) {
            self.json(input, answers.as_ref(), &problems);
        } else {
            self.lines(input, answers.as_ref(), &error);
        }
        if let Some(key) = self.key {
            let columns = self.job.answers();
            let mut line = Line { head: std::mem::take(self.head), columns, digits: key.digits, key: true };
            line.head(self.job, input);
            line.all(answers.as_ref(), None, (self.key_out, self.cells));
            *self.head = line.head;
        }
        if !problems.is_empty() {
            let words = input.row.words();
            let problems = if words.is_empty() {
                problems
            } else {
                problems.of_row(&row_words(input.number, input.label.as_deref(), &words), input.span)
            };
            said.problems = Some((None, problems));
        }
        said
    }

    fn lines(&mut self, input: &Input<'_>, answers: Option<&Answers<'_>>, error: &str) {
        let columns = self.job.answers();
        let head = std::mem::take(self.head);
        let mut line = Line { head, columns, digits: self.layout.digits, key: false };
        line.head(self.job, input);
        for (i, column) in self.job.givens() {
            line.head.push(',');
            match input.written.text(i) {
                Some(text) => line.head.push_str(text),
                None => write_significant(&mut line.head, input.cited().number_of(i, column), FULL),
            }
        }
        line.all(answers, Some(error), (self.out, self.cells));
        *self.head = line.head;
    }

    fn json(&mut self, input: &Input<'_>, answers: Option<&Answers<'_>>, problems: &Problems) {
        let views = problems.views(&self.job.source);
        let variant =
            (!input.row.is_empty()).then(|| Variant::of(input.number, input.label.clone(), &input.row));
        let model = answers.map(|a| a.model);
        *self.out += &json::render_row(&self.job.source.name, variant, model.as_ref(), answers, &views);
        self.out.push('\n');
    }

    /// A row of a table that cannot be read.
    pub fn fault(&mut self, row: &Cited<'_>, (source, error): Fault) -> RowMessages {
        let by_row = matches!(*error, TableError::Absent { .. });
        let mut problems = Problems::new();
        problems.push(*error);
        let mut said = sorted(&problems);
        self.unsolved(row, &first_error(&problems), || problems.views(&source));
        if by_row {
            problems = problems.of_row(&format!("row {}", row.number), None);
        }
        said.problems = Some((Some(source), problems));
        said
    }

    /// An error of our own ends one row, not the batch.
    fn panicked(&mut self, input: &Input<'_>) -> RowMessages {
        self.unsolved(&input.cited(), "internal error: please report this row with the file", Vec::new);
        RowMessages { failed: Some("internal error".to_owned()), ..RowMessages::default() }
    }

    fn unsolved(
        &mut self,
        row: &Cited<'_>,
        error: &str,
        views: impl FnOnce() -> Vec<assur_text::diagnostic::DiagnosticView>,
    ) {
        let number = row.number;
        if let Some(filled) = &mut self.filled {
            filled.row(self.job, row, None, error);
        } else if matches!(self.format, Format::Json | Format::Jsonl) {
            let variant = Some(Variant::unread(number));
            *self.out += &json::render_row(&self.job.source.name, variant, None, None, &views());
            self.out.push('\n');
        } else {
            let cells = usize::from(self.job.label().is_some()) + self.job.givens().count();
            let head = number.to_string() + &",".repeat(cells);
            let line = Line { head, columns: self.job.answers(), digits: 0, key: false };
            line.all(None, Some(error), (self.out, self.cells));
        }
        if self.key.is_some() {
            let head = number.to_string() + if self.job.label().is_some() { "," } else { "" };
            Line { head, columns: self.job.answers(), digits: 0, key: true }.all(
                None,
                None,
                (self.key_out, self.cells),
            );
        }
    }
}

/// The lines of a row: the cells before the pose, and the columns after it.
struct Line<'a> {
    head: String,
    columns: Option<&'a AnswerColumns>,
    digits: usize,
    key: bool,
}

impl Line<'_> {
    fn head(&mut self, job: &Job, input: &Input<'_>) {
        self.head.clear();
        // writing to a String does not fail
        let _ = write!(self.head, "{}", input.number);
        if job.label().is_some() {
            self.head.push(',');
            write_text(input.label.as_deref().unwrap_or_default(), &mut self.head);
        }
    }

    /// One line per place that something is asked for at.
    fn all(
        &self,
        answers: Option<&Answers<'_>>,
        error: Option<&str>,
        (out, cells): (&mut String, &mut Vec<u8>),
    ) {
        let Some((columns, answers)) = self.columns.zip(answers) else {
            self.begin("", out);
            if let Some(columns) = self.columns {
                self.event(columns.names_events().then(String::new), out);
                columns.write_none(self.key, out);
            }
            return end(error, out);
        };
        let whole = columns.whole(answers);
        let greatest = (self.key || self.digits < FULL).then(|| answers.greatest());
        for line in columns.lines(answers, self.key) {
            self.begin(line.name(), out);
            self.event(columns.events_of(answers, &line), out);
            cells.clear();
            let places = (line.pose, line.whole(&whole));
            columns.write(answers, places, (self.digits, self.key, greatest.as_ref()), cells);
            out.push_str(std::str::from_utf8(cells).unwrap_or_default());
            let own = columns.failure_of(answers, &line).map(|why| failure(&answers.model, why).to_string());
            end(error.map(|e| own.as_deref().unwrap_or(e)), out);
        }
    }

    /// The cell of events, which a key does not have.
    fn event(&self, events: Option<String>, out: &mut String) {
        if let Some(events) = events.filter(|_| !self.key) {
            out.push(',');
            write_text(&events, out);
        }
    }

    fn begin(&self, pose: &str, out: &mut String) {
        out.push_str(&self.head);
        out.push(',');
        write_text(pose, out);
    }
}

fn end(error: Option<&str>, out: &mut String) {
    if let Some(error) = error {
        out.push(',');
        if !error.is_empty() {
            // a cell does not go over the end of its line
            let one_line = error.split_whitespace().collect::<Vec<_>>().join(" ");
            write_text(&one_line, out);
        }
    }
    out.push_str(LINE_END);
}

fn code_of(problem: &dyn miette::Diagnostic) -> String {
    problem.code().map_or_else(|| "error".to_owned(), |code| code.to_string())
}

/// The messages about a row, by code.
fn sorted(problems: &Problems) -> RowMessages {
    let (mut failed, mut warned) = (None, Vec::new());
    for problem in problems.sorted() {
        let code = code_of(problem);
        let severity = problem.severity();
        if matches!(severity, None | Some(miette::Severity::Error)) {
            failed.get_or_insert(code);
        } else if !warned.contains(&code) {
            warned.push(code);
        }
    }
    RowMessages { failed, warned, ..RowMessages::default() }
}

fn first_error(problems: &Problems) -> String {
    let is_error = |p: &&dyn Problem| matches!(p.severity(), None | Some(miette::Severity::Error));
    problems.sorted().into_iter().find(is_error).map(ToString::to_string).unwrap_or_default()
}
