//! The answer key beside the answers.

use super::answers::{Answers, NONE};
use super::document::{Column, Report, Section, Table};
use crate::exercise::Outcome;

/// How many expectations hold, and a table of those that do not.
pub(super) fn section(answers: &Answers<'_>, report: &mut Report) {
    let outcomes = answers.outcomes;
    let failed: Vec<&Outcome> = outcomes.iter().filter(|o| !o.passed).collect();
    let mut section = Section::new("Expectations");
    match (outcomes.len(), failed.len()) {
        (0, _) => return,
        (1, 0) => section.text("the one there is holds"),
        (all, 0) => section.text(format!("all {all} hold")),
        (all, failed) => section.text(format!("{failed} of {all} FAIL:")),
    }
    section.table(table(&failed, answers.precision.digits));
    report.section(section);
}

fn table(failed: &[&Outcome], digits: usize) -> Table {
    let mut columns = ["expectation", "pose"].map(Column::words).to_vec();
    columns.extend(["expected", "got", "off by", "allowed"].map(Column::right));
    let mut table = Table::new(columns, 2);
    for outcome in failed {
        let expected = outcome.expectation(digits);
        let within = outcome.within.map(|w| outcome.display.text(crate::model::Value::Scalar(w), 3));
        let difference = crate::model::Value::Scalar(outcome.difference().magnitude());
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
    matches!(outcome.expected, crate::model::Value::Truth(_))
}
