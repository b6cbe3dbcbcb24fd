//! Groups without a closed form: their joints, drives and efforts as scalar constraints for Newton's method.

use super::general_step::{BalanceSystem, GeneralMotion, SharedPlace, UnknownForce};
use super::geometry::{guide, pin_arm};
use super::joint::Hinge;
use super::planned::Plan;
use super::train::{counted_turns, slot_of};
use crate::group::general::{Constraint, GearTerm, Geared, Gearing, General, Law, Line, Point};
use crate::math::Vec2;
use crate::structure::{BodyId, BodyRate, EffortKind, EffortSource, Group, GroupJoint, JointKind, Structure};

/// Steps of the motion are not made shorter than by this.
const MOST_FASTER: f64 = 100.0;

/// Places of bodies in the slices of a system.
struct Places {
    slots: Vec<usize>,
    moving: usize,
}

impl Places {
    fn new(group: &Group) -> Self {
        let slots: Vec<usize> = group.bodies.iter().map(|b| b.0).collect();
        let moving = slots.len();
        Self { slots, moving }
    }

    fn of(&mut self, body: BodyId) -> usize {
        match self.slots.iter().position(|&s| s == body.0) {
            Some(place) => place,
            None => {
                self.slots.push(body.0);
                self.slots.len() - 1
            }
        }
    }
}

fn hinge(structure: &Structure, joint: GroupJoint, places: &mut Places) -> Constraint {
    let pin = |body| super::geometry::pin(&structure.replaced, joint, body);
    Constraint::Revolute {
        a: Point { body: places.of(joint.body), r: pin(joint.body) },
        b: Point { body: places.of(joint.base), r: pin(joint.base) },
    }
}

/// The parts of a prismatic joint: the angle (unless it follows from others) and the offset with its radius.
fn prismatic(
    structure: &Structure,
    joint: GroupJoint,
    places: &mut Places,
) -> Option<(Option<Constraint>, Point, Line, f64)> {
    let JointKind::Prismatic {
        slider, point, direction, guide, through, along, offset, angle_redundant, ..
    } = structure.replaced.joint(joint.joint).kind
    else {
        return None;
    };
    let (s, g) = (places.of(slider), places.of(guide));
    let angle = (!angle_redundant).then(|| Constraint::parallel(g, along, s, direction));
    Some((angle, Point { body: s, r: point }, Line { body: g, r: through, d: along }, offset))
}

fn law(value: f64) -> Law {
    Law { value, ..Law::default() }
}

fn torque(a: usize, b: usize) -> Constraint {
    Constraint::Angle { a, b, angle: Vec2::new(1.0, 0.0), rate: 0.0, second: 0.0 }
}

/// What a rate is the rate of.
fn coordinate(structure: &Structure, rate: BodyRate, places: &mut Places) -> Option<Geared> {
    match rate {
        BodyRate::Turn(body) => Some(Geared::turn(places.of(body))),
        BodyRate::Slide(id) => match structure.replaced.joint(id).kind {
            JointKind::Prismatic { slider, point, guide, through, along, .. } => Some(Geared::Slide {
                point: Point { body: places.of(slider), r: point },
                line: Line { body: places.of(guide), r: through, d: along },
            }),
            JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => None,
        },
    }
}

/// The efforts of a group that act at several places: their multiplier is the effort where the law is the sum of their rates.
fn shared(
    structure: &Structure,
    group: &Group,
    places: &mut Places,
) -> (Vec<(usize, Vec<SharedPlace>)>, Vec<Gearing>) {
    let (mut all, mut laws) = (Vec::new(), Vec::new());
    for &effort in &group.efforts {
        if structure.efforts[effort].only().is_some() {
            continue;
        }
        let (mut at, mut terms) = (Vec::new(), Vec::new());
        let mut term = |rate, coefficient| {
            terms.extend(coordinate(structure, rate, places).map(|of| GearTerm { of, coefficient }));
        };
        for kind in structure.efforts[effort].places() {
            match kind {
                EffortKind::Angle(body) => {
                    term(BodyRate::Turn(body), 1.0);
                    at.push(SharedPlace::Torque(body.0, 0));
                }
                EffortKind::RelativeAngle { first, second, .. } => {
                    term(BodyRate::Turn(second), 1.0);
                    term(BodyRate::Turn(first), -1.0);
                    at.push(SharedPlace::Torque(second.0, first.0));
                }
                EffortKind::Coordinate(id) => {
                    let JointKind::Prismatic { slider, guide: base, .. } = structure.replaced.joint(id).kind
                    else {
                        continue;
                    };
                    term(BodyRate::Slide(id), 1.0);
                    let joint = GroupJoint { joint: id, body: slider, base, prismatic: true, inner: true };
                    at.push(SharedPlace::Along(guide(structure, joint, 0)));
                }
                EffortKind::Line(_) | EffortKind::Point(_) | EffortKind::Place(..) => {}
            }
        }
        all.push((effort, at));
        laws.push(Gearing::new(terms, 0.0));
    }
    (all, laws)
}

