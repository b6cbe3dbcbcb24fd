//! What to add and what to leave out: lines to paste, each of them tried.

use super::effort::{EffortKind, EffortSource, in_pair};
use super::incidence::{Defect, Fit, Part};
use super::joint::{BodyId, BodyOrigin, Replaced};
use super::trial::Trial;
use crate::math::Vec2;
use crate::model::{Guide, LinkId, Mechanism, PairId, PairKind, Pin, Wheel};

/// Changes tried of each sort.
const MOST_TRIED: usize = 24;
/// Lines offered as alternatives.
const MOST_SHOWN: usize = 3;

/// The links of a part.
pub(super) fn links<'a>(replaced: &'a Replaced, part: &'a Part) -> impl Iterator<Item = LinkId> + 'a {
    part.bodies.iter().filter_map(|b| match replaced.bodies[b.0].origin {
        BodyOrigin::Link(id) => Some(id),
        BodyOrigin::Imaginary(_) => None,
    })
}

/// A pair as its statement begins: `slot E`.
pub(super) fn statement(mechanism: &Mechanism, pair: PairId) -> String {
    let pair = mechanism.pair(pair);
    let word = match &pair.kind {
        PairKind::Revolute(_) => "revolute",
        PairKind::Prismatic(_) => "prismatic",
        PairKind::Slot(_) => "slot",
        PairKind::Contact { .. } => "contact",
        PairKind::Cylinder { .. } => "cylinder",
        PairKind::Transmission(t) => t.kind.word(),
    };
    format!("`{word} {}`", pair.name)
}

/// An effort as its statement begins: `drive crank`, `balance Mb`.
fn effort_statement(mechanism: &Mechanism, source: EffortSource) -> String {
    match source {
        EffortSource::Drive(id) => format!("`drive {}`", mechanism.drives[id.index()].name),
        EffortSource::Balance(id) => format!("`balance {}`", mechanism.balances[id.index()].name),
    }
}

/// Drives or unknown efforts that may be left out, each by itself.
pub(super) fn needless_efforts(trial: Trial<'_>, defect: &Defect) -> Vec<String> {
    let tried = defect.over.efforts.iter().take(MOST_TRIED);
    let needless = tried.filter(|&&e| lessens(trial.without_effort(e), defect));
    needless.map(|&e| effort_statement(trial.mechanism, trial.efforts[e].source)).collect()
}

/// What may be done to pairs and links, each by itself.
pub(super) fn needless_parts(trial: Trial<'_>, defect: &Defect) -> Vec<String> {
    let (mechanism, over) = (trial.mechanism, &defect.over);
    let mut out = Vec::new();
    // what takes least is left out first
    let mut pairs = over.pairs.clone();
    pairs.sort_by_key(|p| p.1);
    let pairs: Vec<PairId> =
        pairs.iter().map(|p| p.0).take(MOST_TRIED).filter(|&p| !is_driven(trial, p)).collect();
    for &pair in &pairs {
        if trial.as_slot(pair).is_some_and(|fit| lessens(fit, defect)) {
            let name = &mechanism.pair(pair).name;
            out.push(format!("write `slot {name}` in place of `prismatic {name}`"));
        }
    }
    for &pair in &pairs {
        if lessens(trial.without_pairs(&[pair], None), defect) {
            out.push(format!("leave out {}", statement(mechanism, pair)));
        }
    }
    for link in links(trial.replaced, over).take(MOST_TRIED) {
        let joined = pairs_of(mechanism, link);
        let driven = joined.iter().any(|&p| is_driven(trial, p)) || drives_link(trial, link);
        if !driven && lessens(trial.without_pairs(&joined, Some(BodyId(link.index()))), defect) {
            out.push(format!("leave out link `{}` with its pairs", mechanism.link(link).name));
        }
    }
    out.truncate(MOST_SHOWN);
    out
}

