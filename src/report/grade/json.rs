//! Marks as JSON: one object, SI and radians.

use super::{hint, slip_name, word, written};
use crate::exercise::grade::{Graded, GradedRow, Known, Mark, NAMES, Part, Sum, Verdict};
use assur_text::diagnostic::{Diagnosis, DiagnosticView, Problems};
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;
use std::io::{self, Write};

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
    #[serde(serialize_with = "rows")]
    rows: &'a Graded,
    #[serde(serialize_with = "students")]
    students: &'a Graded,
    problems: Vec<PartView<'a>>,
    quantities: Vec<QuantityView<'a>>,
    #[serde(serialize_with = "not_counted")]
    not_counted: &'a Graded,
    unanswered: &'a [String],
    unasked: &'a [String],
    diagnostics: Vec<DiagnosticView>,
    /// Lines that are not marked beyond those in `diagnostics`.
    #[serde(skip_serializing_if = "is_none")]
    more_not_marked: usize,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes references")]
const fn is_none(count: &usize) -> bool {
    *count == 0
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
struct PartView<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<&'a str>,
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

/// One row after another: all views of a class at once would take more memory than its answers.
fn rows<S: Serializer>(graded: &&Graded, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(graded.rows.iter().map(|row| row_view(graded, row)))
}

fn students<S: Serializer>(graded: &&Graded, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(graded.students().map(PartView::from))
}

fn not_counted<S: Serializer>(graded: &&Graded, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(
        graded
            .not_counted
            .iter()
            .map(|aside| NotCountedView { counted_line: aside.counted, row: row_view(graded, &aside.row) }),
    )
}

/// One object, SI and radians, without the line's end.
#[must_use]
pub fn json(graded: &Graded) -> String {
    let mut bytes = Vec::new();
    // a view of texts and finite numbers is always written to memory
    let written = write_json(graded, &mut bytes).is_ok();
    String::from_utf8(bytes).ok().filter(|_| written).unwrap_or_default()
}

/// Writes one object, SI and radians, without the line's end.
///
/// # Errors
/// An error of writing.
pub fn write_json(graded: &Graded, out: &mut dyn Write) -> io::Result<()> {
    let quantities = graded.quantities.iter().enumerate();
    let view = GradedView {
        schema: SCHEMA,
        within: graded.rules.within,
        only_answered: graded.rules.only_answered,
        submissions: graded.rules.submissions.name(),
        credit: graded.rules.credit.parts().collect(),
        sum: graded.total().into(),
        mean: graded.mean(),
        rows: graded,
        students: graded,
        problems: graded.problems().into_iter().map(PartView::from).collect(),
        quantities: quantities
            .map(|(i, q)| QuantityView { name: &q.name, unit: &q.unit.text, sum: graded.total_of(i).into() })
            .collect(),
        not_counted: graded,
        unanswered: &graded.unanswered,
        unasked: &graded.unasked,
        diagnostics: diagnostics(graded),
        more_not_marked: graded.more_left_out,
    };
    serde_json::to_writer(out, &view).map_err(io::Error::from)
}

impl<'a> From<Part<'a>> for PartView<'a> {
    fn from(Part { name, rows, sum }: Part<'a>) -> Self {
        Self { name, rows, sum: sum.into() }
    }
}

/// What is not marked.
fn diagnostics(graded: &Graded) -> Vec<DiagnosticView> {
    let all = graded.left_out.iter();
    all.flat_map(|(source, error)| {
        Problems::of([Diagnosis::copied(error.as_ref()).as_warning()]).views(source)
    })
    .collect()
}

fn row_view<'a>(graded: &'a Graded, row: &'a GradedRow) -> RowView<'a> {
    debug_assert_eq!(NAMES, ["file", "row", "variant", "pose"]);
    let [file, number, variant, pose] = std::array::from_fn(|i| row.names.each[i].as_deref());
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
    let finite = |x: &Known| x.get().filter(|x| x.is_finite());
    MarkView {
        quantity: &graded.quantity(mark).name,
        given: given.get(),
        text: if matches!(verdict, Verdict::Right) { "" } else { written(verdict) },
        key: key.get(),
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
