//! Stops: impacts, and what rests on them.

use super::equations::Equations;
use super::impulses::Impulses;
use super::lookout::Lookout;
use super::meeting::{hit, opening};
use crate::math::ode::Integrator;
use crate::solve::failure::Halt;

/// Rebounds lower than this part of the size of the mechanism, or of a radian, are not followed: how many are counted does not
/// depend on the accuracy.
pub(super) const LOWEST: f64 = 1e-11;
/// Rounding of a coordinate, of the size of the mechanism, and of a rate, of the sum of what it consists of.
pub(super) const ROUNDING: f64 = 1e-12;
/// The first step after an impact, of the time until the next.
pub(super) const FLIGHT: f64 = 1.2;

/// What happens at a stop.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Touch {
    /// The coordinates of these come to them.
    Hits(Vec<usize>),
    /// It would have to pull.
    Opens(usize),
}

impl Touch {
    /// The first stop at which it happens.
    pub fn stop(&self) -> usize {
        match self {
            Self::Hits(stops) => stops[0],
            Self::Opens(stop) => *stop,
        }
    }
}

/// The stops of a run.
pub(super) struct Stops {
    /// What is hit at the same instant.
    at_once: f64,
    /// Left where the present step begins.
    left: Vec<bool>,
    /// The last four instants at which each was hit, s.
    pub(super) hits: Vec<[f64; 4]>,
    /// When each is closed, and when it opens again, s.
    pub rests: Vec<Vec<(f64, Option<f64>)>>,
    /// By how much rounding of a coordinate may shift the instant of a hit, s: the slower it comes, the more.
    pub shift: f64,
    /// The greatest effort of each since it was closed.
    pressed: Vec<f64>,
    /// Which coordinates are far from their stops.
    lookouts: Vec<Lookout>,
}

/// What an impact leads to.
pub(super) struct Struck {
    /// The unknowns after it.
    pub y: Vec<f64>,
    /// The stop is closed, after rebounds of this duration, s, that are not followed.
    pub closed: Option<f64>,
    /// No step is longer that begins here, s: it may come back.
    pub step: f64,
    /// What the stops gave along their coordinates, N s or N m s.
    pub impulses: Impulses,
}

impl Stops {
    /// For stops of this number; `at_once` is the time in which things happen together, s.
    pub fn new(count: usize, at_once: f64) -> Self {
        Self {
            at_once,
            left: vec![false; count],
            hits: vec![[f64::NAN; 4]; count],
            rests: vec![Vec::new(); count],
            shift: 0.0,
            pressed: vec![0.0; count],
            lookouts: vec![Lookout::NEW; count],
        }
    }

    /// Notes that a coordinate comes to a stop at this rate.
    pub(super) fn note_rate(&mut self, equations: &Equations<'_, '_>, stop: usize, rate: f64) {
        if rate < 0.0 {
            self.shift = self.shift.max(f64::EPSILON * equations.size(stop) / -rate);
        }
    }

    /// Where all stops stand at the first instant; changes the rates where one is hit at once.
    ///
    /// # Errors
    /// A stop is passed, or the motion cannot begin.
    pub fn begin(&mut self, equations: &mut Equations<'_, '_>, t: f64, y: &mut Vec<f64>) -> Result<(), Halt> {
        for index in 0..self.left.len() {
            equations.settle(t, y)?;
            let distance = equations.distance(index);
            let near = ROUNDING * equations.size(index);
            if distance < -near {
                return Err(Halt::StopPassed { stop: index, by: -distance });
            }
            if equations.closed.contains(&index) {
                self.reconcile(equations, (t, &[], 0.0));
                continue;
            }
            if distance > near {
                continue;
            }
            let (rate, rounding) = equations.rate(index, y);
            if rate < -rounding {
                let struck = self.strike(equations, (t, y), &[index])?;
                *y = struck.y;
                if let Some(lasting) = struck.closed {
                    *y = equations.carried_on(t, y, lasting)?;
                }
            }
            self.left[index] = true;
        }
        Ok(())
    }

