//! The answer key next to the answers.

use super::answers::{Answers, NONE};
use super::document::{Column, Report, Section, Table};
use crate::exercise::Outcome;
use assur_model::model::Value;
use assur_text::units::significant;

/// A difference that is shown though the key allows it, in parts of the expected value.
const VISIBLE: f64 = 0.01;

/// The number of expectations met, and a table of the others.
pub(super) fn section(answers: &Answers<'_>, report: &mut Report) {
    let outcomes = answers.outcomes;
    let failed: Vec<&Outcome> = outcomes.iter().filter(|o| !o.passed).collect();
    let mut section = Section::new("Expectations");
    match (outcomes.len(), failed.len()) {
        (0, _) => return,
        (1, 0) => section.text("1 of 1 expectation met"),
        (all, 0) => section.text(format!("all {all} expectations met")),
        (all, failed) => section.text(format!("{failed} of {all} FAIL:")),
    }
    section.table(table(&failed, answers.precision.digits));
    let off: Vec<&Outcome> = outcomes.iter().filter(|o| o.passed && is_off(o)).collect();
    if !off.is_empty() {
        section.text("Within tolerance, but more than 1 % off:");
        section.table(deviations(&off, answers.precision.digits));
    }
    report.section(section);
}

/// Whether an equality is met by its tolerance only: published values that were read off a drawing.
fn is_off(outcome: &Outcome) -> bool {
    let expected = outcome.expected.magnitude();
    outcome.within.is_some() && expected > 0.0 && outcome.difference().magnitude() > VISIBLE * expected
}

/// Expected values next to the computed ones, with the difference relative to the computed value.
fn deviations(off: &[&Outcome], digits: usize) -> Table {
    let mut columns = ["expectation", "pose"].map(Column::words).to_vec();
    columns.extend(["expected", "got", "deviation"].map(Column::right));
    let mut table = Table::new(columns, 2);
    for outcome in off {
        let apart = 100.0 * outcome.difference().magnitude() / outcome.got.magnitude();
        table.row(vec![
            outcome.text.clone(),
            outcome.pose.clone().unwrap_or_else(|| NONE.to_owned()),
            outcome.display.text(outcome.expected, digits),
            outcome.display.text(outcome.got, digits),
            if apart.is_finite() { format!("{} %", significant(apart, 2)) } else { NONE.to_owned() },
        ]);
    }
    table
}

fn table(failed: &[&Outcome], digits: usize) -> Table {
    let mut columns = ["expectation", "pose"].map(Column::words).to_vec();
    columns.extend(["expected", "got", "off by", "allowed"].map(Column::right));
    let mut table = Table::new(columns, 2);
    for outcome in failed {
        let expected = outcome.expectation(digits);
        let within = outcome.within.map(|w| outcome.display.text(Value::Scalar(w), 3));
        let difference = Value::Scalar(outcome.difference().magnitude());
        table.row(vec![
            outcome.text.clone(),
            outcome.pose.clone().unwrap_or_else(|| NONE.to_owned()),
            if expected.is_empty() { "true".to_owned() } else { expected },
            outcome.display.text(outcome.got, digits),
            if expected_is_truth(outcome) { NONE.to_owned() } else { outcome.display.text(difference, 3) },
            within.unwrap_or_else(|| NONE.to_owned()),
        ]);
    }
    table
}

fn expected_is_truth(outcome: &Outcome) -> bool {
    matches!(outcome.expected, Value::Bool(_))
}
