//! Steps that add loads to the bodies before forces are solved.

use super::Effects;
use super::geometry::arm;
use super::step::{Anchor, Arm};
use crate::math::Vec2;
use crate::model::{
    BalanceKind, Bearing, Expr, LoadId, LoadKind, Mechanism, PairKind, Place, SpringId, Value,
};
use crate::structure::{Effort, EffortKind, EffortSource, Structure};

/// One load. Numbers that do not change over a sweep are in the step; the rest is evaluated at every position.
#[derive(Clone, Debug)]
pub enum LoadStep {
    /// The weight at the mass centre, with the inertia force −m a_S and torque −J α where `inertia` is set. The first load of
    /// its body: it is written, not added.
    Mass {
        /// Slot of the body.
        body: usize,
        /// Mass centre in the body's frame.
        centre: Arm,
        /// Mass, kg.
        mass: f64,
        /// Moment of inertia about the mass centre, kg m².
        moment_of_inertia: f64,
        /// Weight, N; null without gravity.
        weight: Vec2,
        /// Weight over mass, m/s².
        gravity: Vec2,
        /// With inertia forces.
        inertia: bool,
    },
    /// A force that does not change, at a point of a body.
    Force {
        /// The load.
        load: LoadId,
        /// Slot of the body.
        body: usize,
        /// Point in the body's frame, m.
        at: Vec2,
        /// Force, N, in ground axes or, where `turning`, in the body's axes.
        force: Vec2,
        /// The axes turn with this body.
        frame: Option<usize>,
    },
    /// A torque that does not change.
    Torque {
        /// The load.
        load: LoadId,
        /// Slot of the body.
        body: usize,
        /// Torque, N m.
        torque: f64,
    },
    /// A load with expressions, a condition, a place of the ground, or inside a pair.
    Evaluated(LoadId),
    /// A spring with a damper beside it.
    Spring {
        /// The spring.
        spring: SpringId,
        /// Its ends: slots of bodies and points in their frames, m.
        ends: [Anchor; 2],
        /// Stiffness, N/m.
        stiffness: f64,
        /// Length without load, m.
        free_length: f64,
        /// Damping, N s/m; none without a damper, so that no velocities are looked at.
        damping: Option<f64>,
    },
}

impl LoadStep {
    /// Whether it adds to the load of a body; one that is evaluated may act on any.
    pub(super) fn acts_on(&self, slot: usize) -> bool {
        match self {
            Self::Mass { body, .. } | Self::Force { body, .. } | Self::Torque { body, .. } => *body == slot,
            Self::Spring { ends, .. } => ends.iter().any(|end| end.body == slot),
            Self::Evaluated(_) => true,
        }
    }
}

/// The line of an unknown force.
#[derive(Clone, Copy, Debug)]
pub struct ForceLine {
    /// Slot of the effort.
    pub effort: usize,
    /// Slot of the body with the point of the line; the ground's for a place that does not move.
    pub body: usize,
    /// The point in its frame, m.
    pub at: Vec2,
    /// Unit direction in ground axes, or in those of `frame`.
    pub along: Vec2,
    /// The axes turn with this body.
    pub frame: Option<usize>,
}

/// The lines of the unknown forces.
pub(super) fn lines(mechanism: &Mechanism, structure: &Structure) -> Vec<ForceLine> {
    let efforts = structure.efforts.iter().enumerate();
    efforts.filter_map(|(effort, e)| line(mechanism, effort, e)).collect()
}

fn line(mechanism: &Mechanism, slot: usize, effort: &Effort) -> Option<ForceLine> {
    let (EffortKind::Line(_), EffortSource::Balance(id)) = (effort.kind, effort.source) else { return None };
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

pub(super) fn plan(mechanism: &Mechanism, effects: &Effects) -> Vec<LoadStep> {
    let mut steps = Vec::new();
    let gravity = mechanism.gravity.filter(|_| effects.gravity).map_or(Vec2::zero(), |g| g.acceleration);
    for (body, link) in mechanism.links.iter().enumerate().skip(1) {
        if let Some(m) = &link.mass
            && (effects.gravity || effects.inertia)
        {
            let gravity = if hangs(mechanism, body) { Vec2::new(gravity.norm(), 0.0) } else { gravity };
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
                LoadKind::Torque { on, value: Expr::Constant(Value::Scalar(torque)), against_motion: false },
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
    steps
}

/// Whether a link is a slider on a rope: its weight pulls along its way, in the sense in which the rope pays out.
fn hangs(mechanism: &Mechanism, link: usize) -> bool {
    mechanism.pairs.iter().any(|p| {
        matches!(&p.kind, PairKind::Prismatic(g) if p.bearing == Some(Bearing::Open) && g.slider.index() == link)
    })
}
