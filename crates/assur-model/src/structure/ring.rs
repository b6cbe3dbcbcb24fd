//! Rings of wheels: a mesh that closes a ring repeats what the others do where the ratios around it agree, and locks the ring
//! where they do not. By the count both hold once too often.

use crate::structure::repeated::repeats;
use assur_math::math::SAME;
use assur_text::diagnostic::Diagnosis;
use std::collections::BTreeMap;

use super::count::Count;
use super::defect::{Defect, Part};
use super::roller::{label, listed};
use super::trial::{Change, Statement, Trial};
use super::words::statement;
use crate::model::{LinkId, Mechanism, PairId, PairKind, Rate};

/// A transmission that closes a ring of others.
struct Ring {
    closing: PairId,
    /// The shaft that would have to turn at `ratio` times its own speed.
    shaft: LinkId,
    ratio: f64,
}

/// Transmissions that only repeat what the others do.
pub(super) fn repeated_mesh(trial: Trial<'_>, count: &Count, defect: &Defect) -> Option<Diagnosis> {
    let mechanism = trial.mechanism;
    let part = defect.over.iter().find(|part| agree(mechanism, part))?;
    let closing: Vec<PairId> = rings(mechanism, part).iter().map(|r| r.closing).collect();
    let out = closing.iter().map(|pair| Statement::Pair(*pair)).collect();
    let now = trial.after(&Change::without_all(out)).fit;
    if now.surplus >= defect.fit.surplus || now.missing > defect.fit.missing {
        return None;
    }
    let named = |pairs: &mut dyn Iterator<Item = PairId>, and| {
        listed(&pairs.map(|p| statement(mechanism, p)).collect::<Vec<_>>(), and)
    };
    let others: Vec<PairId> = part.pairs.iter().map(|p| p.0).filter(|p| !closing.contains(p)).collect();
    let what = named(&mut closing.iter().copied(), "and");
    let place = |p: &PairId| mechanism.pair(*p).span;
    let mut labels: Vec<_> =
        closing.iter().map(|p| label("asks for a ratio that is there already", place(p))).collect();
    labels.extend(others.iter().map(|p| label("gives this ratio", place(p))));
    Some(repeats(
        &what,
        &format!(
            "{} {}",
            named(&mut others.iter().copied(), "and"),
            if others.len() == 1 { "does" } else { "do" }
        ),
        "the ratios around the ring agree",
        format!(
            "leave out {what}, the motion stays the same: by the count F = {} the wheels could not turn; they do, because the \
             ratios agree, but no equation determines how the meshes share the forces",
            count.formula()
        ),
        labels,
    ))
}

/// Why the wheels of a part cannot turn.
pub(super) fn locked(mechanism: &Mechanism, part: &Part) -> Option<String> {
    let ring = rings(mechanism, part).into_iter().find(|r| (r.ratio - 1.0).abs() > SAME)?;
    let ratio = format!("{:.6}", ring.ratio);
    let ratio = ratio.trim_end_matches('0').trim_end_matches('.').replacen('-', "−", 1);
    Some(format!(
        "around the ring of transmissions `{}` would have to turn at {ratio} times its own speed, so nothing can turn",
        mechanism.link(ring.shaft).name
    ))
}

fn agree(mechanism: &Mechanism, part: &Part) -> bool {
    let rings = rings(mechanism, part);
    !rings.is_empty() && rings.iter().all(|r| (r.ratio - 1.0).abs() <= SAME)
}

/// The rings that transmissions close, each with the last of its transmissions; none where the part has other pairs, or wheels
/// whose size is not given.
fn rings(mechanism: &Mechanism, part: &Part) -> Vec<Ring> {
    let mut found = Vec::new();
    // of every shaft and carrier: the first shaft that it turns with, and its speed for one of that
    let mut speeds: BTreeMap<(LinkId, Option<LinkId>), (LinkId, f64)> = BTreeMap::new();
    for &(pair, _) in &part.pairs {
        let Some((ends, carrier, ratio)) = ratio(mechanism, pair) else { return Vec::new() };
        let [(a, of_a), (b, of_b)] = ends.map(|l| *speeds.entry((l, carrier)).or_insert((l, 1.0)));
        if a == b {
            let [_, shaft] = ends;
            found.push(Ring { closing: pair, shaft, ratio: of_a * ratio / of_b });
        } else {
            let factor = of_a * ratio / of_b;
            for (first, speed) in speeds.iter_mut().filter(|(at, _)| at.1 == carrier).map(|s| s.1) {
                if *first == b {
                    (*first, *speed) = (a, *speed * factor);
                }
            }
        }
    }
    found
}

/// The shafts of a transmission, their carrier, and the speed of the second for one of the first.
fn ratio(mechanism: &Mechanism, pair: PairId) -> Option<([LinkId; 2], Option<LinkId>, f64)> {
    let PairKind::Transmission(transmission) = &mechanism.pair(pair).kind else { return None };
    let open = |s: &crate::model::OpenSize| !s.teeth && transmission.ends.contains(&s.wheel);
    let [law] = transmission.laws.as_slice() else { return None };
    let (a, b, carrier) = match law.terms.as_slice() {
        [a, b] => (a, b, None),
        [a, b, (Rate::Turn(carrier), _)] => (a, b, Some(*carrier)),
        _ => return None,
    };
    let ((Rate::Turn(first), c_1), (Rate::Turn(second), c_2)) = (*a, *b) else { return None };
    (!mechanism.open_sizes.iter().any(open)).then_some(([first, second], carrier, -c_1 / c_2))
}
