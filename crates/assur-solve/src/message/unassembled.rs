//! Why the mechanism is not assembled, with what to write or change.

use super::clause::{clause, point_name};
use super::error::SolveError;
use super::format::{label, labels, length, links, short};
use super::gap::gap_text;
use crate::model::{HintKind, PairKind};
use crate::position::Model;
use crate::solve::{Clause, GroupGap, NamedPoint};

/// A group does not close.
pub(super) fn does_not_close(model: &Model<'_>, group: usize, gap: &GroupGap, pose: String) -> SolveError {
    let labels = labels(model, &model.structure.motion[group], "does not close");
    let (gap, help) = gap_text(model, group, gap);
    SolveError::DoesNotClose { pose, gap, help, labels }
}

/// The search for an assembly of a general group found none.
pub(super) fn not_found(
    model: &Model<'_>,
    group: usize,
    (point, never_regular): (Option<NamedPoint>, bool),
    pose: String,
) -> SolveError {
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
    SolveError::NotFound { pose, links: links(model, group), help, labels }
}

/// Several assemblies remain: the groups in which they differ, with the lines that choose.
pub(super) fn ambiguous(
    model: &Model<'_>,
    count: usize,
    groups: &[(usize, Vec<Clause>)],
    pose: String,
) -> SolveError {
    let mut sections = Vec::new();
    let mut marks = Vec::new();
    for (group, clauses) in groups {
        marks.extend(labels(model, &model.structure.motion[*group], "has several assemblies"));
        let mut lines: Vec<String> = Vec::new();
        for line in clauses.iter().map(|c| clause(model, c)) {
            if !lines.contains(&line) {
                lines.push(line);
            }
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
    let which = if chosen { "`assemble` does not choose between them" } else { "the file chooses none" };
    SolveError::Ambiguous { count, pose, which, help, labels: marks }
}

/// No assembly fits a hint: what there is instead.
pub(super) fn not_met(
    model: &Model<'_>,
    (hint, group): (usize, usize),
    assemblies: &[(Clause, Option<f64>)],
    pose: String,
) -> SolveError {
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
    let lines = section(assemblies.iter().map(line));
    let help = match assemblies.len() {
        0 => "leave the clause out".to_owned(),
        1 => format!("write the only assembly{lines}"),
        _ => format!("write one of{lines}"),
    };
    SolveError::HintNotMet { pose, help, labels: marks }
}

fn section(lines: impl Iterator<Item = String>) -> String {
    lines.map(|l| format!("\n  {l}")).collect()
}
