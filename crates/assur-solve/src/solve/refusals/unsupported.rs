//! Constructs that cannot be solved yet.

use crate::model::Mechanism;
use crate::plan::{contact_in, geneva_in, is_follower, is_turned, is_wheel};
use crate::position::Model;
use crate::solve::refusal::Refusal;
use crate::source::Span;
use crate::structure::GroupKind;

/// Constructs that are understood and cannot be solved yet, each kind once.
pub(in crate::solve) fn not_supported(mechanism: &Mechanism) -> Vec<Refusal> {
    let mut kinds: Vec<(&str, Vec<Span>)> = Vec::new();
    for unsupported in &mechanism.unsupported {
        match kinds.iter_mut().find(|k| k.0 == unsupported.what) {
            Some((_, places)) => places.push(unsupported.span),
            None => kinds.push((&unsupported.what, vec![unsupported.span])),
        }
    }
    let refused = |(what, places): (&str, _)| Refusal::Unsupported { what: what.to_owned(), places };
    kinds.into_iter().map(refused).collect()
}

/// Contacts of designed cams of which neither side moves the other by itself, or that carry forces in a way that no step knows.
pub(super) fn cams(model: &Model<'_>) -> Vec<Refusal> {
    let (mechanism, structure) = (model.mechanism, model.structure);
    for group in &structure.motion {
        if let Some((block, _, contact)) = contact_in(mechanism, structure, group)
            && !is_follower(group, block, contact)
            && !is_turned(group, block, contact)
        {
            return vec![Refusal::CamFollower(contact.pair)];
        }
    }
    let mut found = Vec::new();
    for group in structure.forces.iter().filter(|_| model.plan.effects.forces) {
        let Some((_, _, contact)) = contact_in(mechanism, structure, group) else { continue };
        if !matches!(group.kind, GroupKind::Dyad(_)) {
            found.push(Refusal::CamForces(contact.pair));
        }
    }
    found
}

/// Geneva wheels that their cranks do not move, or that carry forces in a way that no step knows.
pub(super) fn genevas(model: &Model<'_>) -> Vec<Refusal> {
    let (mechanism, structure) = (model.mechanism, model.structure);
    for group in &structure.motion {
        if let Some((block, pair)) = geneva_in(mechanism, structure, group)
            && !is_wheel(group, block, pair)
        {
            return vec![Refusal::GenevaWheel(pair.pair)];
        }
    }
    let groups = structure.forces.iter().filter(|_| model.plan.effects.forces);
    let found = groups.filter_map(|group| {
        let (_, pair) = geneva_in(mechanism, structure, group)?;
        let with_crank = group.bodies.iter().any(|b| b.0 == pair.crank.index());
        let known = matches!(group.kind, GroupKind::Dyad(_)) && !with_crank;
        (!known).then_some(Refusal::GenevaForces(pair.pair))
    });
    found.collect()
}
