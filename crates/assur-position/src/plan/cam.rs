//! Designed cams and their followers: either moves the other by the cam's own law.

use super::cam_step::CamStep;
use super::planned::Plan;
use super::step::MotionStep;
use crate::model::{CamContact, Mechanism, PairId, PairKind};
use crate::structure::{BodyOrigin, Group, Structure};

/// The contact of a designed cam whose block belongs to a group.
pub fn contact_in<'m>(
    mechanism: &'m Mechanism,
    structure: &Structure,
    group: &Group,
) -> Option<(usize, usize, &'m CamContact)> {
    let blocks = group.bodies.iter().filter_map(|b| match structure.replaced.bodies[b.0].origin {
        BodyOrigin::Imaginary(pair) => Some((b.0, pair)),
        BodyOrigin::Link(_) => None,
    });
    let of = |pair: PairId| mechanism.cam_contacts.iter().enumerate().find(move |(_, c)| c.pair == pair);
    blocks.into_iter().find_map(|(block, pair)| of(pair).map(|(index, contact)| (block, index, contact)))
}

/// Designed cams from which their followers part: no group has them.
pub(super) fn parting(mechanism: &Mechanism) -> Vec<CamStep> {
    let contacts = mechanism.cam_contacts.iter().enumerate();
    let parting = contacts.filter(|(_, contact)| {
        matches!(mechanism.pair(contact.pair).kind, PairKind::Contact { parts: true, .. })
    });
    let step = |(index, contact): (usize, &CamContact)| {
        let cam = mechanism.cams.get(contact.cam)?.cam.clone();
        Some(CamStep { cam, contact: contact.clone(), index, block: 0, flanks: Vec::new() })
    };
    parting.filter_map(step).collect()
}

/// Whether a group is the follower of a cam that moves already: the follower and the block, nothing else.
pub fn is_follower(group: &Group, block: usize, contact: &CamContact) -> bool {
    group.is_dyad_of(contact.follower, block)
}

/// Whether a group is a cam that its follower, which moves already, turns: the cam and the block, nothing else.
pub fn is_turned(group: &Group, block: usize, contact: &CamContact) -> bool {
    group.is_dyad_of(contact.disk, block)
}

/// The step of a group that is the follower of a designed cam, or the cam.
pub(super) fn step(
    mechanism: &Mechanism,
    structure: &Structure,
    group: &Group,
    branch: usize,
    plan: &mut Plan,
) -> Option<MotionStep> {
    let (block, index, contact) = contact_in(mechanism, structure, group)?;
    let follows = is_follower(group, block, contact);
    if !follows && !is_turned(group, block, contact) {
        return None;
    }
    let cam = mechanism.cams.get(contact.cam)?.cam.clone();
    let flanks = if follows { Vec::new() } else { cam.program.flanks() };
    plan.cams.push(CamStep { cam, contact: contact.clone(), index, block, flanks });
    let cam = plan.cams.len() - 1;
    Some(if follows { MotionStep::Cam { branch, cam } } else { MotionStep::CamTurned { branch, cam } })
}
