//! The equations by which a position is checked, which the closed forms do not use: laid out once, so that a position looks up
//! nothing.

use super::planned::Plan;
use crate::math::Vec2;
use crate::model::Mechanism;
use crate::structure::{BodyId, BodyOrigin, EffortKind, JointKind, Structure};

/// What joints join, what acts on bodies, and what moves.
#[derive(Clone, Debug, Default)]
pub struct Checks {
    /// Joints whose parts must meet, those of designed cams and Geneva wheels left out.
    pub joints: Vec<JointCheck>,
    /// Joined points: the greatest speed is one of theirs.
    pub moving: Vec<(usize, Vec2)>,
    /// By slot of the reaction; `None` for a law.
    pub reactions: Vec<Option<ReactionCheck>>,
    /// Slots of unknown efforts, with the places where each acts.
    pub efforts: Vec<(usize, EffortCheck)>,
    /// Bodies whose motion is not given.
    pub free: Vec<usize>,
}

/// What a joint joins: slots of bodies, places in their frames, m.
#[derive(Clone, Debug)]
pub enum JointCheck {
    Hinge(Vec<(usize, Vec2)>),
    /// A body on a line.
    Guide {
        /// The sliding body and its point.
        slider: (usize, Vec2),
        /// Its unit direction along the line.
        direction: Vec2,
        /// The body that carries the line, and the line's origin.
        guide: (usize, Vec2),
        /// Unit direction of the line.
        along: Vec2,
        /// Distance of the point from the line, m.
        offset: f64,
    },
}

/// Where a reaction acts.
#[derive(Clone, Copy, Debug)]
pub struct ReactionCheck {
    /// Body and point of the place.
    pub at: (usize, Vec2),
    /// The body it acts on.
    pub body: usize,
    pub base: usize,
    /// The point of the other body, where that is one of given motion and the joint a hinge.
    pub driven: Option<Vec2>,
}

/// Where an unknown effort acts.
#[derive(Clone, Copy, Debug)]
pub enum EffortCheck {
    /// A torque on a body from outside.
    Torque(usize),
    /// A torque of the first body on the second.
    Between(usize, usize),
    /// A force along the effort's line on a body.
    Line(usize),
    /// A force on a sliding body along its direction, in its point, from its guide.
    Along {
        /// The sliding body and its point.
        slider: (usize, Vec2),
        /// Its unit direction along the line.
        direction: Vec2,
        /// The body that carries the line.
        guide: usize,
        /// Unit direction of the line.
        along: Vec2,
    },
}

