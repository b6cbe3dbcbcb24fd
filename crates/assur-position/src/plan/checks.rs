//! The equations by which a position is checked, which the closed forms do not use: laid out once, so that a position looks up
//! nothing.

use super::planned::Plan;
use crate::math::Vec2;
use crate::model::{Axis, BalanceKind, DriveTarget, LinkId, Mechanism, PairId};
use crate::structure::{BodyId, BodyOrigin, EffortKind, EffortSource, JointKind, Structure};

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
    /// Bodies whose motion is not given, and parts of bodies.
    pub free: Vec<usize>,
    /// What the elements of friction rub against each other.
    pub rubbing: Vec<[usize; 2]>,
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
        /// What slides on what: bodies, or parts of them.
        held: [usize; 2],
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
            JointKind::Weld { .. } | JointKind::Law(_) => continue,
        };
        if !mechanism.is_by_law(joint.pair) {
            joints.push(check);
        }
    }
    moving.extend(structure.drives.iter().filter_map(|drive| match drive.kind {
        EffortKind::Place(body, at, Axis::X) => Some((body.0, at)),
        _ => None,
    }));
    Checks {
        joints,
        moving,
        reactions: (0..plan.reactions.len()).map(|slot| reaction(mechanism, structure, plan, slot)).collect(),
        efforts: efforts(mechanism, structure).collect(),
        free: (0..replaced.bodies.len())
            .filter(|&slot| !replaced.bodies[slot].known || replaced.part(LinkId::at(slot)).is_some())
            .collect(),
        rubbing: plan
            .friction
            .iter()
            .map(|e| held(mechanism, structure, e.pair, [e.through, e.base]))
            .collect(),
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
        self.efforts.clear();
        self.efforts.extend(efforts(mechanism, structure));
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
        JointKind::Weld { part, at, .. } => ((part.0, *at), None),
        JointKind::Law(_) => return None,
    };
    let [body, base] = held(mechanism, structure, joint.pair, [reaction.body.0, reaction.base.0]);
    Some(ReactionCheck { at, body, base, driven })
}

/// The links, bodies or parts of bodies, by which a pair holds bodies.
fn held(mechanism: &Mechanism, structure: &Structure, pair: PairId, bodies: [usize; 2]) -> [usize; 2] {
    bodies.map(|body| structure.replaced.held_by(mechanism, pair, BodyId(body)).0)
}

/// The places where unknown efforts act.
fn efforts<'s>(
    mechanism: &'s Mechanism,
    structure: &'s Structure,
) -> impl Iterator<Item = (usize, EffortCheck)> + 's {
    let all = structure.efforts.iter().enumerate();
    let places = all.flat_map(|(slot, effort)| {
        effort.places().enumerate().map(move |(place, kind)| (slot, kind, effort.source, place))
    });
    places.filter_map(move |(slot, kind, source, place)| {
        let link = link_of(mechanism, source, place);
        Some((slot, effort(mechanism, structure, kind, link)?))
    })
}

/// The link on which an effort acts at one of its places, where it names one.
fn link_of(mechanism: &Mechanism, source: EffortSource, place: usize) -> Option<LinkId> {
    match source {
        EffortSource::Drive(id) => match mechanism.drives[id.index()].target {
            DriveTarget::Link(link) if place == 0 => Some(link),
            _ => None,
        },
        EffortSource::Balance(id) => match mechanism.balances[id.index()].kind.places().get(place)? {
            BalanceKind::Torque(link) | BalanceKind::Force { on: link, .. } => Some(*link),
            BalanceKind::InPair(_) | BalanceKind::Several(_) => None,
        },
    }
}

fn effort(
    mechanism: &Mechanism,
    structure: &Structure,
    kind: EffortKind,
    link: Option<LinkId>,
) -> Option<EffortCheck> {
    let replaced = &structure.replaced;
    let named =
        |body: BodyId| link.filter(|link| replaced.body_of(*link) == body).map_or(body.0, LinkId::index);
    match kind {
        EffortKind::Angle(body) => Some(EffortCheck::Torque(named(body))),
        EffortKind::RelativeAngle { first, second, joint } => {
            let pair = replaced.joint(joint).pair;
            let [first, second] = held(mechanism, structure, pair, [first.0, second.0]);
            Some(EffortCheck::Between(first, second))
        }
        EffortKind::Line(body) => Some(EffortCheck::Line(named(body))),
        EffortKind::Coordinate(joint) => match replaced.joint(joint).kind {
            JointKind::Prismatic { slider, point, direction, guide, along, .. } => {
                let pair = replaced.joint(joint).pair;
                let held = held(mechanism, structure, pair, [slider.0, guide.0]);
                Some(EffortCheck::Along { held, slider: (slider.0, point), direction, guide: guide.0, along })
            }
            JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => None,
        },
        EffortKind::Point(_) | EffortKind::Place(..) => None,
    }
}
