//! The answers to rows of variants as columns: one line per row and position.

use super::rows::RowLayout;
use crate::exercise::table::{PreciseNumber, Separator};
use crate::report::Answers;
use assur_check::{ColumnUse, Row, RowCell, RowColumn};
use assur_solve::message::failure;
use assur_syntax::document::{Document, ExprKind, Statement};
use std::sync::Arc;

/// Texts, one after another.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Texts {
    text: String,
    /// Where each ends.
    ends: Vec<usize>,
}

impl Texts {
    /// One text, and where each ends in it.
    #[must_use]
    pub fn into_parts(self) -> (String, Vec<usize>) {
        (self.text, self.ends)
    }

    fn push(&mut self, text: &str) {
        self.text.push_str(text);
        self.ends.push(self.text.len());
    }

    fn truncate(&mut self, count: usize) {
        self.ends.truncate(count);
        self.text.truncate(self.ends.last().copied().unwrap_or(0));
    }

    fn append(&mut self, other: &mut Self) {
        let before = self.text.len();
        self.text.push_str(&other.text);
        self.ends.extend(other.ends.iter().map(|end| before + end));
        other.truncate(0);
    }
}

/// Answers to rows: the lines of a row are those of what needs no position and of its positions; one has no answers where a row has none.
#[derive(Clone, Debug, Default)]
pub struct RowAnswers {
    /// The row of each line, from 0.
    pub rows: Vec<usize>,
    /// The position of each line.
    pub poses: Texts,
    /// The events at the instant of each line, where the layout has them.
    pub events: Vec<String>,
    /// The columns of the layout, in the author's units. NaN where there is no answer; 1 and 0 for conditions.
    pub values: Vec<Vec<f64>>,
    /// Lines without answers, with the reasons, in their order.
    pub errors: Vec<(usize, String)>,
}

impl RowAnswers {
    pub(crate) fn of(layout: &RowLayout) -> Self {
        Self { values: vec![Vec::new(); layout.fields.len()], ..Self::default() }
    }

    /// With room for lines.
    pub(crate) fn with_room(layout: &RowLayout, lines: usize) -> Self {
        let mut answers = Self::of(layout);
        answers.rows.reserve_exact(lines);
        answers.poses.ends.reserve_exact(lines);
        answers.values.iter_mut().for_each(|values| values.reserve_exact(lines));
        answers
    }

    /// How many lines there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    pub(crate) fn truncate(&mut self, count: usize) {
        self.rows.truncate(count);
        self.poses.truncate(count);
        self.events.truncate(count);
        self.errors.retain(|(line, _)| *line < count);
        self.values.iter_mut().for_each(|values| values.truncate(count));
    }

    /// Takes lines over.
    pub(crate) fn append(&mut self, other: &mut Self) {
        let before = self.len();
        self.errors.extend(other.errors.drain(..).map(|(line, why)| (before + line, why)));
        self.rows.append(&mut other.rows);
        self.poses.append(&mut other.poses);
        self.events.append(&mut other.events);
        self.values.iter_mut().zip(&mut other.values).for_each(|(all, values)| all.append(values));
    }
}

/// The lines of a row.
pub(crate) struct Line<'a> {
    pub layout: &'a RowLayout,
    pub index: usize,
    /// Memory for its numbers.
    pub numbers: &'a mut Vec<f64>,
    pub out: &'a mut RowAnswers,
}

