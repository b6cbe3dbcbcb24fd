//! Trains of wheels, ropes and sliders. Their laws are linear in the rates with constant coefficients, so that each group
//! is solved once, here: every member's rate is a sum of constants times rates that are known before it. The forces obey
//! the transposed system: with the law Σ c_i q̇_i = 0 and its multiplier λ, the generalized force on q_i is λ c_i.

use super::geometry::{anchor, guide, pin_arm, slide};
use super::joint::Hinge;
use super::planned::Plan;
use super::train_step::{
    LawSite, PlannedLaw, TrainEffort, TrainForces, TrainMember, TrainMotion, TrainSource, TrainSupport,
};
use crate::math::ratio;
use crate::model::{Mechanism, PairKind};
use crate::structure::{
    BodyId, BodyRate, Effort, EffortKind, EffortSource, Group, GroupJoint, GroupKind, JointId, JointKind,
    Structure,
};

fn guide_of(structure: &Structure, joint: JointId) -> Option<GroupJoint> {
    match structure.replaced.joint(joint).kind {
        JointKind::Prismatic { slider, guide, .. } => {
            Some(GroupJoint { joint, body: slider, base: guide, inner: false, prismatic: true })
        }
        _ => None,
    }
}

/// All laws, in the order of their joints.
pub(super) fn laws(mechanism: &Mechanism, structure: &Structure) -> Vec<PlannedLaw> {
    let mut laws: Vec<PlannedLaw> = Vec::new();
    for joint in &structure.replaced.joints {
        let (JointKind::Law(terms), PairKind::Transmission(t)) =
            (&joint.kind, &mechanism.pair(joint.pair).kind)
        else {
            continue;
        };
        let index = laws.iter().filter(|l| l.pair == joint.pair).count();
        let site = |rate: &BodyRate| match rate {
            BodyRate::Turn(body) => Some(LawSite::Turn(body.0)),
            BodyRate::Slide(joint) => {
                guide_of(structure, *joint).map(|j| LawSite::Slide(guide(structure, j, usize::MAX)))
            }
        };
        laws.push(PlannedLaw {
            pair: joint.pair,
            index,
            terms: terms.iter().filter_map(|(rate, c)| Some((site(rate)?, *c))).collect(),
            constant: t.laws[index].constant,
            efficiency: t.laws[index].efficiency,
            grip: None,
            force: t.laws[index].force,
            meeting: t.meeting,
        });
    }
    laws
}

/// Gives the laws that lose power their places among the grips.
pub(super) fn number_losses(plan: &mut Plan) {
    let losing = plan.laws.iter().enumerate().filter(|(_, law)| law.efficiency.is_some());
    plan.losing = losing.map(|(slot, _)| slot).collect();
    for (rank, slot) in plan.losing.iter().enumerate() {
        plan.laws[*slot].grip = Some(plan.friction.len() + rank);
    }
}

/// The place of a law's joint among all laws.
pub(super) fn slot_of(structure: &Structure, law: JointId) -> usize {
    let before = &structure.replaced.joints[..law.0];
    before.iter().filter(|j| matches!(j.kind, JointKind::Law(_))).count()
}

/// Bodies whose angle is known as a number, whole turns included.
pub(super) fn counted_turns(structure: &Structure, plan: &Plan) -> Vec<bool> {
    let mut counted = vec![false; plan.bodies];
    counted[0] = true;
    for group in &structure.motion {
        let base = group.joints.first().map_or(0, |j| j.base.0);
        let sound = match group.kind {
            GroupKind::Driven => group.efforts.iter().all(|&e| match structure.drives[e].kind {
                EffortKind::Angle(_) => true,
                EffortKind::RelativeAngle { .. } => counted[base],
                _ => false,
            }),
            GroupKind::Train => true,
            _ => false,
        };
        for joint in group.joints.iter().filter(|j| sound && !j.prismatic) {
            counted[joint.body.0] = true;
        }
    }
    counted
}

