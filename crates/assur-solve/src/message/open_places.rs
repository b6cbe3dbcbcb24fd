//! What the file leaves open: drives without position, shafts and sliders without place. What depends on it is not
//! answered.

use super::error::{SolveError, label};
use super::format::{labels, links};
use super::train_error::TrainError;
use crate::answer::every_query;
use crate::position::Model;
use miette::LabeledSpan;

use crate::model::{
    About, Bearing, Drive, FindKind, Friction, LinkId, PairId, PairKind, PointRef, Positions,
    TransmissionKind,
};
use crate::plan::LawSite;
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
    open
}

/// Positions that depend on a drive which has none.
pub(crate) fn without_position(model: &Model<'_>) -> Vec<SolveError> {
    let mechanism = model.mechanism;
    if !mechanism.drives.iter().any(|d| matches!(d.positions, Positions::None)) {
        return Vec::new();
    }
    let open = unplaced(model);
    let closed = model.structure.motion.iter().find(|g| {
        !matches!(g.kind, GroupKind::Driven | GroupKind::Train)
            && g.bodies.first().is_some_and(|b| open[b.0].is_some())
    });
    if let Some(group) = closed {
        let drive = group.bodies.first().and_then(|b| open[b.0]).unwrap_or(0);
        let what = format!("how {} stand", links(model, group));
        let labels = labels(model, group, "moves with it");
        return vec![no_position(&mechanism.drives[drive], what, labels)];
    }
    let of_link = |l: LinkId| open[l.index()];
    let of_pair = |p: PairId| mechanism.pair(p).kind.links().into_iter().find_map(|l| open[l.index()]);
    let mut errors: Vec<(usize, &'static str, Span)> = Vec::new();
    every_query(mechanism, &mut |query, span| {
        let found = query.facts().placed.and_then(|(about, what)| {
            let drive = match about {
                About::Link(link) | About::Point(PointRef::Fixed(link, _) | PointRef::Under(link, _)) => {
                    of_link(link)
                }
                About::Pair(pair) => of_pair(pair),
            };
            drive.map(|drive| (drive, what))
        });
        if let Some((drive, what)) = found
            && !errors.iter().any(|e| e.2 == span)
        {
            errors.push((drive, what, span));
        }
    });
    for load in mechanism.loads.iter().filter(|_| model.plan.effects.forces) {
        let Some(on) = load.link().filter(|_| load.is_vector()) else { continue };
        let slides = mechanism.pairs.iter().any(|p| {
            p.bearing.is_some()
                && p.name == mechanism.link(on).name
                && matches!(p.kind, PairKind::Prismatic(_))
        });
        if let Some(drive) = of_link(on).filter(|_| !slides) {
            errors.push((drive, "the place of a force", load.span));
        }
    }
    let all = mechanism.finds.iter().find(|f| matches!(f.kind, FindKind::Reactions));
    let element = |l: usize| {
        let own = |p: &crate::model::Pair| p.bearing.is_some() && p.name == mechanism.links[l].name;
        mechanism.pairs.iter().any(own)
    };
    let linkage = (1..mechanism.links.len()).find_map(|l| open[l].filter(|_| !element(l)));
    if let (Some(find), Some(drive)) = (all, linkage) {
        errors.push((drive, "what `find reactions` tells of the links", find.span));
    }
    let mut out: Vec<SolveError> = Vec::new();
    for (drive, what, span) in errors {
        let labels = vec![label("hangs on the position", span)];
        out.push(no_position(&mechanism.drives[drive], what.to_owned(), labels));
    }
    out
}

fn no_position(drive: &Drive, what: String, mut labels: Vec<LabeledSpan>) -> SolveError {
    labels.push(label("a rate, and no position", drive.span));
    let example = match drive.target {
        crate::model::DriveTarget::Link(_) => "0 deg",
        _ => "0 m",
    };
    let help = format!(
        "write the position before the speed: `drive {} = {example} at …`; the angles and ways of a train are all zero together",
        drive.name
    );
    TrainError::NoPosition { what, drive: drive.name.clone(), help, labels }.into()
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
pub(crate) fn without_place(model: &Model<'_>) -> Vec<SolveError> {
    let mechanism = model.mechanism;
    if model.plan.laws.is_empty() {
        return Vec::new();
    }
    let unknown = unplaced_reactions(model);
    let mut errors: Vec<(PairId, Span)> = Vec::new();
    every_query(mechanism, &mut |query, span| {
        let facts = query.facts();
        let Some(pair) = facts.reaction else { return };
        // the couple of a transmission on its shaft needs no place
        if facts.couple.is_some() && matches!(mechanism.pair(pair).kind, PairKind::Transmission(_)) {
            return;
        }
        if unknown[pair.index()] && !errors.contains(&(pair, span)) {
            errors.push((pair, span));
        }
    });
    let error = |(pair, span): (PairId, Span)| {
        let declared = mechanism.pair(pair);
        let mut labels = vec![label("asked for here", span), label("this pair", declared.span)];
        let unplaced = |p: &&crate::model::Pair| match &p.kind {
            PairKind::Transmission(t) => t.meeting.is_none(),
            _ => false,
        };
        if let Some(law) = mechanism.pairs.iter().find(unplaced)
            && law.span != declared.span
        {
            labels.push(label("its force has no place", law.span));
        }
        let mesh = mechanism.pairs.iter().any(|p| match &p.kind {
            PairKind::Transmission(t) => t.kind == TransmissionKind::Mesh && t.meeting.is_none(),
            _ => false,
        });
        let help = if mesh {
            "a mesh pulls where its wheels touch: place the axes, `wheel w1 … at O1` with a point of what carries the shaft, and give \
             the mesh a `pressure_angle`; the torques are known without: `moment(k, I)`"
        } else {
            "only meshes have a place so far; the torques are known: `moment(b, I)`"
        };
        TrainError::NoPlace { pair: declared.name.clone(), help: help.to_owned(), labels }.into()
    };
    errors.into_iter().map(error).collect()
}

/// Friction that goes by the forces at two contacts, in pairs whose couple is not determined.
pub(crate) fn friction_couples(model: &Model<'_>) -> Option<SolveError> {
    let (mechanism, open) = (model.mechanism, &model.structure.undetermined_couples);
    if !model.plan.effects.friction {
        return None;
    }
    let shared = |id: &&PairId| {
        let friction = mechanism.pair(**id).friction;
        friction.is_some_and(|f| f.is_some() && matches!(f, Friction::BothEnds(_)))
    };
    let pairs: Vec<PairId> = open.iter().filter(shared).copied().collect();
    let names: Vec<String> = pairs.iter().map(|id| format!("`{}`", mechanism.pair(*id).name)).collect();
    let labels = pairs.iter().map(|id| label("not determined", mechanism.pair(*id).span)).collect();
    let chain = if pairs.len() == 1 { "it closes" } else { "they close" };
    (!pairs.is_empty()).then(|| SolveError::OpenCouple { pairs: names.join(" and "), chain, labels })
}

/// Friction in pairs beside transmissions.
pub(crate) fn friction_beside(model: &Model<'_>) -> Option<SolveError> {
    if !model.plan.effects.friction || model.plan.laws.is_empty() {
        return None;
    }
    let rubs = model.mechanism.pairs.iter().filter(|p| p.friction.is_some_and(|f| f.is_some()));
    let labels = rubs.map(|p| label("not supported yet", p.span)).collect();
    let what = "friction in pairs of a mechanism with wheels or ropes".to_owned();
    Some(SolveError::NotSupportedYet { what, labels })
}