/// One condition too many less, and nothing made loose.
fn lessens(now: Fit, defect: &Defect) -> bool {
    now.surplus < defect.fit.surplus && now.missing == defect.fit.missing
}

fn is_driven(trial: Trial<'_>, pair: PairId) -> bool {
    trial.efforts.iter().any(|e| match e.kind {
        EffortKind::RelativeAngle { joint, .. } | EffortKind::Coordinate(joint) => {
            trial.replaced.joint(joint).pair == pair
        }
        EffortKind::Angle(_) | EffortKind::Line(_) | EffortKind::Point(_) => false,
    })
}

fn drives_link(trial: Trial<'_>, link: LinkId) -> bool {
    let body = BodyId(link.index());
    trial.efforts.iter().any(|e| e.bodies(trial.replaced).contains(&body))
}

pub(super) fn pairs_of(mechanism: &Mechanism, link: LinkId) -> Vec<PairId> {
    let pairs = mechanism.pairs.iter().enumerate();
    pairs.filter(|(_, p)| p.kind.links().contains(&link)).map(|(i, _)| PairId::at(i)).collect()
}

/// Pairs that would hold what can still move.
pub(super) fn missing_pairs(trial: Trial<'_>, defect: &Defect, guides_too: bool) -> Vec<String> {
    let mechanism = trial.mechanism;
    let mut found: Vec<(Fit, String)> = Vec::new();
    let mut candidates = shared_points(trial, defect);
    if guides_too {
        candidates.extend(free_guides(trial, defect));
    }
    for (word, name, ends, kind) in candidates.into_iter().take(2 * MOST_TRIED) {
        let now = trial.with_pair(&kind);
        if now.surplus == defect.fit.surplus && now.missing < defect.fit.missing {
            let line = format!("{word} {}: {ends}", free_pair_name(mechanism, &name));
            found.push((now, line));
        }
    }
    let least = found.iter().map(|f| f.0.missing).min().unwrap_or(0);
    let best = found.into_iter().filter(|f| f.0.missing == least);
    best.map(|f| f.1).take(MOST_SHOWN).collect()
}

/// Gear pairs between wheels that nothing runs on yet: a wheel of what is loose and one of another link.
pub(super) fn missing_meshes(trial: Trial<'_>, defect: &Defect) -> Vec<String> {
    let mechanism = trial.mechanism;
    let runs = |wheel: &Wheel| {
        mechanism.pairs.iter().any(|p| match &p.kind {
            PairKind::Transmission(t) => {
                t.ends.iter().any(|end| end.split(['(', ')']).any(|word| word == wheel.name))
            }
            _ => false,
        })
    };
    let idle: Vec<&Wheel> = mechanism.wheels.iter().filter(|w| !runs(w)).take(MOST_TRIED).collect();
    let mut lines = Vec::new();
    for wheel in links(trial.replaced, &defect.under).flat_map(|l| idle.iter().filter(move |w| w.link == l)) {
        for other in idle.iter().filter(|other| other.link != wheel.link) {
            let (a, b) = if other.span.start < wheel.span.start { (other, wheel) } else { (wheel, other) };
            let line = format!("mesh {}: {} - {}", free_pair_name(mechanism, "k"), a.name, b.name);
            if !lines.contains(&line) {
                lines.push(line);
            }
        }
    }
    lines.truncate(MOST_SHOWN);
    lines
}

