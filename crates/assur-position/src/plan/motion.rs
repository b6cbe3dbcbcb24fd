//! Steps of motion, one per structural group.

use super::exact_vec::ExactVec;
use super::geometry::{anchor, arm, leg, pin, pin_arm, slide};
use super::planned::Plan;
use super::step::{DrivenJoint, DrivenLeg, MotionStep};
use super::train_step::TrainMember;
use crate::group::rrr::Sides;
use crate::math::Vec2;
use crate::model::{Axis, Mechanism};
use crate::structure::{Dyad, EffortKind, EffortSource, Group, GroupKind, Structure};

pub(super) fn plan(mechanism: &Mechanism, structure: &Structure, plan: &mut Plan) {
    plan.motion.reserve_exact(structure.motion.len());
    for (branch, group) in structure.motion.iter().enumerate() {
        let by_law = super::cam::step(mechanism, structure, group, branch, plan)
            .or_else(|| super::geneva::step(mechanism, structure, group, branch, plan));
        if let Some(step) = by_law {
            plan.motion.push(step);
            continue;
        }
        let aside = |effort: &usize| structure.drives[*effort].is_aside();
        let step = match group.kind {
            // the angles of other axes than those of bodies
            GroupKind::Train | GroupKind::DrivenLegs(_) if group.efforts.iter().any(aside) => None,
            GroupKind::Triad => super::triad::motion(structure, group, branch),
            GroupKind::Train => {
                let train = super::train::motion(structure, group, plan);
                let bodies = train.members.iter().filter_map(|m| match m {
                    TrainMember::Turn { body, .. } => Some(*body),
                    TrainMember::Shift(_) => None,
                });
                plan.turning.extend(bodies);
                plan.trains.push(train);
                Some(MotionStep::Train { branch, train: plan.trains.len() - 1 })
            }
            _ => closed(structure, group, branch),
        };
        let step = step.unwrap_or_else(|| {
            let general = super::general::problem(structure, group, plan);
            plan.turning.extend(general.turning.iter().filter(|&&(_, member, _)| member).map(|t| t.0));
            plan.general.push(general);
            MotionStep::General { branch, problem: plan.general.len() - 1 }
        });
        plan.motion.push(step);
    }
}

/// The step of a group that has a closed form and no memory of its own.
pub(super) fn closed(structure: &Structure, group: &Group, branch: usize) -> Option<MotionStep> {
    match group.kind {
        GroupKind::Driven => driven(structure, group, branch),
        GroupKind::Free => free(structure, group, branch),
        GroupKind::Dyad(kind) => Some(dyad(structure, group, branch, kind)),
        GroupKind::Translation => Some(MotionStep::Translation {
            branch,
            slides: [0, 1].map(|i| slide(&structure.replaced, group.joints[i], group.joints[i].base)),
        }),
        GroupKind::DrivenLegs(kind) => driven_legs(structure, group, branch, kind),
        GroupKind::Triad | GroupKind::Train | GroupKind::General => None,
    }
}

/// `None` where the effort is not one of a single joint: the general solver takes it.
fn driven(structure: &Structure, group: &Group, branch: usize) -> Option<MotionStep> {
    let (joint, body) = (group.joints[0], group.bodies[0]);
    let effort = &structure.drives[group.efforts[0]];
    let EffortSource::Drive(drive) = effort.source else { return None };
    let replaced = &structure.replaced;
    let ahead = |sign: f64| {
        let [base, own] = if sign > 0.0 { effort.axes } else { [effort.axes[1], effort.axes[0]] };
        (base != own).then(|| base.turned_back(own))
    };
    let turn = |relative, sign| MotionStep::Turn {
        ahead: ahead(sign),
        branch,
        body: body.0,
        base: anchor(replaced, joint),
        pin: pin_arm(replaced, joint, body),
        drive: drive.index(),
        relative,
        sign,
    };
    match effort.kind {
        EffortKind::Angle(_) => Some(turn(false, 1.0)),
        EffortKind::RelativeAngle { second, .. } => Some(turn(true, if second == body { 1.0 } else { -1.0 })),
        EffortKind::Coordinate(_) => Some(MotionStep::Shift {
            branch,
            slide: slide(replaced, joint, joint.base),
            drive: drive.index(),
        }),
        EffortKind::Line(_) | EffortKind::Point(_) | EffortKind::Place(..) => None,
    }
}

fn free(structure: &Structure, group: &Group, branch: usize) -> Option<MotionStep> {
    let (mut x, mut y, mut turn, mut point) = (None, None, None, Vec2::zero());
    for &effort in &group.efforts {
        let effort = &structure.drives[effort];
        let EffortSource::Drive(drive) = effort.source else { return None };
        match effort.kind {
            EffortKind::Place(_, at, axis) => {
                point = at;
                *if axis == Axis::X { &mut x } else { &mut y } = Some(drive.index());
            }
            _ => turn = Some(drive.index()),
        }
    }
    Some(MotionStep::Free { branch, body: group.bodies[0].0, at: arm(point), place: [x?, y?], turn })
}

