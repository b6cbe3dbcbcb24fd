//! The roles of forces: which of them drive and which resist, by the sign of their power.

use super::answers::{Answers, with_unit};
use super::document::{Column, Report, Section, Table};
use assur_model::model::{Expr, FindKind, Mechanism};
use assur_solve::solve::Solved;
use assur_text::units::Dimension;

/// A power below this part of the greatest one is nothing.
const NOTHING: f64 = 1e-12;
/// Most poses that are named one by one.
const NAMED: usize = 3;

/// One row per power that `find powers` asks for.
pub(super) fn section(answers: &Answers<'_>, report: &mut Report) {
    let mechanism: &Mechanism = answers.model.mechanism;
    let Some((first, last)) = mechanism.powers else { return };
    let solved: Vec<(&str, &Solved)> = answers
        .poses()
        .filter_map(|p| Some((p.name.as_str(), p.outcome.as_ref().ok()?)))
        .filter(|(_, solved)| !solved.state.forces.locked)
        .collect();
    let values = |expr: &Expr| -> Vec<f64> {
        solved.iter().map(|(_, s)| answers.solution.view(&answers.model, s).scalar(expr)).collect()
    };
    let finds = mechanism.finds.get(first..last).unwrap_or_default();
    let all: Vec<(&str, Vec<f64>)> = finds
        .iter()
        .filter_map(|find| match &find.kind {
            FindKind::Value { expr, .. } => Some((find.name.as_str(), values(expr))),
            FindKind::Reactions | FindKind::Table(_) => None,
        })
        .collect();
    if all.is_empty() || solved.is_empty() {
        return;
    }
    let finite = |x: &&f64| x.is_finite();
    let greatest =
        all.iter().flat_map(|(_, v)| v.iter().filter(finite)).fold(0.0, |m, x| f64::max(m, x.abs()));
    let display = mechanism.display_of(Dimension::POWER);
    let columns = vec![
        Column::words("power of"),
        Column::words("role"),
        Column::numbers(with_unit("least", &display.unit)),
        Column::numbers(with_unit("greatest", &display.unit)),
    ];
    let mut table = Table::new(columns, 1);
    let figures = |x: f64| answers.precision.figures(display.of_si(x), display.of_si(greatest));
    let names: Vec<&str> = solved.iter().map(|(name, _)| *name).collect();
    for (name, values) in all {
        let least = values.iter().filter(finite).fold(f64::INFINITY, |m, x| m.min(*x));
        let most = values.iter().filter(finite).fold(f64::NEG_INFINITY, |m, x| m.max(*x));
        let of = name.strip_prefix("power(").and_then(|n| n.strip_suffix(')')).unwrap_or(name);
        table.row(vec![
            of.to_owned(),
            role(&names, &values, NOTHING * greatest),
            figures(least),
            figures(most),
        ]);
    }
    let mut section = Section::new("Roles of forces");
    section.table(table);
    report.section(section);
}

/// `drives`, `resists`, or where it does which.
fn role(names: &[&str], values: &[f64], nothing: f64) -> String {
    let at = |holds: &dyn Fn(f64) -> bool| -> Vec<&str> {
        names.iter().zip(values).filter(|(_, x)| holds(**x)).map(|(name, _)| *name).collect()
    };
    let (drives, resists) = (at(&|x| x > nothing), at(&|x| x < -nothing));
    match (drives.as_slice(), resists.as_slice()) {
        ([], []) => "no power".to_owned(),
        (_, []) => "drives".to_owned(),
        ([], _) => "resists".to_owned(),
        (a, b) => format!("drives at {}, resists at {}", poses(a, names.len()), poses(b, names.len())),
    }
}

fn poses(names: &[&str], all: usize) -> String {
    if names.len() <= NAMED {
        format!("pose{} {}", if names.len() == 1 { "" } else { "s" }, names.join(", "))
    } else {
        format!("{} of {all} poses", names.len())
    }
}
