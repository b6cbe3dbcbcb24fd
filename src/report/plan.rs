//! The steps of the plan in words.

use super::cost;
use super::document::{Report, Section, Table};
use super::mobility::{link_names, source_name};
use super::train::motion_in_words as train_in_words;
use assur_model::model::{LinkId, LoadKind, Unsupported};
use assur_model::structure::{Effort, EffortSource, Group, GroupKind};
use assur_position::plan::{ForceStep, LoadStep, MotionStep};
use assur_solve::measure::Costs;
use assur_solve::solve::Model;
use assur_text::diagnostic::place;
use assur_text::source::Source;

/// The steps at every position, with their cost if it was measured, and statements that are not supported yet.
pub(super) fn sections(source: &Source, model: &Model<'_>, costs: Option<&Costs>, report: &mut Report) {
    let mut table = Table::of_words(&["step", "what", "how"]);
    let mut step = |what: String, how: String| {
        let number = (table.rows.len() + 1).to_string();
        table.row(vec![number, what, how]);
    };
    for (group, motion) in model.structure.motion.iter().zip(&model.plan.motion) {
        let efforts = &model.structure.drives;
        step(format!("motion of {}", bodies(model, group)), motion_in_words(model, group, efforts, motion));
    }
    for load in &model.plan.loads {
        let (what, how) = load_in_words(model, load);
        step(what, how);
    }
    for (group, force) in model.structure.forces.iter().zip(&model.plan.forces) {
        let what = format!("reactions on {}", bodies(model, group));
        step(what, force_in_words(model, group, &model.structure.efforts, force));
    }
    let mut section = Section::new("Plan");
    if let Some(costs) = costs {
        cost::add_columns(costs, &mut table);
    }
    section.table(table);
    report.section(section);
    if let Some(costs) = costs {
        report.section(cost::section(model, costs));
    }
    let mut unsupported: Vec<&Unsupported> = model.mechanism.unsupported.iter().collect();
    unsupported.sort_by_key(|u| u.span);
    let line = |u: &&Unsupported| format!("{} (line {})", u.what, place(&source.text, u.span.start).line);
    let mut later = Section::new("Not yet supported");
    later.list(unsupported.iter().map(line).collect());
    report.section(later);
}

/// The links of a group; the imaginary ones of a higher pair by its name.
fn bodies(model: &Model<'_>, group: &Group) -> String {
    let names = link_names(model, group);
    if names.is_empty() {
        let all = group.bodies.iter().map(|&b| model.structure.replaced.body_name(model.mechanism, b));
        return all.collect::<Vec<_>>().join(", ");
    }
    names.join(", ")
}

fn motion_in_words(model: &Model<'_>, group: &Group, efforts: &[Effort], step: &MotionStep) -> String {
    let with: Vec<String> = group.efforts.iter().map(|&e| source_name(model, &efforts[e])).collect();
    match step {
        MotionStep::Turn { .. } | MotionStep::Shift { .. } | MotionStep::Free { .. } => {
            let free = |e: &usize| match efforts[*e].source {
                EffortSource::Drive(id) => model.mechanism.drives[id.index()].free,
                EffortSource::Balance(_) => false,
            };
            let how = if group.efforts.iter().any(free) { "a free coordinate" } else { "prescribed" };
            format!("{how} by {}", with.join(", "))
        }
        MotionStep::Triad { .. } => {
            "triad: all assemblies by a sextic, then followed with a certificate".to_owned()
        }
        MotionStep::Cam { cam, .. } => {
            let index = model.plan.cams.get(*cam).map_or(0, |c| c.contact.cam);
            let name = model.mechanism.cams.get(index).map_or("", |c| c.name.as_str());
            format!("the law of cam {name}")
        }
        MotionStep::CamTurned { cam, .. } => {
            let index = model.plan.cams.get(*cam).map_or(0, |c| c.contact.cam);
            let name = model.mechanism.cams.get(index).map_or("", |c| c.name.as_str());
            format!("the law of cam {name} backwards: the angle at the lift of the follower")
        }
        MotionStep::Geneva { .. } => "the law of a Geneva wheel".to_owned(),
        MotionStep::Train { train, .. } => train_in_words(model, &model.plan.trains[*train]),
        MotionStep::General { .. } => {
            format!("Newton's method, {} links at once", link_names(model, group).len())
        }
        _ => closed_form(group, &with),
    }
}

