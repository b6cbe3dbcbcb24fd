//! The cost of the plan per position: by step, by effect, and the effects that are not asked for.

use super::answers::{Answers, NONE};
use super::document::{Block, Column, Section, Table};
use super::simulation::taken;
use assur_model::structure::{BodyOrigin, Group};
use assur_position::plan::{ForceStep, MotionStep, Precision};
use assur_solve::measure::{
    Costs, DigitLess, MotionCost, Over, run_with_a_digit_less, samples_with_a_digit_less,
};
use assur_solve::solve::Model;
use assur_text::units::significant;

/// Adds time and share to the rows of the steps: motion, loads, forces.
pub(super) fn add_columns(costs: &Costs, table: &mut Table) {
    let steps = || costs.motion.iter().chain(&costs.loads).chain(&costs.forces);
    table.columns.push(times());
    table.columns.push(Column::right("share"));
    // the table is not broken
    table.keys = table.columns.len();
    for (row, &time) in table.rows.iter_mut().zip(steps()) {
        row.extend([nanoseconds(time), share(time, costs.total)]);
    }
}

/// The effects with their times; the part of contacts and transmissions; effects that are not asked for.
pub(super) fn section(model: &Model<'_>, costs: &Costs) -> Section {
    let mut section = Section::new("Cost per position");
    let columns = vec![Column::words("effect"), times(), Column::right("share")];
    let mut table = Table::new(columns, 3);
    for (name, time) in &costs.effects {
        table.row(vec![(*name).to_owned(), nanoseconds(*time), share(*time, costs.total)]);
    }
    table.row(vec!["the plan".to_owned(), nanoseconds(costs.total), share(costs.total, costs.total)]);
    section.table(table);
    let mut facts: Vec<(String, String)> = Vec::new();
    let contacts = |group: &Group| {
        let bodies = &model.structure.replaced.bodies;
        group.bodies.iter().any(|b| matches!(bodies[b.0].origin, BodyOrigin::Imaginary(_)))
    };
    let parts = [
        ("contacts", of_groups(model, costs, contacts)),
        ("transmissions", of_groups(model, costs, |group| !group.laws.is_empty())),
    ];
    for (name, part) in parts {
        if let Some(time) = part {
            let text = format!("{} ns, {} of the plan", nanoseconds(time), share(time, costs.total));
            facts.push((name.to_owned(), text));
        }
    }
    for (name, time) in &costs.beside {
        facts.push(((*name).to_owned(), format!("{} ns in addition to the plan", nanoseconds(*time))));
    }
    if let Some(MotionCost { report, time, watched }) = &costs.motion_under_loads {
        let text = format!(
            "{:.1} ms by {}: {} steps, {} evaluations in all runs",
            time * 1e3,
            taken(model.mechanism, report),
            report.steps,
            report.evaluations
        );
        facts.push(("the motion".to_owned(), text));
        if let Some(part) = watched {
            facts.push(("events and functions".to_owned(), format!("{} of a run", share(*part, 1.0))));
        }
    }
    let idle = model.plan.effects.not_asked_for(model.mechanism);
    if !idle.is_empty() {
        facts.push(("not asked for".to_owned(), idle.join(", ")));
    }
    facts.push(("measured".to_owned(), measured(model, costs)));
    section.blocks.push(Block::Facts(facts));
    section
}

/// The cost of the steps of some groups together; `None` if there are no such groups.
fn of_groups(model: &Model<'_>, costs: &Costs, wanted: impl Fn(&Group) -> bool) -> Option<f64> {
    let motion = model.structure.motion.iter().zip(&costs.motion);
    let forces = model.structure.forces.iter().zip(&costs.forces);
    let times: Vec<f64> = motion.chain(forces).filter(|(group, _)| wanted(group)).map(|(_, t)| *t).collect();
    (!times.is_empty()).then(|| times.iter().sum())
}

fn measured(model: &Model<'_>, costs: &Costs) -> String {
    let places = costs.places;
    match (costs.over, model.mechanism.drives.as_slice()) {
        (Over::Turn, [drive]) => {
            format!("best of repeated runs at {places} positions over one turn of {}", drive.name)
        }
        _ if places == 1 => "best of repeated runs at the file's position".to_owned(),
        _ => format!("best of repeated runs at {places} of the file's positions"),
    }
}

fn times() -> Column {
    Column::numbers("time [ns]")
}

fn nanoseconds(time: f64) -> String {
    format!("{:.1}", time * 1e9)
}

