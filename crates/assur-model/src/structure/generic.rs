//! A mechanism at random dimensions in a random position: what its joints let move there they let move almost everywhere.
//! Only what the text makes one stays one: a point of a link that several joints share is one point for all of them, and
//! a line that several joints share has one direction. A pin that would bring two points of one link together holds nowhere: it has a
//! place of its own.

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
    /// Pins that would bring two points of one link together.
    pub(super) split: Vec<Split>,
}

/// A pin that would bring two points of one link together: it cannot hold.
#[derive(Clone, Copy)]
pub(super) struct Split {
    pub joint: JointId,
    pub body: BodyId,
    /// In the frame of the body, m.
    pub points: [Vec2; 2],
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
                    points.pin(i, real.map(|(body, at)| (*body, bits(*at, Vec2::zero()))).collect());
                }
                JointKind::Prismatic { slider, guide, through, along, .. } => {
                    if is_link(replaced, *guide) && !replaced.bodies[slider.0].on_rim {
                        directions.join(i, (*guide, bits(*through, *along)));
                    }
                }
                JointKind::Weld { .. } | JointKind::Law(_) => {}
            }
        }
        let (at, split) = (points.first.clone(), std::mem::take(&mut points.split));
        Self { points: points.vectors(0), directions: directions.vectors(1 << 40), at, split }
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
    split: Vec<Split>,
}

impl Classes {
    fn new(joints: usize) -> Self {
        Self { first: BTreeMap::new(), parent: (0..joints).collect(), split: Vec::new() }
    }

    fn root(&self, mut at: usize) -> usize {
        while self.parent[at] != at {
            at = self.parent[at];
        }
        at
    }

    /// Puts a joint into the classes of its names, unless a body would have two of them in one.
    fn pin(&mut self, joint: usize, names: Vec<Name>) {
        let classes: Vec<usize> =
            names.iter().filter_map(|n| self.first.get(n)).map(|j| self.root(*j)).collect();
        let known = self.first.iter().filter(|(_, joint)| classes.contains(&self.root(**joint)));
        let mut all: Vec<Name> = known.map(|(name, _)| *name).chain(names.iter().copied()).collect();
        all.sort_unstable();
        all.dedup();
        let Some(two) = all.windows(2).find(|two| two[0].0 == two[1].0) else {
            return names.into_iter().for_each(|name| self.join(joint, name));
        };
        let points = [two[0].1, two[1].1].map(|[x, y, ..]| Vec2::new(f64::from_bits(x), f64::from_bits(y)));
        self.split.push(Split { joint: JointId(joint), body: two[0].0, points });
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