    /// What happens first within the last step.
    pub fn first<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) -> Option<(f64, Touch)> {
        let mut first: Option<(f64, Touch)> = None;
        for index in 0..self.left.len() {
            if equations.slipping.as_ref().is_some_and(|slipping| slipping.kept[index]) {
                continue;
            }
            if method.keeps_off(index) {
                continue;
            }
            let found = if equations.closed.contains(&index) {
                opening(equations, method, index, self.pressed[index]).map(|t| (t, Touch::Opens(index)))
            } else {
                let lookout = &mut self.lookouts[index];
                let distance = |equations: &mut Equations<'_, '_>, t: f64, y: &[f64]| {
                    if equations.observe_again(t, y, false) { equations.distance(index) } else { f64::NAN }
                };
                if !self.left[index] && lookout.is_far(equations, method, distance) {
                    continue;
                }
                hit(equations, method, index, (self.left[index], self.at_once), lookout)
                    .map(|t| (t, Touch::Hits(vec![index])))
            };
            let Some((t, touch)) = found else { continue };
            match (&mut first, touch) {
                (Some((before, Touch::Hits(others))), Touch::Hits(mut own))
                    if (t - *before).abs() <= self.at_once =>
                {
                    others.append(&mut own);
                    *before = before.min(t);
                }
                (Some((before, _)), _) if *before <= t => {}
                (_, touch) => first = Some((t, touch)),
            }
        }
        first
    }

    /// A step has ended, where something happens at a stop or not: what happens up to an instant. A stop is left until its
    /// coordinate is farther from it than rounding.
    pub fn passed<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &M,
        (touched, here): (Option<(f64, Touch)>, f64),
    ) -> Option<Touch> {
        let closed = !equations.closed.is_empty();
        let known = (closed || self.left.contains(&true)) && equations.observe(method.t(), method.y(), false);
        for (index, pressed) in self.pressed.iter_mut().enumerate() {
            let effort = equations.trial.motion.stops[index].abs();
            let is_closed = known && equations.closed.contains(&index);
            *pressed = if is_closed { pressed.max(effort) } else { 0.0 };
        }
        for index in 0..self.left.len() {
            self.left[index] &= known && equations.distance(index) <= ROUNDING * equations.size(index);
        }
        touched.filter(|(t, _)| *t <= here).map(|(_, touch)| touch)
    }

    /// The stops beside those that are hit at which a coordinate stands that does not come to them, where everything was evaluated.
    pub fn touching(&self, equations: &mut Equations<'_, '_>, y: &[f64], hit: &[usize]) -> Vec<usize> {
        let others =
            (0..self.left.len()).filter(|other| !hit.contains(other) && !equations.closed.contains(other));
        let mut touching: Vec<usize> = others.collect();
        touching.retain(|other| {
            let (rate, rounding) = equations.rate(*other, y);
            equations.distance(*other) <= ROUNDING * equations.size(*other) && rate >= -rounding
        });
        touching
    }

    /// A coordinate leaves its stop.
    pub fn leave(&mut self, index: usize) {
        self.left[index] = true;
    }

    /// Notes which stops have been closed and opened at an instant, s; those that are hit are closed so much later.
    pub fn reconcile(&mut self, equations: &Equations<'_, '_>, (t, hit, later): (f64, &[usize], f64)) {
        for (index, rests) in self.rests.iter_mut().enumerate() {
            let closed = equations.closed.contains(&index);
            match rests.last_mut().filter(|rest| rest.1.is_none()) {
                Some(rest) if !closed => rest.1 = Some(t),
                None if closed => rests.push((if hit.contains(&index) { t + later } else { t }, None)),
                _ => continue,
            }
            self.left[index] = true;
        }
    }
}
