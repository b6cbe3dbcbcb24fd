//! A mechanism at random dimensions in a random position: what its joints let move there they let move almost everywhere.
//! Only what the text makes one stays one: a point of a link that several joints share is one point for all of them, and
//! a line that several joints share has one direction.

use std::collections::HashMap;

use super::field::Number;
use super::joint::{BodyId, BodyOrigin, JointId, JointKind, Replaced};
use crate::math::Vec2;

/// A vector over the prime field.
pub(super) type Vector = [Number; 2];

/// Points and directions of the joints.
pub(super) struct Generic {
    points: Vec<Vector>,
    directions: Vec<Vector>,
}

/// What is one point in the world, or one direction.
#[derive(PartialEq, Eq, Hash)]
enum Name {
    /// A place of a body, or a line of it.
    Of(BodyId, Vec<u64>),
    /// What one joint has for itself.
    Joint(usize),
}

impl Generic {
    pub(super) fn new(replaced: &Replaced) -> Self {
        let (mut points, mut directions) = (Classes::default(), Classes::default());
        for (i, joint) in replaced.joints.iter().enumerate() {
            let own = points.add(Name::Joint(i));
            directions.add(Name::Joint(i));
            match &joint.kind {
                JointKind::Revolute(members) => {
                    // the profile of a designed cam moves on along the cam
                    let along_rim = members.iter().any(|m| replaced.bodies[m.0.0].on_rim);
                    let real = members.iter().filter(|m| is_link(replaced, m.0) && !along_rim);
                    for (body, at) in real {
                        let point = points.add(Name::Of(*body, bits(&[*at])));
                        points.join(own, point);
                    }
                }
                JointKind::Prismatic { slider, guide, through, along, .. } => {
                    if is_link(replaced, *guide) && !replaced.bodies[slider.0].on_rim {
                        let line = directions.add(Name::Of(*guide, bits(&[*through, *along])));
                        let own = directions.add(Name::Joint(i));
                        directions.join(own, line);
                    }
                }
                JointKind::Law(_) => {}
            }
        }
        let joints = replaced.joints.len();
        Self { points: points.vectors(joints, 0), directions: directions.vectors(joints, 1 << 40) }
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

fn bits(vectors: &[Vec2]) -> Vec<u64> {
    // −0 is 0
    vectors.iter().flat_map(|v| [(v.x + 0.0).to_bits(), (v.y + 0.0).to_bits()]).collect()
}

/// Names that stand for one and the same.
#[derive(Default)]
struct Classes {
    index: HashMap<Name, usize>,
    parent: Vec<usize>,
}

impl Classes {
    fn add(&mut self, name: Name) -> usize {
        let next = self.parent.len();
        let index = *self.index.entry(name).or_insert(next);
        if index == next {
            self.parent.push(next);
        }
        index
    }

    fn root(&self, mut at: usize) -> usize {
        while self.parent[at] != at {
            at = self.parent[at];
        }
        at
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b)] = a.min(b);
    }

    /// The random vector of every joint.
    fn vectors(&self, joints: usize, seed: u64) -> Vec<Vector> {
        let root = |i| self.index.get(&Name::Joint(i)).map_or(0, |&own| self.root(own) as u64);
        (0..joints).map(|i| [0, 1].map(|k| Number::random(seed + 2 * root(i) + k))).collect()
    }
}
