//! Forces against the motion at points that may move in several directions: they act by the velocity. Where such a point comes to rest
//! the force would change its direction at every evaluation.

use super::equations::Equations;
use super::event_detector::AT_ONCE;
use crate::math::Vec2;
use crate::math::ode::Integrator;
use crate::model::{LoadId, LoadKind, Place};
use crate::position::State;

/// A motion has fewer reversals than `MANY` within the part `SOON` of a run. More of them mean that the point is at rest.
const MANY: usize = 8;
const SOON: f64 = 1e6 * AT_ONCE;

/// The last reversals of points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reversals([f64; MANY]);

impl Default for Reversals {
    fn default() -> Self {
        Self([f64::NEG_INFINITY; MANY])
    }
}

impl Reversals {
    /// The load whose point has come to rest in the last step, in a run of this length, s.
    pub fn detect<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &M,
        length: f64,
    ) -> Option<LoadId> {
        let plan = equations.model.plan;
        let apart = |id: LoadId| !plan.opposing.iter().any(|load| load.load == id);
        let mut loads = equations.model.mechanism.loads.iter().enumerate();
        let any = loads.any(|(index, load)| load.is_against_motion() && apart(LoadId::at(index)));
        if !any || !equations.is_braked() {
            return None;
        }
        let loads: Vec<_> =
            equations.acting().filter(|(id, load, _)| load.is_against_motion() && apart(*id)).collect();
        let mut rests = None;
        for (id, load, _) in loads {
            let LoadKind::ForceAgainstMotion { on, at, .. } = &load.kind else { continue };
            let before = velocity(&equations.accepted.1, on.index(), at);
            if !equations.observe(method.t(), method.y(), false) {
                return None;
            }
            if before.dot(velocity(&equations.trial, on.index(), at)) >= 0.0 {
                continue;
            }
            self.0.rotate_left(1);
            self.0[MANY - 1] = method.t();
            if method.t() - self.0[0] <= SOON * length {
                rests = Some(id);
            }
        }
        rests
    }
}

/// The velocity of the point at which a force acts.
fn velocity(state: &State, body: usize, at: &Place) -> Vec2 {
    let body = &state.motion.bodies[body];
    match at {
        Place::Local(at) => body.velocity(*at),
        Place::Ground(crate::model::Expr::Constant(crate::model::Value::Vector(p))) => {
            body.v + (*p - body.p).perp() * body.omega
        }
        Place::Ground(_) => Vec2::zero(),
    }
}
