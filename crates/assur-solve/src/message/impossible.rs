//! Positions at which there is no motion, or no force, or no number.

use super::format::{body, dead_position, label, labels, links};
use super::parallel::{turn_some_face, turn_the_face};
use crate::answer::LeftCurve;
use crate::position::Model;
use crate::solve::{GroupId, Lost};
use crate::structure::{EffortKind, EffortSource};
use assur_text::diagnostic::Diagnosis;
use miette::LabeledSpan;

/// A group whose determinant vanishes.
pub(super) fn dead(model: &Model<'_>, group: GroupId, condition: f64, pose: String) -> Diagnosis {
    let group = group.of(model.structure);
    let help = turn_the_face(model, group).unwrap_or_else(|| {
        format!(
            "choose a position next to it, or drive {} itself: in a dead position the drives determine neither \
             velocities nor forces",
            one_of(&links(model, group))
        )
    });
    Diagnosis::error(
        "mech::solve::dead_position",
        format!("dead position{pose}: {}", dead_position(model, group, condition)),
    )
    .labels(labels(model, group, "dead"))
    .help(help)
}

fn one_of(links: &str) -> String {
    if links.contains(" and ") { format!("one of {links}") } else { links.to_owned() }
}

/// A group of forces with unknown efforts whose determinant vanishes.
pub(super) fn cannot_hold(model: &Model<'_>, group: usize, condition: f64, pose: String) -> Diagnosis {
    let group = &model.structure.forces[group];
    let links = links(model, group);
    let mut marks = Vec::new();
    let mut line = false;
    for &effort in &group.efforts {
        let effort = &model.structure.efforts[effort];
        line |= matches!(effort.kind, EffortKind::Line(_));
        let span = match effort.source {
            EffortSource::Balance(id) => model.mechanism.balances[id.index()].span,
            EffortSource::Drive(id) => model.mechanism.drives[id.index()].span,
        };
        marks.push(label("cannot hold them here", span));
    }
    let prismatic = group.joints.first().is_some_and(|j| j.prismatic);
    let (why, help) = match (group.joints.len(), line, prismatic) {
        (1, true, true) => (
            format!("the unknown force is perpendicular to the guide of {links} and cannot hold it"),
            "turn the force towards the guide",
        ),
        (1, true, false) => (
            format!("the unknown force passes through the hinge of {links} and cannot hold it"),
            "turn the force away from the hinge, or move its point",
        ),
        _ => (
            format!("the unknown effort cannot hold {links} in this position"),
            "choose another point or direction for the effort, or another position",
        ),
    };
    let sigma =
        if condition > 0.0 { format!(" (condition figure σ = {condition:.1e})") } else { String::new() };
    marks.extend(labels(model, group, "held by this"));
    Diagnosis::error(
        "mech::solve::effort_cannot_hold",
        format!("the forces cannot be found{pose}: {}", why + &sigma),
    )
    .labels(marks)
    .help(help.to_owned())
}

/// A result of which no digit is left.
pub(super) fn not_finite(model: &Model<'_>, lost: Lost, pose: String) -> Diagnosis {
    let what = match lost {
        Lost::Position(id) => format!("the position of {}", body(model, id)),
        Lost::Velocity(id) => format!("the velocity of {}", body(model, id)),
        Lost::Acceleration(id) => format!("the acceleration of {}", body(model, id)),
        Lost::Reaction(pair) => format!("the reaction in `{}`", model.mechanism.pair(pair).name),
        Lost::Effort => "an unknown effort".to_owned(),
        Lost::Closure => "the position of the links".to_owned(),
        Lost::Equilibrium => "the balance of forces".to_owned(),
    };
    Diagnosis::error(
        "mech::solve::not_finite",
        format!("{what}{pose} cannot be computed: the numbers are too large"),
    )
    .labels(at_drives(model, "at this position"))
    .help(
        turn_some_face(model).unwrap_or_else(|| {
            "check units and powers of ten of lengths, speeds, masses and loads".to_owned()
        }),
    )
}

/// A spring of length zero.
pub(super) fn spring_at_zero(model: &Model<'_>, spring: usize, pose: &str) -> Diagnosis {
    let spring = &model.mechanism.springs[spring];
    Diagnosis::error(
        "mech::solve::spring_at_zero",
        format!("the force of spring `{}` has no direction{pose}: both its ends are at one place", spring.name),
    )
    .label(spring.span, "of length zero")
    .help(
        "its force turns round where its length passes zero: let the ends pass each other at a distance, end before \
         it, or write `free_length 0 mm` where it pulls at every length",
    )
}

/// The way to a position is too long to be followed.
pub(super) fn too_far(model: &Model<'_>, pose: String) -> Diagnosis {
    Diagnosis::error("mech::solve::way_too_long", format!("the step to this position is too large{pose}"))
        .labels(at_drives(model, "driven that far"))
        .help(
            "ask for positions in between: the motion is followed in steps of two \
             degrees, at most 2 million of them (11,111 turns) from one position to \
             the next",
        )
}

fn at_drives(model: &Model<'_>, text: &str) -> Vec<LabeledSpan> {
    model.mechanism.drives.iter().map(|d| label(text, d.span)).collect()
}

/// A curve is asked for a value beyond its table.
pub(super) fn curve_left(left: &LeftCurve, pose: String) -> Diagnosis {
    let curve = &left.curve;
    {
        let extent = curve.extent();
        Diagnosis::error(
            "mech::curve::outside",
            format!(
                "curve `{}` has no value at {}{pose}: its table goes from {extent}",
                curve.name,
                curve.shown(left.argument)
            ),
        )
        .label(curve.span, &extent)
        .help(
            "add rows, or write `periodic` after its name if it begins again, or \
             `held` if its end values hold beyond the table",
        )
    }
}