/// A row of the system: coefficients of members and of sources.
struct Rows<'a> {
    structure: &'a Structure,
    group: &'a Group,
    counted: Vec<bool>,
    sources: Vec<TrainSource>,
    members: Vec<Vec<f64>>,
    known: Vec<Vec<(usize, f64)>>,
}

impl Rows<'_> {
    fn source(&mut self, source: TrainSource) -> usize {
        let found = self.sources.iter().position(|s| *s == source);
        found.unwrap_or_else(|| {
            self.sources.push(source);
            self.sources.len() - 1
        })
    }

    fn add(&mut self, terms: &[(BodyRate, f64)], drive: Option<usize>, constant: f64) {
        let mut row = vec![0.0; self.group.bodies.len()];
        let mut known = Vec::new();
        for &(rate, coefficient) in terms {
            let (member, source) = match rate {
                BodyRate::Turn(BodyId::GROUND) => continue,
                BodyRate::Turn(body) => (
                    self.group.joints.iter().position(|j| j.body == body && !j.prismatic),
                    Some(TrainSource::Turn { body: body.0, followed: !self.counted[body.0] }),
                ),
                BodyRate::Slide(joint) => (
                    self.group.joints.iter().position(|j| j.joint == joint),
                    guide_of(self.structure, joint)
                        .map(|j| TrainSource::Slide(slide(&self.structure.replaced, j, j.base))),
                ),
            };
            match (member, source) {
                (Some(member), _) => row[member] += coefficient,
                (None, Some(source)) => known.push((self.source(source), coefficient)),
                (None, None) => {}
            }
        }
        if let Some(drive) = drive {
            known.push((self.source(TrainSource::Drive(drive)), -1.0));
        }
        if constant != 0.0 {
            known.push((self.source(TrainSource::Constant), -constant));
        }
        self.members.push(row);
        self.known.push(known);
    }

    /// Members' rates as sums of sources' rates.
    fn solved(&self) -> Option<Vec<f64>> {
        let n = self.group.bodies.len();
        if self.members.len() != n {
            return None;
        }
        let mut right = vec![0.0; n * self.sources.len()];
        for (i, known) in self.known.iter().enumerate() {
            for (source, coefficient) in known {
                right[i * self.sources.len() + source] -= coefficient;
            }
        }
        if self.sources.is_empty() {
            return ratio::solve(&self.members.concat(), &vec![0.0; n], n).map(|_| Vec::new());
        }
        ratio::solve(&self.members.concat(), &right, n)
    }
}

pub(super) fn motion(structure: &Structure, group: &Group, plan: &Plan) -> TrainMotion {
    let mut rows = Rows {
        structure,
        group,
        counted: counted_turns(structure, plan),
        sources: Vec::new(),
        members: Vec::new(),
        known: Vec::new(),
    };
    for law in &group.laws {
        if let JointKind::Law(terms) = &structure.replaced.joint(*law).kind {
            rows.add(terms, None, plan.laws[slot_of(structure, *law)].constant);
        }
    }
    for &index in &group.efforts {
        let effort = &structure.drives[index];
        let EffortSource::Drive(drive) = effort.source else { continue };
        let terms = driven_terms(effort);
        rows.add(&terms, Some(drive.index()), 0.0);
    }
    let replaced = &structure.replaced;
    let member = |joint: &GroupJoint| {
        if joint.prismatic {
            TrainMember::Shift(slide(replaced, *joint, joint.base))
        } else {
            let pin = pin_arm(replaced, *joint, joint.body);
            TrainMember::Turn { body: joint.body.0, base: anchor(replaced, *joint), pin }
        }
    };
    let solved = rows.solved();
    TrainMotion {
        members: group.joints.iter().map(member).collect(),
        regular: solved.is_some(),
        coefficients: solved.unwrap_or_else(|| vec![0.0; group.bodies.len() * rows.sources.len()]),
        sources: rows.sources,
    }
}

