//! Contacts that would have to pull, ropes that would have to push, and belts that slip with the second wheel driving: from there on
//! the motion is another one.

use super::equations::Equations;
use super::records::within_step;
use super::slipping::Mode;
use crate::math::ode::Integrator;
use crate::math::ode::event::first_crossing;
use crate::model::{Mechanism, PairId, PairKind, Query, TransmissionKind, Value};

/// Rounding of a force, relative to the greatest in the mechanism.
const ROUNDING: f64 = 1e-9;

/// What holds only as long as it presses, pulls, or passes power on.
pub(super) struct Openings {
    pairs: Vec<PairId>,
}

impl Openings {
    pub fn new(mechanism: &Mechanism) -> Self {
        let pairs = mechanism.pairs.iter().enumerate().filter(|(_, pair)| match &pair.kind {
            PairKind::Contact { .. } => true,
            PairKind::Transmission(t) => t.kind == TransmissionKind::Rope || t.slip > 0.0,
            _ => false,
        });
        Self { pairs: pairs.map(|(i, _)| PairId::at(i)).collect() }
    }

    /// What is open at an instant.
    pub fn at_once(&self, equations: &mut Equations<'_, '_>, t: f64, y: &[f64]) -> Option<PairId> {
        let known = !self.pairs.is_empty() && equations.observe(t, y, true);
        let noise = ROUNDING * equations.greatest_force();
        self.pairs.iter().copied().find(|pair| known && equations.holding_force(*pair) < -noise)
    }

    /// The first of them that opens within the last step, and when.
    pub fn first<M: Integrator<f64>>(
        &self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) -> Option<(f64, PairId)> {
        if self.pairs.is_empty() || equations.mode == Some(Mode::Resting) {
            // what friction takes is not determined
            return None;
        }
        let step = (method.previous_t(), method.t());
        let mut y = method.y().to_vec();
        let mut first: Option<(f64, PairId)> = None;
        for pair in &self.pairs {
            let mut force = |t: f64| {
                let known = within_step(equations, method, t, &mut y) && equations.observe(t, &y, true);
                let noise = ROUNDING * equations.greatest_force();
                if known { (equations.holding_force(*pair), noise) } else { (f64::NAN, f64::NAN) }
            };
            let (begin, noise) = force(step.0);
            let noise = noise.max(force(step.1).1);
            // what was nothing before is nothing as long as rounding alone makes it negative
            let below = if begin > noise { 0.0 } else { noise };
            let found = first_crossing(step, None, |t| force(t).0 + below).filter(|c| !c.rising);
            if let Some(c) = found.filter(|c| first.is_none_or(|(earliest, _)| c.t < earliest)) {
                first = Some((c.t, *pair));
            }
        }
        first
    }
}

impl Equations<'_, '_> {
    /// What presses a contact together or pulls a rope in the state that is observed, N; the least of a rope's parts. Of a belt that
    /// slips what the force loses on its way from the first wheel to the second.
    fn holding_force(&self, pair: PairId) -> f64 {
        let view = self.view();
        match &self.model.mechanism.pair(pair).kind {
            PairKind::Contact { first, .. } => match view.query(&Query::Normal(pair, first.link)) {
                Value::Scalar(normal) => normal,
                _ => f64::NAN,
            },
            PairKind::Transmission(t) if t.slip > 0.0 => {
                let forces = self.trial.forces.law_forces.iter().zip(&self.model.plan.laws);
                let of_pair = forces.filter(|(_, law)| law.pair == pair);
                let lost = of_pair
                    .map(|(f, law)| (f.sides[0].abs() - f.sides[1].abs()) * (f.multiplier * law.force).abs());
                lost.fold(f64::INFINITY, f64::min)
            }
            _ => {
                let laws = self.model.plan.laws.iter().filter(|law| law.pair == pair);
                laws.map(|law| view.tension(pair, law.index)).fold(f64::INFINITY, f64::min)
            }
        }
    }

    /// The greatest force in a pair or a transmission in the state that is observed, N.
    fn greatest_force(&self) -> f64 {
        let forces = &self.trial.forces;
        let reactions = forces.reactions.iter().map(|r| r.force.norm());
        let pulls = forces.law_forces.iter().zip(&self.model.plan.laws);
        let pulls = pulls.map(|(f, law)| (f.multiplier * law.force * f.sides[0]).abs());
        reactions.chain(pulls).fold(0.0, f64::max)
    }
}