/// The laws of wheels of a group, with their slots.
fn laws(structure: &Structure, group: &Group, plan: &Plan, places: &mut Places) -> Vec<(usize, Gearing)> {
    let replaced = &structure.replaced;
    let laws = group.laws.iter().filter_map(|&id| {
        let JointKind::Law(terms) = &replaced.joint(id).kind else { return None };
        let slot = slot_of(structure, id);
        let terms = terms.iter().filter_map(|&(rate, coefficient)| {
            Some(GearTerm { of: coordinate(structure, rate, places)?, coefficient })
        });
        Some((slot, Gearing::new(terms.collect(), plan.laws[slot].constant)))
    });
    laws.collect()
}

/// Bodies whose angles the laws speak of.
fn turning(
    structure: &Structure,
    laws: &[(usize, Gearing)],
    places: &Places,
    plan: &Plan,
) -> Vec<(usize, bool, bool)> {
    let counted = counted_turns(structure, plan);
    let mut found: Vec<(usize, bool, bool)> = Vec::new();
    for term in laws.iter().flat_map(|l| &l.1.terms) {
        if let Geared::Turn { body, .. } = term.of {
            let (slot, member) = (places.slots[body], body < places.moving);
            if !found.iter().any(|f| f.0 == slot) {
                found.push((slot, member, !member && !counted[slot]));
            }
        }
    }
    found
}

/// How many times as fast as another body a law may turn one.
fn faster(law: &Gearing) -> f64 {
    let turns = || {
        let turning = law.terms.iter().filter(|t| matches!(t.of, Geared::Turn { .. }));
        turning.map(|t| t.coefficient.abs()).filter(|c| *c > 0.0)
    };
    (turns().fold(0.0, f64::max) / turns().fold(f64::INFINITY, f64::min)).clamp(1.0, MOST_FASTER)
}

pub(super) fn problem(structure: &Structure, group: &Group, plan: &Plan) -> GeneralMotion {
    let mut places = Places::new(group);
    let (mut constraints, mut driven, mut round) = (Vec::new(), Vec::new(), Vec::new());
    for &joint in &group.joints {
        if !joint.prismatic {
            constraints.push(hinge(structure, joint, &mut places));
        } else if let Some((angle, point, line, offset)) = prismatic(structure, joint, &mut places) {
            constraints.extend(angle);
            if offset > 0.0 {
                round.push((constraints.len(), offset));
            }
            constraints.push(Constraint::Offset { point, line, law: law(offset) });
        }
    }
    for link in &structure.passive {
        if group.bodies.contains(&BodyId(link.index())) {
            let (ground, body) = (places.of(BodyId::GROUND), places.of(BodyId(link.index())));
            constraints.push(torque(ground, body));
        }
    }
    for &index in &group.efforts {
        let effort = &structure.drives[index];
        let EffortSource::Drive(drive) = effort.source else { continue };
        let constraint = match effort.kind {
            EffortKind::Angle(body) => torque(places.of(BodyId::GROUND), places.of(body)),
            EffortKind::RelativeAngle { first, second, .. } => torque(places.of(first), places.of(second)),
            EffortKind::Coordinate(id) => {
                let Some(&joint) = group.joints.iter().find(|j| j.joint == id) else { continue };
                let Some((_, point, line, _)) = prismatic(structure, joint, &mut places) else { continue };
                Constraint::Coordinate { point, line, law: law(0.0) }
            }
            EffortKind::Place(body, at, axis) => {
                let point = Point { body: places.of(body), r: at };
                let line = Line { body: places.of(BodyId::GROUND), r: Vec2::zero(), d: axis.unit() };
                Constraint::Coordinate { point, line, law: law(0.0) }
            }
            EffortKind::Line(_) | EffortKind::Point(_) => continue,
        };
        let ahead = effort.is_aside().then(|| effort.axes[0].turned_back(effort.axes[1]));
        driven.push((constraints.len(), drive.index(), ahead));
        constraints.push(constraint);
    }
    let laws = laws(structure, group, plan, &mut places);
    let turning = turning(structure, &laws, &places, plan);
    let (slots, laws): (Vec<usize>, Vec<Gearing>) = laws.into_iter().unzip();
    let faster = laws.iter().map(faster).fold(1.0, f64::max);
    let equations = General::with_laws(places.moving, places.slots.len(), constraints, laws).ok();
    GeneralMotion {
        bodies: places.slots,
        moving: places.moving,
        equations,
        driven,
        round,
        turning,
        laws: slots,
        faster,
    }
}

