//! The answer key beside the answers.

use super::answers::{Answers, NONE};
use super::document::{Column, Report, Section, Table};
use crate::exercise::Outcome;
use crate::model::Value;

/// One row per expectation and pose, those that fail marked.
pub(super) fn section(answers: &Answers<'_>, report: &mut Report) {
    let outcomes = answers.outcomes;
    let passed = outcomes.iter().filter(|o| o.passed).count();
    let heading = if passed == outcomes.len() {
        format!("Expectations: all {passed} hold")
    } else {
        format!("Expectations: {passed} of {} hold", outcomes.len())
    };
    let mut section = Section::new(heading);
    section.table(table(outcomes, answers.precision.digits));
    report.section(section);
}

fn table(outcomes: &[Outcome], digits: usize) -> Table {
    let with_poses = outcomes.iter().any(|o| o.pose.is_some() && outcomes[0].pose != o.pose);
    let mut columns = vec![Column::words("expectation")];
    if with_poses {
        columns.push(Column::words("pose"));
    }
    columns.extend(["expected", "got"].map(Column::numbers));
    columns.extend(["unit", ""].map(Column::words));
    let mut table = Table::new(columns, 1);
    for outcome in outcomes {
        let mut cells = vec![outcome.text.clone()];
        if with_poses {
            cells.push(outcome.pose.clone().unwrap_or_else(|| NONE.to_owned()));
        }
        let sign = match (outcome.comparison, outcome.expected) {
            (Some(_), _) => outcome.expectation(digits),
            (None, value) => outcome.display.figures(value, digits),
        };
        let (expected, unit) = match outcome.comparison {
            Some(_) => (sign, String::new()),
            None => (sign, outcome.display.unit.clone()),
        };
        cells.push(expected);
        cells.push(got(outcome, digits));
        cells.push(unit);
        cells.push(if outcome.passed { "holds" } else { "FAILS" }.to_owned());
        table.row(cells);
    }
    table
}

/// What was got, to as many digits as agree with what was expected.
fn got(outcome: &Outcome, digits: usize) -> String {
    let difference = outcome.difference();
    let noise = outcome.within.unwrap_or(0.0);
    match (outcome.got, outcome.expected) {
        // within the tolerance the expected figures are the ones to read
        (Value::Scalar(_), Value::Scalar(0.0)) if outcome.passed && difference.magnitude() <= noise => {
            "0".to_owned()
        }
        (value, _) => outcome.display.figures(value, digits),
    }
}
