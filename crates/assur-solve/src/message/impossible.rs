//! Positions at which there is no motion, or no force, or no number.

use super::error::{SolveError, label};
use super::format::{body, labels, links, place, stands};
use crate::position::{Model, State, Wanted};
use crate::structure::{BodyId, EffortKind, EffortSource, Group};

/// A group whose determinant vanishes.
pub(crate) fn dead(model: &Model<'_>, group: &Group, condition: f64, pose: &Wanted) -> SolveError {
    SolveError::DeadPosition {
        pose: place(model, pose),
        stands: stands(model, group, condition),
        help: format!(
            "where a group is dead no velocity and no force follows from the drives: choose a position beside it, or \
             drive {} itself",
            one_of(&links(model, group))
        ),
        labels: labels(model, group, "dead"),
    }
}

fn one_of(links: &str) -> String {
    if links.contains(" and ") { format!("one of {links}") } else { links.to_owned() }
}

/// A group of forces whose determinant vanishes.
pub(crate) fn cannot_hold(model: &Model<'_>, group: &Group, condition: f64, pose: &Wanted) -> SolveError {
    if group.efforts.is_empty() {
        return dead(model, group, condition, pose);
    }
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
            format!("the unknown force stands across the guide of {links} and cannot hold it"),
            "turn the force towards the guide",
        ),
        (1, true, false) => (
            format!("the unknown force passes through the hinge of {links} and cannot hold it"),
            "turn the force away from the hinge, or move its place",
        ),
        _ => (
            format!("the unknown effort cannot hold {links} as they stand"),
            "choose another place or direction for the effort, or another position",
        ),
    };
    let sigma =
        if condition > 0.0 { format!(" (condition figure σ = {condition:.1e})") } else { String::new() };
    marks.extend(labels(model, group, "held by this"));
    SolveError::EffortCannotHold {
        pose: place(model, pose),
        why: why + &sigma,
        help: help.to_owned(),
        labels: marks,
    }
}

/// The first result that is no number.
pub(crate) fn not_finite(model: &Model<'_>, state: &State, pose: &Wanted) -> Option<SolveError> {
    let body = |i: usize| body(model, BodyId(i));
    let pairs = model.plan.reactions.iter().zip(&state.forces.reactions);
    let bodies = || state.motion.bodies.iter().enumerate();
    let what = bodies()
        .find(|(_, b)| !(b.p.x + b.p.y + b.u.x + b.u.y).is_finite())
        .map(|(i, _)| format!("the position of {}", body(i)))
        .or_else(|| {
            let found = bodies().find(|(_, b)| !(b.v.x + b.v.y + b.omega).is_finite());
            found.map(|(i, _)| format!("the velocity of {}", body(i)))
        })
        .or_else(|| {
            let found = bodies().find(|(_, b)| !(b.a.x + b.a.y + b.alpha).is_finite());
            found.map(|(i, _)| format!("the acceleration of {}", body(i)))
        })
        .or_else(|| {
            let found = pairs.clone().find(|(_, r)| !(r.force.x + r.force.y + r.couple).is_finite());
            found.map(|(joint, _)| {
                let pair = model.structure.replaced.joint(joint.joint).pair;
                format!("the reaction in `{}`", model.mechanism.pair(pair).name)
            })
        })
        .or_else(|| {
            state.forces.efforts.iter().find(|e| !e.is_finite()).map(|_| "an unknown effort".to_owned())
        })?;
    let labels = model.mechanism.drives.iter().map(|d| label("at this position", d.span)).collect();
    Some(SolveError::NotFinite { pose: place(model, pose), what, labels })
}
