//! Stops next to pairs that rub, each in a way of its own: which of those that are touched press.

use super::contact_modes::{SLOW, joins};
use super::equations::Equations;
use super::sliding_sense::Slipping;
use super::stop::ROUNDING;
use crate::model::{LoadId, Query, Value};

/// What stands at a stop may have a rate that is so many times what rounding makes of it: what integration leaves.
const DRIFT: f64 = 1e3;
/// A sliding speed that an impact changes by less than this part of the greatest stays as it is.
const SAME: f64 = 1e-11;

impl Equations<'_, '_> {
    /// Lets a closed stop press with an effort, N or N m.
    pub fn press(&mut self, index: usize, effort: f64) {
        let mechanism = self.model.mechanism;
        let value = mechanism.stops[index].side * effort;
        self.trial.motion.stops[index] = value;
        // the efforts of stops are the last loads
        let load = LoadId::at(mechanism.loads.len() - mechanism.stops.len() + index);
        self.put_load(load, Value::Scalar(value));
    }

    /// The acceleration of the coordinate of a stop away from it, where everything was evaluated.
    pub fn stop_acceleration(&self, index: usize) -> f64 {
        let stop = self.stop(index);
        match self.view().query(&Query::RelativeAcceleration(stop.pair)) {
            Value::Scalar(value) => stop.side * value,
            _ => f64::NAN,
        }
    }

    /// The stops that are closed, and those at which a coordinate stands, in the state that was moved last.
    pub fn standing_stops(&mut self, slipping: &Slipping, t: f64, y: &[f64]) -> Vec<usize> {
        let count = self.model.mechanism.stops.len();
        if count > 0 {
            self.follow_angles(t);
        }
        let all = (0..count).filter(|index| !slipping.off.contains(index));
        let mut stops: Vec<usize> = all.collect();
        stops.retain(|index| self.closed.contains(index) || self.stands_at(*index, y));
        stops
    }

    /// Whether a coordinate stands at its stop.
    fn stands_at(&mut self, index: usize, y: &[f64]) -> bool {
        if self.distance(index) > ROUNDING * self.size(index) {
            return false;
        }
        let (rate, rounding) = self.rate(index, y);
        rate.abs() <= DRIFT * rounding
    }

    /// Of these stops, closes those that are to be closed, and opens the others.
    pub fn close_those(&mut self, stops: &[usize], closed: &[bool]) {
        self.closed.retain(|index| !stops.contains(index));
        let those = stops.iter().zip(closed).filter(|(_, closed)| **closed);
        those.for_each(|(index, _)| self.close(*index));
    }

    fn open_among(&self, stops: &[usize]) -> Vec<usize> {
        stops.iter().copied().filter(|index| !self.closed.contains(index)).collect()
    }

    /// A stop that would pull, or one that would be passed, and whether it is to be closed, where everything was evaluated.
    pub fn misjudged_stop(&mut self, slipping: &Slipping, stops: &[usize]) -> Option<(usize, bool)> {
        let least = -SLOW * slipping.greatest;
        let efforts = self.closed.iter().zip(&slipping.bears[slipping.held.len()..]);
        let pulls = efforts.filter(|(_, effort)| **effort < least).min_by(|a, b| a.1.total_cmp(b.1));
        if let Some((index, _)) = pulls {
            return Some((*index, false));
        }
        for index in self.open_among(stops) {
            let slopes = self.slopes(index);
            let unit: f64 =
                slopes.iter().zip(&slipping.units).map(|(slope, unit)| (slope * unit).abs()).sum();
            if self.stop_acceleration(index) < least * unit {
                return Some((index, true));
            }
        }
        None
    }

    /// Lets friction hold the elements that move with the coordinate of a stop, and with nothing else.
    pub fn hold_at(&mut self, slipping: &mut Slipping, stop: usize) {
        let slopes = self.slopes(stop);
        for element in 0..slipping.senses.len() {
            let mut own = Vec::with_capacity(self.order());
            self.slopes_of_element(element, &mut own);
            let mut basis = Vec::new();
            joins(slopes.clone(), &mut basis);
            if !joins(own, &mut basis) {
                slipping.senses[element] = 0.0;
            }
        }
    }

    /// Notes the stops that are open while friction holds their coordinates there.
    pub fn find_kept(&mut self, slipping: &mut Slipping, stops: &[usize]) {
        slipping.kept.fill(false);
        let basis = self.basis(&slipping.held);
        for index in self.open_among(stops) {
            let slopes = self.slopes(index);
            slipping.kept[index] = !joins(slopes, &mut basis.clone());
        }
    }

    /// What closed stops and these elements keep from moving.
    pub fn basis(&mut self, held: &[usize]) -> Vec<Vec<f64>> {
        let mut basis = Vec::new();
        for k in 0..self.closed.len() {
            let slopes = self.slopes(self.closed[k]);
            joins(slopes, &mut basis);
        }
        for &element in held {
            self.is_independent(element, &mut basis);
        }
        basis
    }

    /// Notes which elements an impact sets in motion: the rates before and after it.
    pub fn mark_struck(&mut self, slipping: &mut Slipping, t: f64, rates: [&[f64]; 2]) {
        let [before, after] = rates.map(|y| {
            self.set_position(t, y);
            self.trial.run_motion::<1>(self.model.plan);
            self.sliding_speeds(slipping)
        });
        let fastest = slipping.fastest;
        for (struck, (before, after)) in slipping.struck.iter_mut().zip(before.iter().zip(&after)) {
            *struck = (after - before).abs() > SAME * fastest;
        }
        slipping.turning.clear();
    }
}
