//! Steps of forces, one per structural group, from the outermost loads to the efforts.

use super::exact_vec::ExactVec;
use super::force_step::{DrivenPart, EffortLine, ForceStep, Inner};
use super::geometry::{guide, hinge, pin, pin_arm};
use super::joint::OuterJoint;
use super::planned::Plan;
use super::step::MotionStep;
use crate::structure::{Dyad, EffortKind, Group, GroupJoint, GroupKind, Structure};

pub(super) fn plan(structure: &Structure, plan: &mut Plan) {
    let moved_by = MovedBy::of(structure);
    plan.forces.reserve_exact(structure.forces.len());
    plan.reactions.reserve_exact(structure.forces.iter().map(|group| group.joints.len()).sum());
    for group in &structure.forces {
        let first = plan.reactions.len();
        plan.reactions.extend(group.joints.iter().copied());
        let step = match group.kind {
            GroupKind::Triad | GroupKind::General if group.laws.is_empty() => {
                super::triad::forces(structure, group, first)
            }
            GroupKind::Train => {
                plan.train_forces.push(super::train::forces(structure, group, first, plan));
                Some(ForceStep::Train { train: plan.train_forces.len() - 1 })
            }
            _ => closed(structure, group, first, plan, moved_by.same(structure, group)),
        };
        let step = step.unwrap_or_else(|| {
            plan.balance_systems.push(super::general::balance_system(structure, group, first, plan));
            ForceStep::General { system: plan.balance_systems.len() - 1 }
        });
        plan.forces.push(step);
    }
}

/// The step of a group that has a closed form and no memory of its own; its reactions begin at slot `first`, and this step
/// of motion moves it.
pub(super) fn closed(
    structure: &Structure,
    group: &Group,
    first: usize,
    plan: &Plan,
    moved_by: Option<usize>,
) -> Option<ForceStep> {
    match group.kind {
        GroupKind::Driven => driven(structure, group, first),
        GroupKind::Dyad(kind) => Some(dyad(structure, group, first, kind, (plan, moved_by))),
        GroupKind::Translation => Some(ForceStep::Translation {
            ways: [0, 1].map(|i| guide(structure, group.joints[i], first + i)),
        }),
        GroupKind::DrivenLegs(kind) => driven_legs(structure, group, first, kind),
        GroupKind::Free | GroupKind::Triad | GroupKind::Train | GroupKind::General => None,
    }
}

/// The line of an effort with the sign with which a positive value acts on `body`.
pub(super) fn effort_line(
    structure: &Structure,
    effort: usize,
    body: usize,
    joint: Option<(GroupJoint, usize)>,
) -> Option<(EffortLine, f64)> {
    match structure.efforts[effort].kind {
        EffortKind::Angle(b) => Some((EffortLine::Torque { body: b.0, base: 0 }, 1.0)),
        EffortKind::RelativeAngle { first, second, .. } => {
            let other = if second.0 == body { first } else { second };
            Some((EffortLine::Torque { body, base: other.0 }, if second.0 == body { 1.0 } else { -1.0 }))
        }
        EffortKind::Line(b) => Some((EffortLine::Force { body: b.0, line: effort }, 1.0)),
        EffortKind::Coordinate(_) => {
            let (joint, slot) = joint?;
            let guide = guide(structure, joint, slot);
            Some((EffortLine::Along(guide), if guide.slider == body { 1.0 } else { -1.0 }))
        }
        EffortKind::Point(_) | EffortKind::Place(..) => None,
    }
}

/// One body, one joint, one effort; `None` where the effort stands in another joint.
fn driven(structure: &Structure, group: &Group, slot: usize) -> Option<ForceStep> {
    let (joint, body) = (group.joints[0], group.bodies[0]);
    let index = group.efforts[0];
    let (effort, sign) = effort_line(structure, index, body.0, Some((joint, slot)))?;
    if let EffortLine::Torque { base, .. } = effort
        && base != 0
        && base != joint.base.0
    {
        return None;
    }
    let value = (index, sign);
    Some(if joint.prismatic {
        ForceStep::Shift { guide: guide(structure, joint, slot), effort, value }
    } else {
        ForceStep::Turn { hinge: hinge(structure, joint, slot), effort, value }
    })
}

