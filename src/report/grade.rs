//! Marks: tables to read, comma-separated values, JSON.

use super::csv;
use super::document::{Block, Column, Report, Section, Table};
use crate::exercise::grade::{Graded, GradedRow, Mark, NAMES, Verdict};
use assur_text::units::significant;
use serde::Serialize;

/// Name and version of the format.
const SCHEMA: &str = "assur.grade/1";
const DIGITS: usize = 6;

/// `12 of 14`
fn of((right, all): (usize, usize)) -> String {
    format!("{right} of {all}")
}

/// `3 %`; relative to a key of 0 there is no percentage.
fn deviation(error: f64) -> String {
    if error.is_finite() { percent(error) } else { "key is 0".to_owned() }
}

/// `3 %`
fn percent(x: f64) -> String {
    format!("{} %", significant(100.0 * x, 3))
}

const fn word(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict::Right => "right",
        Verdict::Wrong(_) => "wrong",
        Verdict::Missing => "missing",
        Verdict::Unreadable(..) => "unreadable",
    }
}

fn hint(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Wrong(Some(slip)) => slip.words(),
        Verdict::Unreadable(_, why) => why.clone(),
        _ => String::new(),
    }
}

/// An answer and the key in the unit of the answers.
fn figures(graded: &Graded, mark: &Mark) -> (String, String) {
    let unit = &graded.quantities[mark.quantity].unit;
    let figures = |x: f64| significant(unit.from_si(x), DIGITS);
    let given = match &mark.verdict {
        Verdict::Unreadable(text, _) => text.clone(),
        _ => mark.given.map(figures).unwrap_or_default(),
    };
    (given, figures(mark.key))
}

/// Tables to read: wrong and missing answers, totals per row and per quantity.
#[must_use]
pub fn report(graded: &Graded) -> Report {
    let sections = [not_right(graded), per_row(graded), per_quantity(graded), not_answered(graded)];
    let title = format!("{} right, within {}", of(graded.totals()), percent(graded.within));
    let mut report = Report { title, ..Report::default() };
    sections.into_iter().for_each(|s| report.section(s));
    report
}

fn not_right(graded: &Graded) -> Section {
    let mut table = Table::new(
        vec![
            Column::words("row"),
            Column::words("quantity"),
            Column::right("given"),
            Column::right("key"),
            Column::words("unit"),
            Column::right("deviation"),
            Column::words("verdict"),
        ],
        2,
    );
    for row in &graded.rows {
        for mark in row.marks.iter().filter(|m| m.verdict != Verdict::Right) {
            let quantity = &graded.quantities[mark.quantity];
            let (given, key) = figures(graded, mark);
            let hint = hint(&mark.verdict);
            let verdict = word(&mark.verdict);
            let verdict = if hint.is_empty() { verdict.to_owned() } else { format!("{verdict}: {hint}") };
            let off = mark.error.map(deviation).unwrap_or_default();
            let unit = quantity.unit.text.clone();
            table.row(vec![row.words(), quantity.name.clone(), given, key, unit, off, verdict]);
        }
    }
    let mut section = Section::new("Wrong or missing");
    section.table(table);
    section
}

fn per_row(graded: &Graded) -> Section {
    let mut table = Table::of_words(&["row", "right"]);
    for row in &graded.rows {
        table.row(vec![row.words(), of((row.right(), row.marks.len()))]);
    }
    Section { heading: "Rows".to_owned(), blocks: vec![Block::Table(table)] }
}

fn per_quantity(graded: &Graded) -> Section {
    let mut table = Table::of_words(&["quantity", "right"]);
    for (i, quantity) in graded.quantities.iter().enumerate() {
        table.row(vec![quantity.name.clone(), of(graded.totals_of(i))]);
    }
    Section { heading: "Quantities".to_owned(), blocks: vec![Block::Table(table)] }
}

fn not_answered(graded: &Graded) -> Section {
    let mut section = Section::new("Not answered");
    section.list(graded.unanswered.iter().map(|row| format!("no answers for {row}")).collect());
    if !graded.unasked.is_empty() {
        section.text(format!("No column answers {}.", graded.unasked.join(", ")));
    }
    section
}

