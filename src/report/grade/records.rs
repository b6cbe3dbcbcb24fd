//! Marks as comma-separated values: one line per answer, and one per sum and per notice, by the first column.

use super::super::csv;
use super::{Figures, hint, slip_name, word};
use crate::exercise::grade::{Graded, GradedRow, Mark, Part, Sum, left_out_words};
use assur_text::units::significant;
use std::io::{self, Write};

/// Digits of parts and points.
const DIGITS: usize = 10;
const HEAD: [&str; 20] = [
    "record",
    "file",
    "row",
    "variant",
    "pose",
    "student",
    "line",
    "quantity",
    "unit",
    "given",
    "key",
    "off by [%]",
    "deviation",
    "verdict",
    "slip",
    "hint",
    "right",
    "total",
    "points",
    "possible",
];

/// Lines on their way out.
struct Records<'a> {
    out: &'a mut dyn Write,
    written: io::Result<()>,
}

impl Records<'_> {
    /// Writes a line, its missing cells empty, unless an earlier one could not be written.
    fn row(&mut self, mut cells: Vec<String>) {
        if self.written.is_ok() {
            cells.resize(HEAD.len(), String::new());
            self.written = self.out.write_all(csv::record(cells.iter().map(String::as_str)).as_bytes());
        }
    }
}

/// Writes one line per answer, with its verdict; then sums and what is not marked.
///
/// # Errors
/// An error of writing.
pub fn write_csv(graded: &Graded, out: &mut dyn Write) -> io::Result<()> {
    let mut records = Records { out, written: Ok(()) };
    records.row(HEAD.map(str::to_owned).to_vec());
    let each = |record: &'static str, row: &GradedRow, records: &mut Records<'_>| {
        row.marks.iter().for_each(|mark| records.row(answer(graded, record, row, mark)));
    };
    graded.rows.iter().for_each(|row| each("answer", row, &mut records));
    for aside in &graded.not_counted {
        each("not counted", &aside.row, &mut records);
        let hint = format!("line {} counts", aside.counted);
        records.row(Line { hint, ..Line::of_row("not counted row", &aside.row, aside.row.sum()) }.cells());
    }
    for row in &graded.rows {
        records.row(Line::of_row("row", row, row.sum()).cells());
    }
    sums(graded, &mut records);
    notices(graded, &mut records);
    records.written
}

/// What is not answered, what is not marked, the rules.
fn notices(graded: &Graded, records: &mut Records<'_>) {
    for row in &graded.unanswered {
        records.row(Line { hint: row.clone(), ..Line::new("not answered") }.cells());
    }
    for name in &graded.unasked {
        let hint = "no column answers this".to_owned();
        records.row(Line { quantity: name.clone(), hint, ..Line::new("not answered") }.cells());
    }
    for (source, error) in &graded.left_out {
        let line = (source.lines_before + 1).to_string();
        records.row(Line { line, hint: left_out_words(error), ..Line::new("not marked") }.cells());
    }
    if graded.more_left_out > 0 {
        let hint = super::more_lines(graded.more_left_out);
        records.row(Line { hint, ..Line::new("not marked") }.cells());
    }
    for hint in rules(graded) {
        records.row(Line { hint, ..Line::new("rule") }.cells());
    }
}

fn rules(graded: &Graded) -> Vec<String> {
    let rules = &graded.rules;
    let missing = if rules.only_answered { "left out" } else { "wrong" };
    let mut all = vec![
        format!("within {}", super::percent(rules.within)),
        format!("missing answers are {missing}"),
        format!("the {} submission counts", rules.submissions.name()),
    ];
    all.extend(rules.credit.parts().map(|(slip, part)| format!("credit for {slip} {part}")));
    all
}

fn sums(graded: &Graded, records: &mut Records<'_>) {
    for part in graded.students() {
        let Part { name, sum, .. } = part;
        let student = name.unwrap_or_default().to_owned();
        records.row(Line { student, sum: Some(sum), ..Line::new("student") }.cells());
    }
    for Part { name, sum, .. } in graded.problems() {
        let mut line = Line { sum: Some(sum), ..Line::new("problem") };
        line.names[0] = name.unwrap_or_default().to_owned();
        records.row(line.cells());
    }
    for (i, quantity) in graded.quantities.iter().enumerate() {
        let sum = Some(graded.total_of(i));
        records.row(Line { quantity: quantity.name.clone(), sum, ..Line::new("quantity") }.cells());
    }
    let hint = graded.mean().map(|mean| format!("mean of the students {}", super::percent(mean)));
    let hint = hint.unwrap_or_default();
    records.row(Line { hint, sum: Some(graded.total()), ..Line::new("total") }.cells());
}

fn answer(graded: &Graded, record: &'static str, row: &GradedRow, mark: &Mark) -> Vec<String> {
    let quantity = graded.quantity(mark);
    let line = Line {
        quantity: quantity.name.clone(),
        unit: quantity.unit.text.clone(),
        figures: Some(Figures::of(graded, mark)),
        off: mark.error.get().map(|e| significant(100.0 * e, 4)).unwrap_or_default(),
        verdict: word(&mark.verdict),
        slip: slip_name(&mark.verdict),
        hint: hint(mark),
        ..Line::of_row(record, row, Sum::of([mark]))
    };
    line.cells()
}

/// A line before it is written.
#[derive(Default)]
struct Line {
    record: &'static str,
    names: [String; 4],
    student: String,
    line: String,
    quantity: String,
    unit: String,
    figures: Option<Figures>,
    off: String,
    verdict: &'static str,
    slip: &'static str,
    hint: String,
    sum: Option<Sum>,
}

impl Line {
    fn new(record: &'static str) -> Self {
        Self { record, ..Self::default() }
    }

    fn of_row(record: &'static str, row: &GradedRow, sum: Sum) -> Self {
        Self {
            names: row.names.each.clone().map(Option::unwrap_or_default),
            student: row.person.as_deref().unwrap_or_default().to_owned(),
            line: row.line.map(|line| line.to_string()).unwrap_or_default(),
            sum: Some(sum),
            ..Self::new(record)
        }
    }

    fn cells(self) -> Vec<String> {
        let [given, key, deviation] = self.figures.map(|f| [f.given, f.key, f.deviation]).unwrap_or_default();
        let number = |x: f64| significant(x, DIGITS);
        let sum = self
            .sum
            .map(|s| [s.right.to_string(), s.total.to_string(), number(s.points), number(s.possible)]);
        let mut cells = vec![self.record.to_owned()];
        cells.extend(self.names);
        cells.extend([self.student, self.line, self.quantity, self.unit, given, key, self.off, deviation]);
        cells.extend([self.verdict.to_owned(), self.slip.to_owned(), self.hint]);
        cells.extend(sum.unwrap_or_default());
        cells
    }
}
