//! Forces in hinges with friction circles that pass near zero: there their magnitude bends sharply, and with it the friction, which
//! the error estimate of a step does not see where the bend lies between its stages. Steps are short there.

use super::equations::Equations;
use crate::math::Vec2;
use crate::math::ode::{Integrator, Undefined};
use crate::plan::FrictionLaw;

/// A step ends before a force changes by more than this multiple of its least magnitude: up to there the series of a step is exact
/// enough.
const MOST: f64 = 2.0;

/// The forces in all friction circles where the last step ended.
#[derive(Default)]
pub(super) struct Bends {
    /// Where, s.
    t: f64,
    forces: Vec<Vec2>,
    /// Those where it began.
    before: Vec<Vec2>,
    /// The greatest so far.
    greatest: f64,
}

impl Bends {
    /// Ends the last step early where it is too long for a force.
    ///
    /// # Errors
    /// A stage has no value.
    pub fn keep_short<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        tolerance: f64,
    ) -> Result<(), Undefined> {
        if equations.circles().next().is_none() || equations.holds() {
            return Ok(());
        }
        if self.t != method.previous_t() || self.forces.is_empty() {
            let y = method.previous_y().to_vec();
            self.sample(equations, (method.previous_t(), &y));
        }
        std::mem::swap(&mut self.before, &mut self.forces);
        self.sample(equations, (method.t(), method.y()));
        let much = tolerance * equations.extent() * self.greatest;
        let part = |((a, b), radius): ((&Vec2, &Vec2), f64)| {
            let way = *b - *a;
            let length = way.norm();
            if radius * length <= much {
                return 1.0;
            }
            let nearest = (*a + way * (-a.dot(way) / (length * length)).clamp(0.0, 1.0)).norm();
            let approach = if a.dot(way) < 0.0 { 1.0 + MOST } else { 1.0 };
            MOST * nearest.max(a.norm() / approach).max(much / radius) / length
        };
        let pairs = self.before.iter().zip(&self.forces).zip(equations.circles());
        let part = pairs.map(part).fold(1.0, f64::min);
        if part < 1.0 {
            let from = method.previous_t();
            method.shorten(equations, from + part * (method.t() - from))?;
            self.sample(equations, (method.t(), method.y()));
        }
        Ok(())
    }

    fn sample(&mut self, equations: &mut Equations<'_, '_>, (t, y): (f64, &[f64])) {
        self.t = t;
        self.forces.clear();
        if equations.is_at(t, y) || equations.observe(t, y, true) {
            self.forces.extend(equations.circle_forces());
        }
        self.greatest = self.forces.iter().map(|force| force.norm()).fold(self.greatest, f64::max);
    }
}

impl Equations<'_, '_> {
    /// The radii of all friction circles.
    fn circles(&self) -> impl Iterator<Item = f64> {
        self.model.plan.friction.iter().filter_map(|element| match element.kind {
            FrictionLaw::Circle { radius } => Some(radius),
            _ => None,
        })
    }

    fn circle_forces(&self) -> impl Iterator<Item = Vec2> {
        let all = self.model.plan.friction.iter();
        let circles = all.filter(|element| matches!(element.kind, FrictionLaw::Circle { .. }));
        circles.map(|element| self.trial.measured(self.model.plan, element))
    }
}
