//! The coordinates of stops, and rebounds from them: from v under the acceleration −a they follow each other in a geometric series.
//! Where they are lower than what is asked for, the run goes on from its limit, 2 v / (a (1 − e)) later.

use super::drives::moves;
use super::equations::Equations;
use super::stop::ROUNDING;
use crate::math::ode::System;
use crate::model::{Query, Stop, Value};
use crate::position::extent;
use crate::solve::failure::Halt;

/// A closed stop pulls that does so by more than this part of the greatest effort of a stop.
pub(super) const PULLS: f64 = 1e-9;

/// Rebounds from a stop.
pub(super) struct Rebounds {
    /// Of the first, m or rad.
    pub height: f64,
    /// Duration of the first, s.
    pub one: f64,
    /// Duration of all together, s.
    pub all: f64,
}

impl Rebounds {
    /// From this speed, with accelerations away from the stop on the way up and on the way back; nothing where nothing pulls it back.
    pub fn between(speed: f64, restitution: f64, up: f64, back: f64) -> Option<Self> {
        if up >= 0.0 || back >= 0.0 {
            return None;
        }
        let (up, back) = (-up, -back);
        let height = 0.5 * speed * speed / up;
        let one = speed / up * (1.0 + (up / back).sqrt());
        let kept = restitution * (back / up).sqrt();
        Some(Self { height, one, all: if kept < 1.0 { one / (1.0 - kept) } else { 0.0 } })
    }
}

impl Equations<'_, '_> {
    pub fn stop(&self, index: usize) -> &Stop {
        &self.model.mechanism.stops[index]
    }

    /// What its coordinate is measured by.
    pub fn size(&self, index: usize) -> f64 {
        let stop = self.stop(index);
        if stop.turns { 1.0 } else { extent(self.model).max(stop.bound.abs()) }
    }

    fn of_pair(&self, query: &Query) -> f64 {
        match self.view().query(query) {
            Value::Scalar(value) => value,
            _ => f64::NAN,
        }
    }

    /// How far the coordinate of a stop is from it in the state that is observed.
    pub fn distance(&self, index: usize) -> f64 {
        let stop = self.stop(index);
        stop.side * (self.of_pair(&Query::Displacement(stop.pair)) - stop.bound)
    }

    /// Evaluates everything at an instant.
    pub fn settle(&mut self, t: f64, y: &[f64]) -> Result<(), Halt> {
        if !self.observe(t, y, true) {
            return Err(self.halt());
        }
        Ok(())
    }

    pub fn close(&mut self, index: usize) {
        self.closed.push(index);
        self.closed.sort_unstable();
    }

    /// What its coordinate does, away from the stop, for a unit rate of each free coordinate, where everything was evaluated.
    pub fn slopes(&mut self, index: usize) -> Vec<f64> {
        let (pair, side) = (self.stop(index).pair, self.stop(index).side);
        let model = self.model;
        let rate = |state: &crate::position::State| side * state.coordinate_rate(model, pair);
        (0..self.order()).map(|i| self.reduced.at_unit_rate(i, &mut self.trial, rate)).collect()
    }

    /// The rate with which its coordinate moves away from the stop, where everything was evaluated at this place; and what
    /// rounding may make of it.
    pub fn rate(&mut self, index: usize, y: &[f64]) -> (f64, f64) {
        let slopes = self.slopes(index);
        let n = self.order();
        let terms = slopes.iter().zip(&y[n..2 * n]).map(|(slope, rate)| slope * rate);
        let given = self.given_rate(index);
        let (sum, greatest) = terms.fold((given, given.abs()), |(s, m), x| (s + x, m + x.abs()));
        (sum, ROUNDING * greatest)
    }

    /// The part of this rate that the drives have whose motion is given.
    pub fn given_rate(&mut self, index: usize) -> f64 {
        let drives = &self.model.mechanism.drives;
        let inputs = self.trial.motion.inputs.iter().zip(drives);
        if !inputs.into_iter().any(|(input, drive)| !drive.free && moves(input)) {
            return 0.0;
        }
        let stop = self.stop(index);
        let all = stop.side * self.trial.coordinate_rate(self.model, stop.pair);
        let slopes = self.slopes(index);
        let inputs = &self.trial.motion.inputs;
        let free = self.reduced.free().iter().zip(&slopes);
        all - free.map(|(&drive, slope)| slope * inputs[drive].rate).sum::<f64>()
    }

    /// The unknowns a short time later, as they go on from here.
    pub fn carried_on(&mut self, t: f64, y: &[f64], time: f64) -> Result<Vec<f64>, Halt> {
        let n = self.order();
        let mut dy = vec![0.0; y.len()];
        if self.rates(t, y, &mut dy).is_err() {
            return Err(self.halt());
        }
        let mut later: Vec<f64> = y.iter().zip(&dy).map(|(y, dy)| y + dy * time).collect();
        for (q, a) in later.iter_mut().zip(&dy[n..2 * n]) {
            *q += 0.5 * a * time * time;
        }
        Ok(later)
    }

    /// Whether nothing moves, and nothing but an instant can change that.
    pub fn is_held(&self) -> bool {
        self.slipping.as_ref().is_some_and(|slipping| slipping.rests)
    }
}
