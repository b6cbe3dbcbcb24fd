//! Where the drives are at a position.

use crate::report::Answers;
use assur_check::parts_of;
use assur_model::model::{DriveTarget, FindKind, Mechanism, Query, Value};
use assur_solve::solve::Pose;
use assur_syntax::document::{Document, Expr, ExprKind, Statement};
use assur_syntax::given::{Datum, Given, Shown, lines, names_of};
use assur_text::units::significant;
use assur_worked::{Name, drive_letter, letters_in_text, printed_unit};

/// Digits of a drive.
const DIGITS: usize = 6;

/// The letter of every drive whose position is not asked for, with its value; nothing of a motion under loads.
pub(super) fn drives_at(answers: &Answers<'_>, pose: &Pose) -> Vec<(Name, String)> {
    let mechanism = answers.model.mechanism;
    if mechanism.simulation.is_some() {
        return Vec::new();
    }
    let shown = mechanism.drives.iter().zip(&pose.drives).filter_map(|(drive, value)| {
        let Some(Value::Scalar(x)) = value.value().filter(|_| !is_asked(mechanism, drive.target)) else {
            return None;
        };
        let display = mechanism.drive_display(drive.target);
        let figures = significant(display.of_si(x), DIGITS).replace('-', "−");
        Some((drive_letter(mechanism, drive), format!("{figures}{}", printed_unit(&display.unit))))
    });
    shown.collect()
}

/// The same in words: `φ_1 = 60°`.
pub(super) fn in_words(drives: &[(Name, String)]) -> String {
    let one = |(letter, value): &(Name, String)| format!("{} = {value}", letters_in_text(letter));
    drives.iter().map(one).collect::<Vec<_>>().join(", ")
}

/// Whether the coordinate of a drive is itself a question.
fn is_asked(mechanism: &Mechanism, target: DriveTarget) -> bool {
    mechanism.finds.iter().any(|find| match &find.kind {
        FindKind::Value { expr: assur_model::model::Expr::Query(query), .. } => match (query, target) {
            (Query::Angle(link), DriveTarget::Link(own)) => *link == own,
            (Query::Displacement(pair), DriveTarget::Pair(own)) => *pair == own,
            _ => false,
        },
        _ => false,
    })
}

/// Whether positions follow from values of the table of variants, or from what is solved, as a dead position does.
pub(super) fn vary(document: &Document, in_table: &dyn Fn(&str) -> bool) -> bool {
    let given = Given::of(document);
    let table = document.statements.iter().filter_map(|s| match &s.node {
        Statement::Given(value) => Some(value.name.node.as_str()),
        _ => None,
    });
    let following = given.following(&table.filter(|name| in_table(name)).collect());
    let lines = lines(document);
    let data = lines.iter().flat_map(|line| &line.data).filter(|datum| datum.shown == Shown::Heading);
    let follows = |expr: &Expr| {
        let mut calls = false;
        parts_of(expr, &mut |part| calls |= matches!(part.kind, ExprKind::Call { .. }));
        calls || names_of(expr).into_iter().any(|name| following.contains(name))
    };
    data.flat_map(Datum::expressions).any(follows)
}