fn dyad(structure: &Structure, group: &Group, branch: usize, kind: Dyad) -> MotionStep {
    let replaced = &structure.replaced;
    let [first, inner, second] = [group.joints[0], group.joints[1], group.joints[2]];
    match kind {
        Dyad::Rrr => {
            let legs = [leg(replaced, first, inner), leg(replaced, second, inner)];
            MotionStep::Rrr { branch, legs, sides: Sides::new(legs[0].length, legs[1].length) }
        }
        Dyad::Rrp => {
            let slide = slide(replaced, second, second.base);
            let pin = pin(replaced, inner, second.body);
            let from_point = ExactVec::between(slide.point, pin).in_axes(slide.direction);
            MotionStep::Rrp { branch, leg: leg(replaced, first, inner), slide, pin: arm(pin), from_point }
        }
        Dyad::Rpr => {
            let slide = slide(replaced, inner, first.body);
            let pins = [pin(replaced, first, first.body), pin(replaced, second, second.body)];
            MotionStep::Rpr {
                branch,
                bases: [anchor(replaced, first), anchor(replaced, second)],
                from_origin: ExactVec::between(slide.origin, pins[0]).in_axes(slide.along),
                from_point: ExactVec::between(slide.point, pins[1]).in_axes(slide.direction),
                pins: pins.map(arm),
                slide,
            }
        }
        Dyad::Prp => {
            let slides = [slide(replaced, first, first.base), slide(replaced, second, second.base)];
            let pins = [pin(replaced, inner, first.body), pin(replaced, inner, second.body)];
            let from_point =
                [0, 1].map(|i| ExactVec::between(slides[i].point, pins[i]).in_axes(slides[i].direction));
            MotionStep::Prp { branch, slides, pins: pins.map(arm), from_point }
        }
        Dyad::Rpp => MotionStep::Rpp {
            branch,
            base: anchor(replaced, first),
            pin: pin_arm(replaced, first, first.body),
            inner: slide(replaced, inner, second.body),
            outer: slide(replaced, second, second.base),
        },
    }
}

fn driven_legs(structure: &Structure, group: &Group, branch: usize, kind: Dyad) -> Option<MotionStep> {
    let replaced = &structure.replaced;
    let second = group.joints[2];
    if kind == Dyad::Rrr {
        let legs = [driven_leg(structure, group, 0)?, driven_leg(structure, group, 2)?];
        return Some(MotionStep::DrivenRrr { branch, legs });
    }
    let slide = slide(replaced, second, second.base);
    let pin = pin(replaced, group.joints[1], second.body);
    let from_point = ExactVec::between(slide.point, pin).in_axes(slide.direction);
    Some(MotionStep::DrivenRrp {
        branch,
        leg: driven_leg(structure, group, 0)?,
        slide,
        pin: arm(pin),
        from_point,
    })
}

/// The leg that depends on the outer joint of this index.
fn driven_leg(structure: &Structure, group: &Group, outer: usize) -> Option<DrivenLeg> {
    let replaced = &structure.replaced;
    let (outer, inner) = (group.joints[outer], group.joints[1]);
    let from = pin(replaced, outer, outer.body);
    let leg = DrivenLeg {
        body: outer.body.0,
        base: anchor(replaced, outer),
        pin: arm(from),
        arm: ExactVec::between(from, pin(replaced, inner, outer.body)),
        joint: None,
    };
    let Some(&joint) = group.joints[3..].iter().find(|j| j.base == outer.body) else { return Some(leg) };
    let (kind, drive) = group.efforts.iter().find_map(|&e| {
        let effort = &structure.drives[e];
        let EffortSource::Drive(drive) = effort.source else { return None };
        match effort.kind {
            EffortKind::Coordinate(j) | EffortKind::RelativeAngle { joint: j, .. } if j == joint.joint => {
                Some((effort.kind, drive.index()))
            }
            _ => None,
        }
    })?;
    let to = pin(replaced, inner, joint.body);
    Some(match kind {
        EffortKind::RelativeAngle { second, .. } => {
            let base = anchor(replaced, joint);
            let hinge = pin(replaced, joint, joint.body);
            let sign = if second == joint.body { 1.0 } else { -1.0 };
            let (pin, to_inner) = (arm(hinge), ExactVec::between(hinge, to));
            let turn = DrivenJoint::Turn { base, body: joint.body.0, pin, arm: to_inner, drive, sign };
            DrivenLeg { arm: ExactVec::between(from, base.at), joint: Some(turn), ..leg }
        }
        _ => {
            let slide = slide(replaced, joint, joint.base);
            let inner = ExactVec::between(slide.point, to).carried(slide.direction, slide.along);
            let arm = ExactVec::between(from, slide.origin).plus(inner);
            DrivenLeg { arm, joint: Some(DrivenJoint::Shift { slide, drive }), ..leg }
        }
    })
}
