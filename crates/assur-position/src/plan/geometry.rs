//! From joints to the numbers of the steps.

use super::exact_vec::ExactVec;
use super::joint::{Guide, Hinge};
use super::step::{Anchor, Arm, Leg, Slide};
use crate::math::Vec2;
use crate::structure::{BodyId, GroupJoint, JointKind, Replaced, Structure};

/// The point of a revolute joint in the frame of one of its bodies.
pub(super) fn pin(replaced: &Replaced, joint: GroupJoint, body: BodyId) -> Vec2 {
    match &replaced.joint(joint.joint).kind {
        JointKind::Revolute(members) => members.iter().find(|m| m.0 == body).map_or(Vec2::zero(), |m| m.1),
        JointKind::Prismatic { slider, point, through, .. } => {
            if *slider == body {
                *point
            } else {
                *through
            }
        }
        JointKind::Weld { .. } | JointKind::Law(_) => Vec2::zero(),
    }
}

/// A point of a body's frame as the steps hold it.
pub(super) fn arm(at: Vec2) -> Arm {
    (at != Vec2::zero()).then_some(at)
}

/// [`pin`] as the steps hold it.
pub(super) fn pin_arm(replaced: &Replaced, joint: GroupJoint, body: BodyId) -> Arm {
    arm(pin(replaced, joint, body))
}

pub(super) fn anchor(replaced: &Replaced, joint: GroupJoint) -> Anchor {
    Anchor { body: joint.base.0, at: pin(replaced, joint, joint.base) }
}

/// A prismatic joint seen from `base`: the line is the guide's where the guide is the base; else the parallel through
/// the slider's point, on which the guide's origin moves backwards.
pub(super) fn slide(replaced: &Replaced, joint: GroupJoint, base: BodyId) -> Slide {
    let JointKind::Prismatic { slider, point, direction, guide, through, along, offset, .. } =
        replaced.joint(joint.joint).kind
    else {
        return Slide {
            base: joint.base.0,
            origin: Vec2::zero(),
            along: Vec2::new(1.0, 0.0),
            body: joint.body.0,
            point: Vec2::zero(),
            direction: Vec2::new(1.0, 0.0),
            turn: Vec2::new(1.0, 0.0),
            radius: 0.0,
            sense: 1.0,
        };
    };
    if base == guide {
        Slide {
            base: guide.0,
            origin: through,
            along,
            body: slider.0,
            point,
            direction,
            turn: along.turned_back(direction),
            radius: offset,
            sense: 1.0,
        }
    } else {
        Slide {
            base: slider.0,
            origin: point,
            along: direction,
            body: guide.0,
            point: through,
            direction: along,
            turn: direction.turned_back(along),
            radius: -offset,
            sense: -1.0,
        }
    }
}

/// The leg of a dyad between its outer revolute and its inner one.
pub(super) fn leg(replaced: &Replaced, outer: GroupJoint, inner: GroupJoint) -> Leg {
    let from = pin(replaced, outer, outer.body);
    let to = pin(replaced, inner, outer.body);
    let length = (to - from).norm();
    let direction = (to - from) / length;
    Leg {
        body: outer.body.0,
        base: anchor(replaced, outer),
        pin: arm(from),
        direction,
        length,
        turn: direction / length,
        arm: ExactVec::between(from, to),
    }
}

pub(super) fn hinge(structure: &Structure, joint: GroupJoint, slot: usize) -> Hinge {
    Hinge {
        body: joint.body.0,
        pin: pin_arm(&structure.replaced, joint, joint.body),
        base: joint.base.0,
        slot,
    }
}

pub(super) fn guide(structure: &Structure, joint: GroupJoint, slot: usize) -> Guide {
    let (slider, point, direction) = match structure.replaced.joint(joint.joint).kind {
        JointKind::Prismatic { slider, point, direction, .. } => (slider, point, direction),
        JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => {
            (joint.body, Vec2::zero(), Vec2::new(1.0, 0.0))
        }
    };
    Guide { body: joint.body.0, base: joint.base.0, slider: slider.0, point, direction, slot }
}
