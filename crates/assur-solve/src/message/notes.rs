//! The sentences about what deserves a warning or a note.

use super::consistent::several;
use super::error::SolveError;
use super::format::{and_at, drive_text, four, label, labels, links, place, rounded, with_unit};
use super::friction::{locked, no_effort, no_sliding};
use super::over_sweep::needless_flywheel;
use super::partial_sweep::partial_sweep;
use super::simulate::never_ended;
use super::slip::slips;
use super::speeds::{no_damping, unit_speed};
use super::train_error::TrainError;
use crate::model::LinkId;
use crate::position::{DriveValue, Model, Wanted};
use crate::solve::{GroupId, Loss, Note, Pull, Uncertified};
use crate::units::Dimension;

/// What deserves a warning or a note, in the same order.
pub fn notes(model: &Model<'_>, notes: &[Note]) -> impl Iterator<Item = SolveError> {
    notes.iter().filter_map(|one| note(model, one))
}

fn note(model: &Model<'_>, note: &Note) -> Option<SolveError> {
    let mechanism = model.mechanism;
    Some(match note {
        Note::Switched { group, at, from, to } => switched(model, *group, at, (from, to)),
        Note::Elsewhere { link, off, turned, drives } => elsewhere(model, *link, (*off, *turned), drives),
        Note::NeverEnded { event, time } => never_ended(model, *event, *time),
        Note::SelfLocking { pose, more } => self_locking(model, (pose, *more)),
        Note::SeveralBalances { count, followed, pose, more } => {
            several(model, (*count, *followed), (pose, *more))
        }
        Note::RopePushes(pull) => {
            let (name, span, tension, pose, more) = parts(model, pull);
            TrainError::RopePushes { name, pose, more, tension, span }.into()
        }
        Note::Slips(pull) => return slips(model, pull),
        Note::ContactPulls(pull) => {
            let (name, span, normal, pose, more) = parts(model, pull);
            SolveError::ContactPulls { name, pose, normal, more, span }
        }
        Note::PartialSweep { closing, gaps, more } => return partial_sweep(model, *closing, gaps, *more),
        Note::IllConditioned { pose, group, condition, digits, loss } => {
            ill_conditioned(model, pose, *group, (*condition, *digits, *loss))
        }
        Note::NotCertified(worst) => not_certified(model, worst),
        Note::NeedlessFlywheel { flywheel, have, needed } => {
            needless_flywheel(model, *flywheel, *have, *needed)
        }
        Note::NoDamping { drive, springs } => no_damping(mechanism, *drive, springs),
        Note::UnitSpeed { drive, springs, loads } => unit_speed(mechanism, *drive, (springs, loads)),
        Note::NoSliding { pair, pose, more } => no_sliding(model, *pair, (pose, *more)),
        Note::Locked(locking) => locked(model, locking),
        Note::NoCentre { find, links, pose, more } => no_centre(model, *find, *links, (pose, *more)),
        Note::NoEffort { finds, pose, more } => no_effort(model, finds, (pose, *more)),
    })
}

fn no_centre(
    model: &Model<'_>,
    find: usize,
    links: [LinkId; 2],
    (pose, more): (&Wanted, usize),
) -> SolveError {
    let mechanism = model.mechanism;
    let [link, seen_from] = links.map(|link| mechanism.link(link).name.as_str());
    let point = mechanism.link(links[0]).points.first().filter(|_| links[1] == LinkId::GROUND);
    let help = match point {
        Some(point) => format!(
            "ask for a velocity, as in `velocity({link}.{})`: all points of `{link}` have the same",
            point.name
        ),
        None => format!("choose a pose at which `{link}` turns against it, or ask for `omega({link})`"),
    };
    SolveError::NoCentre {
        link: link.to_owned(),
        seen_from: if links[1] == LinkId::GROUND {
            "the ground".to_owned()
        } else {
            format!("`{seen_from}`")
        },
        pose: place(model, pose),
        more: and_at(more),
        help,
        span: mechanism.finds[find].span.into(),
    }
}

fn switched(model: &Model<'_>, group: usize, at: &[DriveValue], (from, to): (&str, &str)) -> SolveError {
    let group = &model.structure.motion[group];
    SolveError::BranchSwitch {
        links: links(model, group),
        from: from.to_owned(),
        to: to.to_owned(),
        near: drive_text(model, &rounded(model, at, 1.0)),
        labels: labels(model, group, "this group"),
    }
}

fn elsewhere(
    model: &Model<'_>,
    link: LinkId,
    (off, turned): (f64, f64),
    drives: &[DriveValue],
) -> SolveError {
    let mechanism = model.mechanism;
    let moved = with_unit(model, off, Dimension::LENGTH);
    let labels = mechanism.drives.iter().map(|d| label("after whole turns of this drive", d.span));
    SolveError::Elsewhere {
        link: mechanism.link(link).name.clone(),
        by: format!("{moved} and {} deg", four(turned.to_degrees())),
        at: drive_text(model, drives),
        labels: labels.collect(),
    }
}

fn self_locking(model: &Model<'_>, (pose, more): (&Wanted, usize)) -> SolveError {
    let lossy = model.plan.laws.iter().filter_map(|l| Some((model.mechanism.pair(l.pair), l.efficiency?)));
    let lossy: Vec<_> = lossy.collect();
    let labels = lossy.iter().map(|(p, _)| label("self-locking here", p.span)).collect();
    let back = lossy.iter().map(|(p, [there, back])| {
        if there == back {
            format!("`{}` has an efficiency of {}", p.name, four(*back))
        } else {
            // that of a thread with friction follows from its angles
            let formula = if *back == 2.0 - 1.0 / *there {
                format!("2 − 1/{} = ", four(*there))
            } else {
                String::new()
            };
            format!("driven backwards `{}` has an efficiency of {formula}{}", p.name, four(*back))
        }
    });
    let back = back.collect::<Vec<_>>().join(", ");
    let help = format!(
        "raise the efficiency, or let the unknown effort drive in this sense too: {back}; below 0 it is self-locking"
    );
    TrainError::SelfLocking { pose: place(model, pose), more: and_at(more), help, labels }.into()
}

/// Name and span of a pair that pulls or pushes; its force, the position, how many others there are.
fn parts(model: &Model<'_>, pull: &Pull) -> (String, miette::SourceSpan, String, String, String) {
    let pair = model.mechanism.pair(pull.pair);
    let force = with_unit(model, pull.least, Dimension::FORCE);
    (pair.name.clone(), pair.span.into(), force, place(model, &pull.pose), and_at(pull.poses - 1))
}

fn ill_conditioned(
    model: &Model<'_>,
    pose: &Wanted,
    group: GroupId,
    (condition, digits, loss): (f64, u32, Loss),
) -> SolveError {
    let group = group.of(model.structure);
    SolveError::IllConditioned {
        pose: place(model, pose),
        links: links(model, group),
        condition,
        digits,
        what: match loss {
            Loss::Velocities => "velocities",
            Loss::Accelerations => "accelerations",
            Loss::Forces => "forces",
            Loss::ForcesNearLocking => "forces near self-locking",
        },
        labels: labels(model, group, "near a dead position"),
    }
}

fn not_certified(model: &Model<'_>, worst: &Uncertified) -> SolveError {
    let Uncertified { pose, group, h, sigma, poses } = worst;
    let group = &model.structure.motion[*group];
    SolveError::NotCertified {
        pose: place(model, pose),
        links: links(model, group),
        figure: format!("{h:.1e}, with the condition figure σ = {sigma:.1e}"),
        more: and_at(poses - 1),
        labels: labels(model, group, "this group"),
    }
}