type Candidate = (&'static str, String, String, PairKind);

/// Hinges at points of one name in two links that no pair joins.
fn shared_points(trial: Trial<'_>, defect: &Defect) -> Vec<Candidate> {
    let mechanism = trial.mechanism;
    let pin = |link: LinkId, name: &str, at| Pin { link, name: name.to_owned(), at };
    let mut out: Vec<Candidate> = Vec::new();
    for loose in links(trial.replaced, &defect.under).take(MOST_TRIED) {
        let joined: Vec<LinkId> =
            pairs_of(mechanism, loose).iter().flat_map(|p| mechanism.pair(*p).kind.links()).collect();
        for point in &mechanism.link(loose).points {
            for (i, other) in mechanism.links.iter().enumerate() {
                let id = LinkId::at(i);
                let Some(twin) = other.points.iter().find(|p| p.name == point.name) else { continue };
                if id == loose || joined.contains(&id) {
                    continue;
                }
                let pins = vec![pin(id, &twin.name, twin.at), pin(loose, &point.name, point.at)];
                let ends = format!("{} - {}", other.name, mechanism.link(loose).name);
                let name = point.name.clone();
                let again = |c: &Candidate| c.1 == name && c.2.split(" - ").all(|e| ends.contains(e));
                if !out.iter().any(again) {
                    out.push(("revolute", name, ends, PairKind::Revolute(pins)));
                }
            }
        }
    }
    out
}

/// Guides on lines that no pair uses.
fn free_guides(trial: Trial<'_>, defect: &Defect) -> Vec<Candidate> {
    let mechanism = trial.mechanism;
    let mut out: Vec<Candidate> = Vec::new();
    for (i, link) in mechanism.links.iter().enumerate() {
        let base = LinkId::at(i);
        for line in link.lines.iter().filter(|l| !is_used(mechanism, base, &l.name)) {
            for loose in links(trial.replaced, &defect.under).filter(|l| *l != base).take(MOST_TRIED) {
                for point in &mechanism.link(loose).points {
                    let guide = Guide {
                        slider: loose,
                        point_name: point.name.clone(),
                        point: point.at,
                        direction: Vec2::new(1.0, 0.0),
                        guide: base,
                        line_name: line.name.clone(),
                        through: line.through,
                        along: line.along,
                        contacts: None,
                        guide_first: false,
                    };
                    let ends = format!(
                        "{}.{} - {}.{}",
                        mechanism.link(loose).name,
                        point.name,
                        link.name,
                        line.name
                    );
                    let name = || point.name.clone();
                    out.push(("prismatic", name(), ends.clone(), PairKind::Prismatic(guide.clone())));
                    out.push(("slot", name(), ends, PairKind::Slot(guide)));
                }
            }
        }
    }
    out
}

fn is_used(mechanism: &Mechanism, link: LinkId, line: &str) -> bool {
    let of_slider = |g: &Guide| {
        let mut lines = mechanism.link(g.slider).lines.iter();
        g.slider == link && lines.any(|l| l.name == line && l.through == g.point && l.along == g.direction)
    };
    mechanism.pairs.iter().any(|p| match &p.kind {
        PairKind::Prismatic(g) => g.guide == link && g.line_name == line || of_slider(g),
        PairKind::Slot(g) => g.guide == link && g.line_name == line,
        PairKind::Contact { first, second, .. } => {
            [first, second].iter().any(|f| f.link == link && f.name == line)
        }
        PairKind::Revolute(_) | PairKind::Cylinder { .. } | PairKind::Transmission(_) => false,
    })
}

/// A name for a pair that no link, pair or group has.
fn free_pair_name(mechanism: &Mechanism, wish: &str) -> String {
    let taken = |name: &str| {
        mechanism.links.iter().any(|l| l.name == name)
            || mechanism.pairs.iter().any(|p| p.name == name)
            || mechanism.groups.iter().any(|g| g.name == name)
    };
    let letters = ('A'..='Z').map(String::from);
    let numbered = (1..).map(|i| format!("{wish}{i}"));
    let mut names = std::iter::once(wish.to_owned()).chain(letters).chain(numbered);
    names.find(|n| !taken(n)).unwrap_or_else(|| wish.to_owned())
}

/// What a drive or an unknown effort would be called.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Adds {
    Drives,
    Balances,
}

