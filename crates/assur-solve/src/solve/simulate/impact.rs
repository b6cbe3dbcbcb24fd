//! What stops do to the rates and the accelerations.
//!
//! An impact is one linear equation (below). Rebounds from v under the
//! acceleration −a follow each other in a geometric series: where they are lower than what is asked for, the run goes on from
//! its limit, 2 v / (a (1 − e)) later.

use super::drives::moves;
use super::equations::Equations;
use super::stop::ROUNDING;
use crate::math::{Lu, ode::System};
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

// Impulses of an impact.
//
// With the slopes j = ∂g/∂q of a coordinate g that hits its stop an impulse Λ along it changes the rates by M⁻¹ j Λ, and ġ becomes
// −e ġ: Λ = −(1 + e) ġ / (j M⁻¹ j). Other stops that are closed take part where they would be passed: of all of them
//
// ġ⁺ = ġ + J M⁻¹ Jᵀ Λ ≥ wanted,  Λ ≥ 0,  one of the two equal,
//
// which has one solution where the stops do not depend on each other (J. J. Moreau, Unilateral contact and dry friction in finite
// freedom dynamics, 1988).

/// So many stops at most take part in an impact.
const MOST: usize = 8;

/// What takes part in an impact.
struct Impact {
    stops: Vec<usize>,
    slopes: Vec<Vec<f64>>,
    /// M⁻¹ of them.
    each: Vec<Vec<f64>>,
    before: Vec<f64>,
    wanted: Vec<f64>,
}

impl Impact {
    /// How an impulse at one changes the rate of another.
    fn change(&self, of: usize, by: usize) -> f64 {
        self.slopes[of].iter().zip(&self.each[by]).map(|(a, b)| a * b).sum()
    }

    /// The impulses, if those of a part of the stops are all there are.
    fn impulses(&self, part: &[usize]) -> Option<Vec<f64>> {
        let mut factors = Lu::new(part.len());
        let mut found: Vec<f64> = part.iter().map(|&i| self.wanted[i] - self.before[i]).collect();
        for (row, &i) in part.iter().enumerate() {
            for (column, &j) in part.iter().enumerate() {
                *factors.at_mut(row, column) = self.change(i, j);
            }
        }
        if !factors.factor() {
            return None;
        }
        factors.solve(&mut found);
        let mut impulses = vec![0.0; self.stops.len()];
        part.iter().zip(&found).for_each(|(&i, impulse)| impulses[i] = *impulse);
        let fits = (0..self.stops.len()).all(|i| {
            let terms = (0..self.stops.len()).map(|j| self.change(i, j) * impulses[j]);
            let (sum, greatest) = terms.fold((0.0, 0.0_f64), |(s, m), x| (s + x, m.max(x.abs())));
            impulses[i] >= 0.0 && self.before[i] + sum - self.wanted[i] >= -ROUNDING * greatest
        });
        fits.then_some(impulses)
    }
}

impl Equations<'_, '_> {
    /// Changes the rates so that stops that are hit have these rates, and closed ones that stand are not passed; the unknown work loses
    /// what the impact takes.
    ///
    /// # Errors
    /// Nothing is moved by an impulse, or there are no such impulses.
    pub fn reflect(&mut self, hit: &[(usize, f64)], standing: &[usize], y: &mut [f64]) -> Result<(), Halt> {
        let n = self.order();
        let mut impact = self.impact(hit, standing);
        for (i, stop) in impact.stops.iter().enumerate() {
            impact.before[i] = self.rate(*stop, y).0;
        }
        let count = impact.stops.len();
        let compliance = (0..count).map(|i| impact.change(i, i));
        if compliance.into_iter().any(|own| own.is_nan() || own <= 0.0) {
            return Err(Halt::NoInertia);
        }
        // those that are hit first, then with more and more of the others
        let mut parts: Vec<usize> = if count <= MOST { (1..1_usize << count).collect() } else { Vec::new() };
        let all_hit = (1_usize << hit.len()) - 1;
        parts.sort_by_key(|part| ((part & all_hit) != all_hit, part.count_ones()));
        let list = |part: &usize| (0..count).filter(|i| part >> i & 1 == 1).collect::<Vec<_>>();
        let found = parts.iter().find_map(|part| impact.impulses(&list(part)));
        let Some(impulses) = found else { return Err(Halt::StopsAtOnce { stops: impact.stops }) };
        for (i, impulse) in impulses.iter().enumerate() {
            for (rate, each) in y[n..2 * n].iter_mut().zip(&impact.each[i]) {
                *rate += each * impulse;
            }
            let after = impact.before[i] + (0..count).map(|j| impact.change(i, j) * impulses[j]).sum::<f64>();
            y[2 * n] += 0.5 * impulse * (impact.before[i] + after);
            let stops = n == 1 && after.abs() <= f64::EPSILON * impact.before[i].abs();
            if stops && self.given_rate(impact.stops[i]) == 0.0 {
                y[1] = 0.0;
            }
        }
        Ok(())
    }

    /// What takes part, where everything was evaluated.
    fn impact(&mut self, hit: &[(usize, f64)], standing: &[usize]) -> Impact {
        let stops: Vec<usize> = hit.iter().map(|(stop, _)| *stop).chain(standing.iter().copied()).collect();
        let slopes: Vec<Vec<f64>> = stops.iter().map(|stop| self.slopes(*stop)).collect();
        let each = slopes.iter().map(|slopes| {
            let mut each = slopes.clone();
            self.reduced.solve(&mut each);
            each
        });
        let each = each.collect();
        let wanted = hit.iter().map(|(_, rate)| *rate).chain(standing.iter().map(|_| 0.0)).collect();
        Impact { before: vec![0.0; stops.len()], stops, slopes, each, wanted }
    }
}
