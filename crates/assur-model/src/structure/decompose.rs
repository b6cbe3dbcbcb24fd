//! Splits the bodies into structural groups.
//!
//! Every scalar condition of a joint or drive is matched to a freedom of a body it touches (on the side of forces: every
//! scalar unknown to an equation of equilibrium). Bodies that hang together in a circle through the matching form one
//! group; this is the fine decomposition of Dulmage and Mendelsohn, so that the groups are the smallest possible.

use super::defect::Defect;
use super::echelon::{Echelon, Number, row};
use super::effort::Effort;
use super::group::{Group, Inside};
use super::incidence::{Incidence, Owner};
use super::joint::{BodyId, GroupJoint, JointId, JointKind, Replaced};
use super::matching::{Matching, components, match_all};

/// Which of the two dual problems is split.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// Known: the drives. A group follows those it depends on.
    Motion,
    /// Unknown: the efforts. A group follows those that depend on it.
    Forces,
}

/// Groups in the order of solution.
pub(super) fn decompose(
    replaced: &Replaced,
    incidence: &Incidence,
    efforts: &[Effort],
    side: Side,
) -> Result<Vec<Group>, Box<Defect>> {
    let matching = match_all(&incidence.conditions, &incidence.capacity);
    let order = order(incidence, &matching, side);
    let is_complete = matching.is_complete(&incidence.capacity);
    if !(is_complete && are_determinate(incidence, &matching, &order))
        && let Some(defect) = incidence.defect(replaced)
    {
        return Err(Box::new(defect));
    }
    let members = Members::new(replaced, &order, side);
    let mut joints = members.joints(replaced);
    let mut inside = inside(replaced, incidence, &matching, &order);
    let groups = (0..order.len()).filter_map(|rank| {
        let bodies = members.bodies(rank)?;
        let (joints, inside) = (std::mem::take(&mut joints[rank]), std::mem::take(&mut inside[rank]));
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

/// Whether the conditions matched to the bodies and pins of every set determine them, those before it being known: the
/// count of a whole can agree where one part of it has too many conditions and another too few.
fn are_determinate(incidence: &Incidence, matching: &Matching, order: &[Vec<usize>]) -> bool {
    // the set of every column, and its place there
    let mut places = vec![(usize::MAX, 0); incidence.columns()];
    order.iter().enumerate().all(|(set, vertices)| {
        let nodes = || vertices.iter().flat_map(|&vertex| incidence.nodes_of(vertex));
        let mut size = 0;
        for column in nodes().flat_map(|node| incidence.columns_of(node)) {
            places[column] = (set, size);
            size += 1;
        }
        let mut conditions: Vec<usize> =
            nodes().flat_map(|node| matching.held[node].iter().copied()).collect();
        conditions.sort_unstable();
        let inside = |t: &(usize, Number)| {
            let (its_set, place) = places[t.0];
            (its_set == set).then_some((place, t.1))
        };
        let rows = conditions.iter().map(|&c| row(incidence.rows[c].iter().filter_map(inside).collect()));
        let mut echelon = Echelon::new(size);
        conditions.len() == size && rows.into_iter().all(|row| echelon.add(row))
    })
}

/// The efforts and the laws of every group, by rank.
fn inside(
    replaced: &Replaced,
    incidence: &Incidence,
    matching: &Matching,
    order: &[Vec<usize>],
) -> Vec<Inside> {
    let mut rank_of = vec![0; incidence.vertex(incidence.capacity.len())];
    for (rank, vertices) in order.iter().enumerate() {
        vertices.iter().for_each(|&v| rank_of[v] = rank);
    }
    let mut inside = vec![Inside::default(); order.len()];
    for (owner, node) in incidence.owners.iter().zip(&matching.node_of) {
        let Some(node) = node else { continue };
        let inside = &mut inside[rank_of[incidence.vertex(*node)]];
        match owner {
            Owner::Effort(effort) => inside.efforts.push(*effort),
            Owner::Joint(joint) if matches!(replaced.joint(*joint).kind, JointKind::Law(_)) => {
                inside.laws.push(*joint);
            }
            Owner::Joint(_) | Owner::Passive => {}
        }
    }
    inside
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

    /// The joints of every group, by rank. A pin of many links is taken apart into joints with the member that carries
    /// it: the one known first (motion) or solved last (forces).
    fn joints(&self, replaced: &Replaced) -> Vec<Vec<GroupJoint>> {
        let mut out = vec![Vec::new(); self.order.len()];
        for (i, joint) in replaced.joints.iter().enumerate() {
            if matches!(joint.kind, JointKind::Law(_) | JointKind::Weld { .. }) {
                continue;
            }
            let bodies = joint.bodies();
            let Some(hub) = (0..bodies.len()).min_by_key(|&m| self.depth(bodies[m])) else { continue };
            let base = bodies[hub];
            for (m, &body) in bodies.iter().enumerate() {
                let Some(rank) = self.rank[body.0].filter(|_| m != hub) else { continue };
                out[rank].push(GroupJoint {
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