fn driven_terms(effort: &Effort) -> Vec<(BodyRate, f64)> {
    match effort.kind {
        EffortKind::Angle(body) => vec![(BodyRate::Turn(body), 1.0)],
        EffortKind::RelativeAngle { first, second, .. } => {
            vec![(BodyRate::Turn(second), 1.0), (BodyRate::Turn(first), -1.0)]
        }
        EffortKind::Coordinate(joint) => vec![(BodyRate::Slide(joint), 1.0)],
        EffortKind::Line(_) | EffortKind::Point(_) | EffortKind::Place(..) => Vec::new(),
    }
}

pub(super) fn forces(structure: &Structure, group: &Group, first_slot: usize, plan: &Plan) -> TrainForces {
    let replaced = &structure.replaced;
    let n = group.bodies.len();
    let support = |(i, joint): (usize, &GroupJoint)| {
        if joint.prismatic {
            let guide = guide(structure, *joint, first_slot + i);
            TrainSupport::Shift(guide, if guide.slider == joint.body.0 { 1.0 } else { -1.0 })
        } else {
            let pin = pin_arm(replaced, *joint, joint.body);
            let hinge = Hinge { body: joint.body.0, pin, base: joint.base.0, slot: first_slot + i };
            TrainSupport::Turn(hinge, group.bodies.iter().position(|b| *b == joint.base))
        }
    };
    let members: Vec<TrainSupport> = group.joints.iter().enumerate().map(support).collect();
    let laws: Vec<usize> = group.laws.iter().map(|l| slot_of(structure, *l)).collect();
    let efforts: Vec<TrainEffort> =
        group.efforts.iter().filter_map(|&e| effort(structure, e, &structure.efforts[e])).collect();
    let mut matrix = vec![0.0; n * (laws.len() + efforts.len())];
    let columns = laws.len() + efforts.len();
    let row = |site: &LawSite| match site {
        LawSite::Turn(body) => group.joints.iter().position(|j| j.body.0 == *body && !j.prismatic),
        LawSite::Slide(guide) => group.joints.iter().position(|j| {
            j.prismatic
                && [j.body.0, j.base.0].contains(&guide.body)
                && [j.body.0, j.base.0].contains(&guide.base)
        }),
    };
    for (column, &law) in laws.iter().enumerate() {
        for (site, coefficient) in &plan.laws[law].terms {
            if let Some(row) = row(site) {
                matrix[row * columns + column] += coefficient;
            }
        }
    }
    for (i, effort) in efforts.iter().enumerate() {
        let acts = match effort {
            TrainEffort::Torque(_, body, base) => {
                vec![(LawSite::Turn(*body), 1.0), (LawSite::Turn(*base), -1.0)]
            }
            TrainEffort::Along(_, guide) => vec![(LawSite::Slide(*guide), 1.0)],
        };
        for (site, sign) in acts {
            if let Some(row) = row(&site) {
                matrix[row * columns + laws.len() + i] += sign;
            }
        }
    }
    let inverse = inverse(&matrix, n, columns);
    let unique = !inverse.is_empty() && super::train_losses::unique(&members, &laws, &matrix, plan);
    TrainForces { members, laws, efforts, matrix, inverse, unique }
}

fn inverse(matrix: &[f64], n: usize, columns: usize) -> Vec<f64> {
    if columns != n {
        return Vec::new();
    }
    let mut unit = vec![0.0; n * n];
    (0..n).for_each(|i| unit[i * n + i] = 1.0);
    ratio::solve(matrix, &unit, n).unwrap_or_default()
}

fn effort(structure: &Structure, slot: usize, effort: &Effort) -> Option<TrainEffort> {
    match effort.kind {
        EffortKind::Angle(body) => Some(TrainEffort::Torque(slot, body.0, 0)),
        EffortKind::RelativeAngle { first, second, .. } => Some(TrainEffort::Torque(slot, second.0, first.0)),
        EffortKind::Coordinate(joint) => {
            guide_of(structure, joint).map(|j| TrainEffort::Along(slot, guide(structure, j, usize::MAX)))
        }
        EffortKind::Line(_) | EffortKind::Point(_) | EffortKind::Place(..) => None,
    }
}
