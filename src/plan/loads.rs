//! Steps that add loads to the bodies before forces are solved.

use super::Effects;
use crate::math::Vec2;
use crate::model::{Bearing, Expr, LoadId, LoadKind, Mechanism, PairKind, Place, SpringId, Value};

/// One load. Numbers that do not change over a sweep are in the step; the rest is evaluated at every position.
#[derive(Clone, Debug)]
pub enum LoadStep {
    /// Weight m g at the mass centre, with the inertia force −m a_S and torque −J α where `inertia` is set.
    Mass {
        /// Slot of the body.
        body: usize,
        /// Mass centre in the body's frame, m.
        centre: Vec2,
        /// Mass, kg.
        mass: f64,
        /// Moment of inertia about the mass centre, kg m².
        moment_of_inertia: f64,
        /// Acceleration of free fall, m/s²; null without gravity.
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
    /// A spring.
    Spring(SpringId),
}

pub(super) fn plan(mechanism: &Mechanism, effects: &Effects) -> Vec<LoadStep> {
    let mut steps = Vec::new();
    let gravity = mechanism.gravity.filter(|_| effects.gravity).map_or(Vec2::zero(), |g| g.acceleration);
    for (body, link) in mechanism.links.iter().enumerate().skip(1) {
        if let Some(m) = &link.mass
            && (effects.gravity || effects.inertia)
        {
            steps.push(LoadStep::Mass {
                body,
                centre: m.centre,
                mass: m.mass,
                moment_of_inertia: m.inertia,
                gravity: if hangs(mechanism, body) { Vec2::new(gravity.norm(), 0.0) } else { gravity },
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
    steps.extend((0..mechanism.springs.len()).map(|i| LoadStep::Spring(SpringId::at(i))));
    steps
}

/// Whether a link is a slider on a rope: its weight pulls along its way, in the sense in which the rope pays out.
fn hangs(mechanism: &Mechanism, link: usize) -> bool {
    mechanism.pairs.iter().any(|p| {
        matches!(&p.kind, PairKind::Prismatic(g) if p.bearing == Some(Bearing::Open) && g.slider.index() == link)
    })
}
