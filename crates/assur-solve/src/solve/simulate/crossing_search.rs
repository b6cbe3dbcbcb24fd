//! Change points within a step: none is leapt over.
//!
//! Where the assemblies of a group meet, |σ| is zero, and what is integrated need not show it: a light link may go on in its other
//! assembly without any force telling. |σ| of a dyad is a sine of the angle between two directions, so that it changes no faster than
//! both bodies turn: between two places of a step it stays above zero where its sum at both is more than that. A step that may pass
//! zero is looked into, and ends before it; from there the way leads over the change point.

use super::coordinates::CAREFUL;
use super::equations::Equations;
use super::integration::{AGAIN, Integration};
use super::records::within_step;
use crate::math::ode::Integrator;
use crate::plan::MotionStep;
use crate::solve::failure::Halt;

/// Two bodies turn against each other at most so much faster than the faster one.
const AGAINST: f64 = 2.0;
/// Where |σ| is known to pass no place below this, none passes zero.
const NOTHING: f64 = 1e-3;
/// Where the step begins with less, the way over was looked for already; otherwise it is to end with about so much.
const LOOKED: f64 = AGAIN * CAREFUL;
const BEFORE: f64 = 0.8 * LOOKED;

/// A place of a step: the instant, s, |σ|, and how fast it may change, 1/s.
type Place = (f64, f64, f64);

impl Integration<'_, '_> {
    /// Ends the last step before a change point that it would leap over.
    ///
    /// # Errors
    /// It lies ahead of where the step begins, and no way leads over it.
    pub fn keep_assemblies<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
    ) -> Result<(), Halt> {
        if equations.is_on_the_way_over() {
            return Ok(());
        }
        let (from, to) = (method.previous_t(), method.t());
        let begin = (from, equations.condition(), AGAINST * equations.fastest_accepted());
        let Some(end) = self.place(equations, method, to) else { return Ok(()) };
        if is_clear(begin, end) || equations.stages.is_clear((to - from) * begin.2.max(end.2)) {
            return Ok(());
        }
        let Some((before, zero)) = self.first_zero(equations, method, (begin, end)) else { return Ok(()) };
        if begin.1 <= LOOKED {
            // it was looked for from there
            let Some(group) = equations.least_group() else { return Ok(()) };
            // it has come that far
            let shortened = method.shorten(equations, before.0).is_ok();
            return Err(if shortened { Halt::Dead { group, condition: before.1 } } else { equations.halt() });
        }
        let part = BEFORE / begin.1;
        let t = zero - part * (zero - from);
        if method.shorten(equations, t).is_err() {
            return Err(equations.halt());
        }
        Ok(())
    }

    /// The last place before the first zero of |σ| between two places of a step, and where that is, s.
    fn first_zero<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        (last, next): (Place, Place),
    ) -> Option<(Place, f64)> {
        if is_clear(last, next) {
            return None;
        }
        let apart = next.0 - last.0;
        if last.1.max(next.1) < NOTHING || apart <= f64::EPSILON * next.0.abs() {
            return Some((last, last.0 + 0.5 * apart));
        }
        let middle = self.place(equations, method, last.0 + 0.5 * apart)?;
        let before = self.first_zero(equations, method, (last, middle));
        before.or_else(|| self.first_zero(equations, method, (middle, next)))
    }

    fn place<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        t: f64,
    ) -> Option<Place> {
        let y = &mut self.watch.y;
        let known = within_step(equations, method, t, y) && equations.observe_bodies(t, y);
        known.then(|| (t, equations.trial_condition(), AGAINST * equations.fastest_seen()))
    }
}

/// Whether |σ| stays above zero between two places; where no group has two assemblies it is 1.
fn is_clear((t, a, speed): Place, (to, b, other): Place) -> bool {
    (a == 1.0 && b == 1.0) || a + b > (to - t) * speed.max(other)
}

impl Equations<'_, '_> {
    /// Whether the step that was made last leads over a change point.
    fn is_on_the_way_over(&self) -> bool {
        self.bridge.is_some() || self.passage.is_some()
    }

    /// Evaluates a state, if it is not that of the last evaluation.
    fn observe_bodies(&mut self, t: f64, y: &[f64]) -> bool {
        self.is_at(t, y) || self.observe(t, y, false)
    }

    /// The group whose |σ| is least where the step begins, if it has two assemblies by a closed form.
    fn least_group(&self) -> Option<usize> {
        let conditions = self.here().1.motion.conditions.iter().enumerate();
        let (group, _) = conditions.min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
        let step = self.model.plan.motion.get(group)?;
        (!matches!(step, MotionStep::General { .. } | MotionStep::Triad { .. })).then_some(group)
    }
}