impl Line<'_> {
    /// One line per place that something is asked for at, as in a table of text.
    pub fn all(&mut self, answers: Option<&Answers<'_>>, error: &str) {
        let Some(answers) = answers else { return self.without_answers(error) };
        let columns = &self.layout.answers;
        let whole = columns.whole(answers);
        let greatest = self.layout.key.then(|| answers.greatest());
        let mut row = std::mem::take(self.numbers);
        for line in columns.lines(answers, self.layout.key) {
            columns.write_row(answers, (line.pose, line.whole(&whole)), greatest.as_ref(), &mut row);
            let why = columns.failure_of(answers, &line).map(|why| failure(&answers.model, why).to_string());
            self.push_event(columns.events_of(answers, &line));
            self.push(line.name(), &row, why.as_deref().unwrap_or(error));
        }
        *self.numbers = row;
    }

    /// The line of a row without answers.
    pub fn without_answers(&mut self, error: &str) {
        let none = vec![f64::NAN; self.layout.fields.len()];
        self.push_event(None);
        self.push("", &none, error);
    }

    fn push_event(&mut self, event: Option<String>) {
        if self.layout.names_events {
            self.out.events.push(event.unwrap_or_default());
        }
    }

    fn push(&mut self, pose: &str, row: &[f64], error: &str) {
        if !error.is_empty() {
            let one_line = error.split_whitespace().collect::<Vec<_>>().join(" ");
            self.out.errors.push((self.out.len(), one_line));
        }
        self.out.rows.push(self.index);
        self.out.poses.push(pose);
        let finite = |x: f64| if x.is_finite() { x } else { f64::NAN };
        self.out.values.iter_mut().zip(row).for_each(|(values, x)| values.push(finite(*x)));
    }
}

// Cells of rows in memory, and the header that they would have in a table of text.

/// What a column of rows holds.
#[derive(Clone, Copy, Debug)]
pub enum Cells<'c> {
    /// Numbers in the unit of the column; NaN where one is missing.
    Numbers(&'c [f64]),
    /// Names of rows.
    Names(&'c [Option<String>]),
}

/// What is wrong with a row.
#[derive(Clone, Debug, thiserror::Error)]
#[error("the value of `{name}` is {what}")]
pub(crate) struct Missing {
    /// The column.
    pub name: String,
    /// `missing`, `infinite`
    pub what: &'static str,
}

/// Reads a row in SI, or what is wrong with it. The digits of its numbers are looked at where they [count](digits_count).
pub(crate) fn read_row(
    columns: &Arc<[RowColumn]>,
    cells: &[Cells<'_>],
    index: usize,
    digits: bool,
    row: &mut Row,
) -> Result<(), Missing> {
    row.begin(columns);
    for (column, cells) in columns.iter().zip(cells) {
        let number = match cells {
            _ if column.what == ColumnUse::Label => {
                row.push(RowCell::default());
                continue;
            }
            Cells::Numbers(numbers) => numbers.get(index).copied().unwrap_or(f64::NAN),
            Cells::Names(_) => f64::NAN,
        };
        if !number.is_finite() {
            let what = if number.is_nan() { "missing" } else { "infinite" };
            return Err(Missing { name: column.name.clone(), what });
        }
        let digit = if digits { column.unit.to_si(last_digit(number)) } else { 0.0 };
        row.push(RowCell { value: column.unit.to_si(number), digit });
    }
    Ok(())
}

/// Whether the digits of numbers count: an expectation may take its tolerance from them.
pub(crate) fn digits_count(document: &Document) -> bool {
    document.statements.iter().any(|statement| matches!(statement.node, Statement::Expect(_)))
}

/// The header of columns with their names and units, as in a table of text.
pub(crate) fn header_line(document: &Document, header: &[(String, Option<String>)]) -> String {
    header.iter().map(|column| header_cell(document, column)).collect::<Vec<_>>().join(", ")
}

/// One unit in the last digit of a number as it would be written.
fn last_digit(number: f64) -> f64 {
    PreciseNumber::read(&number.to_string(), Separator::Comma).map_or(0.0, |written| written.digit)
}

/// The header of a column as in a table of text: without a unit of its own the `given` has that of its declaration.
fn header_cell(document: &Document, (name, unit): &(String, Option<String>)) -> String {
    let unit = unit.clone().or_else(|| declared_unit(document, name));
    let text = match unit.filter(|unit| !unit.is_empty()) {
        Some(unit) if !name.contains('[') => format!("{name} [{unit}]"),
        _ => name.clone(),
    };
    let text = text.replace(['\r', '\n'], " ");
    let needs_quotes = text.contains([',', ';', '\t', '"']);
    if needs_quotes { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

/// The unit in which a document gives the value of a name.
fn declared_unit(document: &Document, name: &str) -> Option<String> {
    document.statements.iter().find_map(|statement| match &statement.node {
        Statement::Given(given) if given.name.node == name => match &given.value.kind {
            ExprKind::Number(number) => number.unit.as_ref().map(|unit| unit.node.clone()),
            _ => None,
        },
        _ => None,
    })
}
