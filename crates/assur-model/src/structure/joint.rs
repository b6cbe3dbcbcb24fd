//! Bodies and joints of the replaced mechanism: revolute and prismatic only.

use crate::math::Vec2;
use crate::model::{LinkId, Mechanism, PairId};

/// A body of the replaced mechanism: the mechanism's links first, imaginary ones after.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(pub usize);

impl BodyId {
    pub const GROUND: Self = Self(0);
}

/// A joint of the replaced mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JointId(pub usize);

/// A body and where it comes from.
#[derive(Clone, Debug)]
pub struct Body {
    /// Where it comes from.
    pub origin: BodyOrigin,
    /// Its motion is known from outside: the ground, outer links driven at a point, and what is welded to another link.
    pub known: bool,
    /// It stands for the contact with a designed cam: its joints move on along the cam's profile.
    pub on_rim: bool,
}

/// Where a body comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyOrigin {
    /// A link of the mechanism.
    Link(LinkId),
    /// A massless link that replaces this higher pair.
    Imaginary(PairId),
}

/// A joint between bodies.
#[derive(Clone, Debug)]
pub struct Joint {
    /// The pair it belongs to.
    pub pair: PairId,
    pub kind: JointKind,
}

#[derive(Clone, Debug)]
pub enum JointKind {
    /// Points (in the frames of their bodies, m) that coincide. Two members make one lower pair, k make k − 1.
    Revolute(Vec<(BodyId, Vec2)>),
    /// A body that slides along a line without turning against it.
    Prismatic {
        slider: BodyId,
        /// Its point, in its frame, m.
        point: Vec2,
        /// Unit direction in its frame that lies along the line.
        direction: Vec2,
        /// The body that carries the line.
        guide: BodyId,
        /// Origin of the line in the guide's frame, m.
        through: Vec2,
        /// Unit direction of the line in the guide's frame.
        along: Vec2,
        /// The point keeps this distance from the line, m: the radius of a round profile. On which side is a matter of
        /// assembly.
        offset: f64,
        /// The condition on the angle follows from other prismatic pairs: it is left out, and the couple with it.
        angle_redundant: bool,
        /// The joint closes a chain of prismatic pairs: its couple is not determined.
        in_chain: bool,
    },
    /// What holds a part of a body of welded links on another part, or on the link whose frame the body has, by a point of each.
    /// No condition: they move as one.
    Weld { part: BodyId, at: Vec2, base: BodyId, on: Vec2 },
    /// A law between rates with constant coefficients: Σ coefficient × rate = 0. One condition.
    Law(Vec<(BodyRate, f64)>),
}

/// A variable of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyRate {
    /// Angular velocity of a body.
    Turn(BodyId),
    /// Rate of the coordinate of a prismatic joint.
    Slide(JointId),
}

/// A link that is welded to the one whose frame its body has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    pub body: BodyId,
    /// Its origin in the frame of the body, m.
    pub at: Vec2,
    /// Its x axis in that frame.
    pub along: Vec2,
    /// The angle of that axis, rad.
    pub angle: f64,
}

impl Part {
    pub(super) const fn own(link: usize) -> Self {
        Self { body: BodyId(link), at: Vec2::new(0.0, 0.0), along: Vec2::new(1.0, 0.0), angle: 0.0 }
    }

    pub(super) fn place(&self, at: Vec2) -> Vec2 {
        self.at + at.turned(self.along)
    }
}

/// The mechanism with every higher pair replaced.
#[derive(Clone, Debug)]
pub struct Replaced {
    /// Bodies, the links first and in their order.
    pub bodies: Vec<Body>,
    pub joints: Vec<Joint>,
    /// Links whose rotation changes nothing: it is held at zero.
    pub passive: Vec<LinkId>,
    /// Per link, where it is a part of another body; none without welds.
    pub(super) parts: Vec<Option<Part>>,
    /// The first joint that stands for each pair; the others of the pair follow it.
    pub(super) first_joint: Vec<Option<JointId>>,
}

impl Joint {
    /// The bodies it joins; of a law those that turn, of a weld none.
    #[must_use]
    pub fn bodies(&self) -> Vec<BodyId> {
        match &self.kind {
            JointKind::Revolute(members) => members.iter().map(|m| m.0).collect(),
            JointKind::Prismatic { slider, guide, .. } => vec![*slider, *guide],
            JointKind::Weld { .. } => Vec::new(),
            JointKind::Law(terms) => {
                let turning = |rate: &BodyRate| match rate {
                    BodyRate::Turn(body) => Some(*body),
                    BodyRate::Slide(_) => None,
                };
                terms.iter().filter_map(|(rate, _)| turning(rate)).collect()
            }
        }
    }
}

