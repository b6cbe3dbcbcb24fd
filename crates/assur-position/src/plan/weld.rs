//! Welded links: where they lie in their bodies, and what their welds hold.

use super::planned::Plan;
use super::step::Anchor;
use crate::math::Vec2;
use crate::model::LinkId;
use crate::structure::{GroupJoint, JointId, JointKind, Structure};

/// A link that moves with the body that it is a part of.
#[derive(Clone, Copy, Debug)]
pub struct PlannedPart {
    /// Slot of the link.
    pub part: usize,
    /// Slot of its body.
    pub body: usize,
    /// The step of motion that moves the body; none where it is known.
    pub after: Option<usize>,
    /// Origin of the link in the body's frame, m.
    pub at: Vec2,
    /// Its x axis in that frame.
    pub along: Vec2,
    /// The angle of that axis, rad.
    pub angle: f64,
}

/// What a weld does to the part that it carries.
#[derive(Clone, Copy, Debug)]
pub struct PlannedWeld {
    /// Slot of the reaction.
    pub slot: usize,
    /// The part, and the point at which it is held.
    pub part: Anchor,
    /// Slot of the link that holds it.
    pub base: usize,
}

/// The parts, each with the step of motion after which it follows its body.
pub(super) fn parts(structure: &Structure) -> Vec<PlannedPart> {
    let replaced = &structure.replaced;
    let links = (0..replaced.bodies.len()).map(LinkId::at);
    let parts = links.filter_map(|link| Some((link, replaced.part(link)?)));
    let planned = parts.map(|(link, part)| PlannedPart {
        part: link.index(),
        body: part.body.0,
        after: structure.motion.iter().position(|group| group.bodies.contains(&part.body)),
        at: part.at,
        along: part.along,
        angle: part.angle,
    });
    planned.collect()
}

/// The reactions of welds, behind those of all groups, from the links whose frames bodies have outwards.
pub(super) fn welds(structure: &Structure, plan: &mut Plan) {
    for (i, joint) in structure.replaced.joints.iter().enumerate() {
        let JointKind::Weld { part, at, base, .. } = joint.kind else { continue };
        let slot = plan.reactions.len();
        plan.reactions.push(GroupJoint {
            joint: JointId(i),
            body: part,
            base,
            inner: false,
            prismatic: false,
        });
        plan.welds.push(PlannedWeld { slot, part: Anchor { body: part.0, at }, base: base.0 });
    }
}
