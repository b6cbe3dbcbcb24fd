//! The answers: quantities asked for, at every pose.

use super::answers::{Answers, NONE, with_unit};
use super::columns::{Cell, Quantity};
use super::document::{Align, Column, Report, Section, Table};
use super::reactions::{ReactionEntry, reactions};
use super::simulation;
use super::symbols::Symbols;
use assur_model::model::{Display, Value};
use assur_solve::message::failure;
use assur_solve::solve::{MotionScales, Pose};
use assur_text::units::{Dimension, significant};

/// Digits that remain after the conversion from SI into the author's unit: 30 deg remain 30 deg.
const FULL: usize = 15;

/// What the tables are of that have numbers of all poses.
pub const OF_MOTION: &str = "over the whole motion";
pub const OF_CYCLE: &str = "for the whole cycle";

/// Answers, and the poses that have none.
pub(super) fn sections(answers: &Answers<'_>, report: &mut Report) {
    let mut section = Section::new("Answers");
    let scale = answers.greatest();
    let poses: Vec<&Pose> = answers.poses().collect();
    if let [pose] = poses.as_slice() {
        let quantities = answers.all_quantities(&poses);
        let drives = drives_in_words(answers, pose);
        let header = if drives.is_empty() { "quantity".to_owned() } else { format!("at {drives}") };
        section.table(of_one_pose(answers, scale, header, &quantities));
    } else {
        section.table(of_a_sweep(answers, scale, &poses, &answers.quantities(&poses)));
        let moves = answers.model.mechanism.simulation.is_some();
        let header = if moves { OF_MOTION } else { OF_CYCLE };
        let whole = answers.quantities_without_pose();
        section.table(of_one_pose(answers, scale, header.to_owned(), &whole));
    }
    let mut own: Vec<String> =
        answers.efforts().into_iter().filter(|e| e.of_drive).map(|e| e.written).collect();
    own.dedup();
    if !own.is_empty() {
        section.text(format!("No balance is declared: {} is the drive's own effort.", own.join(", ")));
    }
    if answers.model.mechanism.finds.is_empty() && answers.outcomes.is_empty() {
        section.text("Nothing requested. Add a `find` statement, e.g. `find reactions`.");
    }
    report.section(section);
    let mut failed = Section::new("Poses without solution");
    failed.list(failures(answers));
    report.section(failed);
}

/// One row per quantity.
fn of_one_pose(answers: &Answers<'_>, scale: MotionScales, header: String, quantities: &[Quantity]) -> Table {
    let with_vectors = quantities.iter().any(|q| matches!(q.values[..], [Some(Value::Vector(_))]));
    let mut columns = vec![Column::words(header), Column::numbers("value"), Column::words("unit")];
    if with_vectors {
        columns[1].align = Align::Right;
        columns.push(Column::numbers("magnitude"));
    }
    let mut table = Table::new(columns, 1);
    let symbols = Symbols::of(answers.model.mechanism);
    for quantity in quantities {
        let value = quantity.values.first().copied().flatten();
        let mut cells = vec![symbols.label(&quantity.name)];
        if value.is_none() && quantity.missing != NONE {
            cells.push(quantity.missing.to_owned());
        } else {
            cells.push(figures(answers, scale, &quantity.display, value));
            cells.push(quantity.display.unit.clone());
        }
        if let Some(Value::Vector(v)) = value {
            let magnitude = Some(Value::Scalar(libm::hypot(v.x, v.y)));
            cells.push(figures(answers, scale, &quantity.display, magnitude));
        }
        table.row(cells);
    }
    table
}

/// A value in figures, rounding errors as 0.
pub(super) fn figures(
    answers: &Answers<'_>,
    scale: MotionScales,
    display: &Display,
    value: Option<Value>,
) -> String {
    let unit = scale.in_unit(display);
    let precision = answers.precision_of(None);
    let number = |x: f64| precision.figures(display.of_si(x), unit);
    match value {
        Some(Value::Scalar(x)) => number(x),
        Some(Value::Vector(v)) => format!("({}, {})", number(v.x), number(v.y)),
        Some(Value::Bool(truth)) => truth.to_string(),
        None => NONE.to_owned(),
    }
}

/// One row per pose, one column per number.
fn of_a_sweep(answers: &Answers<'_>, scale: MotionScales, poses: &[&Pose], quantities: &[Quantity]) -> Table {
    let mut table = Table::new(vec![Column::words(answers.pose_header())], 1);
    table.rows = poses.iter().map(|p| vec![answers.pose_cell(p)]).collect();
    if simulation::names_events(answers.model.mechanism) {
        table.columns.push(Column::words("event"));
        let events = poses.iter().map(|p| simulation::events_at(answers, p));
        table.rows.iter_mut().zip(events).for_each(|(row, events)| row.push(events));
    }
    for (i, drive) in answers.shown_drives() {
        let display = answers.model.mechanism.drive_display(drive.target);
        let cells = poses.iter().map(|p| answers.drive_figures(drive.target, p.drives.get(i)));
        table.column(with_unit(&drive.name, &display.unit), cells);
    }
    table.keys = table.columns.len();
    let symbols = Symbols::of(answers.model.mechanism);
    for quantity in quantities {
        let unit = scale.in_unit(&quantity.display);
        for part in quantity.parts() {
            let greatest = unit.max(part.greatest());
            let cells = part.cells.iter().zip(poses).map(|(cell, pose)| match cell {
                Cell::Number(x) => answers.precision_of(Some(pose)).figures(*x, greatest),
                Cell::Bool(truth) => truth.to_string(),
                Cell::None => quantity.missing.to_owned(),
            });
            let name = symbols.label(&part.name);
            table.column(with_unit(&name, &quantity.display.unit), cells);
        }
    }
    if table.columns.len() > table.keys { table } else { Table::default() }
}

