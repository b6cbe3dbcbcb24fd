//! The clauses of `assemble` that choose between the assemblies of a group.

use crate::answer::{PoseAnswers, first_angles};
use crate::math::Vec2;
use crate::model::{LinkId, PairId, PairKind};
use crate::plan::{contact_in, is_turned};
use crate::position::{Model, SAME, State, extent};
use crate::structure::{BodyOrigin, Dyad, Group, GroupKind, JointKind};

/// A clause of `assemble` that chooses an assembly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Clause {
    /// A hinge lies on one side of the line through two others.
    Side {
        hinge: PairId,
        from: PairId,
        to: PairId,
        /// Left, or right.
        left: bool,
    },
    /// A hinge lies ahead of another along a guide, or behind it.
    Along {
        hinge: PairId,
        other: PairId,
        /// Ahead, or behind.
        ahead: bool,
    },
    /// The coordinate of a pair has this sign.
    Sign {
        pair: PairId,
        /// Greater than zero, or less.
        positive: bool,
    },
    /// The angle of a revolute is in a range.
    Between {
        pair: PairId,
        /// Greater than this, rad, if there is a lower bound.
        above: Option<f64>,
        /// Less than this, rad, if there is an upper bound.
        below: Option<f64>,
    },
    /// A point lies near a place.
    Near {
        point: NamedPoint,
        /// The place, m.
        place: Vec2,
    },
}

/// A point of a link by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamedPoint {
    pub link: LinkId,
    /// Index into [`crate::model::Link::points`].
    pub index: usize,
}

