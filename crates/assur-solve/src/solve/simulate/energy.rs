//! Mass and force along the one coordinate, of motions that follow from the energy.

use super::equations::Equations;
use crate::math::ode::Undefined;
use crate::solve::failure::Halt;

impl Equations<'_, '_> {
    /// Mass and force along the coordinate at a value of it, and the powers whose works are asked for, at a unit rate;
    /// how far it is to each stop.
    pub(super) fn mass_and_force(&mut self, q: f64, out: &mut [f64]) -> Result<bool, Undefined> {
        self.forget();
        if let Err(halt) = self.walk_to(q) {
            self.why = Some(halt);
            return Err(Undefined);
        }
        self.start_trial();
        self.trial.motion.stops.fill(0.0);
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
        let works = self.model.mechanism.works.len();
        let (works, distances) = out[2..].split_at_mut(works);
        self.powers(works, 1.0);
        if !distances.is_empty() {
            self.follow_angles(self.here().0);
        }
        for (index, distance) in distances.iter_mut().enumerate() {
            *distance = self.distance(index);
        }
        Ok(true)
    }
}
