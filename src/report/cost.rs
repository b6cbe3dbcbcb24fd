//! The cost of the plan per position: by step, by effect, and the effects that are not asked for.

use super::document::{Block, Column, Section, Table};
use super::simulation::taken;
use assur_model::structure::{BodyOrigin, Group};
use assur_solve::measure::{Costs, MotionCost, Over};
use assur_solve::solve::Model;

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
