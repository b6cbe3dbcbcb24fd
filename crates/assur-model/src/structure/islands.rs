//! Links that pairs join to each other and not to the ground.

use crate::model::{DriveTarget, LinkId, Mechanism, PairKind};

/// Links that no pair joins to the ground. The ground and links driven or started at a point are firm.
pub(super) fn floating_islands(mechanism: &Mechanism) -> Vec<Vec<LinkId>> {
    let island = islands(mechanism);
    let mut firm = vec![false; mechanism.links.len()];
    let roots = mechanism.drives.iter().filter_map(|d| match d.target {
        DriveTarget::Point(link, _) | DriveTarget::Place(link, ..) => Some(link.index()),
        _ => None,
    });
    for root in roots.chain([0]) {
        firm[island[root]] = true;
    }
    let mut members: Vec<Vec<LinkId>> = vec![Vec::new(); mechanism.links.len()];
    for (i, &island) in island.iter().enumerate().filter(|(_, island)| !firm[**island]) {
        members[island].push(LinkId::at(i));
    }
    members.into_iter().filter(|links| !links.is_empty()).collect()
}

/// The island of every link, named by one of its links.
fn islands(mechanism: &Mechanism) -> Vec<usize> {
    let mut parent: Vec<usize> = (0..mechanism.links.len()).collect();
    let mut join = |a: LinkId, b: LinkId| {
        let (a, b) = (root(&mut parent, a.index()), root(&mut parent, b.index()));
        parent[a.max(b)] = a.min(b);
    };
    for pair in &mechanism.pairs {
        let links = pair.kind.links();
        links.windows(2).for_each(|two| join(two[0], two[1]));
        if let PairKind::Cylinder { barrel, rod, from, to } = &pair.kind {
            join(*barrel, from.link);
            join(*rod, to.link);
        }
    }
    (0..parent.len()).map(|i| root(&mut parent, i)).collect()
}

fn root(parent: &mut [usize], mut at: usize) -> usize {
    while parent[at] != at {
        parent[at] = parent[parent[at]];
        at = parent[at];
    }
    at
}