impl JointKind {
    /// The terms of a law.
    #[must_use]
    pub fn law(&self) -> Option<&[(BodyRate, f64)]> {
        match self {
            Self::Law(terms) => Some(terms),
            Self::Revolute(_) | Self::Prismatic { .. } | Self::Weld { .. } => None,
        }
    }

    /// Whether both join the same bodies in the same way, wherever on them.
    fn is_alike(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Revolute(a), Self::Revolute(b)) => a.iter().map(|m| m.0).eq(b.iter().map(|m| m.0)),
            (
                Self::Prismatic { slider, guide, offset, angle_redundant, in_chain, .. },
                Self::Prismatic {
                    slider: other_slider,
                    guide: other_guide,
                    offset: other_offset,
                    angle_redundant: other_redundant,
                    in_chain: other_chain,
                    ..
                },
            ) => {
                (slider, guide, angle_redundant, in_chain)
                    == (other_slider, other_guide, other_redundant, other_chain)
                    && (*offset > 0.0) == (*other_offset > 0.0)
            }
            (Self::Law(a), Self::Law(b)) => a.iter().map(|t| t.0).eq(b.iter().map(|t| t.0)),
            _ => false,
        }
    }
}

impl Replaced {
    /// The bodies that a law speaks of.
    #[must_use]
    pub fn bodies_of_law(&self, law: &[(BodyRate, f64)]) -> Vec<BodyId> {
        let bodies = law.iter().flat_map(|(rate, _)| match rate {
            BodyRate::Turn(body) => vec![*body],
            BodyRate::Slide(joint) => self.joint(*joint).bodies(),
        });
        let mut bodies: Vec<BodyId> = bodies.collect();
        bodies.sort_unstable();
        bodies.dedup();
        bodies
    }

    /// Whether bodies and joints are the same but for their numbers.
    pub(super) fn is_alike(&self, other: &Self) -> bool {
        let bodies = |r: &Self| r.bodies.iter().map(|b| (b.origin, b.known)).collect::<Vec<_>>();
        self.passive == other.passive
            && bodies(self) == bodies(other)
            && self.joints.len() == other.joints.len()
            && self
                .joints
                .iter()
                .zip(&other.joints)
                .all(|(a, b)| a.pair == b.pair && a.kind.is_alike(&b.kind))
    }

    /// The joint with this id.
    #[must_use]
    pub fn joint(&self, id: JointId) -> &Joint {
        &self.joints[id.0]
    }

    /// Prismatic pairs whose couples are not determined, in order.
    #[must_use]
    pub fn undetermined_couples(&self) -> Vec<PairId> {
        let in_chain = |j: &&Joint| matches!(j.kind, JointKind::Prismatic { in_chain: true, .. });
        let mut pairs: Vec<PairId> = self.joints.iter().filter(in_chain).map(|j| j.pair).collect();
        pairs.sort_unstable();
        pairs
    }

    /// The name of a body: its links', or that of the pair it replaces.
    #[must_use]
    pub fn body_name(&self, mechanism: &Mechanism, body: BodyId) -> String {
        match self.bodies[body.0].origin {
            BodyOrigin::Link(_) => {
                let links = self.links_of(body).into_iter().map(|link| mechanism.link(link).name.as_str());
                links.collect::<Vec<_>>().join(" + ")
            }
            BodyOrigin::Imaginary(pair) => format!("({})", mechanism.pair(pair).name),
        }
    }

    /// The joints that stand for a pair, in the order made.
    pub fn joints_of(&self, pair: PairId) -> impl Iterator<Item = JointId> + '_ {
        let first = self.first_joint.get(pair.index()).copied().flatten().map_or(self.joints.len(), |j| j.0);
        (first..self.joints.len()).map(JointId).take_while(move |j| self.joint(*j).pair == pair)
    }

    pub(super) fn push(&mut self, joint: Joint) {
        let pair = joint.pair.index();
        if self.first_joint.len() <= pair {
            self.first_joint.resize(pair + 1, None);
        }
        self.first_joint[pair].get_or_insert(JointId(self.joints.len()));
        self.joints.push(joint);
    }
}

// Joints as a group sees them.

/// A joint of a group, reduced to two bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GroupJoint {
    pub joint: JointId,
    /// Its body in the group.
    pub body: BodyId,
    /// The other body: in the group for an inner joint; else one that is known already (motion) or solved later (forces).
    pub base: BodyId,
    /// Both bodies are in the group.
    pub inner: bool,
    /// Prismatic rather than revolute.
    pub prismatic: bool,
}