/// One state for every assembly of a group.
pub(super) fn distinct<'s>(model: &Model<'_>, states: &[&'s State], group: &Group) -> Vec<&'s State> {
    apart(model, states, group).iter().map(|alike| alike[0]).collect()
}

/// The states, apart by the assembly of a group.
pub(super) fn apart<'s>(model: &Model<'_>, states: &[&'s State], group: &Group) -> Vec<Vec<&'s State>> {
    let extent = extent(model);
    let same = |a: &State, b: &State| {
        group.bodies.iter().all(|i| {
            let (x, y) = (&a.motion.bodies[i.0], &b.motion.bodies[i.0]);
            (x.p - y.p).norm() <= SAME * extent && (x.u - y.u).norm() <= SAME
        })
    };
    let mut assemblies: Vec<Vec<&State>> = Vec::new();
    for &state in states {
        match assemblies.iter_mut().find(|alike| same(alike[0], state)) {
            Some(alike) => alike.push(state),
            None => assemblies.push(vec![state]),
        }
    }
    assemblies
}

/// A clause for every assembly: by side, order or sign where these tell them apart, else by the place of a point.
pub(super) fn clauses(model: &Model<'_>, assemblies: &[&State], group: &Group) -> Vec<Clause> {
    if let Some(clauses) = by_cam_angle(model, assemblies, group) {
        return clauses;
    }
    let mut clauses: Vec<Clause> = Vec::new();
    for state in assemblies {
        match by_kind(model, state, group) {
            Some(clause) if !clauses.contains(&clause) => clauses.push(clause),
            // two groups before this one may stand differently: the clause is the same
            Some(_)
                if assemblies.len() > 2 && matches!(group.kind, GroupKind::Dyad(Dyad::Rrr | Dyad::Rrp)) => {}
            _ => return near_clauses(model, assemblies, group),
        }
    }
    clauses
}

/// The ranges of the angle of a cam that its follower turns, bounded in the middle between two assemblies.
fn by_cam_angle(model: &Model<'_>, assemblies: &[&State], group: &Group) -> Option<Vec<Clause>> {
    let (block, _, contact) = contact_in(model.mechanism, model.structure, group)?;
    if !is_turned(group, block, contact) {
        return None;
    }
    if assemblies.len() < 2 {
        return Some(near_clauses(model, assemblies, group));
    }
    let hinges = group.joints.iter().map(|j| model.structure.replaced.joint(j.joint).pair);
    let pair = hinges.into_iter().find(|&p| p != contact.pair)?;
    let angles: Vec<f64> = assemblies.iter().map(|state| coordinate(model, state, pair)).collect();
    let mut sorted = angles.clone();
    sorted.sort_by(f64::total_cmp);
    let bounds: Vec<f64> = sorted.windows(2).map(|two| 0.5 * (two[0] + two[1])).collect();
    let each = angles.iter().map(|&angle| Clause::Between {
        pair,
        above: bounds.iter().copied().rfind(|b| *b < angle),
        below: bounds.iter().copied().find(|b| *b > angle),
    });
    Some(each.collect())
}

fn by_kind(model: &Model<'_>, state: &State, group: &Group) -> Option<Clause> {
    let GroupKind::Dyad(dyad) = group.kind else { return None };
    let replaced = &model.structure.replaced;
    let pair = |i: usize| replaced.joint(group.joints[i].joint).pair;
    let kind = |i: usize| &model.mechanism.pair(pair(i)).kind;
    let real = |i: usize| matches!(kind(i), PairKind::Revolute(_) | PairKind::Prismatic(_)).then(|| pair(i));
    let pin = |i: usize| {
        let joint = group.joints[i];
        match &replaced.joint(joint.joint).kind {
            JointKind::Revolute(members) => members
                .iter()
                .find(|m| m.0 == joint.body)
                .map(|m| state.motion.bodies[joint.body.0].position(m.1)),
            JointKind::Prismatic { .. } | JointKind::Weld { .. } | JointKind::Law(_) => None,
        }
    };
    match dyad {
        Dyad::Rrr => {
            let (a, c, b) = (pin(0)?, pin(1)?, pin(2)?);
            let left = (b - a).cross(c - a) >= 0.0;
            Some(Clause::Side { hinge: real(1)?, from: real(0)?, to: real(2)?, left })
        }
        Dyad::Rrp => {
            let (a, c) = (pin(0)?, pin(1)?);
            let JointKind::Prismatic { guide: base, along, .. } = replaced.joint(group.joints[2].joint).kind
            else {
                return None;
            };
            if !matches!(kind(2), PairKind::Prismatic(_)) {
                return None;
            }
            let ahead = (c - a).dot(along.turned(state.motion.bodies[base.0].u)) >= 0.0;
            Some(Clause::Along { hinge: real(1)?, other: real(0)?, ahead })
        }
        Dyad::Rpr => {
            let round = matches!(
                replaced.joint(group.joints[1].joint).kind,
                JointKind::Prismatic { offset, .. } if offset > 0.0
            );
            let value = coordinate(model, state, pair(1));
            if round || !value.is_finite() || value == 0.0 {
                return None;
            }
            Some(Clause::Sign { pair: pair(1), positive: value > 0.0 })
        }
        Dyad::Prp | Dyad::Rpp => None,
    }
}

/// The coordinate of a pair in a state that was not followed.
pub(super) fn coordinate(model: &Model<'_>, state: &State, pair: PairId) -> f64 {
    let angles = first_angles(model, state);
    PoseAnswers { angles: &angles, ..PoseAnswers::bare(model, state) }.displacement(pair)
}

/// The points of a group that a clause can name, with their bodies.
pub(super) fn points(model: &Model<'_>, group: &Group) -> Vec<(NamedPoint, usize, Vec2)> {
    let mut out = Vec::new();
    for body in &group.bodies {
        let BodyOrigin::Link(id) = model.structure.replaced.bodies[body.0].origin else { continue };
        let link = model.mechanism.link(id);
        // the two links of a cylinder have no names of their own
        if link.name.contains('.') {
            continue;
        }
        let named = |index| NamedPoint { link: id, index };
        out.extend(link.points.iter().enumerate().map(|(index, p)| (named(index), body.0, p.at)));
    }
    out
}

/// A clause for every assembly, with the place of the point that differs most between them.
pub(super) fn near_clauses(model: &Model<'_>, assemblies: &[&State], group: &Group) -> Vec<Clause> {
    let mut best: Option<(f64, (NamedPoint, usize, Vec2))> = None;
    for point in points(model, group) {
        let places: Vec<Vec2> =
            assemblies.iter().map(|s| s.motion.bodies[point.1].position(point.2)).collect();
        let apart = places.iter().enumerate().flat_map(|(i, p)| places[..i].iter().map(|q| (*p - *q).norm()));
        let apart = apart.fold(f64::INFINITY, f64::min);
        if best.as_ref().is_none_or(|b| apart > b.0) {
            best = Some((apart, point));
        }
    }
    let Some((_, (point, body, at))) = best else { return Vec::new() };
    let places = assemblies.iter().map(|s| s.motion.bodies[body].position(at));
    places.map(|place| Clause::Near { point, place }).collect()
}
