//! Contacts that would have to pull, ropes that would have to push, clutches and belts that would have to transmit more than their
//! friction can, and belts with a slip whose second wheel would drive: from there on the motion is another one.

use super::equations::Equations;
use super::records::within_step;
use crate::math::ode::Integrator;
use crate::math::ode::event::first_crossing;
use crate::model::{FrictionLimit, Mechanism, PairId, PairKind, Query, UnilateralCondition, Value};

/// Rounding of a force, relative to the greatest in the mechanism.
const ROUNDING: f64 = 1e-9;

/// What holds only as long as forces act as it takes them.
pub(super) struct UnilateralConditions {
    bonds: Vec<(PairId, UnilateralCondition)>,
}

impl UnilateralConditions {
    pub fn new(mechanism: &Mechanism) -> Self {
        let pairs = mechanism.pairs.iter().enumerate();
        let bonds = pairs.flat_map(|(i, pair)| pair.kind.bonds().map(move |bond| (PairId::at(i), bond)));
        Self { bonds: bonds.collect() }
    }

    /// What is open at an instant, where the motion begins or goes on in another way.
    pub fn at_once(
        &self,
        equations: &mut Equations<'_, '_>,
        t: f64,
        y: &[f64],
    ) -> Option<(PairId, UnilateralCondition)> {
        let known = !self.bonds.is_empty() && equations.observe(t, y, true);
        let noise = ROUNDING * equations.greatest_force();
        self.bonds.iter().copied().find(|bond| known && equations.holding_force(*bond) < -noise)
    }

    /// The first of them that opens within the last step, and when.
    pub fn first<M: Integrator<f64>>(
        &self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) -> Option<(f64, (PairId, UnilateralCondition))> {
        if self.bonds.is_empty() {
            return None;
        }
        let step = (method.previous_t(), method.t());
        let mut y = method.y().to_vec();
        let mut first: Option<(f64, (PairId, UnilateralCondition))> = None;
        for bond in &self.bonds {
            let mut force = |t: f64| {
                let known = within_step(equations, method, t, &mut y) && equations.observe(t, &y, true);
                let noise = ROUNDING * equations.greatest_force();
                if known { (equations.holding_force(*bond), noise) } else { (f64::NAN, f64::NAN) }
            };
            let (begin, noise) = force(step.0);
            let noise = noise.max(force(step.1).1);
            // what was nothing before is nothing as long as rounding alone makes it negative
            let below = if begin > noise { 0.0 } else { noise };
            let found = first_crossing(step, None, |t| force(t).0 + below).filter(|c| !c.rising);
            if let Some(c) = found.filter(|c| first.is_none_or(|(earliest, _)| c.t < earliest)) {
                first = Some((c.t, *bond));
            }
        }
        first
    }
}

impl Equations<'_, '_> {
    /// What presses a contact together or pulls a rope in the state that is observed, N; the least of a rope's parts. Of a belt with a
    /// slip what the force loses on its way from the first wheel to the second, and what a grip can take beside what it transmits, N or
    /// N m.
    fn holding_force(&self, (pair, bond): (PairId, UnilateralCondition)) -> f64 {
        let (view, kind) = (self.view(), &self.model.mechanism.pair(pair).kind);
        let forces = self.trial.forces.law_forces.iter().zip(&self.model.plan.laws);
        let forces = forces.filter(|(_, law)| law.pair == pair);
        match (bond, kind) {
            (UnilateralCondition::Presses, PairKind::Contact { first, .. }) => {
                match view.query(&Query::Normal(pair, first.link)) {
                    Value::Scalar(normal) => normal,
                    _ => f64::NAN,
                }
            }
            (UnilateralCondition::Grips, PairKind::Transmission(t)) => {
                t.grip.map_or(f64::NAN, FrictionLimit::capacity) - view.tangential_force(pair)
            }
            (UnilateralCondition::Drives, _) => {
                let lost = forces
                    .map(|(f, law)| (f.sides[0].abs() - f.sides[1].abs()) * (f.multiplier * law.force).abs());
                lost.fold(f64::INFINITY, f64::min)
            }
            _ => forces.map(|(_, law)| view.tension(pair, law.index, None)).fold(f64::INFINITY, f64::min),
        }
    }

    /// The greatest force in a pair or a transmission in the state that is observed, N.
    pub fn greatest_force(&self) -> f64 {
        let forces = &self.trial.forces;
        let reactions = forces.reactions.iter().map(|r| r.force.norm());
        let pulls = forces.law_forces.iter().zip(&self.model.plan.laws);
        let pulls = pulls.map(|(f, law)| (f.multiplier * law.force * f.sides[0]).abs());
        reactions.chain(pulls).fold(0.0, f64::max)
    }
}
