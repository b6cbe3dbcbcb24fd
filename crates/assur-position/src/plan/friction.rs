//! Which joints rub, and how: one element per sliding or turning contact, each in the group that finds its reaction.

use super::force_step::{EffortLine, ForceStep};
use super::friction_step::{FrictionElement, FrictionGroup, FrictionLaw};
use super::geometry::guide;
use super::planned::Plan;
use super::train::slot_of;
use super::train_step::LawSite;
use crate::model::{Friction, LinkId, Mechanism, PairId, PairKind, ProfileShape};
use crate::structure::{BodyId, Group, GroupJoint, JointKind, Structure};

/// The elements by joint where [`FrictionGroup::reduced`] holds: circles in the hinges of a dyad RRR, or of a dyad RRP whose
/// guide rubs by its normal force; the one joint of a link whose effort acts in that joint.
fn reduced(step: &ForceStep, elements: &[FrictionElement], from: usize) -> Option<[Option<usize>; 3]> {
    let joints: &[(usize, bool)] = match step {
        ForceStep::Rrr { outer: [one, two], inner, .. } => {
            &[(one.slot, false), (inner.slot, false), (two.slot, false)]
        }
        ForceStep::Rrp { outer, inner, guide, .. } => {
            &[(outer.slot, false), (inner.slot, false), (guide.slot, true)]
        }
        ForceStep::Turn { hinge, effort: EffortLine::Torque { .. }, .. } => &[(hinge.slot, false)],
        ForceStep::Shift { guide, effort: EffortLine::Along(_), .. } => &[(guide.slot, true)],
        _ => return None,
    };
    let mut found = [None; 3];
    for (index, element) in elements.iter().enumerate() {
        let joint = joints.iter().position(|(slot, _)| *slot == element.slot)?;
        let fits = match element.kind {
            FrictionLaw::Circle { .. } => !joints[joint].1,
            FrictionLaw::Guide { .. } => joints[joint].1,
            FrictionLaw::BothEnds { .. } | FrictionLaw::Contact { .. } | FrictionLaw::Rolling { .. } => false,
        };
        if !fits || element.pin.is_some() || found[joint].is_some() {
            return None;
        }
        found[joint] = Some(from + index);
    }
    Some(found)
}

/// Turns the steps of groups with friction into steps that solve it.
pub(super) fn plan(mechanism: &Mechanism, structure: &Structure, plan: &mut Plan) {
    let foreign = foreign_pins(mechanism, structure);
    let mut first_slot = 0;
    for (index, group) in structure.forces.iter().enumerate() {
        let slots: Vec<usize> = (first_slot..first_slot + group.joints.len()).collect();
        first_slot += group.joints.len();
        let from = plan.friction.len();
        for (joint, &slot) in group.joints.iter().zip(&slots) {
            if foreign.contains(&structure.replaced.joint(joint.joint).pair) {
                continue;
            }
            let pair = structure.replaced.joint(joint.joint).pair;
            // a replaced contact has two joints and rubs once
            let replaced = matches!(mechanism.pair(pair).kind, PairKind::Contact { .. } | PairKind::Slot(_));
            if replaced && plan.friction.iter().any(|other| other.pair == pair) {
                continue;
            }
            plan.friction.extend(element(mechanism, structure, joint, slot));
            plan.friction.extend(rolling(mechanism, structure, pair, slot));
        }
        if plan.friction.len() == from || !foreign.is_empty() {
            continue;
        }
        let laws: Vec<usize> = group.laws.iter().map(|law| slot_of(structure, *law)).collect();
        let plain = std::mem::replace(&mut plan.forces[index], ForceStep::Sequence(Vec::new()));
        let rubbing = FrictionGroup {
            reduced: reduced(&plain, &plan.friction[from..], from),
            bodies: group.bodies.iter().map(|b| b.0).collect(),
            bases: bases(structure, group, &laws, plan),
            elements: (from..plan.friction.len()).collect(),
            slots,
            laws,
        };
        plan.forces[index] = ForceStep::Friction { plain: Box::new(plain), group: Box::new(rubbing) };
    }
    if !foreign.is_empty() {
        foreign.iter().for_each(|pair| pin(mechanism, structure, plan, *pair));
        together(plan);
    }
    parting(mechanism, structure, plan);
}

