//! Impacts next to pairs that rub, each in a way of its own.
//!
//! Friction does not act in an impact; after it every pair goes on at the speed it has then. Rebounds end in a geometric series where
//! friction is the same in all of them: a pair that the rebounds bring to rest must move with the coordinate of the stop, or not at all.
//! Else each rebound lets such pairs slip and stick, and the series is read off the last ones, where these have become one.

use super::contact_modes::joins;
use super::dissipative::DissipativeElement;
use super::equations::Equations;
use super::impact::Rebounds;
use super::impulses::Impulses;
use super::sliding_sense::Slipping;
use super::stop::{FLIGHT, LOWEST, ROUNDING, Stops, Struck};
use crate::solve::failure::Halt;

/// What slides so many times faster than the rebounds change it goes on sliding.
const FASTER: f64 = 10.0;
/// Ratios of the durations of rebounds that differ by less are the same.
const ALIKE: f64 = 1e-5;

/// How everything goes on after an impact.
struct After {
    y: Vec<f64>,
    slipping: Option<Box<Slipping>>,
    closed: Vec<usize>,
    /// The accelerations of the coordinates of what is hit away from their stops.
    accelerations: Vec<f64>,
    /// Those of all elements of friction.
    sliding: Vec<f64>,
    impulses: Impulses,
}

impl Stops {
    fn note_hit(&mut self, stop: usize, t: f64) {
        let hits = &mut self.hits[stop];
        hits.rotate_left(1);
        hits[3] = t;
    }

    /// How long rebounds go on from an impact at an instant, s, where the last ones follow each other in a geometric series.
    fn series(&self, stop: usize, t: f64) -> Option<f64> {
        let [_, a, b, c] = self.hits[stop];
        let [first, second, third] = [b - a, c - b, t - c];
        let (before, ratio) = (second / first, third / second);
        let same = (ratio - before).abs() <= ALIKE * before && ratio < 1.0;
        same.then(|| third * ratio / (1.0 - ratio))
    }

    /// Stops are hit.
    ///
    /// # Errors
    /// There are no impulses, or there is no motion afterwards.
    pub fn strike(
        &mut self,
        equations: &mut Equations<'_, '_>,
        (t, y): (f64, &[f64]),
        hit: &[usize],
    ) -> Result<Struck, Halt> {
        equations.find_masses(t, y)?;
        let mut stand = equations.closed.clone();
        stand.extend(self.touching(equations, y, hit));
        let before: Vec<f64> = hit.iter().map(|stop| equations.rate(*stop, y).0.min(0.0)).collect();
        hit.iter().zip(&before).for_each(|(stop, rate)| self.note_rate(equations, *stop, *rate));
        let was = (equations.slipping.clone(), equations.closed.clone());
        let mut strike = Strike { t, y, hit, before, stand, was };
        let mut kept: Vec<f64> = hit.iter().map(|stop| equations.stop(*stop).restitution).collect();
        let mut struck = Struck { y: Vec::new(), closed: None, step: f64::INFINITY, impulses: Vec::new() };
        let mut all = 0.0;
        let up = loop {
            if kept.iter().all(|kept| *kept == 0.0) {
                break None;
            }
            let up = strike.go_on(equations, &kept, false)?;
            let rest = strike.impact(equations, &vec![0.0; hit.len()])?.0;
            let back = strike.go_on(equations, &vec![0.0; hit.len()], true);
            let rebounds = strike.rebounds(&kept, &up, &back);
            let low = |i: &usize| {
                let lowest = LOWEST * equations.size(hit[*i]);
                kept[*i] > 0.0 && rebounds[*i].as_ref().is_some_and(|rebound| rebound.height <= lowest)
            };
            let low: Vec<usize> = (0..hit.len()).filter(low).collect();
            if low.is_empty() {
                let one = rebounds.iter().flatten().map(|rebound| rebound.one);
                struck.step = FLIGHT * one.fold(f64::INFINITY, f64::min);
                break Some(up);
            }
            for i in low {
                kept[i] = 0.0;
                let lasting = rebounds[i].as_ref().map_or(0.0, |rebound| rebound.all);
                let both = (&up, back.as_ref().map_err(Clone::clone)?);
                let alike = equations.rebounds_alike((t, &rest), both, (hit[i], lasting))?;
                let series = if alike { Some(lasting) } else { self.series(hit[i], t) };
                all = series.ok_or(Halt::Shaken { stop: hit[i] })?.max(all);
            }
        };
        match up {
            Some(up) => {
                (struck.y, struck.impulses) = (up.y, up.impulses);
                (equations.slipping, equations.closed) = (up.slipping, up.closed);
            }
            None => {
                let rest = strike.go_on(equations, &kept, false)?;
                (struck.y, struck.impulses) = (rest.y, rest.impulses);
                let closed = hit.iter().any(|stop| equations.closed.contains(stop));
                struck.closed = closed.then_some(all);
            }
        }
        hit.iter().for_each(|stop| self.note_hit(*stop, t));
        for stop in std::mem::take(&mut strike.stand).into_iter().chain(hit.iter().copied()) {
            self.leave(stop);
        }
        self.reconcile(equations, (t, hit, all));
        Ok(struck)
    }
}

/// What is hit at an instant, s, and what else stands at its stop.
struct Strike<'y> {
    t: f64,
    y: &'y [f64],
    hit: &'y [usize],
    /// The rates with which they come.
    before: Vec<f64>,
    stand: Vec<usize>,
    was: (Option<Box<Slipping>>, Vec<usize>),
}

