//! Steps of a link on three legs.

use super::force_step::{ForceStep, OuterJoint};
use super::forces::{hinge, way};
use super::geometry::{arm, leg, pin, slide};
use super::step::{Arm, Leg, MotionStep, Slide};
use crate::group::triad::Plate;
use crate::math::Vec2;
use crate::structure::{BodyId, Group, JointKind, Structure};

/// The motion of a triad.
#[derive(Clone, Debug, PartialEq)]
pub struct TriadMotion {
    /// Its legs.
    pub legs: [TriadLeg; 3],
    /// Slot of the link they carry.
    pub body: usize,
    /// The mean of its pins, in its frame, m.
    pub mean: Vec2,
    /// Its pins.
    pub plate: Plate,
}

/// A leg on the side of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TriadLeg {
    /// A link on a revolute.
    Link(Leg),
    /// A slider on a guide.
    Slider {
        /// The guide.
        slide: Slide,
        /// The inner revolute in the slider's frame, m.
        pin: Arm,
        /// The inner revolute from the sliding point to the left of the guide, m.
        offset: f64,
    },
}

/// The forces of a triad.
#[derive(Clone, Debug, PartialEq)]
pub struct TriadForces {
    /// Its legs.
    pub legs: [TriadForceLeg; 3],
    /// Slot of the link they carry.
    pub body: usize,
    /// The mean of its pins, in its frame, m.
    pub mean: Vec2,
    /// Its pins.
    pub plate: Plate,
}

/// A leg on the side of forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriadForceLeg {
    /// Slot of its body.
    pub body: usize,
    /// What it hangs on.
    pub outer: OuterJoint,
    /// The revolute to the link in the frame of the leg.
    pub pin: Arm,
    /// Slot of its reaction.
    pub slot: usize,
    /// The reaction kept is this times the force of the leg on the link.
    pub sign: f64,
    /// Unit direction from the outer revolute to the inner one in the frame of a link; of a slider nothing.
    pub direction: Vec2,
    /// 1 / length of a link, 1/m.
    pub inverse: f64,
}

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

/// `None` where a leg has no length: the general solver takes it.
pub(super) fn forces(structure: &Structure, group: &Group, first_slot: usize) -> Option<ForceStep> {
    let replaced = &structure.replaced;
    let link = carried(group);
    let legs = [0, 1, 2].map(|i| {
        let (outer, inner) = (group.joints[i], group.joints[3 + i]);
        let prismatic = matches!(replaced.joint(outer.joint).kind, JointKind::Prismatic { .. });
        let pin_at = pin(replaced, inner, outer.body);
        let along = pin_at - pin(replaced, outer, outer.body);
        let inverse = if prismatic { 0.0 } else { 1.0 / along.norm() };
        TriadForceLeg {
            body: outer.body.0,
            outer: if prismatic {
                OuterJoint::Way(way(structure, outer, first_slot + i))
            } else {
                OuterJoint::Hinge(hinge(structure, outer, first_slot + i))
            },
            pin: arm(pin_at),
            slot: first_slot + 3 + i,
            sign: if inner.body == link { 1.0 } else { -1.0 },
            direction: along * inverse,
            inverse,
        }
    });
    let (plate, mean) = plate(structure, group);
    let finite = legs.iter().all(|leg| leg.inverse.is_finite());
    finite.then(|| ForceStep::Triad(Box::new(TriadForces { legs, body: link.0, mean, plate })))
}
