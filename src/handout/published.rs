//! Published values next to exact ones, where a file expects both of a quantity: what a drawing gives, and what is so.

use crate::exercise::Outcome;
use crate::report::document::{Column, Section, Table};
use assur_text::units::significant;

/// A tolerance below this part of the value is that of an exact one, and above the second that of a published one.
const EXACT: f64 = 1e-6;
const PUBLISHED: f64 = 1e-4;
/// A deviation below this part is rounding.
const ROUNDING: f64 = 1e-12;
const DIGITS: usize = 6;

/// The values that are expected twice; none where there are none.
pub fn section(outcomes: &[Outcome]) -> Option<Section> {
    let mut columns = ["quantity", "pose"].map(Column::words).to_vec();
    columns.extend(["published", "exact", "deviation"].map(Column::right));
    let mut table = Table::new(columns, 2);
    let exact: Vec<&Outcome> = outcomes.iter().filter(|o| part(o).is_some_and(|p| p <= EXACT)).collect();
    for published in outcomes.iter().filter(|o| part(o).is_some_and(|p| p >= PUBLISHED)) {
        let same = |o: &&&Outcome| o.text == published.text && o.pose == published.pose;
        let Some(exact) = exact.iter().find(same) else { continue };
        let apart = 100.0 * published.difference().magnitude() / exact.expected.magnitude();
        table.row(vec![
            published.text.clone(),
            published.pose.clone().unwrap_or_default(),
            published.display.text(published.expected, DIGITS),
            exact.display.text(exact.expected, DIGITS),
            match apart {
                apart if apart <= 100.0 * ROUNDING => "0 %".to_owned(),
                apart if apart.is_finite() => format!("{} %", significant(apart, 2)),
                _ => "–".to_owned(),
            },
        ]);
    }
    let mut section = Section::new("Published values");
    let any = !table.rows.is_empty();
    section.table(table);
    any.then_some(section)
}

/// The tolerance of an equality over its value.
fn part(outcome: &Outcome) -> Option<f64> {
    let size = outcome.expected.magnitude();
    outcome.within.filter(|_| size > 0.0).map(|within| within / size)
}