/// One line per answer, with its verdict.
#[must_use]
pub fn csv(graded: &Graded) -> String {
    let head =
        ["file", "row", "variant", "pose", "student", "quantity", "unit", "given", "key", "off by [%]"];
    let mut table = Table::of_words(&head);
    table.columns.extend(["verdict", "slip", "hint"].map(Column::words));
    for row in &graded.rows {
        for mark in &row.marks {
            let quantity = &graded.quantities[mark.quantity];
            let (given, key) = figures(graded, mark);
            let mut cells: Vec<String> = row.names.iter().map(|n| n.clone().unwrap_or_default()).collect();
            cells.extend([row.person.clone().unwrap_or_default(), quantity.name.clone()]);
            cells.extend([quantity.unit.text.clone(), given, key]);
            cells.push(mark.error.map(|e| significant(100.0 * e, 4)).unwrap_or_default());
            cells.extend([
                word(&mark.verdict).to_owned(),
                slip_name(&mark.verdict).to_owned(),
                hint(&mark.verdict),
            ]);
            table.row(cells);
        }
    }
    csv::render(&table)
}

const fn slip_name(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict::Wrong(Some(slip)) => slip.name(),
        _ => "",
    }
}

#[derive(Serialize)]
struct GradedView<'a> {
    schema: &'static str,
    within: f64,
    right: usize,
    total: usize,
    rows: Vec<RowView<'a>>,
    quantities: Vec<QuantityView<'a>>,
    unanswered: &'a [String],
    unasked: &'a [String],
}

#[derive(Serialize)]
struct RowView<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    row: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    variant: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pose: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    student: Option<&'a str>,
    right: usize,
    total: usize,
    marks: Vec<MarkView<'a>>,
}

#[derive(Serialize)]
struct MarkView<'a> {
    quantity: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    given: Option<f64>,
    key: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<f64>,
    verdict: &'static str,
    #[serde(skip_serializing_if = "str::is_empty")]
    slip: &'static str,
    #[serde(skip_serializing_if = "String::is_empty")]
    hint: String,
}

#[derive(Serialize)]
struct QuantityView<'a> {
    name: &'a str,
    right: usize,
    total: usize,
}

/// One object, SI and radians, without the line's end.
#[must_use]
pub fn json(graded: &Graded) -> String {
    let (right, total) = graded.totals();
    let quantity = |(i, q): (usize, &'_ crate::exercise::grade::Quantity)| {
        let (right, total) = graded.totals_of(i);
        (q.name.clone(), right, total)
    };
    let totals: Vec<_> = graded.quantities.iter().enumerate().map(quantity).collect();
    let view = GradedView {
        schema: SCHEMA,
        within: graded.within,
        right,
        total,
        rows: graded.rows.iter().map(|row| row_view(graded, row)).collect(),
        quantities: totals
            .iter()
            .map(|(name, right, total)| QuantityView { name, right: *right, total: *total })
            .collect(),
        unanswered: &graded.unanswered,
        unasked: &graded.unasked,
    };
    // a view of texts and finite numbers is always written
    serde_json::to_string(&view).unwrap_or_default()
}

fn row_view<'a>(graded: &'a Graded, row: &'a GradedRow) -> RowView<'a> {
    debug_assert_eq!(NAMES, ["file", "row", "variant", "pose"]);
    let [file, number, variant, pose] = std::array::from_fn(|i| row.names[i].as_deref());
    let mark = |m: &'a Mark| MarkView {
        quantity: &graded.quantities[m.quantity].name,
        given: m.given,
        key: m.key,
        error: m.error.filter(|e| e.is_finite()),
        verdict: word(&m.verdict),
        slip: slip_name(&m.verdict),
        hint: hint(&m.verdict),
    };
    RowView {
        file,
        row: number,
        variant,
        pose,
        student: row.person.as_deref(),
        right: row.right(),
        total: row.marks.len(),
        marks: row.marks.iter().map(mark).collect(),
    }
}
