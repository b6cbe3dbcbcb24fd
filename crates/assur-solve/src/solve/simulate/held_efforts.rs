//! What friction and losses bear where they hold. What holds alone bears what is left of the loads; how several share it that depend on
//! each other, or a pair beside a brake or a stop, is not determined.

use super::dissipative::DissipativeElement;
use super::equations::Equations;
use super::sliding_sense::{Mode, Slipping};
use crate::math::Vec2;
use crate::position::ContactMode;

impl Equations<'_, '_> {
    /// Puts what the elements of friction bear that hold, where everything was evaluated.
    pub fn take_held(&mut self) {
        if let Some(slipping) = self.slipping.take() {
            self.mark_open(&slipping);
            self.slipping = Some(slipping);
        } else if self.mode == Some(Mode::Resting) {
            self.hold_at_rest();
        } else if self.leaves_rest() {
            // the speed does not tell the senses in which it begins to slide
            let losing = self.senses_of_losses();
            let senses = self.trial.forces.senses.iter().chain(&losing);
            self.trial.motion.grips.clear();
            self.trial
                .motion
                .grips
                .extend(senses.map(|&sense| ContactMode { sense, ..ContactMode::default() }));
        }
    }

    /// Whether the one coordinate, which rubs, begins to move.
    fn leaves_rest(&self) -> bool {
        let rate = || self.trial.motion.inputs[self.reduced.free()[0]].rate;
        matches!(self.mode, Some(Mode::Moving(_))) && rate() == 0.0
    }

    /// The senses in which the sides of transmissions with losses begin to move with the one coordinate.
    fn senses_of_losses(&mut self) -> Vec<f64> {
        let Some(Mode::Moving(sense)) = self.mode else { return Vec::new() };
        let plan = self.model.plan;
        let laws = plan.losing.iter().map(|slot| &plan.laws[*slot]);
        laws.map(|law| {
            sense * self.reduced.at_unit_rate(0, &mut self.trial, |state| state.law_speed(law)).signum()
        })
        .collect()
    }

    /// The one coordinate rests by friction or losses.
    fn hold_at_rest(&mut self) {
        let (count, all) =
            (DissipativeElement::inner(self.model.plan), DissipativeElement::count(self.model.plan));
        let grips = &mut self.trial.motion.grips;
        grips.clear();
        grips.resize(all, ContactMode { open: true, ..ContactMode::default() });
        let loads = self.model.mechanism.loads.iter().enumerate();
        let against: Vec<usize> =
            loads.filter(|(_, load)| load.is_against_motion()).map(|(i, _)| i).collect();
        if count + against.len() != 1 || !self.closed.is_empty() {
            return;
        }
        if let [load] = against[..] {
            grips.clear();
            return self.hold_by_load(load);
        }
        self.evaluate_loads(self.trial.motion.time);
        let left = self.left_with(0.0);
        let holds = match left {
            // the effort that is left is linear in what holds
            Some(left) if left != 0.0 => self.left_with(left).map(|then| left * left / (left - then)),
            none => none,
        };
        let known = holds.filter(|effort| effort.is_finite() && self.left_with(*effort).is_some());
        if known.is_none() {
            self.trial.motion.grips[0] = ContactMode { open: true, ..ContactMode::default() };
        }
    }

    /// The one coordinate rests by a load against the motion alone.
    fn hold_by_load(&mut self, load: usize) {
        let drive = self.reduced.free()[0];
        let rate = std::mem::replace(&mut self.trial.motion.inputs[drive].rate, 1.0);
        self.trial.run_motion::<1>(self.model.plan);
        let against = std::mem::take(&mut self.trial.motion.against);
        let part = self.view().against_velocity(load);
        self.trial.motion.against = against;
        self.trial.motion.inputs[drive].rate = rate;
        let mut left = [0.0; 2];
        for (effort, left) in [0.0, 1.0].into_iter().zip(&mut left) {
            self.trial.motion.against[load].held = part * effort;
            if self.accelerations_without_friction(std::slice::from_mut(left)).is_err() {
                return;
            }
        }
        // the acceleration is linear in what holds
        let held = left[0] / (left[0] - left[1]);
        self.trial.motion.against[load].held = if held.is_finite() { part * held } else { Vec2::zero() };
    }

    /// What is left of the effort of the coordinate where its element bears this.
    fn left_with(&mut self, effort: f64) -> Option<f64> {
        self.trial.motion.grips[0] = ContactMode { effort, ..ContactMode::default() };
        self.effort(0.0).ok()
    }

    /// How all elements move, as the mechanism as it is written has them, where their speeds do not tell it.
    pub fn grips(&self) -> Vec<ContactMode> {
        let grips = &self.trial.motion.grips;
        if self.slipping.is_none() && self.mode != Some(Mode::Resting) && !self.leaves_rest() {
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