/// The checks of a plan whose forces are planned.
pub(super) fn plan(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> Checks {
    let replaced = &structure.replaced;
    let mut joints = Vec::with_capacity(replaced.joints.len());
    let mut moving = Vec::with_capacity(2 * replaced.joints.len());
    for joint in &replaced.joints {
        let check = match &joint.kind {
            JointKind::Revolute(members) => {
                let members: Vec<_> = members.iter().map(|(body, at)| (body.0, *at)).collect();
                moving.extend_from_slice(&members);
                JointCheck::Hinge(members)
            }
            JointKind::Prismatic { slider, point, direction, guide, through, along, offset, .. } => {
                let (slider, guide) = ((slider.0, *point), (guide.0, *through));
                moving.extend([slider, guide]);
                let (direction, along, offset) = (*direction, *along, *offset);
                JointCheck::Guide { slider, direction, guide, along, offset }
            }
            JointKind::Law(_) => continue,
        };
        if !mechanism.is_by_law(joint.pair) {
            joints.push(check);
        }
    }
    let places = structure.efforts.iter().enumerate();
    let places = places.flat_map(|(slot, effort)| effort.places().map(move |kind| (slot, kind)));
    Checks {
        joints,
        moving,
        reactions: (0..plan.reactions.len()).map(|slot| reaction(mechanism, structure, plan, slot)).collect(),
        efforts: places.filter_map(|(slot, kind)| Some((slot, effort(structure, kind)?))).collect(),
        free: (0..replaced.bodies.len()).filter(|&slot| !replaced.bodies[slot].known).collect(),
    }
}

impl Checks {
    /// Takes over the numbers of joints of a structure without cams and Geneva wheels that differs in nothing else.
    pub(super) fn renumber_joints(&mut self, structure: &Structure) {
        self.moving.clear();
        for (check, joint) in self.joints.iter_mut().zip(&structure.replaced.joints) {
            match (check, &joint.kind) {
                (JointCheck::Hinge(points), JointKind::Revolute(members)) => {
                    points.iter_mut().zip(members).for_each(|(point, member)| point.1 = member.1);
                    self.moving.extend_from_slice(points);
                }
                (
                    JointCheck::Guide { slider, direction, guide, along, .. },
                    JointKind::Prismatic { point, direction: lies, through, along: runs, .. },
                ) => {
                    (slider.1, guide.1, *direction, *along) = (*point, *through, *lies, *runs);
                    self.moving.extend([*slider, *guide]);
                }
                _ => {}
            }
        }
    }

    /// The same for what acts on bodies.
    pub(super) fn renumber_forces(&mut self, mechanism: &Mechanism, structure: &Structure, plan: &Plan) {
        for (slot, check) in self.reactions.iter_mut().enumerate() {
            *check = reaction(mechanism, structure, plan, slot);
        }
        let places = structure.efforts.iter().enumerate();
        let places = places.flat_map(|(slot, effort)| effort.places().map(move |kind| (slot, kind)));
        self.efforts.clear();
        self.efforts.extend(places.filter_map(|(slot, kind)| Some((slot, effort(structure, kind)?))));
    }
}

fn reaction(mechanism: &Mechanism, structure: &Structure, plan: &Plan, slot: usize) -> Option<ReactionCheck> {
    let replaced = &structure.replaced;
    let reaction = &plan.reactions[slot];
    let joint = replaced.joint(reaction.joint);
    let (at, driven) = match &joint.kind {
        JointKind::Revolute(members) => {
            // the block of a cam's contact has its hinge at its origin, wherever on the cam that is
            let is_block = |b: BodyId| replaced.bodies[b.0].origin == BodyOrigin::Imaginary(joint.pair);
            let by_law = mechanism.is_by_law(joint.pair);
            let block = members.iter().find(|m| by_law && is_block(m.0));
            let of = |body: BodyId| members.iter().find(move |m| m.0 == body);
            let place = block.or_else(|| of(reaction.body));
            let given = replaced.bodies[reaction.base.0].known;
            let driven = given.then(|| of(reaction.base).map_or(Vec2::zero(), |m| m.1));
            (place.map_or((reaction.body.0, Vec2::zero()), |m| (m.0.0, m.1)), driven)
        }
        JointKind::Prismatic { slider, point, .. } => ((slider.0, *point), None),
        JointKind::Law(_) => return None,
    };
    Some(ReactionCheck { at, body: reaction.body.0, base: reaction.base.0, driven })
}

fn effort(structure: &Structure, kind: EffortKind) -> Option<EffortCheck> {
    match kind {
        EffortKind::Angle(body) => Some(EffortCheck::Torque(body.0)),
        EffortKind::RelativeAngle { first, second, .. } => Some(EffortCheck::Between(first.0, second.0)),
        EffortKind::Line(body) => Some(EffortCheck::Line(body.0)),
        EffortKind::Coordinate(joint) => match structure.replaced.joint(joint).kind {
            JointKind::Prismatic { slider, point, direction, guide, along, .. } => {
                Some(EffortCheck::Along { slider: (slider.0, point), direction, guide: guide.0, along })
            }
            JointKind::Revolute(_) | JointKind::Law(_) => None,
        },
        EffortKind::Point(_) => None,
    }
}