/// All digits of every number, one row per pose: drives, quantities and, where they are asked for, reactions. What
/// needs no pose stands in every row; a pose without solution has empty cells.
pub(super) fn full_table(answers: &Answers<'_>) -> Table {
    let poses: Vec<&Pose> = answers.poses().collect();
    let mut table = Table::new(vec![Column::words(answers.pose_header())], 1);
    table.rows = poses.iter().map(|p| vec![p.name.clone()]).collect();
    if simulation::names_events(answers.model.mechanism) {
        table.columns.push(Column::words("event"));
        let events = poses.iter().map(|p| simulation::events_at(answers, p));
        table.rows.iter_mut().zip(events).for_each(|(row, events)| row.push(events));
    }
    for (i, drive) in answers.shown_drives() {
        let display = answers.model.mechanism.drive_display(drive.target);
        let values = poses.iter().map(|p| p.drives.get(i).and_then(|d| d.value())).collect();
        add_full(&mut table, &Quantity { name: drive.name.clone(), display, values, missing: NONE });
    }
    for quantity in answers.quantities(&poses) {
        add_full(&mut table, &quantity);
    }
    let whole = answers.quantities_without_pose();
    if poses.is_empty() && !whole.is_empty() {
        // the one row of a file without poses
        table.rows.push(vec![String::new(); table.columns.len()]);
    }
    for mut quantity in whole {
        let value = quantity.values.first().copied().flatten();
        quantity.values = vec![value; table.rows.len()];
        add_full(&mut table, &quantity);
    }
    if answers.wants_reactions() {
        reaction_quantities(answers, &poses).iter().for_each(|q| add_full(&mut table, q));
    }
    table
}

fn add_full(table: &mut Table, quantity: &Quantity) {
    for part in quantity.parts() {
        let cells = part.cells.iter().map(|cell| match cell {
            Cell::Number(x) => significant(*x, FULL),
            Cell::Bool(truth) => truth.to_string(),
            Cell::None => String::new(),
        });
        table.column(with_unit(&part.name, &quantity.display.unit), cells);
    }
}

/// Reactions under the names by which a file asks for them.
fn reaction_quantities(answers: &Answers<'_>, poses: &[&Pose]) -> Vec<Quantity> {
    let mechanism = answers.model.mechanism;
    let entries: Vec<Option<Vec<ReactionEntry>>> =
        poses.iter().map(|p| Some(reactions(answers, p.outcome.as_ref().ok()?))).collect();
    let entries: Vec<_> = entries.into_iter().map(|e| e.filter(|e| !e.is_empty())).collect();
    let Some(pattern) = entries.iter().flatten().next() else { return Vec::new() };
    let mut quantities = Vec::new();
    for (i, entry) in pattern.iter().enumerate() {
        let (pair, on) = (&mechanism.pair(entry.pair).name, &mechanism.link(entry.on).name);
        let each = |value: &dyn Fn(&ReactionEntry) -> Option<Value>| {
            entries.iter().map(|e| e.as_ref().and_then(|e| value(&e[i]))).collect::<Vec<_>>()
        };
        quantities.push(Quantity {
            name: format!("reaction({pair}, {on})"),
            display: mechanism.display_of(Dimension::FORCE),
            values: each(&|e| e.is_known().then_some(Value::Vector(e.force))),
            missing: NONE,
        });
        let moments = each(&|e| e.moment.map(Value::Scalar));
        if moments.iter().any(Option::is_some) {
            quantities.push(Quantity {
                name: format!("moment({pair}, {on})"),
                display: mechanism.display_of(Dimension::TORQUE),
                values: moments,
                missing: NONE,
            });
        }
    }
    quantities
}

/// `crank = 45 deg, c1 = 2.25 m`
fn drives_in_words(answers: &Answers<'_>, pose: &Pose) -> String {
    let mechanism = answers.model.mechanism;
    let drives = mechanism.drives.iter().zip(&pose.drives);
    let words = drives.filter(|(_, value)| value.value().is_some()).map(|(drive, value)| {
        let unit = mechanism.drive_display(drive.target).unit;
        format!("{} = {} {unit}", drive.name, answers.drive_figures(drive.target, Some(value)))
    });
    words.collect::<Vec<_>>().join(", ")
}

/// Each names its pose itself.
fn failures(answers: &Answers<'_>) -> Vec<String> {
    let failed = answers.asked_for().filter_map(|pose| pose.outcome.as_ref().err());
    failed.map(|why| failure(&answers.model, why).to_string()).collect()
}
