//! Motions of one coordinate under forces that depend on its value alone: mass and force along it are all they need.

use super::equations::Equations;
use crate::math::ode::Undefined;
use crate::model::{Expr, Load, LoadKind, Mechanism, Query};
use crate::plan::LoadStep;
use crate::solve::failure::Halt;

impl Equations<'_, '_> {
    /// Whether the value of the one free coordinate tells all forces along it.
    pub fn conserves(&self) -> bool {
        let (mechanism, plan) = (self.model.mechanism, self.model.plan);
        let damped = |load: &LoadStep| matches!(load, LoadStep::Spring { damping: Some(_), .. });
        self.reduced.is_alone()
            && self.mode.is_none()
            && self.slipping.is_none()
            && mechanism.stops.is_empty()
            && plan.genevas.is_empty()
            && !plan.effects.loses()
            && !plan.loads.iter().any(damped)
            && mechanism.loads.iter().all(|load| of_position(mechanism, load))
    }

    /// Mass and force along the coordinate at a value of it, and the powers whose works are asked for, at a unit rate.
    pub(super) fn mass_and_force(&mut self, q: f64, out: &mut [f64]) -> Result<bool, Undefined> {
        self.forget();
        if let Err(halt) = self.walk_to(q) {
            self.why = Some(halt);
            return Err(Undefined);
        }
        self.start_trial();
        self.reduce_at_unit_rate(q);
        if let Some(group) = self.trial.motion.open {
            self.why = Some(Halt::Open { group });
            return Err(Undefined);
        }
        self.evaluate_loads(self.here().0);
        let (mass, force) = self.reduced.mass_and_force(self.model, &mut self.trial, &self.evaluated);
        if mass.is_nan() || mass <= 0.0 {
            self.why = Some(self.without_acceleration());
            return Err(Undefined);
        }
        (out[0], out[1]) = (mass, force);
        self.powers(&mut out[2..], 1.0);
        Ok(true)
    }
}

/// Whether a load depends on the position alone.
fn of_position(mechanism: &Mechanism, load: &Load) -> bool {
    let against = match &load.kind {
        LoadKind::ForceAgainstMotion { .. } => true,
        LoadKind::Torque { against_motion, .. } => *against_motion,
        LoadKind::Force { .. } | LoadKind::InPair { .. } => false,
    };
    !against && load.expressions().all(|expr| is_of_position(mechanism, expr))
}

fn is_of_position(mechanism: &Mechanism, expr: &Expr) -> bool {
    let mut placed = true;
    expr.parts(&mut |part| match part {
        Expr::Query(query) => placed &= is_place(query),
        Expr::Quantity(id) => placed &= is_of_position(mechanism, &mechanism.quantities[id.index()].expr),
        _ => {}
    });
    placed
}

/// Whether a position tells it.
const fn is_place(query: &Query) -> bool {
    matches!(query, Query::Position(_) | Query::LinkDirection(_) | Query::Angle(_) | Query::Displacement(_))
}
