//! What the file leaves open: drives without position, shafts and sliders without place. What depends on it is not
//! answered.

use crate::answer::every_query;
use crate::model::{About, Bearing, FindKind, LinkId, LoadId, PairId, PairKind, PointRef, Positions, Query};
use crate::plan::LawSite;
use crate::position::Model;
use crate::solve::refusal::{Refusal, Unpositioned};
use crate::source::Span;
use crate::structure::{EffortSource, GroupKind};

/// For each body, the first drive without position that its motion depends on.
fn unplaced(model: &Model<'_>) -> Vec<Option<usize>> {
    let mut open: Vec<Option<usize>> = vec![None; model.plan.bodies];
    for group in &model.structure.motion {
        let drives = group.efforts.iter().filter_map(|&e| match model.structure.drives[e].source {
            EffortSource::Drive(id) => Some(id.index()),
            EffortSource::Balance(_) => None,
        });
        let mut found =
            drives.into_iter().find(|d| matches!(model.mechanism.drives[*d].positions, Positions::None));
        for joint in group.joints.iter().filter(|j| !j.inner) {
            found = found.or(open[joint.base.0]);
        }
        for law in &group.laws {
            if let crate::structure::JointKind::Law(terms) = &model.structure.replaced.joint(*law).kind {
                for body in model.structure.replaced.bodies_of_law(terms) {
                    found = found.or(open[body.0]);
                }
            }
        }
        group.bodies.iter().for_each(|b| open[b.0] = found);
    }
    model.plan.parts.iter().for_each(|part| open[part.part] = open[part.body]);
    open
}

/// Positions that depend on a drive which has none.
pub(super) fn without_position(model: &Model<'_>) -> Vec<Refusal> {
    let mechanism = model.mechanism;
    if !mechanism.drives.iter().any(|d| matches!(d.positions, Positions::None)) {
        return Vec::new();
    }
    let open = unplaced(model);
    let closed = model.structure.motion.iter().position(|g| {
        !matches!(g.kind, GroupKind::Driven | GroupKind::Train)
            && g.bodies.first().is_some_and(|b| open[b.0].is_some())
    });
    if let Some(group) = closed {
        let drive = model.structure.motion[group].bodies.first().and_then(|b| open[b.0]).unwrap_or(0);
        return vec![Refusal::NoPosition { drive, what: Unpositioned::Group(group) }];
    }
    let of_link = |l: LinkId| open[l.index()];
    let of_pair = |p: PairId| mechanism.pair(p).kind.links().into_iter().find_map(|l| open[l.index()]);
    let mut found: Vec<Refusal> = Vec::new();
    let mut asked: Vec<Span> = Vec::new();
    every_query(mechanism, &mut |query, span| {
        let placed = query.facts().placed.and_then(|(about, what)| {
            let drive = match about {
                About::Link(link) | About::Point(PointRef::Fixed(link, _) | PointRef::Under(link, _)) => {
                    of_link(link)
                }
                About::Pair(pair) => of_pair(pair),
            };
            drive.map(|drive| (drive, what))
        });
        if let Some((drive, what)) = placed
            && !asked.contains(&span)
        {
            asked.push(span);
            found.push(Refusal::NoPosition { drive, what: Unpositioned::Asked { what, place: span } });
        }
    });
    for (i, load) in mechanism.loads.iter().enumerate().filter(|_| model.plan.effects.forces) {
        let Some(on) = load.link().filter(|_| load.is_vector()) else { continue };
        let slides = mechanism.pairs.iter().any(|p| {
            p.bearing.is_some()
                && p.name == mechanism.link(on).name
                && matches!(p.kind, PairKind::Prismatic(_))
        });
        if let Some(drive) = of_link(on).filter(|_| !slides) {
            found.push(Refusal::NoPosition { drive, what: Unpositioned::Force(LoadId::at(i)) });
        }
    }
    let all = mechanism.finds.iter().find(|f| matches!(f.kind, FindKind::Reactions));
    let element = |l: usize| {
        let own = |p: &crate::model::Pair| p.bearing.is_some() && p.name == mechanism.links[l].name;
        mechanism.pairs.iter().any(own)
    };
    let linkage = (1..mechanism.links.len()).find_map(|l| open[l].filter(|_| !element(l)));
    if let (Some(find), Some(drive)) = (all, linkage) {
        found.push(Refusal::NoPosition { drive, what: Unpositioned::Links(find.span) });
    }
    found
}

/// For each pair, whether its reaction is not known: something that acts on its links has no place.
#[must_use]
pub fn unplaced_reactions(model: &Model<'_>) -> Vec<bool> {
    let (mechanism, structure) = (model.mechanism, model.structure);
    let mut pairs: Vec<bool> = mechanism.pairs.iter().map(|p| p.bearing == Some(Bearing::Open)).collect();
    let mut bodies = vec![false; model.plan.bodies];
    for law in model.plan.laws.iter().filter(|l| l.meeting.is_none()) {
        for (site, _) in &law.terms {
            match site {
                LawSite::Turn(body) => bodies[*body] = true,
                LawSite::Slide(guide) => {
                    bodies[guide.body] = true;
                    bodies[guide.base] = true;
                }
            }
        }
        pairs[law.pair.index()] = true;
    }
    bodies[0] = false;
    for group in &structure.forces {
        if !group.bodies.iter().any(|b| bodies[b.0]) {
            continue;
        }
        for joint in &group.joints {
            pairs[structure.replaced.joint(joint.joint).pair.index()] = true;
            bodies[joint.base.0] |= joint.base.0 != 0;
        }
    }
    pairs
}

/// Reactions that are asked for and have no place.
pub(super) fn without_place(model: &Model<'_>) -> Vec<Refusal> {
    let mechanism = model.mechanism;
    if model.plan.laws.is_empty() {
        return Vec::new();
    }
    let unknown = unplaced_reactions(model);
    let mut found: Vec<Refusal> = Vec::new();
    every_query(mechanism, &mut |query, span| {
        let facts = query.facts();
        if let Query::Internal(asked) = query {
            let of_link = |i: &usize| mechanism.pairs[*i].kind.links().contains(&asked.link);
            let open = (0..mechanism.pairs.len()).filter(|i| unknown[*i]).find(of_link).map(PairId::at);
            let refusal = open.map(|pair| Refusal::NoPlace { pair, place: span });
            found.extend(refusal.filter(|refusal| !found.contains(refusal)));
            return;
        }
        let Some(pair) = facts.reaction else { return };
        // the couple of a transmission on its shaft needs no place
        if facts.couple.is_some() && matches!(mechanism.pair(pair).kind, PairKind::Transmission(_)) {
            return;
        }
        let refusal = Refusal::NoPlace { pair, place: span };
        if unknown[pair.index()] && !found.contains(&refusal) {
            found.push(refusal);
        }
    });
    found
}