impl Strike<'_> {
    /// The unknowns after an impact that leaves these parts of the rates, and the impulses along the coordinates of stops.
    fn impact(&self, equations: &mut Equations<'_, '_>, kept: &[f64]) -> Result<(Vec<f64>, Impulses), Halt> {
        let rates = self.before.iter().zip(kept).map(|(before, kept)| -kept * before);
        let wanted: Vec<_> = self.hit.iter().copied().zip(rates).collect();
        let mut after = self.y.to_vec();
        equations.find_masses(self.t, self.y)?;
        let mut impulses = equations.reflect(&wanted, &self.stand, &mut after)?;
        impulses.iter_mut().for_each(|(stop, impulse)| *impulse *= equations.stop(*stop).side);
        Ok((after, impulses))
    }

    /// How everything goes on then; with all that is hit `off`, as if it were not there.
    fn go_on(&self, equations: &mut Equations<'_, '_>, kept: &[f64], off: bool) -> Result<After, Halt> {
        let (after, impulses) = self.impact(equations, kept)?;
        (equations.slipping, equations.closed) = self.was.clone();
        // as long as none would have to pull
        let stay = self.hit.iter().zip(kept).filter(|(_, kept)| !off && **kept == 0.0);
        stay.for_each(|(stop, _)| equations.close(*stop));
        let greatest = self.before.iter().fold(0.0_f64, |most, rate| most.max(rate.abs()));
        let after = equations.after_impact((self.t, self.y), after, (self.hit, off), ROUNDING * greatest)?;
        Ok(After { impulses, ..after })
    }

    /// The next rebounds from what is hit, of those that keep a part of their rates.
    fn rebounds(&self, kept: &[f64], up: &After, back: &Result<After, Halt>) -> Vec<Option<Rebounds>> {
        let one = |i: usize| {
            let speed = -kept[i] * self.before[i];
            let back = back.as_ref().map_or(up.accelerations[i], |back| back.accelerations[i]);
            Rebounds::between(speed, kept[i], up.accelerations[i], back)
        };
        (0..kept.len()).map(one).collect()
    }
}

impl Equations<'_, '_> {
    /// M and the velocities for unit rates at an instant.
    fn find_masses(&mut self, t: f64, y: &[f64]) -> Result<(), Halt> {
        self.set_position(t, y);
        self.trial.motion.stops.fill(0.0);
        let mut accelerations = vec![0.0; self.order()];
        self.accelerations_without_friction(&mut accelerations)?;
        self.follow_angles(t);
        Ok(())
    }

    /// Goes on from the rates after an impact; stops that are off are not looked at.
    fn after_impact(
        &mut self,
        (t, y): (f64, &[f64]),
        mut after: Vec<f64>,
        (hit, off): (&[usize], bool),
        least: f64,
    ) -> Result<After, Halt> {
        self.find_masses(t, &after)?;
        for index in self.closed.clone() {
            if self.rate(index, &after).0 > least {
                self.closed.retain(|closed| *closed != index);
            }
        }
        if let Some(mut slipping) = self.slipping.take() {
            slipping.off.extend(hit.iter().filter(|_| off));
            self.mark_struck(&mut slipping, t, [y, &after]);
            self.slipping = Some(slipping);
        }
        self.choose_slips(t, &mut after)?;
        self.settle(t, &after)?;
        let accelerations = hit.iter().map(|stop| self.stop_acceleration(*stop)).collect();
        let sliding =
            DissipativeElement::all(self.model.plan).map(|rubs| rubs.acceleration(&self.trial)).collect();
        let mut slipping = self.slipping.clone();
        slipping.iter_mut().for_each(|slipping| slipping.off.clear());
        Ok(After {
            y: after,
            slipping,
            closed: self.closed.clone(),
            accelerations,
            sliding,
            impulses: Vec::new(),
        })
    }

    /// Whether friction is the same in all rebounds from a stop, which last so long, s, on the way up and on the way back, given the rates
    /// without them.
    fn rebounds_alike(
        &mut self,
        (t, rest): (f64, &[f64]),
        (up, back): (&After, &After),
        (stop, lasting): (usize, f64),
    ) -> Result<bool, Halt> {
        let (Some(one), Some(other)) = (&up.slipping, &back.slipping) else { return Ok(false) };
        if up.closed != back.closed {
            return Ok(false);
        }
        let mut speeds = [&up.y, rest].map(|y| {
            self.set_position(t, y);
            self.trial.run_motion::<1>(self.model.plan);
            DissipativeElement::all(self.model.plan).map(|rubs| rubs.speed(&self.trial)).collect::<Vec<_>>()
        });
        let [with, without] = &mut speeds;
        self.find_masses(t, rest)?;
        let slopes = self.slopes(stop);
        for (element, speed) in without.iter().enumerate() {
            let senses = [one.senses[element], other.senses[element]];
            let fastest = up.sliding[element].abs().max(back.sliding[element].abs());
            let change = (with[element] - speed).abs() + fastest * lasting;
            if senses == [0.0; 2] || (senses[0] == senses[1] && speed.abs() > FASTER * change) {
                continue;
            }
            let mut own = Vec::with_capacity(self.order());
            self.slopes_of_element(element, &mut own);
            let mut basis = Vec::new();
            joins(slopes.clone(), &mut basis);
            if joins(own, &mut basis) {
                return Ok(false);
            }
        }
        Ok(true)
    }
}
