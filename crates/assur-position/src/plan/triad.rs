//! Steps of a link on three legs.

use super::force_step::ForceStep;
use super::geometry::{arm, guide, hinge, leg, pin, slide};
use super::joint::OuterJoint;
use super::step::MotionStep;
use super::triad_step::{TriadForceLeg, TriadForces, TriadHold, TriadLeg, TriadMotion};
use crate::group::triad::Plate;
use crate::math::Vec2;
use crate::structure::{BodyId, Group, GroupJoint, JointKind, Structure};

/// The link on the legs.
fn carried(group: &Group) -> BodyId {
    let (leg, inner) = (group.joints[0].body, group.joints[3]);
    if inner.body == leg { inner.base } else { inner.body }
}

fn plate(structure: &Structure, group: &Group) -> (Plate, Vec2) {
    Plate::new([3, 4, 5].map(|i| pin(&structure.replaced, group.joints[i], carried(group))))
}

/// `None` where a leg has no length: the general solver takes it.
pub(super) fn motion(structure: &Structure, group: &Group, branch: usize) -> Option<MotionStep> {
    let replaced = &structure.replaced;
    let mut legs = Vec::new();
    for i in 0..3 {
        let (outer, inner) = (group.joints[i], group.joints[3 + i]);
        if outer.prismatic {
            let slide = slide(replaced, outer, outer.base);
            let pin = pin(replaced, inner, outer.body);
            let offset = (pin - slide.point).turned_back(slide.direction).y;
            legs.push(TriadLeg::Slider { slide, pin: arm(pin), offset });
        } else {
            legs.push(TriadLeg::Link(leg(replaced, outer, inner)));
        }
    }
    let long = |leg: &TriadLeg| !matches!(leg, TriadLeg::Link(leg) if leg.length <= 0.0);
    let (plate, mean) = plate(structure, group);
    let legs: [TriadLeg; 3] = legs.try_into().ok()?;
    let triad = TriadMotion { legs, body: carried(group).0, mean, plate };
    triad.legs.iter().all(long).then(|| MotionStep::Triad { branch, triad: Box::new(triad) })
}

/// The link and its legs, each by the places of its outer and inner joint in the group; `None` for any other group.
fn legs(structure: &Structure, group: &Group) -> Option<(BodyId, [(usize, usize); 3])> {
    let passive = structure.passive.iter().any(|link| group.bodies.contains(&BodyId(link.index())));
    if group.bodies.len() != 4 || !group.efforts.is_empty() || !group.laws.is_empty() || passive {
        return None;
    }
    let joints = || group.joints.iter().enumerate();
    let redundant =
        |id| matches!(structure.replaced.joint(id).kind, JointKind::Prismatic { angle_redundant: true, .. });
    let joins = |j: &GroupJoint, body| j.inner && [j.body, j.base].contains(&body);
    let carried = *group.bodies.iter().find(|&&body| joints().filter(|j| joins(j.1, body)).count() == 3)?;
    let legs: Vec<(usize, usize)> = joints()
        .filter(|(_, outer)| !outer.inner)
        .filter_map(|(i, outer)| {
            let between = |j: &GroupJoint| joins(j, outer.body) && joins(j, carried);
            let (k, inner) = joints().find(|(_, j)| between(j))?;
            let held = !(outer.prismatic && inner.prismatic);
            (held && !redundant(outer.joint) && !redundant(inner.joint)).then_some((i, k))
        })
        .collect();
    let legs: [(usize, usize); 3] = legs.try_into().ok()?;
    let bodies = legs.map(|(outer, _)| group.joints[outer].body);
    let apart = bodies[0] != bodies[1] && bodies[1] != bodies[2] && bodies[2] != bodies[0];
    (apart && group.joints.len() == 6).then_some((carried, legs))
}

/// `None` where the group is another or a leg has no length: the general solver takes it.
pub(super) fn forces(structure: &Structure, group: &Group, first_slot: usize) -> Option<ForceStep> {
    let replaced = &structure.replaced;
    let (link, places) = legs(structure, group)?;
    let legs = places.map(|(i, k)| {
        let (outer, inner) = (group.joints[i], group.joints[k]);
        let held = if inner.prismatic {
            TriadHold::Guide(guide(structure, inner, first_slot + k))
        } else {
            let at = pin(replaced, inner, outer.body);
            let along = at - pin(replaced, outer, outer.body);
            let inverse = if outer.prismatic { 0.0 } else { 1.0 / along.norm() };
            TriadHold::Pin {
                leg: arm(at),
                link: pin(replaced, inner, link),
                slot: first_slot + k,
                sign: if inner.body == link { 1.0 } else { -1.0 },
                direction: along * inverse,
                inverse,
            }
        };
        let outer_joint = if outer.prismatic {
            OuterJoint::Guide(guide(structure, outer, first_slot + i))
        } else {
            OuterJoint::Hinge(hinge(structure, outer, first_slot + i))
        };
        TriadForceLeg { body: outer.body.0, outer: outer_joint, inner: held }
    });
    let long =
        |leg: &TriadForceLeg| !matches!(leg.inner, TriadHold::Pin { inverse, .. } if !inverse.is_finite());
    legs.iter().all(long).then(|| ForceStep::Triad(Box::new(TriadForces { legs, body: link.0 })))
}
