//! Drives and unknown efforts that may be missing: lines to paste, each of them tried.

use super::defect::{Defect, Fit};
use super::effort::{EffortKind, in_pair};
use super::joint::BodyId;
use super::trial::Trial;
use super::words::links;
use crate::model::{
    Drive, Expr, FindKind, Level, LinkId, Mechanism, Pair, PairId, PairKind, Positions, Rate,
    TransmissionKind,
};

const MOST_TRIED: usize = 24;
/// Lines offered as alternatives.
const MOST_SHOWN: usize = 3;

/// What a drive or an unknown effort would be called.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Adds {
    Drives,
    Balances,
}

/// Drives or unknown efforts for what is loose: alternatives where one is missing, else together as many as are missing.
pub(super) fn missing_efforts(trial: Trial<'_>, defect: &Defect, adds: Adds) -> Vec<String> {
    efforts_beside(trial, &[], defect.fit, &defect.loose, adds)
}

/// The same where pairs are added too, after which so much is left loose.
pub(super) fn efforts_beside(
    trial: Trial<'_>,
    pairs: &[PairKind],
    left: Fit,
    among: &[BodyId],
    adds: Adds,
) -> Vec<String> {
    let mut chosen: Vec<EffortKind> = Vec::new();
    let mut lines = Vec::new();
    let wanted = left.missing;
    for (kind, place) in places(trial, among) {
        let mut with = chosen.clone();
        with.push(kind);
        let now = trial.with(pairs, &with).fit();
        if now.surplus > left.surplus || now.missing + with.len() > wanted {
            continue;
        }
        let is_ring = is_ring(trial.mechanism, &kind);
        lines.push(line(trial.mechanism, adds, chosen.len(), kind, &place, is_ring));
        if wanted > 1 || !pairs.is_empty() {
            chosen.push(kind);
        }
        let enough = if wanted == 1 && pairs.is_empty() { MOST_SHOWN } else { wanted };
        if lines.len() == enough {
            break;
        }
    }
    lines
}

fn line(
    mechanism: &Mechanism,
    adds: Adds,
    already: usize,
    kind: EffortKind,
    place: &str,
    is_ring: bool,
) -> String {
    let drive = if mechanism.simulation.is_some() { "start" } else { "drive" };
    match (adds, kind) {
        (Adds::Drives, _) => {
            let (position, speed) = match (kind, is_ring) {
                (EffortKind::Coordinate(_), _) => (" = 100 mm", " at 100 mm/s"),
                (_, true) => (" = 0 deg", " at 0 rpm"),
                (_, false) => (" = 45 deg", " at 60 rpm"),
            };
            let only_speeds = !matches!(kind, EffortKind::Coordinate(_)) && only_speeds(mechanism);
            let position = if only_speeds { "" } else { position };
            let speed = if drive == "drive" && needs_speed(mechanism) { speed } else { "" };
            format!("{drive} {place}{position}{speed}")
        }
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

/// Drives give speeds alone, or there is none and all that turns are shafts.
fn only_speeds(mechanism: &Mechanism) -> bool {
    let is_shaft = |p: &Pair| p.bearing.is_some() || matches!(p.kind, PairKind::Transmission(_));
    let is_speed = |d: &Drive| matches!(d.positions, Positions::None);
    match mechanism.drives.is_empty() {
        true => needs_speed(mechanism) && mechanism.pairs.iter().all(is_shaft),
        false => mechanism.drives.iter().all(is_speed),
    }
}

/// The other drives have a speed, or a question needs one.
fn needs_speed(mechanism: &Mechanism) -> bool {
    let mut needed = mechanism.drives.iter().any(|d| d.speed.is_some());
    let mut ask = |expr: &Expr| expr.queries(&mut |q| needed |= q.facts().level > Level::Positions);
    mechanism.quantities.iter().for_each(|q| ask(&q.expr));
    for find in &mechanism.finds {
        if let FindKind::Value { expr, .. } = &find.kind {
            ask(expr);
        }
    }
    needed
}

/// A ring around other wheels: it is mostly held.
fn is_ring(mechanism: &Mechanism, kind: &EffortKind) -> bool {
    let EffortKind::Angle(body) = kind else { return false };
    mechanism.pairs.iter().any(|pair| match &pair.kind {
        PairKind::Transmission(t) if t.kind == TransmissionKind::Mesh => {
            let terms = t.laws.first().map(|law| law.terms.as_slice());
            let Some([(Rate::Turn(a), c_1), (Rate::Turn(b), c_2), ..]) = terms else { return false };
            let ring = if c_1.abs() > c_2.abs() { a } else { b };
            c_1 * c_2 < 0.0 && ring.index() == body.0
        }
        _ => false,
    })
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
fn places(trial: Trial<'_>, among: &[BodyId]) -> Vec<(EffortKind, String)> {
    let (mechanism, replaced) = (trial.mechanism, trial.replaced);
    let loose: Vec<LinkId> = links(replaced, among).take(4 * MOST_TRIED).collect();
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
    // last, the angle of any link: it may get its pair by the same help
    let names = loose.iter().map(|l| (l, &mechanism.link(*l).name)).filter(|(_, name)| !name.contains('.'));
    found.extend(names.map(|(l, name)| (3, EffortKind::Angle(BodyId(l.index())), name.clone())));
    found.sort_by_key(|f| (f.0, !is_ring(mechanism, &f.1)));
    let mut places: Vec<(EffortKind, String)> = Vec::new();
    for (_, kind, name) in found {
        // a shaft and its bearing have one name
        if !places.iter().any(|p| p.0 == kind || p.1 == name) {
            places.push((kind, name));
        }
    }
    places.truncate(trial.most_tried(MOST_TRIED));
    places
}
