//! Flywheels, and the accuracy of functions over the sweep.

use super::answers::{Answers, NONE};
use super::document::{Column, Report, Section, Table};
use assur_model::model::{Display, Expr, Find, FindKind, Flywheel, Query, Value};
use assur_solve::solve::{CycleAnswer, FlywheelAnswer};
use assur_text::units::Dimension;

/// One section for all flywheels.
pub(super) fn flywheels(answers: &Answers<'_>, report: &mut Report) {
    for (wheel, found) in all_flywheels(answers) {
        let on = &answers.model.mechanism.link(wheel.on).name;
        let mut section = Section::new(format!("Flywheel {} on {on}", wheel.name));
        section.table(of_flywheel(answers, wheel, found));
        report.section(section);
    }
}

/// The flywheels of a file with their results.
pub(super) fn all_flywheels<'a>(
    answers: &Answers<'a>,
) -> impl Iterator<Item = (&'a Flywheel, &'a FlywheelAnswer)> {
    answers.model.mechanism.flywheels.iter().zip(&answers.solution.statics.flywheels)
}

fn of_flywheel(answers: &Answers<'_>, wheel: &Flywheel, found: &FlywheelAnswer) -> Table {
    let mechanism = answers.model.mechanism;
    let scale = answers.greatest();
    let columns = vec![Column::words("quantity"), Column::numbers("value"), Column::words("unit")];
    let mut table = Table::new(columns, 1);
    let mut add = |name: &str, x: f64, display: Display| {
        let figures = answers.precision.figures(display.of_si(x), scale.in_unit(&display));
        table.row(vec![name.to_owned(), figures, display.unit]);
    };
    let of = |d: Dimension| mechanism.display_of(d);
    let energy = Display { unit: "J".into(), factor: 1.0, dimension: of(Dimension::TORQUE).dimension };
    add("mean torque", found.mean_torque, of(Dimension::TORQUE));
    add("mean speed", found.speed, of(Dimension::ANGULAR_VELOCITY));
    add("drive at least work", found.extremes[0], of(Dimension::ANGLE));
    add("drive at greatest work", found.extremes[1], of(Dimension::ANGLE));
    add("fluctuation of work", found.fluctuation, energy);
    let [mean, least, greatest] = found.links;
    if greatest > 0.0 {
        add("reduced inertia of the links, mean", mean, of(Dimension::INERTIA));
        add("least", least, of(Dimension::INERTIA));
        add("greatest", greatest, of(Dimension::INERTIA));
    }
    let subtracted = if wheel.with_links { " without the links" } else { "" };
    add(&format!("moment of inertia{subtracted}"), found.inertia, of(Dimension::INERTIA));
    table
}

/// Names of functions over the sweep, by the item or expectation that asks for each, with their results.
pub(super) fn named<'a>(answers: &Answers<'a>) -> Vec<(&'a str, &'a CycleAnswer)> {
    let mechanism = answers.model.mechanism;
    let finds = mechanism.finds.iter().filter_map(|f| match &f.kind {
        FindKind::Value { expr, .. } => Some((f.name.as_str(), expr)),
        FindKind::Reactions | FindKind::Table(_) => None,
    });
    let expects = mechanism.expects.iter().map(|e| (e.text.as_str(), &e.expr));
    let quantities = mechanism.quantities.iter().map(|q| (q.name.as_str(), &q.expr));
    let mut found: Vec<(usize, &str)> = Vec::new();
    for (name, expr) in quantities.chain(finds).chain(expects) {
        expr.parts(&mut |part| {
            if let Expr::Query(Query::Cycle(index)) = part
                && !found.iter().any(|(i, _)| i == index)
            {
                found.push((*index, name));
            }
        });
    }
    let answer = |(index, name)| Some((name, answers.solution.statics.cycles.get(index)?));
    found.into_iter().filter_map(answer).collect()
}

/// The estimate of a function over the sweep, or of a flywheel.
struct Estimate<'a> {
    name: &'a str,
    /// The error relative to the value, or to what is in play where that is zero.
    relative: f64,
    samples: usize,
    splits: &'a [f64],
}

fn estimates<'a>(answers: &Answers<'a>) -> impl Iterator<Item = Estimate<'a>> {
    let over = |error: f64, of: f64| if error == 0.0 { 0.0 } else { error / of.abs() };
    let of_cycle = move |(name, c): (&'a str, &'a CycleAnswer)| {
        // of what is zero the greatest magnitude in play is the measure
        let relative = over(c.error, if c.value == 0.0 { c.scale } else { c.value });
        Estimate { name, relative, samples: c.samples, splits: &c.splits }
    };
    let is_known = |(_, c): &(&str, &CycleAnswer)| c.value.is_finite();
    let cycles = named(answers).into_iter().filter(is_known).map(of_cycle);
    // of a table its least accurate number
    let tables = of_tables(answers).into_iter().filter_map(move |all| {
        all.into_iter().filter(is_known).map(of_cycle).max_by(|a, b| a.relative.total_cmp(&b.relative))
    });
    let wheels = all_flywheels(answers).map(move |(wheel, found)| {
        let relative = over(found.error, found.fluctuation);
        Estimate { name: &wheel.name, relative, samples: found.samples, splits: &found.splits }
    });
    cycles.chain(tables).chain(wheels)
}

/// The functions over the sweep that the numbers of each table are made of, under its name.
fn of_tables<'a>(answers: &Answers<'a>) -> Vec<Vec<(&'a str, &'a CycleAnswer)>> {
    let all = &answers.solution.statics.cycles;
    let of = |find: &'a Find| {
        let FindKind::Table(table) = &find.kind else { return None };
        let mut found: Vec<usize> = Vec::new();
        for expr in table.entries.iter().flat_map(|entry| &entry.found) {
            expr.queries(&mut |query| match query {
                Query::Cycle(index) if !found.contains(index) => found.push(*index),
                _ => {}
            });
        }
        Some(found.into_iter().filter_map(|i| Some((find.name.as_str(), all.get(i)?))).collect())
    };
    answers.model.mechanism.finds.iter().filter_map(of).collect()
}

/// The greatest estimated error, relative to the value.
pub(super) fn worst_error(answers: &Answers<'_>) -> Option<f64> {
    estimates(answers).map(|e| e.relative).reduce(f64::max)
}

/// Estimated errors, and switching points.
pub(super) fn accuracy(answers: &Answers<'_>, order_of: impl Fn(f64) -> String) -> Table {
    let mechanism = answers.model.mechanism;
    let columns = vec![
        Column::words("over the sweep"),
        Column::right("relative error"),
        Column::right("positions solved"),
        Column::words("switching points"),
    ];
    let mut table = Table::new(columns, 1);
    for estimate in estimates(answers) {
        let mut cells =
            vec![estimate.name.to_owned(), order_of(estimate.relative), estimate.samples.to_string()];
        let places = mechanism.drives.first().map(|d| mechanism.drive_display(d.target));
        let text = |x: &f64| places.as_ref().map(|d| d.text(Value::Scalar(*x), answers.precision.digits));
        let all = estimate.splits.iter().filter_map(text).collect::<Vec<_>>();
        cells.push(if all.is_empty() { NONE.to_owned() } else { all.join(", ") });
        table.row(cells);
    }
    table
}
