//! Links that no pair joins, and islands of links that no pair joins to the ground.

use super::add_pair::missing_pairs;
use super::defect::Defect;
use super::diagnose::{or_weld, pairs_to_add};
use super::incidence::Incidence;
use super::islands::floating_islands;
use super::joint::{Body, BodyId};
use super::roller::{MOST_LABELS, label, listed, names};
use super::trial::Trial;
use super::words::{links, pairs_of};
use crate::model::{DriveTarget, Link, LinkId, Mechanism, PairId};
use crate::source::Span;
use assur_text::diagnostic::Diagnosis;

/// Islands for which pairs are tried.
const MOST_TRIED: usize = 5;
/// What to report of every island.
pub(super) fn floating(trial: Trial<'_>) -> Vec<Diagnosis> {
    let islands = floating_islands(trial.mechanism);
    let defect =
        (!islands.is_empty()).then(|| Incidence::new(trial.replaced, trial.efforts).defect(trial.replaced));
    let Some(defect) = defect.flatten() else { return Vec::new() };
    let described = islands.iter().enumerate();
    described.map(|(i, links)| describe(trial, (i < MOST_TRIED).then_some(&defect), links)).collect()
}

/// A link that is driven at a point and that no pair joins to the loose ones: it moves nothing.
pub(super) fn moves_nothing(trial: Trial<'_>, defect: &Defect) -> Option<Diagnosis> {
    let joined = |link: LinkId| trial.mechanism.pairs.iter().any(|pair| pair.kind.links().contains(&link));
    let alone = trial.mechanism.drives.iter().find_map(|drive| match drive.target {
        DriveTarget::Point(link, _) if !joined(link) => Some(link),
        _ => None,
    });
    alone.map(|link| {
        let diagnosis = describe(trial, Some(defect), &[link]);
        match by_name(trial.mechanism, link) {
            Some(line) => diagnosis.help(format!("a pair may be missing; add the line\n  {line}")).added(),
            None => diagnosis,
        }
    })
}

/// A hinge at a point whose name another link has too.
fn by_name(mechanism: &Mechanism, alone: LinkId) -> Option<String> {
    let own = mechanism.link(alone);
    let others = mechanism.links.iter().skip(1).filter(|other| other.name != own.name);
    let shared = |other: &Link| {
        let point = own.points.iter().find(|point| other.points.iter().any(|p| p.name == point.name))?;
        Some(format!("revolute {}: {} - {}", point.name, other.name, own.name))
    };
    others.into_iter().find_map(shared)
}

fn describe(trial: Trial<'_>, defect: Option<&Defect>, links: &[LinkId]) -> Diagnosis {
    let mechanism = trial.mechanism;
    let help = help(trial, defect, links);
    if let [one] = links {
        let link = mechanism.link(*one);
        return Diagnosis::error(
            "mech::determinacy::floating_link",
            format!("link `{}` is not joined to any other link", link.name),
        )
        .label(link.span, "no pair names this link")
        .help(help)
        .added();
    }
    let places = links.iter().map(|l| mechanism.link(*l).span).filter(|s| *s != Span::default());
    let labels = places.take(MOST_LABELS).map(|s| label("not joined to the ground", s));
    Diagnosis::error(
        "mech::determinacy::not_grounded",
        format!(
            "{} are joined to each other, but not to the ground",
            names(mechanism, links.iter().copied())
        ),
    )
    .labels(labels)
    .help(help)
}

/// Pairs that would join the island, and what they leave to be driven.
fn help(trial: Trial<'_>, defect: Option<&Defect>, links: &[LinkId]) -> String {
    let it = if links.len() == 1 { "it" } else { "them" };
    let bodies: Vec<BodyId> = links.iter().map(|l| trial.replaced.body_of(*l)).collect();
    let missing = defect.and_then(|defect| Some((defect, missing_pairs(trial, defect, &bodies)?)));
    if let Some((defect, missing)) = missing {
        let weld = or_weld(trial, defect, &bodies);
        return format!("{}{weld}\nor remove {it}", pairs_to_add(trial, missing, &bodies));
    }
    let mechanism = trial.mechanism;
    let named = links.iter().find_map(|l| Some((mechanism.link(*l), mechanism.link(*l).points.last()?)));
    let (link, point) = named.map_or(("LINK", "P"), |(l, p)| (l.name.as_str(), p.name.as_str()));
    let free = match mechanism.simulation {
        Some(_) => format!(
            "or let it move freely: add `start {link}.{point} = (0 m, 0 m)` and `start {link} = 0 deg`; "
        ),
        None => String::new(),
    };
    format!(
        "give the ground a point `{point}` too and add `revolute {point}: ground - {link}`, with a drive or a second pair \
         for the remaining freedoms; {free}or remove {it}"
    )
}

// Links that no drive moves, in a mechanism that is driven.

/// Links that pairs hold to the ground whatever the drives do. A mechanism without a drive is a structure: there all of them
/// are meant to be held.
pub(super) fn immobile(trial: Trial<'_>, driven: &Incidence) -> Option<Diagnosis> {
    let replaced = trial.replaced;
    // an outer link is known, and moves
    let is_outer = |(i, b): (usize, &Body)| {
        b.known && BodyId(i) != BodyId::GROUND && replaced.part(LinkId::at(i)).is_none()
    };
    if trial.efforts.is_empty() || replaced.bodies.iter().enumerate().any(is_outer) {
        return None;
    }
    let still = driven.unmoved();
    let held: Vec<LinkId> = links(replaced, &still).collect();
    if held.is_empty() || held.iter().any(|l| replaced.passive.contains(l)) {
        return None;
    }
    let mechanism = trial.mechanism;
    let is_still = |l: &LinkId| *l == LinkId::GROUND || held.contains(l);
    let mut pairs: Vec<PairId> = held.iter().flat_map(|l| pairs_of(mechanism, *l)).collect();
    pairs.sort_unstable();
    pairs.dedup();
    pairs.retain(|p| mechanism.pair(*p).kind.links().iter().all(is_still));
    let quoted: Vec<String> = pairs.iter().map(|p| format!("`{}`", mechanism.pair(*p).name)).collect();
    let spans = held.iter().map(|l| mechanism.link(*l).span).filter(|s| *s != Span::default());
    let moves = if held.len() == 1 { "does" } else { "do" };
    Some(
        Diagnosis::warning(
            "mech::determinacy::immobile",
            format!("{} {moves} not move, whatever the drives do", names(mechanism, held.iter().copied())),
        )
        .labels(spans.take(MOST_LABELS).map(|s| label("cannot move", s)))
        .help(format!(
            "check which links {} join, because they hold them to the ground; \
             nothing is wrong if they are a frame whose reactions are asked for",
            listed(&quoted, "and")
        )),
    )
}
