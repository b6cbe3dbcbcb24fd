//! What friction and losses bear where they hold. What holds alone bears what is left of the loads; how several share it that depend on
//! each other, or a pair beside a brake or a stop, is not determined.

use super::equations::Equations;
use super::sliding_sense::Slipping;
use crate::position::ContactMode;

impl Equations<'_, '_> {
    /// Puts what the elements of friction bear that hold, where everything was evaluated.
    pub fn take_held(&mut self) {
        if let Some(slipping) = self.slipping.take() {
            self.mark_open(&slipping);
            self.slipping = Some(slipping);
        }
    }

    /// How all elements move, as the mechanism as it is written has them, where their speeds do not tell it.
    pub fn grips(&self) -> Vec<ContactMode> {
        let grips = &self.trial.motion.grips;
        if self.slipping.is_none() {
            return Vec::new();
        }
        self.chart.map_or_else(|| grips.clone(), |chart| chart.grips(grips))
    }

    /// Marks the elements that hold and whose speeds depend on those of others that hold.
    fn mark_open(&mut self, slipping: &Slipping) {
        let held: Vec<usize> = (0..slipping.senses.len()).filter(|&e| slipping.senses[e] == 0.0).collect();
        if held.len() == slipping.held.len() {
            // none depends on others
            return;
        }
        for &element in &held {
            let mut basis = self.basis(&[]);
            for &other in held.iter().filter(|other| **other != element) {
                self.is_independent(other, &mut basis);
            }
            let alone = !slipping.undetermined && self.is_independent(element, &mut basis);
            self.trial.motion.grips[element].open = !alone;
        }
    }
}
