//! Steps that add loads to the bodies before forces are solved.

use super::effects::Effects;
use super::geometry::arm;
use super::load_step::{ForceLine, LoadStep};
use super::step::Anchor;
use crate::math::Vec2;
use crate::model::{
    BalanceKind, Bearing, DriveTarget, Expr, LinkId, LoadId, LoadKind, Mechanism, PairId, PairKind, Place,
    SpringId, Value,
};
use crate::structure::{BodyOrigin, Effort, EffortKind, EffortSource, JointKind, Structure};
use std::collections::HashSet;

/// The lines of the unknown forces.
pub(super) fn lines(mechanism: &Mechanism, structure: &Structure, lines: &mut Vec<ForceLine>) {
    let efforts = structure.efforts.iter().enumerate();
    lines.clear();
    lines.extend(efforts.filter_map(|(effort, e)| line(mechanism, structure, (effort, e))));
}

fn line(mechanism: &Mechanism, structure: &Structure, (slot, effort): (usize, &Effort)) -> Option<ForceLine> {
    let id = match (effort.kind, effort.source) {
        (EffortKind::Line(_), EffortSource::Balance(id)) => id,
        (EffortKind::Line(_), EffortSource::Drive(id)) => {
            let drive = &mechanism.drives[id.index()];
            let DriveTarget::Place(on, at, axis) = drive.target else { return None };
            let tangent = if drive.free { tangent(mechanism, structure, on) } else { None };
            let (frame, along) = tangent.map_or((None, axis.unit()), |(frame, along)| (Some(frame), along));
            return Some(ForceLine { effort: slot, body: on.index(), at, along, frame });
        }
        _ => return None,
    };
    let BalanceKind::Force { on, at, along, frame } = &mechanism.balances[id.index()].kind else {
        return None;
    };
    let (body, at) = match at {
        Place::Local(at) => (on.index(), *at),
        // a place of the ground: `check` folds it to numbers
        Place::Ground(Expr::Constant(Value::Vector(at))) => (0, *at),
        Place::Ground(_) => (0, Vec2::new(f64::NAN, f64::NAN)),
    };
    Some(ForceLine { effort: slot, body, at, along: *along, frame: frame.map(|f| f.index()) })
}

/// The direction in which a link in contact can move, in the frame of a body, where one coordinate of its place is free: the effort
/// there is nothing in any direction, and across the normal friction does not lock it.
fn tangent(mechanism: &Mechanism, structure: &Structure, link: LinkId) -> Option<(usize, Vec2)> {
    let places =
        mechanism.drives.iter().filter(|d| matches!(d.target, DriveTarget::Place(on, ..) if on == link));
    let mut contacts = mechanism.pairs.iter().enumerate().filter(|(_, pair)| {
        matches!(pair.kind, PairKind::Contact { .. }) && pair.kind.links().contains(&link)
    });
    let (contact, _) = contacts.next()?;
    if places.count() != 1 || contacts.next().is_some() {
        return None;
    }
    let replaced = &structure.replaced;
    replaced.joints_of(PairId::at(contact)).find_map(|joint| match &replaced.joint(joint).kind {
        JointKind::Prismatic { guide, along, .. } => Some((guide.0, *along)),
        // across the rod between two centres
        JointKind::Revolute(members) => {
            let rod = members.iter().map(|(body, _)| body.0);
            let rod = rod
                .into_iter()
                .find(|body| matches!(replaced.bodies[*body].origin, BodyOrigin::Imaginary(_)))?;
            let slides = replaced
                .joints_of(PairId::at(contact))
                .any(|joint| matches!(replaced.joint(joint).kind, JointKind::Prismatic { .. }));
            (!slides).then_some((rod, Vec2::new(0.0, 1.0)))
        }
        JointKind::Weld { .. } | JointKind::Law(_) => None,
    })
}

pub(super) fn plan(mechanism: &Mechanism, effects: &Effects, steps: &mut Vec<LoadStep>) {
    steps.clear();
    let masses = mechanism.links.iter().filter(|link| link.mass.is_some()).count();
    steps.reserve_exact(masses + mechanism.loads.len() + mechanism.springs.len());
    let gravity = mechanism.gravity.filter(|_| effects.gravity).map_or(Vec2::zero(), |g| g.acceleration);
    let hanging = hanging(mechanism);
    for (body, link) in mechanism.links.iter().enumerate().skip(1) {
        if let Some(m) = &link.mass
            && (effects.gravity || effects.inertia)
        {
            let gravity = if hanging.contains(&body) { Vec2::new(gravity.norm(), 0.0) } else { gravity };
            steps.push(LoadStep::Mass {
                body,
                centre: arm(m.centre),
                mass: m.mass,
                moment_of_inertia: m.inertia,
                weight: gravity * m.mass,
                gravity,
                inertia: effects.inertia,
            });
        }
    }
    for (i, load) in mechanism.loads.iter().enumerate() {
        let id = LoadId::at(i);
        // a load on a pin that is fixed to the ground
        if load.link() == Some(LinkId::GROUND) {
            continue;
        }
        let step = match (&load.kind, &load.when) {
            (
                LoadKind::Force {
                    on,
                    at: Place::Local(at),
                    value: Expr::Constant(Value::Vector(force)),
                    frame,
                },
                None,
            ) => LoadStep::Force {
                load: id,
                body: on.index(),
                at: *at,
                force: *force,
                frame: frame.map(|f| f.index()),
            },
            (
                LoadKind::Torque {
                    on,
                    value: Expr::Constant(Value::Scalar(torque)),
                    against_motion: false,
                    ..
                },
                None,
            ) => LoadStep::Torque { load: id, body: on.index(), torque: *torque },
            _ => LoadStep::Evaluated(id),
        };
        steps.push(step);
    }
    steps.extend(mechanism.springs.iter().enumerate().map(|(i, s)| LoadStep::Spring {
        spring: SpringId::at(i),
        ends: [s.from, s.to].map(|(link, at)| Anchor { body: link.index(), at }),
        stiffness: s.stiffness,
        free_length: s.free_length,
        damping: (s.damping > 0.0).then_some(s.damping),
    }));
}

/// Links that are sliders on a rope: their weights pull along their ways, in the sense in which the rope pays out.
fn hanging(mechanism: &Mechanism) -> HashSet<usize> {
    let open = mechanism.pairs.iter().filter(|p| p.bearing == Some(Bearing::Open));
    let sliders = open.filter_map(|p| match &p.kind {
        PairKind::Prismatic(g) => Some(g.slider.index()),
        _ => None,
    });
    sliders.collect()
}