fn dyad(
    structure: &Structure,
    group: &Group,
    first_slot: usize,
    kind: Dyad,
    (plan, moved_by): (&Plan, Option<usize>),
) -> ForceStep {
    let [first, inner, second] = [group.joints[0], group.joints[1], group.joints[2]];
    let hinge_of = |i: usize| hinge(structure, group.joints[i], first_slot + i);
    let way_of = |i: usize| guide(structure, group.joints[i], first_slot + i);
    let inner_hinge = || Inner {
        pin: pin(&structure.replaced, inner, first.body),
        second_pin: pin_arm(&structure.replaced, inner, second.body),
        on_rim: plan.cams.iter().any(|cam| {
            let bodies = [cam.contact.disk.index(), cam.block];
            cam.contact.face.is_some() && bodies == [first.body.0, second.body.0]
        }),
        arms: [first, second].map(|o| {
            ExactVec::between(pin(&structure.replaced, o, o.body), pin(&structure.replaced, inner, o.body))
        }),
        slot: first_slot + 1,
        sign: if inner.body == second.body { 1.0 } else { -1.0 },
    };
    // the follower of a cam is moved by its law: such a step leaves nothing behind for the forces
    let leaves = |&step: &usize| {
        matches!(plan.motion.get(step), Some(MotionStep::Rrr { .. } | MotionStep::Rrp { .. }))
    };
    let motion = moved_by.filter(leaves);
    match kind {
        Dyad::Rrr => ForceStep::Rrr { outer: [hinge_of(0), hinge_of(2)], inner: inner_hinge(), motion },
        Dyad::Rrp => ForceStep::Rrp { outer: hinge_of(0), inner: inner_hinge(), guide: way_of(2), motion },
        Dyad::Rpr => ForceStep::Rpr { outer: [hinge_of(0), hinge_of(2)], guide: way_of(1) },
        Dyad::Prp => ForceStep::Prp { ways: [way_of(0), way_of(2)], inner: inner_hinge() },
        Dyad::Rpp => ForceStep::Rpp { outer: hinge_of(0), inner: way_of(1), guide: way_of(2) },
    }
}

/// The step of motion of every body.
struct MovedBy(Vec<Option<usize>>);

impl MovedBy {
    fn of(structure: &Structure) -> Self {
        let mut steps = vec![None; structure.replaced.bodies.len()];
        for (step, group) in structure.motion.iter().enumerate() {
            group.bodies.iter().for_each(|b| steps[b.0] = Some(step));
        }
        Self(steps)
    }

    /// The step of motion of the group, where motion has the same dyad with the same first link.
    fn same(&self, structure: &Structure, group: &Group) -> Option<usize> {
        let step = self.0[group.bodies.first()?.0]?;
        let m = &structure.motion[step];
        let joints = m.joints.iter().map(|j| j.joint).eq(group.joints.iter().map(|j| j.joint));
        (m.kind == group.kind && m.bodies == group.bodies && joints).then_some(step)
    }
}

fn driven_legs(structure: &Structure, group: &Group, first_slot: usize, kind: Dyad) -> Option<ForceStep> {
    let [first, inner, second] = [group.joints[0], group.joints[1], group.joints[2]];
    let far = |root| group.joints[3..].iter().position(|j| j.base == root);
    let end = |root| far(root).map_or(root, |i| group.joints[3 + i].body);
    let ends = [end(first.body), end(second.body)];
    let part = |root| match far(root) {
        None => Some(None),
        Some(i) => {
            let (joint, slot) = (group.joints[3 + i], first_slot + 3 + i);
            let mut inside = group.efforts.iter();
            let effort = *inside.find(|&&e| match structure.efforts[e].kind {
                EffortKind::Coordinate(j) | EffortKind::RelativeAngle { joint: j, .. } => j == joint.joint,
                _ => false,
            })?;
            let (line, sign) = effort_line(structure, effort, joint.body.0, Some((joint, slot)))?;
            let at = if joint.prismatic {
                OuterJoint::Guide(guide(structure, joint, slot))
            } else {
                OuterJoint::Hinge(hinge(structure, joint, slot))
            };
            Some(Some(DrivenPart { joint: at, effort: line, value: (effort, sign) }))
        }
    };
    let outer = if kind == Dyad::Rrp {
        OuterJoint::Guide(guide(structure, second, first_slot + 2))
    } else {
        OuterJoint::Hinge(hinge(structure, second, first_slot + 2))
    };
    let inner_hinge = Inner {
        pin: pin(&structure.replaced, inner, ends[0]),
        second_pin: pin_arm(&structure.replaced, inner, ends[1]),
        on_rim: false,
        arms: [ExactVec::default(); 2],
        slot: first_slot + 1,
        sign: if inner.body == ends[1] { 1.0 } else { -1.0 },
    };
    Some(ForceStep::DrivenLegs {
        outer: (hinge(structure, first, first_slot), outer),
        inner: inner_hinge,
        ends: ends.map(|b| b.0),
        driven: [part(first.body)?, part(second.body)?],
    })
}
