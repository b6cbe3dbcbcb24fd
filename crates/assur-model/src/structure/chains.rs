//! Chains of prismatic joints: bodies that do not turn against each other.

use super::joint::{JointKind, Replaced};

/// A prismatic joint at the body whose list it is in, and the body on its other side.
type Edge = (usize, usize);

/// Marks prismatic joints whose condition on the angle follows from others (a spanning forest from the ground keeps
/// those nearest to it), and all that lie on a closed chain of prismatic joints.
pub(super) fn mark_chains(replaced: &mut Replaced) {
    let mut edges: Vec<Vec<Edge>> = vec![Vec::new(); replaced.bodies.len()];
    for (i, joint) in replaced.joints.iter().enumerate() {
        if let JointKind::Prismatic { slider, guide, .. } = joint.kind {
            edges[slider.0].push((i, guide.0));
            edges[guide.0].push((i, slider.0));
        }
    }
    let kept = spanning_forest(&edges, replaced.joints.len());
    let bridges = bridges(&edges, replaced.joints.len());
    for (i, joint) in replaced.joints.iter_mut().enumerate() {
        if let JointKind::Prismatic { angle_redundant, in_chain, .. } = &mut joint.kind {
            *angle_redundant = !kept[i];
            *in_chain = !bridges[i];
        }
    }
}

/// Which joints reach a body first, from the ground outwards.
fn spanning_forest(edges: &[Vec<Edge>], joints: usize) -> Vec<bool> {
    let mut seen = vec![false; edges.len()];
    let mut kept = vec![false; joints];
    for root in 0..edges.len() {
        if std::mem::replace(&mut seen[root], true) {
            continue;
        }
        let mut queue = std::collections::VecDeque::from([root]);
        while let Some(at) = queue.pop_front() {
            for &(joint, next) in &edges[at] {
                if !std::mem::replace(&mut seen[next], true) {
                    kept[joint] = true;
                    queue.push_back(next);
                }
            }
        }
    }
    kept
}

/// Which joints lie on no closed chain: without one of them its bodies do not hang together (Tarjan, without recursion).
fn bridges(edges: &[Vec<Edge>], joints: usize) -> Vec<bool> {
    const NEW: usize = usize::MAX;
    let (mut index, mut low) = (vec![NEW; edges.len()], vec![NEW; edges.len()]);
    let mut found = vec![false; joints];
    let mut next = 0;
    for root in 0..edges.len() {
        if index[root] != NEW {
            continue;
        }
        // body, the joint it was reached by, how many of its joints are done
        let mut path = vec![(root, NEW, 0)];
        while let Some((at, by, done)) = path.pop() {
            if done == 0 {
                (index[at], low[at]) = (next, next);
                next += 1;
            }
            if let Some(&(joint, other)) = edges[at].get(done) {
                path.push((at, by, done + 1));
                if index[other] == NEW {
                    path.push((other, joint, 0));
                } else if joint != by {
                    low[at] = low[at].min(index[other]);
                }
            } else if let Some(&(before, ..)) = path.last() {
                found[by] = low[at] == index[at];
                low[before] = low[before].min(low[at]);
            }
        }
    }
    found
}
