//! Drives and unknown efforts that may be missing: lines to paste, each of them tried.

use super::defect::{Defect, Fit};
use super::effort::{EffortKind, in_pair};
use super::joint::BodyId;
use super::leave_out::links;
use super::trial::Trial;
use crate::model::{LinkId, Mechanism, PairId, PairKind};

/// Places tried.
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
        lines.push(line(trial.mechanism, adds, chosen.len(), kind, &place));
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
fn line(mechanism: &Mechanism, adds: Adds, already: usize, kind: EffortKind, place: &str) -> String {
    let drive = if mechanism.simulation.is_some() { "start" } else { "drive" };
    match (adds, kind) {
        (Adds::Drives, EffortKind::Coordinate(_)) => format!("{drive} {place} = 100 mm"),
        (Adds::Drives, _) => format!("{drive} {place} = 45 deg"),
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
    found.sort_by_key(|f| f.0);
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
