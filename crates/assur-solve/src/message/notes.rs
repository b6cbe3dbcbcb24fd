//! The sentences about what deserves a warning or a note.

use super::consistent::several;
use super::format::{and_at, drive_text, four, label, labels, links, place, rounded, short, with_unit};
use super::friction::{locked, no_effort, no_sliding};
use super::over_sweep::needless_flywheel;
use super::partial_sweep::partial_sweep;
use super::simulate::never_ended;
use super::slip::slips;
use super::speeds::{no_damping, unit_speed};
use crate::model::{LinkId, PointRef, Query};
use crate::position::{DriveValue, Model, PoseRequest};
use crate::solve::{GroupId, Loss, Note, Pull, Uncertified, WholeCycleRange};
use crate::source::Span;
use crate::units::Dimension;
use assur_text::diagnostic::Diagnosis;

/// What deserves a warning or a note, in the same order.
pub fn notes(model: &Model<'_>, notes: &[Note]) -> impl Iterator<Item = Diagnosis> {
    notes.iter().filter_map(|one| note(model, one))
}

fn note(model: &Model<'_>, note: &Note) -> Option<Diagnosis> {
    let mechanism = model.mechanism;
    Some(match note {
        Note::Switched { group, at, from, to } => switched(model, *group, at, (from, to)),
        Note::Elsewhere { link, off, turned, drives, whole } => {
            elsewhere(model, *link, (*off, *turned), drives, *whole)
        }
        Note::NeverEnded { event, at } => never_ended(model, *event, *at),
        Note::SelfLocking { pose, more } => self_locking(model, (pose, *more)),
        Note::SeveralBalances { count, followed, pose, more } => {
            several(model, (*count, *followed), (pose, *more))
        }
        Note::RopePushes(pull) => {
            let (name, span, tension, pose, more) = parts(model, pull);
            Diagnosis::warning(
                "mech::train::rope_pushes",
                format!("rope `{name}` would have to push{pose}{more}: its pull is {tension}"),
            )
            .label(span, "slack")
            .help(
                "check the sense of the load, or add a counterweight: a rope only pulls, \
                 so it would be slack there",
            )
        }
        Note::Slips(pull) => return slips(model, pull),
        Note::ContactPulls(pull) => {
            let (name, span, normal, pose, more) = parts(model, pull);
            Diagnosis::warning(
                "mech::solve::contact_pulls",
                format!("contact `{name}` would have to transmit tension{pose}: normal force {normal}{more}"),
            )
            .label(span, "parts here")
            .help(
                "press the profiles together by a spring or a load, or guide a pin in a \
                 `slot`: they part here",
            )
        }
        Note::PartialSweep { closing, gaps, more } => return partial_sweep(model, *closing, gaps, *more),
        Note::IllConditioned { pose, group, condition, digits, loss } => {
            ill_conditioned(model, pose, *group, (*condition, *digits, *loss))
        }
        Note::NotCertified(worst) => not_certified(model, worst),
        Note::NeedlessFlywheel { flywheel, have, needed } => {
            needless_flywheel(model, *flywheel, *have, *needed)
        }
        Note::NoDamping { drive, springs, loads } => no_damping(mechanism, *drive, (springs, loads)),
        Note::UnitSpeed { drive, springs, loads } => unit_speed(mechanism, *drive, (springs, loads)),
        Note::NoSliding { pair, pose, more } => no_sliding(model, *pair, (pose, *more)),
        Note::Locked(locking) => locked(model, locking),
        Note::NoCentre { find, of, pose, more } => match *of {
            Query::CurvatureRadius(point) | Query::CurvatureCentre(point) => {
                no_curvature(model, *find, point, (pose, *more))
            }
            Query::Turning(link, other) => no_centre(model, *find, [link, other], (pose, *more)),
            _ => return None,
        },
        Note::NoEffort { finds, pose, more } => no_effort(model, finds, (pose, *more)),
    })
}

fn no_centre(
    model: &Model<'_>,
    find: usize,
    links: [LinkId; 2],
    (pose, more): (&PoseRequest, usize),
) -> Diagnosis {
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
    Diagnosis::warning(
        "mech::solve::no_centre",
        format!(
            "`{link}` does not turn against {}{}{}: its instant centre is at infinity",
            if links[1] == LinkId::GROUND { "the ground".to_owned() } else { format!("`{seen_from}`") },
            place(model, pose),
            and_at(more)
        ),
    )
    .label(mechanism.finds[find].span, "no value")
    .help(help)
}

fn no_curvature(
    model: &Model<'_>,
    find: usize,
    point: PointRef,
    (pose, more): (&PoseRequest, usize),
) -> Diagnosis {
    let (PointRef::Fixed(link, at) | PointRef::Under(link, (_, at))) = point;
    let link = model.mechanism.link(link);
    let name = link.points.iter().find(|p| p.at == at).map_or("", |p| p.name.as_str());
    let name = format!("`{}.{name}`", link.name);
    Diagnosis::warning(
        "mech::solve::no_curvature",
        format!("{name} is at rest or its path is straight{}{}", place(model, pose), and_at(more)),
    )
    .label(model.mechanism.finds[find].span, "no value")
    .help("choose a pose at which the point moves along a curve")
}

