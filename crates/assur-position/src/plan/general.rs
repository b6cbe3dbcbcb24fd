//! Groups without a closed form: their joints, drives and efforts as scalar constraints for Newton's method.

use super::general_step::{BalanceSystem, GeneralMotion, UnknownForce};
use super::geometry::{guide, pin_arm};
use super::joint::Hinge;
use crate::group::general::{Constraint, General, Law, Line, Point};
use crate::math::Vec2;
use crate::structure::{BodyId, EffortKind, EffortSource, Group, GroupJoint, JointKind, Structure};

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

pub(super) fn problem(structure: &Structure, group: &Group) -> GeneralMotion {
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
            EffortKind::Line(_) | EffortKind::Point(_) => continue,
        };
        driven.push((constraints.len(), drive.index()));
        constraints.push(constraint);
    }
    let equations = General::new(places.moving, places.slots.len(), constraints).ok();
    GeneralMotion { bodies: places.slots, moving: places.moving, equations, driven, round }
}

pub(super) fn balance_system(structure: &Structure, group: &Group, first_slot: usize) -> BalanceSystem {
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
    for &effort in &group.efforts {
        let (constraint, unknown) = match structure.efforts[effort].kind {
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
            EffortKind::Point(_) => continue,
        };
        if matches!(unknown, UnknownForce::Torque { .. }) {
            torques.push(constraints.len());
        }
        constraints.push(constraint);
        unknowns.push(unknown);
    }
    let equations = General::new(places.moving, places.slots.len(), constraints).ok();
    BalanceSystem { bodies: places.slots, moving: places.moving, equations, unknowns, lines, torques }
}
