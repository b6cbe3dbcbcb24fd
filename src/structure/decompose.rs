//! Splits the bodies into structural groups.
//!
//! Every scalar condition of a joint or drive is matched to a freedom of a body it touches (on the side of forces: every
//! scalar unknown to an equation of equilibrium). Bodies that hang together in a circle through the matching form one
//! group; this is the fine decomposition of Dulmage and Mendelsohn, so that the groups are the smallest possible.

use super::effort::{Effort, EffortKind};
use super::group::{Group, GroupJoint};
use super::joint::{BodyId, Joint, JointId, JointKind, Replaced};
use super::matching::{Condition, Matching, components, match_all};

/// Which of the two dual problems is split.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// Known: the drives. A group follows those it hangs on.
    Motion,
    /// Unknown: the efforts. A group follows those that hang on it.
    Forces,
}

/// What does not match.
#[derive(Clone, Debug)]
pub(super) struct Defect {
    /// Bodies and joints (efforts by index) with too many conditions.
    pub over: Part,
    /// Bodies and joints with too few.
    pub under: Part,
}

/// Part of a mechanism.
#[derive(Clone, Debug, Default)]
pub(super) struct Part {
    pub bodies: Vec<BodyId>,
    pub joints: Vec<JointId>,
    pub efforts: Vec<usize>,
}

#[derive(Clone, Copy)]
enum Owner {
    Joint(JointId),
    Effort(usize),
    Passive,
}

/// Conditions with their owners, over nodes: two per body (place with two freedoms, angle with one), one per pin of more
/// than two links (two freedoms).
struct Incidence {
    conditions: Vec<Condition>,
    owners: Vec<Owner>,
    capacity: Vec<usize>,
    bodies: usize,
}

impl Incidence {
    fn new(replaced: &Replaced, efforts: &[Effort]) -> Self {
        let mut capacity: Vec<usize> =
            replaced.bodies.iter().flat_map(|b| if b.known { [0, 0] } else { [2, 1] }).collect();
        let mut this = Self {
            conditions: Vec::new(),
            owners: Vec::new(),
            capacity: Vec::new(),
            bodies: replaced.bodies.len(),
        };
        for (i, joint) in replaced.joints.iter().enumerate() {
            this.add_joint(replaced, JointId(i), joint, &mut capacity);
        }
        for link in &replaced.passive {
            this.add(Owner::Passive, vec![2 * link.index() + 1]);
        }
        for (i, effort) in efforts.iter().enumerate() {
            this.add_effort(replaced, i, effort);
        }
        this.capacity = capacity;
        this
    }

    fn add(&mut self, owner: Owner, nodes: Vec<usize>) {
        self.conditions.push(Condition { nodes });
        self.owners.push(owner);
    }

    fn place_and_angle(replaced: &Replaced, bodies: &[BodyId]) -> Vec<usize> {
        let unknown = bodies.iter().filter(|b| !replaced.bodies[b.0].known);
        unknown.flat_map(|b| [2 * b.0, 2 * b.0 + 1]).collect()
    }

    fn angles(replaced: &Replaced, bodies: &[BodyId]) -> Vec<usize> {
        bodies.iter().filter(|b| !replaced.bodies[b.0].known).map(|b| 2 * b.0 + 1).collect()
    }

    fn add_joint(&mut self, replaced: &Replaced, id: JointId, joint: &Joint, capacity: &mut Vec<usize>) {
        match &joint.kind {
            JointKind::Revolute(members) if members.len() > 2 => {
                let pin = capacity.len();
                capacity.push(2);
                for member in members {
                    let mut nodes = Self::place_and_angle(replaced, &[member.0]);
                    nodes.push(pin);
                    self.add(Owner::Joint(id), nodes.clone());
                    self.add(Owner::Joint(id), nodes);
                }
            }
            JointKind::Revolute(_) => {
                let nodes = Self::place_and_angle(replaced, &joint.bodies());
                self.add(Owner::Joint(id), nodes.clone());
                self.add(Owner::Joint(id), nodes);
            }
            JointKind::Prismatic { angle_redundant, .. } => {
                if !angle_redundant {
                    self.add(Owner::Joint(id), Self::angles(replaced, &joint.bodies()));
                }
                self.add(Owner::Joint(id), Self::place_and_angle(replaced, &joint.bodies()));
            }
        }
    }

    fn add_effort(&mut self, replaced: &Replaced, index: usize, effort: &Effort) {
        let bodies = effort.bodies(replaced);
        let nodes = match effort.kind {
            EffortKind::Point(_) => return,
            EffortKind::Angle(_) | EffortKind::RelativeAngle { .. } => Self::angles(replaced, &bodies),
            EffortKind::Coordinate(_) | EffortKind::Line(_) => Self::place_and_angle(replaced, &bodies),
        };
        self.add(Owner::Effort(index), nodes);
    }

    /// The body of a node, or the number of bodies plus that of the pin.
    fn vertex(&self, node: usize) -> usize {
        if node < 2 * self.bodies { node / 2 } else { node - self.bodies }
    }

