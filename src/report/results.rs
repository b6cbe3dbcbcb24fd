//! The answers: quantities asked for, at every pose.

use super::answers::{Answers, NONE, with_unit};
use super::columns::{Cell, Quantity};
use super::document::{Align, Column, Report, Section, Table};
use super::rows::AnswerColumns;
use super::simulation;
use super::symbols::Symbols;
use assur_model::model::{Display, Value};
use assur_solve::message::failure;
use assur_solve::solve::{MotionScales, Pose};

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

/// All digits of every number, one row per pose: drives, and what is asked for in the order of the file. What needs no pose stands in
/// every row; a pose without solution has empty cells.
pub(super) fn full_table(answers: &Answers<'_>) -> Table {
    let columns = AnswerColumns::of_file(&answers.model);
    let events = columns.names_events();
    let mut table = Table::new(vec![Column::words(answers.pose_header())], 1);
    table.columns.extend(events.then(|| Column::words("event")));
    table.columns.extend(columns.headers(false).into_iter().map(Column::numbers));
    let whole = columns.whole(answers);
    let poses = answers.poses().map(Some).collect::<Vec<_>>();
    // the one row of a file without poses
    let without = [None];
    for pose in if poses.is_empty() && !whole.is_empty() { &without[..] } else { &poses } {
        let mut row = vec![pose.map_or_else(String::new, |pose| pose.name.clone())];
        row.extend(
            events.then(|| pose.map_or_else(String::new, |pose| simulation::events_at(answers, pose))),
        );
        columns.each_value(false, answers, (*pose, &whole), |answer, value| row.extend(answer.cells(value)));
        table.row(row);
    }
    table
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
