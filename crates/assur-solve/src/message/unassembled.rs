//! Why the mechanism is not assembled, with what to write or change.

use super::clause::{clause, point_name};
use super::format::{label, labels, length, links, short};
use super::gap::gap_text;
use super::odd_point::odd_point;
use super::parallel::turn_the_face;
use crate::model::{HintKind, PairKind};
use crate::position::Model;
use crate::solve::{Clause, GroupGap, MOST_CLAUSES, NamedPoint};
use crate::source::{Edit, Span};
use assur_text::diagnostic::{Diagnosis, Fix};

/// A group does not close.
pub(super) fn does_not_close(model: &Model<'_>, group: usize, gap: &GroupGap, pose: String) -> Diagnosis {
    if let Some(error) = odd_point(model) {
        return error;
    }
    let labels = labels(model, &model.structure.motion[group], "does not close");
    let (gap, help) = gap_text(model, group, gap);
    Diagnosis::error("mech::assembly::does_not_close", format!("the mechanism does not close{pose}: {gap}"))
        .labels(labels)
        .help(help)
}

/// The search for an assembly of a general group found none.
pub(super) fn not_found(
    model: &Model<'_>,
    group: usize,
    (point, never_regular): (Option<NamedPoint>, bool),
    pose: String,
) -> Diagnosis {
    if let Some(error) = odd_point(model) {
        return error;
    }
    let group = &model.structure.motion[group];
    let help = match point {
        _ if never_regular => {
            "change a direction or a length: in every position of these links their pairs are dependent, as \
             with two parallel guides"
                .to_owned()
        }
        Some(point) => format!(
            "give the approximate position of a point, as in `assemble {} near (200 mm, 100 mm)`, or check the lengths",
            point_name(model, point)
        ),
        None => "check the lengths".to_owned(),
    };
    let labels = labels(model, group, "does not close");
    Diagnosis::error(
        "mech::assembly::not_found",
        format!("no assembly of {} was found{pose}", links(model, group)),
    )
    .labels(labels)
    .help(help)
}

/// Several assemblies remain: the groups in which they differ, with the lines that choose.
pub(super) fn ambiguous(
    model: &Model<'_>,
    count: usize,
    groups: &[(usize, Vec<Clause>)],
    pose: String,
) -> Diagnosis {
    if let Some(error) = odd_point(model) {
        return error;
    }
    let mut sections = Vec::new();
    let mut marks = Vec::new();
    let mut listed = None;
    for (group, clauses) in groups {
        marks.extend(labels(model, &model.structure.motion[*group], "has several assemblies"));
        let mut lines: Vec<String> = Vec::new();
        for line in clauses.iter().map(|c| clause(model, c)) {
            if !lines.contains(&line) {
                lines.push(line);
            }
        }
        if clauses.len() == MOST_CLAUSES && count > MOST_CLAUSES {
            listed = Some(lines.len());
        }
        // a choice between lines that are the same is none
        sections.extend((lines.len() > 1).then(|| section(lines.into_iter())));
    }
    let chosen = !model.mechanism.hints.is_empty();
    let write = if chosen { "add" } else { "write" };
    let help = if sections.is_empty() {
        "choose with `assemble`: name a point near which a link lies, as in `assemble rod.C near (1 m, 2 m)`"
            .to_owned()
    } else {
        format!("{write} one of{}", sections.join("\nand one of"))
    };
    let help = match listed {
        Some(listed) => format!(
            "{help}\nthese are {listed} of {count}: if yours is not among them, write where one of the points is, from a drawing"
        ),
        None => help,
    };
    let which = if chosen { "`assemble` does not choose between them" } else { "the file chooses none" };
    Diagnosis::error(
        "mech::assembly::ambiguous",
        format!("the mechanism has {count} assemblies{pose}, and {which}"),
    )
    .labels(marks)
    .help(help)
    .added()
}

/// No assembly fits a hint: what there is instead.
pub(super) fn not_met(
    model: &Model<'_>,
    (hint, group): (usize, usize),
    assemblies: &[(Clause, Option<f64>)],
    pose: String,
) -> Diagnosis {
    let hint = &model.mechanism.hints[hint];
    let line = |(chosen, coordinate): &(Clause, Option<f64>)| match (&hint.kind, coordinate) {
        (HintKind::Coordinate { pair, .. }, Some(value)) => {
            let pair = model.mechanism.pair(*pair);
            let value = match pair.kind {
                PairKind::Revolute(_) => format!("{} deg", short(value.to_degrees())),
                _ => length(model, *value),
            };
            format!("{}   // {} = {value}", clause(model, chosen), pair.name)
        }
        _ => clause(model, chosen),
    };
    let mut marks = vec![label("no assembly satisfies this", hint.span)];
    marks.extend(labels(model, &model.structure.motion[group], "this group"));
    // what lies nowhere is no assembly
    let lies = |(clause, _): &&(Clause, Option<f64>)| match clause {
        Clause::Near { place, .. } => place.norm().is_finite(),
        _ => true,
    };
    let lines: Vec<String> = assemblies.iter().filter(lies).map(line).collect();
    let count = lines.len();
    let lines = section(lines.into_iter());
    let help = match count {
        0 => turn_the_face(model, &model.structure.motion[group])
            .unwrap_or_else(|| "leave the clause out".to_owned()),
        1 => format!("write the only assembly{lines}"),
        _ => format!("write one of{lines}"),
    };
    Diagnosis::error("mech::assembly::hint_not_met", format!("no assembly{pose} satisfies `assemble`"))
        .labels(marks)
        .fixes(clauses(&help, hint.span))
        .help(help)
}

fn section(lines: impl Iterator<Item = String>) -> String {
    lines.map(|l| format!("\n  {l}")).collect()
}

/// The clauses that a help lists, each in place of one that is not met.
fn clauses(help: &str, at: Span) -> Vec<Fix> {
    let clause =
        |line: &str| Some(line.strip_prefix("  assemble ")?.split("  //").next()?.trim_end().to_owned());
    let fix = |clause: String| {
        let edits = vec![Edit::new(at, clause.as_str())];
        Fix { title: format!("write `assemble {clause}`"), edits, certain: false }
    };
    help.lines().filter_map(clause).map(fix).collect()
}