/// Drives or unknown efforts for what is loose: alternatives where one is missing, else together as many as are missing.
pub(super) fn missing_efforts(trial: Trial<'_>, defect: &Defect, adds: Adds) -> Vec<String> {
    let mut chosen: Vec<EffortKind> = Vec::new();
    let mut lines = Vec::new();
    let wanted = defect.fit.missing;
    for (kind, place) in places(trial, defect) {
        let mut with = chosen.clone();
        with.push(kind);
        let now = trial.with_efforts(&with);
        if now.surplus > defect.fit.surplus || now.missing + with.len() > wanted {
            continue;
        }
        lines.push(line(trial.mechanism, adds, chosen.len(), kind, &place));
        if wanted > 1 {
            chosen.push(kind);
        }
        if lines.len() == if wanted == 1 { MOST_SHOWN } else { wanted } {
            break;
        }
    }
    lines
}

fn line(mechanism: &Mechanism, adds: Adds, already: usize, kind: EffortKind, place: &str) -> String {
    match (adds, kind) {
        (Adds::Drives, EffortKind::Coordinate(_)) => format!("drive {place} = 100 mm"),
        (Adds::Drives, _) => format!("drive {place} = 45 deg"),
        (Adds::Balances, EffortKind::Coordinate(_)) => {
            format!("balance force {} in {place}", free_quantity_name(mechanism, "F", already))
        }
        (Adds::Balances, EffortKind::RelativeAngle { .. }) => {
            format!("balance torque {} in {place}", free_quantity_name(mechanism, "M", already))
        }
        (Adds::Balances, _) => {
            format!("balance torque {} on {place}", free_quantity_name(mechanism, "M", already))
        }
    }
}

/// `M1`, `M2`, … without those that the file has.
fn free_quantity_name(mechanism: &Mechanism, letter: &str, already: usize) -> String {
    let taken = |name: &str| {
        mechanism.balances.iter().any(|b| b.name == name)
            || mechanism.values.iter().any(|v| v.name == name)
            || mechanism.quantities.iter().any(|q| q.name == name)
            || mechanism.loads.iter().any(|l| l.name.as_deref() == Some(name))
    };
    let names = (1..).map(|i| format!("{letter}{i}")).filter(|n| !taken(n));
    names.take(already + 1).last().unwrap_or_else(|| letter.to_owned())
}

/// Where a drive could stand: those beside the ground first, then those beside what does not move.
fn places(trial: Trial<'_>, defect: &Defect) -> Vec<(EffortKind, String)> {
    let (mechanism, replaced) = (trial.mechanism, trial.replaced);
    let loose: Vec<LinkId> = links(replaced, &defect.under).take(4 * MOST_TRIED).collect();
    let mut found: Vec<(u8, EffortKind, String)> = Vec::new();
    for (i, pair) in mechanism.pairs.iter().enumerate() {
        let ends = pair.kind.links();
        let moving: Vec<LinkId> = ends.iter().copied().filter(|l| loose.contains(l)).collect();
        if moving.is_empty() {
            continue;
        }
        let rank = match (ends.contains(&LinkId::GROUND), ends.len() > moving.len()) {
            (true, _) => 0,
            (false, true) => 1,
            (false, false) => 2,
        };
        if let (PairKind::Revolute(_), 0 | 1) = (&pair.kind, rank) {
            let kinds =
                moving.iter().map(|l| (rank, EffortKind::Angle(BodyId(l.index())), mechanism.link(*l)));
            found.extend(kinds.map(|(rank, kind, link)| (rank, kind, link.name.clone())));
        } else if let Some(kind) = in_pair(mechanism, replaced, PairId::at(i)) {
            found.push((rank, kind, pair.name.clone()));
        }
    }
    found.sort_by_key(|f| f.0);
    let mut places: Vec<(EffortKind, String)> = Vec::new();
    for (_, kind, name) in found {
        if !places.iter().any(|p| p.0 == kind) {
            places.push((kind, name));
        }
    }
    places.truncate(MOST_TRIED);
    places
}