/// The elements of contacts that part, which stand in no group.
fn parting(mechanism: &Mechanism, structure: &Structure, plan: &mut Plan) {
    for (stop, place) in mechanism.stops.iter().enumerate() {
        let pair = mechanism.pair(place.pair);
        let coefficient = pair.friction.as_ref().map_or(0.0, Friction::coefficient);
        let PairKind::Contact { first, second, internal, parts: true } = &pair.kind else { continue };
        let [body, base] = [first.link, second.link].map(|link| structure.replaced.body_of(link).0);
        let profile = |link, shape| structure.replaced.profile(link, shape);
        let kind = FrictionLaw::Contact {
            coefficient,
            first: profile(first.link, first.shape),
            second: profile(second.link, second.shape),
            internal: *internal,
            presses: 1.0,
        };
        let (pin, stop) = (None, Some(stop));
        let slides =
            FrictionElement { pair: place.pair, body, base, through: body, slot: 0, kind, pin, stop };
        plan.friction.extend((coefficient > 0.0).then_some(slides));
        let rolling = rolling(mechanism, structure, place.pair, 0);
        plan.friction.extend(rolling.map(|element| FrictionElement { stop, ..element }));
    }
}

/// The resistance of a contact against rolling, pressed by the reaction of this slot.
fn rolling(
    mechanism: &Mechanism,
    structure: &Structure,
    contact: PairId,
    slot: usize,
) -> Option<FrictionElement> {
    let pair = mechanism.pair(contact);
    let PairKind::Contact { first, second, .. } = &pair.kind else { return None };
    let arm = pair.friction.as_ref().map(Friction::arm).filter(|arm| *arm > 0.0)?;
    let [body, base] = [first.link, second.link].map(|link| structure.replaced.body_of(link).0);
    let kind = FrictionLaw::Rolling { arm };
    Some(FrictionElement { pair: contact, body, base, through: body, slot, kind, pin: None, stop: None })
}

/// Hinges of several links with friction where another link than the first carries some of the joints. What turns in
/// the first link then presses with the reactions of several groups.
fn foreign_pins(mechanism: &Mechanism, structure: &Structure) -> Vec<PairId> {
    let mut found = Vec::new();
    for joint in structure.forces.iter().flat_map(|g| &g.joints) {
        let id = structure.replaced.joint(joint.joint).pair;
        let pair = mechanism.pair(id);
        let PairKind::Revolute(pins) = &pair.kind else { continue };
        let rubs = pair.friction.is_some_and(|f| f.is_some());
        if rubs
            && pins.len() > 2
            && joint.base != structure.replaced.body_of(pins[0].link)
            && !found.contains(&id)
        {
            found.push(id);
        }
    }
    found
}

/// The elements of such a hinge: each link against the first, pressed by all that acts on it there.
fn pin(mechanism: &Mechanism, structure: &Structure, plan: &mut Plan, id: PairId) {
    let pair = mechanism.pair(id);
    let (PairKind::Revolute(pins), Some(Friction::Circle(radius))) = (&pair.kind, pair.friction) else {
        return;
    };
    let joints = structure.forces.iter().flat_map(|g| &g.joints).enumerate();
    let joints: Vec<_> = joints.filter(|(_, j)| structure.replaced.joint(j.joint).pair == id).collect();
    for link in pins[1..].iter().map(|p| structure.replaced.body_of(p.link).0) {
        let from = plan.pin_slots.len();
        for (slot, joint) in &joints {
            if joint.body.0 == link {
                plan.pin_slots.push((*slot, 1.0));
            } else if joint.base.0 == link {
                plan.pin_slots.push((*slot, -1.0));
            }
        }
        let Some((slot, _)) = plan.pin_slots.get(from) else { continue };
        plan.friction.push(FrictionElement {
            pair: id,
            body: link,
            base: structure.replaced.body_of(pins[0].link).0,
            through: link,
            slot: *slot,
            kind: FrictionLaw::Circle { radius },
            pin: Some((from, plan.pin_slots.len())),
            stop: None,
        });
    }
}

/// All groups in one step, the last.
fn together(plan: &mut Plan) {
    let steps: Vec<ForceStep> =
        plan.forces.iter_mut().map(|s| std::mem::replace(s, ForceStep::Sequence(Vec::new()))).collect();
    let group = FrictionGroup {
        bodies: (1..plan.bodies).collect(),
        bases: vec![0],
        elements: (0..plan.friction.len()).collect(),
        slots: (0..plan.reactions.len()).collect(),
        laws: (0..plan.laws.len()).collect(),
        reduced: None,
    };
    if let Some(last) = plan.forces.last_mut() {
        *last = ForceStep::Friction { plain: Box::new(ForceStep::Sequence(steps)), group: Box::new(group) };
    }
}

