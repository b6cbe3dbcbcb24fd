//! Impacts next to pairs that rub, each in a way of its own.
//!
//! Friction does not act in an impact; after it every pair goes on at the speed it has then. Rebounds end in a geometric series where
//! friction is the same in all of them: a pair that the rebounds bring to rest must move with the coordinate of the stop, or not at all.
//! Else each rebound lets such pairs slip and stick, and the series is read off the last ones, where these have become one.

use super::contact_modes::joins;
use super::dissipative::DissipativeElement;
use super::equations::Equations;
use super::impact::Rebounds;
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
    /// The acceleration of the coordinate of the stop away from it.
    acceleration: f64,
    /// Those of all elements of friction.
    sliding: Vec<f64>,
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

    /// Stops are hit, one alone or several that do not rebound.
    ///
    /// # Errors
    /// There are no impulses, or there is no motion afterwards.
    pub fn strike_slipping(
        &mut self,
        equations: &mut Equations<'_, '_>,
        (t, y): (f64, &[f64]),
        hit: &[usize],
    ) -> Result<Struck, Halt> {
        equations.find_masses(t, y)?;
        let mut stand = equations.closed.clone();
        stand.extend(self.touching(equations, y, hit));
        let before = hit.iter().map(|stop| equations.rate(*stop, y).0).fold(0.0, f64::min);
        hit.iter().for_each(|stop| self.note_rate(equations, *stop, before));
        let restitution = match hit {
            [only] => equations.stop(*only).restitution,
            _ => 0.0,
        };
        let impact = |equations: &mut Equations<'_, '_>, part: f64| {
            let wanted: Vec<_> = hit.iter().map(|stop| (*stop, -part * before)).collect();
            let mut after = y.to_vec();
            equations.find_masses(t, y)?;
            equations.reflect(&wanted, &stand, &mut after)?;
            Ok::<_, Halt>(after)
        };
        let own = |equations: &Equations<'_, '_>| (equations.slipping.clone(), equations.closed.clone());
        let was = own(equations);
        let go_on = |equations: &mut Equations<'_, '_>, part: f64, off: Option<usize>| {
            let after = impact(equations, part)?;
            (equations.slipping, equations.closed) = was.clone();
            if part == 0.0 && off.is_none() {
                // as long as none would have to pull
                hit.iter().for_each(|stop| equations.close(*stop));
            }
            equations.after_impact((t, y), after, (hit[0], off), ROUNDING * before.abs())
        };
        let mut struck = Struck { y: Vec::new(), closed: None, step: f64::INFINITY };
        let mut all = 0.0;
        let bounces = if restitution > 0.0 {
            let speed = -restitution * before;
            let up = go_on(equations, restitution, None)?;
            let rest = impact(equations, 0.0)?;
            let back = go_on(equations, 0.0, Some(hit[0]));
            let rebounds = Rebounds::between(
                speed,
                restitution,
                up.acceleration,
                match &back {
                    Ok(back) => back.acceleration,
                    Err(_) => up.acceleration,
                },
            );
            let lowest = LOWEST * equations.size(hit[0]);
            match rebounds {
                Some(Rebounds { height, all: lasting, .. }) if height <= lowest => {
                    let alike = equations.rebounds_alike((t, &rest), (&up, &back?), (hit[0], lasting))?;
                    let series = if alike { Some(lasting) } else { self.series(hit[0], t) };
                    all = series.ok_or(Halt::Shaken { stop: hit[0] })?;
                    None
                }
                None => Some((up, f64::INFINITY)),
                Some(Rebounds { one, .. }) => Some((up, FLIGHT * one)),
            }
        } else {
            None
        };
        match bounces {
            Some((up, step)) => {
                struck.step = step;
                struck.y = up.y;
                (equations.slipping, equations.closed) = (up.slipping, up.closed);
            }
            None => {
                struck.y = go_on(equations, 0.0, None)?.y;
                let closed = hit.iter().any(|stop| equations.closed.contains(stop));
                struck.closed = closed.then_some(all);
            }
        }
        hit.iter().for_each(|stop| self.note_hit(*stop, t));
        for stop in stand.into_iter().chain(hit.iter().copied()) {
            self.leave(stop);
        }
        self.reconcile(equations, (t, hit, all));
        Ok(struck)
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

    /// Goes on from the rates after an impact; a stop that is off is not looked at.
    fn after_impact(
        &mut self,
        (t, y): (f64, &[f64]),
        mut after: Vec<f64>,
        (stop, off): (usize, Option<usize>),
        least: f64,
    ) -> Result<After, Halt> {
        self.find_masses(t, &after)?;
        for index in self.closed.clone() {
            if self.rate(index, &after).0 > least {
                self.closed.retain(|closed| *closed != index);
            }
        }
        if let Some(mut slipping) = self.slipping.take() {
            slipping.off = off;
            self.mark_struck(&mut slipping, t, [y, &after]);
            self.slipping = Some(slipping);
        }
        self.choose_slips(t, &mut after)?;
        self.settle(t, &after)?;
        let acceleration = self.stop_acceleration(stop);
        let sliding =
            DissipativeElement::all(self.model.plan).map(|rubs| rubs.acceleration(&self.trial)).collect();
        let mut slipping = self.slipping.clone();
        slipping.iter_mut().for_each(|slipping| slipping.off = None);
        Ok(After { y: after, slipping, closed: self.closed.clone(), acceleration, sliding })
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