fn share(time: f64, total: f64) -> String {
    if total > 0.0 { format!("{:.0} %", 100.0 * time / total) } else { "0 %".to_owned() }
}

// Times, errors and shares in words.

/// Units of time with the microseconds in each, from the smallest on.
pub(super) const UNITS: [(&str, f64); 4] = [("ns", 1e-3), ("µs", 1.0), ("ms", 1e3), ("s", 1e6)];

/// The greatest unit of which a time has at least one.
pub(super) fn unit(micros: f64) -> (&'static str, f64) {
    UNITS.into_iter().rfind(|(_, size)| micros >= *size).unwrap_or(UNITS[0])
}

/// A time in a unit that fits: `2.3 ms`.
pub(super) fn time(micros: f64) -> String {
    // what rounds to a thousand has one of the next unit
    let (name, size) = unit(micros * 1.005);
    let amount = micros / size;
    if amount < 9.95 { format!("{amount:.1} {name}") } else { format!("{amount:.0} {name}") }
}

/// An error in one figure.
pub(super) fn size(error: f64) -> String {
    match error {
        0.0 => "0".to_owned(),
        error if error.is_finite() => format!("{error:.0e}"),
        _ => NONE.to_owned(),
    }
}

/// The digits that an error leaves.
pub(super) fn digits(error: f64) -> String {
    if error.is_finite() { format!("{:.1}", -libm::log10(error.max(1e-40))) } else { NONE.to_owned() }
}

/// A count with its thousands apart.
pub(super) fn count(count: usize) -> String {
    let figures = count.to_string();
    let mut out = String::new();
    for (i, figure) in figures.chars().enumerate() {
        out.push_str(if i > 0 && (figures.len() - i).is_multiple_of(3) { "," } else { "" });
        out.push(figure);
    }
    out
}

/// How much more or less something is: `+9 %`, `−35 %`; in times from twice on.
pub(super) fn change(ratio: f64) -> String {
    let percent = (100.0 * (ratio - 1.0)).round();
    if !percent.is_finite() {
        return NONE.to_owned();
    }
    match percent {
        100.0.. => format!("{} times", significant(ratio, 2)),
        0.0.. => format!("+{percent} %"),
        _ => format!("−{} %", -percent),
    }
}

/// A part of something or a multiple of it, before `of …`: `33 %`, `2.1 times`.
pub(super) fn part(ratio: f64) -> String {
    if ratio < 1.995 {
        format!("{} %", significant(100.0 * ratio, 2))
    } else {
        format!("{} times", significant(ratio, 2))
    }
}

// What the accuracy of the answers took, and what a digit less would save, in one line.

/// The line; nothing where nothing was computed.
pub(super) fn line(answers: &Answers<'_>) -> Option<String> {
    let (model, solution) = (&answers.model, answers.solution);
    if solution.simulation.is_some() {
        let found = run_with_a_digit_less(model, solution)?;
        let less = format!("within {}", size(10.0 * found.within));
        return Some(format!(
            "an error of {} took {}",
            size(found.within),
            compared(&found, "evaluations", &less)
        ));
    }
    if let Some(found) = samples_with_a_digit_less(model, solution) {
        return Some(format!(
            "functions over the sweep took {}",
            compared(&found, "samples", "a digit less")
        ));
    }
    let poses = answers.poses().count();
    let plan = model.plan;
    let iterated =
        plan.motion.iter().any(|s| matches!(s, MotionStep::General { .. } | MotionStep::Triad { .. }))
            || plan.forces.iter().any(|s| matches!(s, ForceStep::Friction { .. }));
    let numbers = match plan.settings.scalar {
        Precision::F64 => "f64",
        Precision::DoubleDouble => "double-double",
    };
    let saves =
        if iterated { "the last steps of its iterations at most" } else { "nothing: nothing is iterated" };
    (poses > 0).then(|| format!("{} in {numbers}; a digit less would save {saves}", positions(poses)))
}

fn positions(count: usize) -> String {
    format!("{} position{}", self::count(count), if count == 1 { "" } else { "s" })
}

/// Counts of both, and what the smaller one saves.
fn compared(found: &DigitLess, what: &str, less: &str) -> String {
    let took = format!("{} {what}", count(found.took));
    match found.less {
        Some(fewer) if fewer < found.took => {
            let saved = 100.0 * (found.took - fewer) as f64 / found.took as f64;
            format!("{took}; {less} would take {}, {saved:.0} % less", count(fewer))
        }
        Some(_) => format!("{took}; {less} would save nothing"),
        None => took,
    }
}