/// A change point is known to about 1e-8 rad.
const CHANGE_PER_DEGREE: f64 = 1e4;

fn switched(model: &Model<'_>, group: usize, at: &[DriveValue], (from, to): (&str, &str)) -> Diagnosis {
    let group = &model.structure.motion[group];
    Diagnosis::warning(
        "mech::assembly::branch_switch",
        format!(
            "{} change to their other assembly between poses {from} and {to}, at {}",
            links(model, group),
            drive_text(model, &rounded(model, at, CHANGE_PER_DEGREE))
        ),
    )
    .labels(labels(model, group, "this group"))
    .help(
        "check the motion after this change point, where both assemblies meet: \
         the links continue by their velocity, but a real machine may continue in \
         either assembly",
    )
}

fn elsewhere(
    model: &Model<'_>,
    link: LinkId,
    (off, turned): (f64, f64),
    drives: &[DriveValue],
    whole: Option<WholeCycleRange>,
) -> Diagnosis {
    let mechanism = model.mechanism;
    let moved = with_unit(model, off, Dimension::LENGTH);
    let labels = mechanism.drives.iter().map(|d| label("after whole turns of this drive", d.span));
    let whole = whole.map_or("; no whole cycle was found".to_owned(), |range| {
        let [from, to] = [range.from, range.to].map(|x| short(x.to_degrees()));
        format!(": for a whole one write `{from} deg .. {to} deg in {} steps`", range.steps)
    });
    Diagnosis::warning(
        "mech::solve::not_periodic",
        format!(
            "after whole turns of the drive the mechanism is not where it began: `{}` \
             is elsewhere by {moved} and {} deg",
            mechanism.link(link).name,
            four(turned.to_degrees())
        ),
    )
    .labels(labels)
    .help(format!(
        "the pose at {} is left out, and functions over the sweep take a part of the cycle{whole}",
        drive_text(model, drives)
    ))
}

fn self_locking(model: &Model<'_>, (pose, more): (&PoseRequest, usize)) -> Diagnosis {
    let lossy = model.plan.laws.iter().filter_map(|l| Some((model.mechanism.pair(l.pair), l.efficiency?)));
    let lossy: Vec<_> = lossy.collect();
    let labels = lossy.iter().map(|(p, _)| label("self-locking here", p.span));
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
    Diagnosis::warning(
        "mech::train::self_locking",
        format!(
            "the load cannot drive the mechanism{}{}: it is self-locking",
            place(model, pose),
            and_at(more)
        ),
    )
    .labels(labels)
    .help(help)
}

/// Name and span of a pair that pulls or pushes; its force, the position, how many others there are.
fn parts(model: &Model<'_>, pull: &Pull) -> (String, Span, String, String, String) {
    let pair = model.mechanism.pair(pull.pair);
    let force = with_unit(model, pull.least, Dimension::FORCE);
    (pair.name.clone(), pair.span, force, place(model, &pull.pose), and_at(pull.poses - 1))
}

fn ill_conditioned(
    model: &Model<'_>,
    pose: &PoseRequest,
    group: GroupId,
    (condition, digits, loss): (f64, u32, Loss),
) -> Diagnosis {
    let group = group.of(model.structure);
    Diagnosis::warning(
        "mech::solve::ill_conditioned",
        format!(
            "near a dead position{}: about {digits} digits are left in the {} of {}",
            place(model, pose),
            match loss {
                Loss::Velocities => "velocities",
                Loss::Accelerations => "accelerations",
                Loss::Forces => "forces",
                Loss::ForcesNearLocking => "forces near self-locking",
            },
            links(model, group)
        ),
    )
    .labels(labels(model, group, "near a dead position"))
    .help(format!(
        "condition figure σ = {condition:.1e}; the error of positions grows as \
         ε/σ, that of velocities and forces as ε/σ², that of accelerations as \
         ε/σ³, with ε = 2.2e-16"
    ))
}

fn not_certified(model: &Model<'_>, worst: &Uncertified) -> Diagnosis {
    let Uncertified { pose, group, h, sigma, poses } = worst;
    let group = &model.structure.motion[*group];
    Diagnosis::warning(
        "mech::solve::not_certified",
        format!(
            "the position of {} could not be verified{}{}",
            links(model, group),
            place(model, pose),
            and_at(poses - 1)
        ),
    )
    .labels(labels(model, group, "this group"))
    .help(format!(
        "choose a position next to it: the theorem of Newton and Kantorovich \
         needs h ≤ 0.5, but h = {h:.1e}, with the condition figure σ = \
         {sigma:.1e}; so near to a dead position rounding errors decide whether \
         there is one solution, two or none"
    ))
}