    fn part(&self, (conditions, nodes): (Vec<usize>, Vec<usize>)) -> Part {
        let mut part = Part::default();
        for node in nodes {
            let vertex = self.vertex(node);
            if vertex < self.bodies && !part.bodies.contains(&BodyId(vertex)) {
                part.bodies.push(BodyId(vertex));
            }
        }
        for condition in conditions {
            match self.owners[condition] {
                Owner::Joint(j) if !part.joints.contains(&j) => part.joints.push(j),
                Owner::Effort(e) => part.efforts.push(e),
                _ => {}
            }
        }
        part
    }
}

/// Groups in the order of solution.
pub(super) fn decompose(
    replaced: &Replaced,
    efforts: &[Effort],
    side: Side,
) -> Result<Vec<Group>, Box<Defect>> {
    let incidence = Incidence::new(replaced, efforts);
    let matching = match_all(&incidence.conditions, &incidence.capacity);
    let over = matching.overdetermined(&incidence.conditions);
    let under = matching.underdetermined(&incidence.conditions, &incidence.capacity);
    if !(over.0.is_empty() && under.1.is_empty()) {
        return Err(Box::new(Defect { over: incidence.part(over), under: incidence.part(under) }));
    }
    let order = order(&incidence, &matching, side);
    let members = Members::new(replaced, &order, side);
    let groups = (0..order.len()).filter_map(|rank| {
        let bodies = members.bodies(rank)?;
        let joints = members.joints(replaced, rank);
        let inside = efforts_inside(&incidence, &matching, &order[rank]);
        Some(Group::new(bodies, joints, inside, efforts, replaced))
    });
    Ok(groups.collect())
}

/// Strongly connected sets of bodies and pins, in the order of solution.
fn order(incidence: &Incidence, matching: &Matching, side: Side) -> Vec<Vec<usize>> {
    let vertices = incidence.vertex(incidence.capacity.len());
    let mut successors = vec![Vec::new(); vertices];
    for (condition, node) in incidence.conditions.iter().zip(&matching.node_of) {
        let Some(node) = node else { continue };
        let owner = incidence.vertex(*node);
        for &other in &condition.nodes {
            let other = incidence.vertex(other);
            if other != owner {
                match side {
                    Side::Motion => successors[owner].push(other),
                    Side::Forces => successors[other].push(owner),
                }
            }
        }
    }
    components(&successors)
}

fn efforts_inside(incidence: &Incidence, matching: &Matching, vertices: &[usize]) -> Vec<usize> {
    let inside = incidence.owners.iter().zip(&matching.node_of).filter_map(|(owner, node)| match owner {
        Owner::Effort(e) if node.is_some_and(|n| vertices.contains(&incidence.vertex(n))) => Some(*e),
        _ => None,
    });
    inside.collect()
}

/// Which body is solved when.
struct Members<'a> {
    order: &'a [Vec<usize>],
    rank: Vec<Option<usize>>,
    side: Side,
}

impl<'a> Members<'a> {
    fn new(replaced: &Replaced, order: &'a [Vec<usize>], side: Side) -> Self {
        let mut rank = vec![None; replaced.bodies.len()];
        for (r, vertices) in order.iter().enumerate() {
            for &v in vertices {
                if let Some(body) = replaced.bodies.get(v)
                    && !body.known
                {
                    rank[v] = Some(r);
                }
            }
        }
        Self { order, rank, side }
    }

    fn bodies(&self, rank: usize) -> Option<Vec<BodyId>> {
        let bodies: Vec<BodyId> = self.order[rank]
            .iter()
            .filter(|&&v| self.rank.get(v).is_some_and(|r| *r == Some(rank)))
            .map(|&v| BodyId(v))
            .collect();
        (!bodies.is_empty()).then_some(bodies)
    }

    /// How late a body is solved, counted so that the smaller carries the larger: known bodies come first.
    fn depth(&self, body: BodyId) -> usize {
        match (self.rank[body.0], self.side) {
            (None, _) => 0,
            (Some(r), Side::Motion) => r + 1,
            (Some(r), Side::Forces) => self.order.len() - r,
        }
    }

    /// The joints of the group of this rank. A pin of many links is taken apart into joints with the member that
    /// carries it: the one known first (motion) or solved last (forces).
    fn joints(&self, replaced: &Replaced, rank: usize) -> Vec<GroupJoint> {
        let mut out = Vec::new();
        for (i, joint) in replaced.joints.iter().enumerate() {
            let bodies = joint.bodies();
            let Some(hub) = (0..bodies.len()).min_by_key(|&m| self.depth(bodies[m])) else { continue };
            let base = bodies[hub];
            for (m, &body) in bodies.iter().enumerate() {
                if m == hub || self.rank[body.0] != Some(rank) {
                    continue;
                }
                out.push(GroupJoint {
                    joint: JointId(i),
                    body,
                    base,
                    inner: self.rank[base.0] == Some(rank),
                    prismatic: matches!(joint.kind, JointKind::Prismatic { .. }),
                });
            }
        }
        out
    }
}