fn force_in_words(model: &Model<'_>, group: &Group, efforts: &[Effort], step: &ForceStep) -> String {
    let with: Vec<String> = group.efforts.iter().map(|&e| source_name(model, &efforts[e])).collect();
    match step {
        ForceStep::Turn { .. } | ForceStep::Shift { .. } => format!("equilibrium, with {}", with.join(", ")),
        ForceStep::Train { .. } => train_forces(model, group, &with),
        ForceStep::Triad(_) => THREE_LEGS.to_owned(),
        ForceStep::General { .. } if with.is_empty() => "all equations of equilibrium at once".to_owned(),
        ForceStep::General { .. } => {
            format!("all equations of equilibrium at once, with {}", with.join(", "))
        }
        ForceStep::Sequence(_) => {
            "solved together with the last group (coupled by friction in a shared hinge)".into()
        }
        ForceStep::Friction { plain, .. } if matches!(**plain, ForceStep::Sequence(_)) => {
            "all groups in turn, friction by Newton's method for all at once".to_owned()
        }
        ForceStep::Friction { plain, .. } => {
            format!("{}, friction by Newton's method", force_in_words(model, group, efforts, plain))
        }
        _ => closed_form(group, &with),
    }
}

const THREE_LEGS: &str = "closed form, triad: three equations";

/// `equilibrium, with k and balance M`: with the forces of transmissions and the efforts found there.
fn train_forces(model: &Model<'_>, group: &Group, with: &[String]) -> String {
    let mut found: Vec<String> = Vec::new();
    for law in &group.laws {
        let name = &model.mechanism.pair(model.structure.replaced.joint(*law).pair).name;
        if !found.contains(name) {
            found.push(name.clone());
        }
    }
    found.extend(with.iter().cloned());
    format!("equilibrium, with {}", found.join(", "))
}

/// `closed form, dyad RRR (drive c1)`: with a driven joint inside a link.
fn closed_form(group: &Group, with: &[String]) -> String {
    let inside = if with.is_empty() { String::new() } else { format!(" ({})", with.join(", ")) };
    match group.kind {
        GroupKind::Translation => "closed form, between two guides".to_owned(),
        _ => format!("closed form, dyad {}{inside}", group.kind_name()),
    }
}

fn load_in_words(model: &Model<'_>, step: &LoadStep) -> (String, String) {
    let mechanism = model.mechanism;
    match step {
        LoadStep::Mass { body, weight, inertia, .. } => {
            let weight = weight.norm() > 0.0;
            let what = match (weight, inertia) {
                (true, true) => "weight and inertia force",
                (true, false) => "weight",
                _ => "inertia force",
            };
            (format!("{what} of {}", mechanism.link(LinkId::at(*body)).name), "at its mass centre".to_owned())
        }
        LoadStep::Force { load, .. } => load_on(model, load.index(), "constant"),
        LoadStep::Torque { load, .. } => load_on(model, load.index(), "constant"),
        LoadStep::Evaluated(load) => load_on(model, load.index(), "evaluated at every pose"),
        LoadStep::Spring { spring, .. } => {
            (format!("spring {}", mechanism.springs[spring.index()].name), "from its length".to_owned())
        }
    }
}

fn load_on(model: &Model<'_>, index: usize, how: &str) -> (String, String) {
    let load = &model.mechanism.loads[index];
    let name = load.name.as_ref().map(|n| format!(" {n}")).unwrap_or_default();
    let what = match &load.kind {
        _ if load.pin.is_some() => {
            let pin = load.pin.map_or("", |pin| model.mechanism.pair(pin).name.as_str());
            format!("force{name} at {pin}")
        }
        LoadKind::Force { on, .. } | LoadKind::ForceAgainstMotion { on, .. } => {
            format!("force{name} on {}", model.mechanism.link(*on).name)
        }
        LoadKind::Torque { on, .. } => format!("torque{name} on {}", model.mechanism.link(*on).name),
        LoadKind::InPair { pair, against_motion: true, .. } => {
            format!("torque of {}", model.mechanism.pair(*pair).name)
        }
        LoadKind::InPair { pair, .. } => format!("effort{name} in {}", model.mechanism.pair(*pair).name),
    };
    (what, how.to_owned())
}
