//! What welds cannot be.

use super::joint::{BodyId, Replaced};
use super::roller::{MOST_LABELS, label, names};
use super::weld::{Welds, is_law, spoken_of, weld};
use super::words::{drive_statement, line, statement};
use crate::model::{Drive, DriveTarget, LinkId, Mechanism, PairId, PairKind};
use assur_text::diagnostic::Diagnosis;

/// What welds cannot be: rings, pairs within one body, links that laws speak of, points that are driven.
pub(super) fn defects(mechanism: &Mechanism, replaced: &Replaced) -> Vec<Diagnosis> {
    if !replaced.has_parts() {
        return Vec::new();
    }
    let mut found: Vec<Diagnosis> =
        Welds::of(mechanism).closing.iter().map(|&pair| ring(mechanism, replaced, pair)).collect();
    for (i, pair) in mechanism.pairs.iter().enumerate() {
        let (id, links) = (PairId::at(i), pair.kind.links());
        let moves = !matches!(pair.kind, PairKind::Weld { .. } | PairKind::Cylinder { .. });
        let same = |(a, b): (usize, &LinkId)| {
            links[..a].iter().any(|c| replaced.body_of(*c) == replaced.body_of(*b))
        };
        if moves && links.iter().enumerate().any(same) {
            found.push(inside(mechanism, replaced, id));
        } else if is_law(mechanism, id) {
            let part = spoken_of(mechanism, id).into_iter().find(|link| replaced.part(*link).is_some());
            found.extend(part.map(|link| of_law(mechanism, id, link)));
        }
    }
    let fixed = |drive: &&Drive| match drive.target {
        DriveTarget::Link(link) | DriveTarget::Place(link, ..) => {
            link != LinkId::GROUND && replaced.body_of(link) == BodyId::GROUND
        }
        DriveTarget::Pair(_) | DriveTarget::Point(..) => false,
    };
    found.extend(mechanism.drives.iter().filter(fixed).map(|drive| of_fixed(mechanism, replaced, drive)));
    found
}

/// The welds of the body of a link.
fn welds_of(mechanism: &Mechanism, replaced: &Replaced, link: LinkId) -> Vec<PairId> {
    let body = replaced.body_of(link);
    let welds = mechanism.pairs.iter().enumerate().filter_map(weld);
    welds.filter(|(_, pins, _)| pins.iter().any(|p| replaced.body_of(p.link) == body)).map(|w| w.0).collect()
}

fn ring(mechanism: &Mechanism, replaced: &Replaced, pair: PairId) -> Diagnosis {
    let what = statement(mechanism, pair);
    let links = mechanism.pair(pair).kind.links();
    let others = welds_of(mechanism, replaced, links[0]).into_iter().filter(|other| *other != pair);
    let already = others.map(|other| label("joins them already", mechanism.pair(other).span));
    Diagnosis::error(
        "mech::determinacy::overconstrained",
        format!(
            "{what} joins {}, which are one body without it: the forces in the welds are statically indeterminate",
            names(mechanism, links.iter().copied())
        ),
    )
    .primary(mechanism.pair(pair).span, "one weld too many")
    .labels(already.take(MOST_LABELS))
    .help(format!("leave out {what}"))
}

fn inside(mechanism: &Mechanism, replaced: &Replaced, pair: PairId) -> Diagnosis {
    let what = statement(mechanism, pair);
    let links = mechanism.pair(pair).kind.links();
    let twice = links.iter().enumerate().find_map(|(i, link)| {
        let first = links[..i].iter().find(|other| replaced.body_of(**other) == replaced.body_of(*link))?;
        Some([*first, *link])
    });
    let twice = twice.unwrap_or([links[0]; 2]);
    let welds = welds_of(mechanism, replaced, twice[0]);
    let rigid = welds.iter().map(|weld| label("makes them one body", mechanism.pair(*weld).span));
    let degree = degree(mechanism, replaced, twice[0]);
    let hinged = if degree == 1 { hinge(mechanism, pair, &welds) } else { None };
    let hinged = hinged.map(|(line, weld)| format!(", or write `{line}` in place of {weld}"));
    let fixed = if twice.contains(&LinkId::GROUND) { "supports" } else { "joints" };
    Diagnosis::error(
        "mech::determinacy::overconstrained",
        format!(
            "{what} joins {}, which are one body: the forces in their {fixed} are statically indeterminate by {degree}",
            names(mechanism, twice.into_iter())
        ),
    )
    .primary(mechanism.pair(pair).span, "nothing can move here")
    .labels(rigid.take(MOST_LABELS))
    .help(format!("leave out {what}{}", hinged.unwrap_or_default()))
}

/// How many conditions hold the links of a body beyond those of the welds that make it one.
fn degree(mechanism: &Mechanism, replaced: &Replaced, link: LinkId) -> usize {
    let body = replaced.body_of(link);
    let more = |kind: &PairKind| {
        let same = kind.links().iter().filter(|link| replaced.body_of(**link) == body).count();
        let each = match kind {
            PairKind::Revolute(_) | PairKind::Prismatic(_) => 2,
            PairKind::Slot(_) | PairKind::Contact { .. } | PairKind::Transmission(_) => 1,
            PairKind::Weld { .. } | PairKind::Cylinder { .. } => 0,
        };
        each * same.saturating_sub(1)
    };
    let closing = Welds::of(mechanism).closing.into_iter().map(|pair| mechanism.pair(pair).kind.links());
    let rings = closing.filter(|links| links.iter().any(|link| replaced.body_of(*link) == body)).count();
    3 * rings + mechanism.pairs.iter().map(|pair| more(&pair.kind)).sum::<usize>()
}

/// The one weld of a body of two links as a hinge, which takes one condition less, where a slot away from it holds them too.
fn hinge(mechanism: &Mechanism, slot: PairId, welds: &[PairId]) -> Option<(String, String)> {
    let ([weld], PairKind::Slot(guide)) = (welds, &mechanism.pair(slot).kind) else { return None };
    let pair = mechanism.pair(*weld);
    let PairKind::Weld { pins, .. } = &pair.kind else { return None };
    if pins.len() != 2 || pins.iter().any(|pin| pin.link == guide.slider && pin.at == guide.point) {
        return None;
    }
    let line = line(mechanism, &pair.name, &PairKind::Revolute(pins.clone()))?;
    Some((line, statement(mechanism, *weld)))
}

fn of_law(mechanism: &Mechanism, pair: PairId, link: LinkId) -> Diagnosis {
    let name = &mechanism.link(link).name;
    Diagnosis::error(
        "mech::determinacy::weld_in_law",
        format!(
            "`{name}` is welded and belongs to {}: this is not supported here",
            statement(mechanism, pair)
        ),
    )
    .label(mechanism.pair(pair).span, format!("speaks of `{name}`"))
    .help(format!(
        "leave out the weld, and give `{name}` the points, masses and loads of the link that is welded to it"
    ))
}

fn of_fixed(mechanism: &Mechanism, replaced: &Replaced, drive: &Drive) -> Diagnosis {
    let welds = welds_of(mechanism, replaced, LinkId::GROUND);
    let what = drive_statement(drive);
    Diagnosis::error(
        "mech::determinacy::overconstrained",
        format!("{what} moves a link that is welded to the ground"),
    )
    .primary(drive.span, "nothing can move here")
    .labels(welds.iter().map(|weld| label("holds it", mechanism.pair(*weld).span)).take(MOST_LABELS))
    .help(format!("leave out {what}: reactions of what does not move need no drive"))
}
