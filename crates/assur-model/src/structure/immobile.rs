//! Links that no drive moves, in a mechanism that is driven.

use super::error::{StructureError, label, listed};
use super::incidence::Incidence;
use super::joint::{Body, BodyId};
use super::leave_out::{links, pairs_of};
use super::names::{MOST_LABELS, names};
use super::trial::Trial;
use crate::model::{LinkId, PairId};
use crate::source::Span;

/// Links that pairs hold to the ground whatever the drives do. A mechanism without a drive is a structure: there all of them
/// are meant to be held. `driven` is the incidence of its drives.
pub(super) fn immobile(trial: Trial<'_>, driven: &Incidence) -> Option<StructureError> {
    let replaced = trial.replaced;
    // an outer link is known, and moves
    let is_outer = |(i, b): (usize, &Body)| b.known && BodyId(i) != BodyId::GROUND;
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
    Some(StructureError::Immobile {
        names: names(mechanism, held.iter().copied()),
        moves,
        pairs: listed(&quoted, "and"),
        labels: spans.take(MOST_LABELS).map(|s| label("cannot move", s)).collect(),
    })
}
