//! What the decomposition found against how the mechanism was put together.

use crate::support::draft::Draft;
use assur::internals::model::LinkId;
use assur::internals::structure::{
    BodyId, BodyOrigin, Effort, EffortKind, Group, GroupKind, JointKind, Replaced, Structure,
};

/// Everything that is wrong with the groups of a mechanism.
pub fn wrong_groups(draft: &Draft, structure: &Structure) -> Vec<String> {
    let mut wrong = Vec::new();
    if structure.count.mobility != i64::try_from(draft.mechanism.drives.len()).unwrap_or(-1) {
        wrong.push(format!("mobility {}", structure.count.formula()));
    }
    for (groups, efforts) in [(&structure.motion, &structure.drives), (&structure.forces, &structure.efforts)]
    {
        wrong.extend(not_covering(structure, groups));
        wrong.extend(not_minimal(structure, groups, efforts));
    }
    let mut found: Vec<(Vec<LinkId>, &str)> =
        structure.motion.iter().map(|g| (links(structure, g), kind(g))).collect();
    let mut made: Vec<(Vec<LinkId>, &str)> =
        draft.made.iter().map(|m| (sorted(m.links.clone()), m.kind)).collect();
    found.sort();
    made.sort();
    // which condition of a chain of prismatic pairs is the redundant one is a matter of choice
    let chained = draft.made.iter().any(|m| m.kind == "PP");
    if found != made && !chained {
        wrong.push(format!("found {found:?} but made {made:?}"));
    }
    wrong
}

fn kind(group: &Group) -> &'static str {
    match group.kind {
        GroupKind::DrivenLegs(_) => "driven legs",
        _ => group.kind_name(),
    }
}

fn sorted(mut links: Vec<LinkId>) -> Vec<LinkId> {
    links.sort();
    links
}

fn links(structure: &Structure, group: &Group) -> Vec<LinkId> {
    let real = group.bodies.iter().filter_map(|b| match structure.replaced.bodies[b.0].origin {
        BodyOrigin::Link(id) => Some(id),
        BodyOrigin::Imaginary(_) => None,
    });
    sorted(real.collect())
}

/// Every body that moves is in one group.
fn not_covering(structure: &Structure, groups: &[Group]) -> Option<String> {
    let mut times = vec![0; structure.replaced.bodies.len()];
    for body in groups.iter().flat_map(|g| &g.bodies) {
        times[body.0] += 1;
    }
    let bodies = structure.replaced.bodies.iter().zip(&times);
    let wrong = bodies.filter(|(b, t)| **t != usize::from(!b.known)).count();
    (wrong > 0 && !groups.is_empty()).then(|| format!("bodies are in so many groups: {times:?}"))
}

/// Conditions between some bodies and those known already: two for a revolute, one or two for a prismatic joint, one for
/// a drive or a passive freedom.
fn conditions(replaced: &Replaced, efforts: &[Effort], some: &[BodyId], known: &[BodyId]) -> usize {
    let here = |b: &BodyId| some.contains(b) || known.contains(b);
    let mut count = 0;
    for joint in &replaced.joints {
        let members = joint.bodies();
        let inside = members.iter().filter(|b| here(b)).count();
        if !members.iter().any(|b| some.contains(b)) {
            continue;
        }
        let in_known = members.iter().filter(|b| known.contains(b)).count();
        count += match joint.kind {
            JointKind::Revolute(_) => 2 * (inside - 1) - 2 * in_known.saturating_sub(1),
            JointKind::Prismatic { angle_redundant, .. } if inside == 2 => 2 - usize::from(angle_redundant),
            JointKind::Prismatic { .. } | JointKind::Weld { .. } => 0,
            JointKind::Law(_) => usize::from(inside == members.len()),
        };
    }
    for effort in efforts {
        let bodies = effort.bodies(replaced);
        let stands = bodies.iter().all(here) && bodies.iter().any(|b| some.contains(b));
        count += usize::from(stands && !matches!(effort.kind, EffortKind::Point(_)));
    }
    count + replaced.passive.iter().filter(|l| some.contains(&BodyId(l.index()))).count()
}

/// A group has as many conditions as freedoms, and no part of it has. Forces are solved from the other end: there the
/// bodies that are solved later carry the group.
fn not_minimal(structure: &Structure, groups: &[Group], efforts: &[Effort]) -> Vec<String> {
    let replaced = &structure.replaced;
    let forces = std::ptr::eq(groups.as_ptr(), structure.forces.as_ptr());
    let mut known: Vec<BodyId> =
        (0..replaced.bodies.len()).map(BodyId).filter(|b| replaced.bodies[b.0].known).collect();
    let mut wrong = Vec::new();
    let order: Vec<&Group> = if forces { groups.iter().rev().collect() } else { groups.iter().collect() };
    for group in order {
        let bodies = &group.bodies;
        let balanced = conditions(replaced, efforts, bodies, &known) == 3 * bodies.len();
        if !balanced {
            wrong
                .push(format!("{} conditions for {bodies:?}", conditions(replaced, efforts, bodies, &known)));
        }
        if bodies.len() <= 8 {
            for mask in 1..(1_usize << bodies.len()) - 1 {
                let part: Vec<BodyId> =
                    (0..bodies.len()).filter(|i| mask >> i & 1 == 1).map(|i| bodies[i]).collect();
                if conditions(replaced, efforts, &part, &known) >= 3 * part.len() {
                    wrong.push(format!("{part:?} of {bodies:?} is a group of its own"));
                }
            }
        }
        known.extend(bodies);
    }
    wrong
}