/// The bodies outside a group on which its joints, efforts and laws of wheels act.
fn bases(structure: &Structure, group: &Group, laws: &[usize], plan: &Plan) -> Vec<usize> {
    let mut bases: Vec<usize> = Vec::new();
    let efforts = group.efforts.iter().flat_map(|&e| structure.efforts[e].bodies(&structure.replaced));
    let sites = laws.iter().flat_map(|law| &plan.laws[*law].terms).flat_map(|(site, _)| match site {
        LawSite::Turn(body) => vec![BodyId(*body)],
        LawSite::Slide(guide) => vec![BodyId(guide.body), BodyId(guide.base)],
    });
    for base in group.joints.iter().map(|joint| joint.base).chain(efforts).chain(sites) {
        if !group.bodies.contains(&base) && !bases.contains(&base.0) {
            bases.push(base.0);
        }
    }
    if !bases.contains(&0) {
        bases.push(0);
    }
    bases
}

fn element(
    mechanism: &Mechanism,
    structure: &Structure,
    joint: &GroupJoint,
    slot: usize,
) -> Option<FrictionElement> {
    let id = structure.replaced.joint(joint.joint).pair;
    let pair = mechanism.pair(id);
    let at = |body: BodyId, base: BodyId, kind| FrictionElement {
        pair: id,
        body: body.0,
        base: base.0,
        through: body.0,
        slot,
        kind,
        pin: None,
        stop: None,
    };
    let body = |link| structure.replaced.body_of(link);
    let profile = |link, shape| structure.replaced.profile(link, shape);
    match (&pair.kind, pair.friction?) {
        (PairKind::Revolute(_), Friction::Circle(radius)) => {
            (radius > 0.0).then(|| at(joint.body, joint.base, FrictionLaw::Circle { radius }))
        }
        (PairKind::Prismatic(of), friction) => {
            let guide = guide(structure, *joint, slot);
            let kind = match friction {
                Friction::Coefficient(coefficient) => FrictionLaw::Guide { coefficient, guide },
                Friction::BothEnds(coefficient) => {
                    FrictionLaw::BothEnds { coefficient, guide, contacts: of.contacts? }
                }
                Friction::Circle(_) | Friction::Rolling { .. } => return None,
            };
            (friction.coefficient() > 0.0).then(|| at(joint.body, joint.base, kind))
        }
        (PairKind::Slot(guide), friction) => {
            let prismatic = matches!(structure.replaced.joint(joint.joint).kind, JointKind::Prismatic { .. });
            let kind = FrictionLaw::Contact {
                coefficient: friction.coefficient(),
                first: profile(guide.slider, ProfileShape::Point(guide.point)),
                second: profile(guide.guide, ProfileShape::Line(guide.through, guide.along)),
                internal: false,
                presses: 0.0,
            };
            let block = if joint.base == body(guide.guide) { joint.body } else { joint.base };
            (prismatic && friction.coefficient() > 0.0).then(|| FrictionElement {
                through: block.0,
                ..at(body(guide.slider), body(guide.guide), kind)
            })
        }
        (PairKind::Contact { first, second, internal, .. }, friction) => {
            let kind = FrictionLaw::Contact {
                coefficient: friction.coefficient(),
                first: profile(first.link, first.shape),
                second: profile(second.link, second.shape),
                internal: *internal,
                presses: side_of_reaction(mechanism, structure, joint, id),
            };
            (friction.coefficient() > 0.0).then(|| at(body(first.link), body(second.link), kind))
        }
        _ => None,
    }
}

/// 1 where the reaction of a joint that stands for a contact is that on the side of its first profile, else −1.
fn side_of_reaction(
    mechanism: &Mechanism,
    structure: &Structure,
    joint: &GroupJoint,
    contact: PairId,
) -> f64 {
    let PairKind::Contact { first, second, .. } = &mechanism.pair(contact).kind else { return 0.0 };
    let cam = mechanism.cam_contacts.iter().find(|cam| cam.pair == contact);
    let is_of = |body: BodyId, link: LinkId| {
        // what a roller gets is found on the follower that carries it
        let carrier = cam.filter(|cam| cam.roller.is_some_and(|(roller, _)| roller == link));
        let links = [Some(link), carrier.map(|cam| cam.follower)];
        links.into_iter().flatten().any(|link| structure.replaced.body_of(link) == body)
    };
    if is_of(joint.body, first.link) || is_of(joint.base, second.link) { 1.0 } else { -1.0 }
}
