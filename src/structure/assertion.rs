//! `group NAME: links` — asserted groups against those found.

use super::error::StructureError;
use super::{BodyId, BodyOrigin, Structure};
use crate::model::{GroupAssertion, Mechanism, PairKind};

/// Errors and warnings; groups that are asserted get their names.
pub(super) fn check(
    mechanism: &Mechanism,
    structure: &mut Structure,
) -> (Vec<StructureError>, Vec<StructureError>) {
    let (mut errors, mut warnings) = (Vec::new(), Vec::new());
    for assertion in &mechanism.groups {
        let (lower, higher) = pairs_of(mechanism, structure, assertion);
        let n = assertion.links.len();
        if 3 * n != 2 * lower.len() + higher.len() {
            errors.push(StructureError::not_a_group(mechanism, assertion, &lower, &higher));
            continue;
        }
        let inside: Vec<usize> = structure
            .motion
            .iter()
            .enumerate()
            .filter(|(_, g)| {
                let mut links = g.bodies.iter().filter_map(|b| link_of(structure, *b)).peekable();
                links.peek().is_some() && links.all(|l| assertion.links.contains(&l))
            })
            .map(|(i, _)| i)
            .collect();
        match inside.as_slice() {
            [one] => structure.motion[*one].name = Some(assertion.name.clone()),
            [] => errors.push(StructureError::part_of_larger(mechanism, assertion, structure)),
            many => warnings.push(StructureError::contains_smaller(mechanism, assertion, structure, many)),
        }
    }
    (errors, warnings)
}

fn link_of(structure: &Structure, body: BodyId) -> Option<crate::model::LinkId> {
    match structure.replaced.bodies[body.0].origin {
        BodyOrigin::Link(id) => Some(id),
        BodyOrigin::Imaginary(_) => None,
    }
}

/// Lower pairs (one entry per pair they count for) and higher pairs of the named links, without those that join them to
/// links solved later: such a pair belongs to the later group.
fn pairs_of(
    mechanism: &Mechanism,
    structure: &Structure,
    assertion: &GroupAssertion,
) -> (Vec<usize>, Vec<usize>) {
    let rank = |link: crate::model::LinkId| {
        let body = BodyId(link.index());
        structure.motion.iter().position(|g| g.bodies.contains(&body))
    };
    let last = assertion.links.iter().map(|&l| rank(l)).max().flatten();
    let (mut lower, mut higher) = (Vec::new(), Vec::new());
    for (i, pair) in mechanism.pairs.iter().enumerate() {
        let mut links = pair.kind.links();
        links.retain(|&l| rank(l) <= last);
        let inside = links.iter().filter(|l| assertion.links.contains(l)).count();
        if inside == 0 || links.len() < 2 {
            continue;
        }
        let outside = links.len() - inside;
        match &pair.kind {
            // of a pin, the links of the group turn on one carrier: outside where there is one
            PairKind::Revolute(_) => {
                lower.extend(std::iter::repeat_n(i, if outside > 0 { inside } else { inside - 1 }));
            }
            PairKind::Cylinder { .. } => {}
            PairKind::Prismatic(_) => lower.push(i),
            PairKind::Slot(_) | PairKind::Contact { .. } => higher.push(i),
        }
    }
    (lower, higher)
}
