//! A solved file as JSON: `docs/json-schema/solution-1.json`. SI and radians, fixed order of keys; what was not asked
//! for, or does not exist, is left out.

mod entries;
mod lines;
mod pose;
mod simulation;
mod train;

use serde::Serialize;

use super::answers::Answers;
use crate::exercise::Outcome;
use assur_check::{ColumnUse, Row};
use assur_model::model::{self, TableEntry};
use assur_solve::solve::{Model, Pose};
use assur_text::diagnostic::DiagnosticView;
use assur_text::source::is_obeyed;
use entries::ReachedView;
use entries::StructureView;
use entries::{AccuracyView, FlywheelView};
use entries::{Entries, Number, Reading};
pub use lines::JsonLines;
use pose::PoseView;
use simulation::{SimulationView, events};
use std::fmt::Write;

/// Name and version of the format.
const SCHEMA: &str = "assur.solution/1";

#[derive(Serialize)]
struct SolutionView<'a> {
    schema: &'static str,
    file: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    mechanism: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    variant: Option<Variant>,
    #[serde(skip_serializing_if = "Option::is_none")]
    structure: Option<StructureView<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    effects: Option<Vec<&'static str>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    accuracy: Option<ReachedView>,
    #[serde(skip_serializing_if = "Option::is_none")]
    simulation: Option<SimulationView>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    events: Entries<Vec<Number>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    poses: Option<Vec<PoseView<'a>>>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    cycle: Entries<Reading>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    tables: Entries<Entries<Vec<Number>>>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    cycle_accuracy: Entries<AccuracyView>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    flywheels: Entries<FlywheelView>,
    #[serde(skip_serializing_if = "Option::is_none")]
    expectations: Option<Vec<ExpectationView<'a>>>,
    diagnostics: &'a [DiagnosticView],
}

/// Name and version of the format of one position.
const POSITION: &str = "assur.position/1";

#[derive(Serialize)]
struct PositionView<'a> {
    schema: &'static str,
    file: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    variant: Option<&'a Variant>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pose: Option<PoseView<'a>>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    cycle: Entries<Reading>,
}

/// A row of a table of variants.
#[derive(Clone, Debug, Serialize)]
pub struct Variant {
    /// Counted from 1.
    row: usize,
    /// Its name in the column `variant`.
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    /// Its numbers by name, SI.
    values: Entries<Number>,
}

impl Variant {
    #[must_use]
    pub fn of(row: usize, name: Option<String>, numbers: &Row) -> Self {
        let numbers = numbers.entries().filter(|(column, _)| column.what != ColumnUse::Label);
        let values = numbers.filter_map(|(c, cell)| Some((c.name.clone(), Number::of(cell.value)?)));
        Self { row, name, values: Entries(values.collect()) }
    }

    /// A row that cannot be read.
    #[must_use]
    pub const fn unread(row: usize) -> Self {
        Self { row, name: None, values: Entries(Vec::new()) }
    }
}

#[derive(Serialize)]
struct ExpectationView<'a> {
    text: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pose: Option<&'a str>,
    expected: Reading,
    got: Reading,
    #[serde(skip_serializing_if = "Option::is_none")]
    within: Option<Number>,
    passed: bool,
}

/// One file as one line of JSON, without the line's end. What could not be reached is left out: the structure of a file
/// that has none, the poses of one that is not solved.
#[must_use]
pub fn render(
    file: &str,
    model: Option<&Model<'_>>,
    answers: Option<&Answers<'_>>,
    diagnostics: &[DiagnosticView],
) -> String {
    render_row(file, None, model, answers, diagnostics)
}

/// As [`render`], with a row of a table of variants.
#[must_use]
pub fn render_row(
    file: &str,
    variant: Option<Variant>,
    model: Option<&Model<'_>>,
    answers: Option<&Answers<'_>>,
    diagnostics: &[DiagnosticView],
) -> String {
    let title = model.map(|s| s.mechanism.title.as_str());
    let view = SolutionView {
        schema: SCHEMA,
        file,
        mechanism: title.filter(|t| !t.is_empty()),
        variant,
        structure: model.map(StructureView::of),
        effects: model.map(|s| s.plan.effects.computed()),
        accuracy: answers.and_then(|a| a.reached).map(ReachedView::of),
        simulation: answers.and_then(SimulationView::of),
        events: answers.filter(|a| a.solution.statics.swept.is_some()).map_or(Entries(Vec::new()), events),
        poses: answers.map(|a| a.poses().map(|p| PoseView::of(a, p)).collect()),
        cycle: Entries(answers.map(of_cycle).unwrap_or_default()),
        cycle_accuracy: answers.map_or_else(|| Entries(Vec::new()), entries::accuracy),
        flywheels: answers.map_or_else(|| Entries(Vec::new()), entries::flywheels),
        tables: Entries(answers.map(tables).unwrap_or_default()),
        expectations: answers.map(|a| a.outcomes.iter().filter_map(expectation).collect()),
        diagnostics,
    };
    // a view of texts, truths and finite numbers is always written
    escaped(serde_json::to_string(&view).unwrap_or_default())
}

/// One position as one line of JSON, without the line's end: `docs/json-schema/position-1.json`. Of a file without positions
/// what needs none.
#[must_use]
pub fn render_position<'a>(
    file: &'a str,
    variant: Option<&'a Variant>,
    answers: &Answers<'a>,
    pose: Option<&'a Pose>,
) -> String {
    let view = position_view(file, variant, answers, pose);
    escaped(serde_json::to_string(&view).unwrap_or_default())
}

fn position_view<'a>(
    file: &'a str,
    variant: Option<&'a Variant>,
    answers: &Answers<'a>,
    pose: Option<&'a Pose>,
) -> PositionView<'a> {
    PositionView {
        schema: POSITION,
        file,
        variant,
        pose: pose.map(|pose| PoseView::of(answers, pose)),
        cycle: Entries(of_cycle(answers)),
    }
}

/// The same JSON without characters that a terminal obeys: they occur in strings only.
pub(super) fn escaped(json: String) -> String {
    if !json.contains(is_obeyed) {
        return json;
    }
    let mut out = String::with_capacity(json.len() + 16);
    for c in json.chars() {
        if is_obeyed(c) {
            // writing to a String does not fail
            let _ = write!(out, "\\u{:04x}", u32::from(c));
        } else {
            out.push(c);
        }
    }
    out
}
/// Tables by the names of their entries.
fn tables(answers: &Answers<'_>) -> Vec<(String, Entries<Vec<Number>>)> {
    let table = |(name, table, pose): (String, &model::Table, Option<&Pose>)| {
        // an entry that does not exist at some place (the radius of a straight piece) is left out
        let entry = |e: &TableEntry| {
            let values = answers.entry(e, pose).iter().map(|x| Number::of(*x)).collect::<Option<Vec<_>>>()?;
            Some((e.name.clone(), values))
        };
        (name, Entries(table.entries.iter().filter_map(entry).collect()))
    };
    answers.tables().into_iter().map(table).collect()
}

fn of_cycle(answers: &Answers<'_>) -> Vec<(String, Reading)> {
    let all = answers.quantities_without_pose().into_iter();
    all.filter_map(|q| Some((q.name, Reading::of(q.values.first().copied().flatten()?)?))).collect()
}

fn expectation(outcome: &Outcome) -> Option<ExpectationView<'_>> {
    Some(ExpectationView {
        text: &outcome.text,
        pose: outcome.pose.as_deref(),
        expected: Reading::of(outcome.expected)?,
        got: Reading::of(outcome.got)?,
        within: outcome.within.and_then(Number::of),
        passed: outcome.passed,
    })
}
