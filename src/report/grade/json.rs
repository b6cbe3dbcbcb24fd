//! Marks as JSON: one object, SI and radians.

use super::{hint, slip_name, word, written};
use crate::exercise::grade::{Graded, GradedRow, LeftOut, Mark, NAMES, Part, Sum, Verdict};
use assur_text::diagnostic::{DiagnosticView, Problems};
use serde::Serialize;
use std::collections::BTreeMap;

/// Name and version of the format.
const SCHEMA: &str = "assur.grade/2";

#[derive(Serialize)]
struct GradedView<'a> {
    schema: &'static str,
    within: f64,
    only_answered: bool,
    submissions: &'static str,
    credit: BTreeMap<&'a str, f64>,
    #[serde(flatten)]
    sum: SumView,
    #[serde(skip_serializing_if = "Option::is_none")]
    mean: Option<f64>,
    rows: Vec<RowView<'a>>,
    students: Vec<PartView>,
    problems: Vec<PartView>,
    quantities: Vec<QuantityView<'a>>,
    not_counted: Vec<NotCountedView<'a>>,
    unanswered: &'a [String],
    unasked: &'a [String],
    diagnostics: Vec<DiagnosticView>,
}

#[derive(Serialize)]
struct SumView {
    right: usize,
    total: usize,
    points: f64,
    possible: f64,
}

impl From<Sum> for SumView {
    fn from(Sum { right, total, points, possible }: Sum) -> Self {
        Self { right, total, points, possible }
    }
}

#[derive(Serialize)]
struct RowView<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<usize>,
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
    #[serde(flatten)]
    sum: SumView,
    marks: Vec<MarkView<'a>>,
}

#[derive(Serialize)]
struct NotCountedView<'a> {
    counted_line: usize,
    #[serde(flatten)]
    row: RowView<'a>,
}

#[derive(Serialize)]
struct MarkView<'a> {
    quantity: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    given: Option<f64>,
    #[serde(skip_serializing_if = "str::is_empty")]
    text: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    key: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    deviation: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<f64>,
    verdict: &'static str,
    #[serde(skip_serializing_if = "str::is_empty")]
    slip: &'static str,
    #[serde(skip_serializing_if = "String::is_empty")]
    hint: String,
    counts: bool,
    points: f64,
    possible: f64,
}

#[derive(Serialize)]
struct PartView {
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    rows: usize,
    #[serde(flatten)]
    sum: SumView,
}

#[derive(Serialize)]
struct QuantityView<'a> {
    name: &'a str,
    unit: &'a str,
    #[serde(flatten)]
    sum: SumView,
}

/// One object, SI and radians, without the line's end.
#[must_use]
pub fn json(graded: &Graded) -> String {
    let quantities = graded.quantities.iter().enumerate();
    let view = GradedView {
        schema: SCHEMA,
        within: graded.rules.within,
        only_answered: graded.rules.only_answered,
        submissions: graded.rules.submissions.name(),
        credit: graded.rules.credit.parts().collect(),
        sum: graded.total().into(),
        mean: graded.mean(),
        rows: graded.rows.iter().map(|row| row_view(graded, row)).collect(),
        students: graded.students().into_iter().map(PartView::from).collect(),
        problems: graded.problems().into_iter().map(PartView::from).collect(),
        quantities: quantities
            .map(|(i, q)| QuantityView { name: &q.name, unit: &q.unit.text, sum: graded.total_of(i).into() })
            .collect(),
        not_counted: graded
            .not_counted
            .iter()
            .map(|aside| NotCountedView { counted_line: aside.counted, row: row_view(graded, &aside.row) })
            .collect(),
        unanswered: &graded.unanswered,
        unasked: &graded.unasked,
        diagnostics: diagnostics(graded),
    };
    // a view of texts and finite numbers is always written
    serde_json::to_string(&view).unwrap_or_default()
}

impl From<Part> for PartView {
    fn from(Part { name, rows, sum }: Part) -> Self {
        Self { name, rows, sum: sum.into() }
    }
}

/// What is not marked.
fn diagnostics(graded: &Graded) -> Vec<DiagnosticView> {
    let all = graded.left_out.iter();
    all.flat_map(|(source, error)| Problems::of([LeftOut((**error).clone())]).views(source)).collect()
}

fn row_view<'a>(graded: &'a Graded, row: &'a GradedRow) -> RowView<'a> {
    debug_assert_eq!(NAMES, ["file", "row", "variant", "pose"]);
    let [file, number, variant, pose] = std::array::from_fn(|i| row.names[i].as_deref());
    RowView {
        line: row.line,
        file,
        row: number,
        variant,
        pose,
        student: row.person.as_deref(),
        sum: row.sum().into(),
        marks: row.marks.iter().map(|mark| mark_view(graded, mark)).collect(),
    }
}

fn mark_view<'a>(graded: &'a Graded, mark: &'a Mark) -> MarkView<'a> {
    let Mark { given, key, deviation, error, verdict, counts, points, possible, .. } = mark;
    let finite = |x: &Option<f64>| x.filter(|x| x.is_finite());
    MarkView {
        quantity: &graded.quantities[mark.quantity].name,
        given: *given,
        text: if matches!(verdict, Verdict::Right) { "" } else { written(verdict) },
        key: *key,
        deviation: finite(deviation),
        error: finite(error),
        verdict: word(verdict),
        slip: slip_name(verdict),
        hint: hint(mark),
        counts: *counts,
        points: *points,
        possible: *possible,
    }
}