pub(super) fn balance_system(
    structure: &Structure,
    group: &Group,
    first_slot: usize,
    plan: &Plan,
) -> BalanceSystem {
    let mut places = Places::new(group);
    let (mut constraints, mut unknowns, mut lines) = (Vec::new(), Vec::new(), Vec::new());
    let mut torques = Vec::new();
    for (i, &joint) in group.joints.iter().enumerate() {
        let slot = first_slot + i;
        if !joint.prismatic {
            let pin = pin_arm(&structure.replaced, joint, joint.body);
            let at = Hinge { body: joint.body.0, pin, base: joint.base.0, slot };
            constraints.push(hinge(structure, joint, &mut places));
            unknowns.push(UnknownForce::Hinge { slot, hinge: at });
        } else if let Some((angle, point, line, offset)) = prismatic(structure, joint, &mut places) {
            let guide = guide(structure, joint, slot);
            if let Some(angle) = angle {
                constraints.push(angle);
                unknowns.push(UnknownForce::Couple(guide));
            }
            constraints.push(Constraint::Offset { point, line, law: law(offset) });
            unknowns.push(UnknownForce::Normal(guide));
        }
    }
    for link in &structure.passive {
        if group.bodies.contains(&BodyId(link.index())) {
            let (ground, body) = (places.of(BodyId::GROUND), places.of(BodyId(link.index())));
            constraints.push(torque(ground, body));
            unknowns.push(UnknownForce::Passive);
        }
    }
    let (shared, mut gearings) = shared(structure, group, &mut places);
    for &effort in &group.efforts {
        let Some(kind) = structure.efforts[effort].only() else { continue };
        let (constraint, unknown) = match kind {
            EffortKind::Angle(body) => (
                torque(places.of(BodyId::GROUND), places.of(body)),
                UnknownForce::Torque { effort, body: body.0, base: 0 },
            ),
            EffortKind::RelativeAngle { first, second, .. } => (
                torque(places.of(first), places.of(second)),
                UnknownForce::Torque { effort, body: second.0, base: first.0 },
            ),
            EffortKind::Coordinate(id) => {
                let Some(i) = group.joints.iter().position(|j| j.joint == id) else { continue };
                let joint = group.joints[i];
                let Some((_, point, line, _)) = prismatic(structure, joint, &mut places) else { continue };
                let guide = guide(structure, joint, first_slot + i);
                (Constraint::Coordinate { point, line, law: law(0.0) }, UnknownForce::Along { effort, guide })
            }
            EffortKind::Line(body) => {
                lines.push((constraints.len(), effort));
                let point = Point { body: places.of(body), r: Vec2::zero() };
                let line = Line { body: places.of(BodyId::GROUND), r: Vec2::zero(), d: Vec2::new(1.0, 0.0) };
                (Constraint::Coordinate { point, line, law: law(0.0) }, UnknownForce::Line(effort))
            }
            EffortKind::Point(_) | EffortKind::Place(..) => continue,
        };
        if matches!(unknown, UnknownForce::Torque { .. }) {
            torques.push(constraints.len());
        }
        constraints.push(constraint);
        unknowns.push(unknown);
    }
    let (slots, laws): (Vec<usize>, Vec<Gearing>) =
        laws(structure, group, plan, &mut places).into_iter().unzip();
    gearings.extend(laws);
    let equations = General::with_laws(places.moving, places.slots.len(), constraints, gearings).ok();
    BalanceSystem {
        bodies: places.slots,
        moving: places.moving,
        equations,
        unknowns,
        lines,
        torques,
        shared,
        laws: slots,
    }
}
