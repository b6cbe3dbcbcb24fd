//! A mechanism at random dimensions in a random position: what its joints let move there they let move almost everywhere.
//! Only what the text makes one stays one: a point of a link that several joints share is one point for all of them, and
//! a line that several joints share has one direction.

use std::collections::BTreeMap;

use super::echelon::Number;
use super::joint::{BodyId, BodyOrigin, JointId, JointKind, Replaced};
use crate::math::Vec2;

/// A vector over the prime field.
pub(super) type Vector = [Number; 2];

/// Points and directions of the joints.
#[derive(Clone)]
pub(super) struct Generic {
    points: Vec<Vector>,
    directions: Vec<Vector>,
    /// A joint at each point of a link that has one.
    at: BTreeMap<Name, usize>,
}

/// A place of a body, or a line of it.
type Name = (BodyId, [u64; 4]);

impl Generic {
    pub(super) fn new(replaced: &Replaced) -> Self {
        let joints = replaced.joints.len();
        let (mut points, mut directions) = (Classes::new(joints), Classes::new(joints));
        for (i, joint) in replaced.joints.iter().enumerate() {
            match &joint.kind {
                JointKind::Revolute(members) => {
                    // the profile of a designed cam moves on along the cam
                    let along_rim = members.iter().any(|m| replaced.bodies[m.0.0].on_rim);
                    let real = members.iter().filter(|m| is_link(replaced, m.0) && !along_rim);
                    for (body, at) in real {
                        points.join(i, (*body, bits(*at, Vec2::new(0.0, 0.0))));
                    }
                }
                JointKind::Prismatic { slider, guide, through, along, .. } => {
                    if is_link(replaced, *guide) && !replaced.bodies[slider.0].on_rim {
                        directions.join(i, (*guide, bits(*through, *along)));
                    }
                }
                JointKind::Weld { .. } | JointKind::Law(_) => {}
            }
        }
        let (at, points) = (points.first.clone(), points.vectors(0));
        Self { points, directions: directions.vectors(1 << 40), at }
    }

    /// The place of a point of a link in the world.
    pub(super) fn place(&self, body: BodyId, at: Vec2) -> Vector {
        let name = (body, bits(at, Vec2::new(0.0, 0.0)));
        let seed = || name.1.iter().fold(body.0 as u64, |sum, bits| sum.rotate_left(21) ^ bits);
        self.at
            .get(&name)
            .map_or_else(|| [0, 1].map(|k| Number::random(seed() ^ k)), |&joint| self.points[joint])
    }

    /// The place of a joint in the world.
    pub(super) fn point(&self, joint: JointId) -> Vector {
        self.points[joint.0]
    }

    /// The direction of a prismatic joint in the world.
    pub(super) fn direction(&self, joint: JointId) -> Vector {
        self.directions[joint.0]
    }
}

fn is_link(replaced: &Replaced, body: BodyId) -> bool {
    matches!(replaced.bodies[body.0].origin, BodyOrigin::Link(_))
}

fn bits(first: Vec2, second: Vec2) -> [u64; 4] {
    // −0 is 0
    [first.x, first.y, second.x, second.y].map(|x| (x + 0.0).to_bits())
}

/// Joints whose places, or whose directions, are one.
struct Classes {
    /// A joint of every name.
    first: BTreeMap<Name, usize>,
    /// Of every joint, one of its class before it, or itself.
    parent: Vec<usize>,
}

impl Classes {
    fn new(joints: usize) -> Self {
        Self { first: BTreeMap::new(), parent: (0..joints).collect() }
    }

    fn root(&self, mut at: usize) -> usize {
        while self.parent[at] != at {
            at = self.parent[at];
        }
        at
    }

    /// Puts a joint into the class of a name.
    fn join(&mut self, joint: usize, name: Name) {
        let first = *self.first.entry(name).or_insert(joint);
        let (a, b) = (self.root(joint), self.root(first));
        self.parent[a.max(b)] = a.min(b);
    }

    /// The random vector of every joint.
    fn vectors(&self, seed: u64) -> Vec<Vector> {
        let root = |i| self.root(i) as u64;
        (0..self.parent.len()).map(|i| [0, 1].map(|k| Number::random(seed + 2 * root(i) + k))).collect()
    }
}
