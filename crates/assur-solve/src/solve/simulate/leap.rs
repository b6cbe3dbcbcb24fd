//! Change points within a step: none is leapt over.
//!
//! Where the assemblies of a group meet, |σ| is zero, and what is integrated need not show it: a light link may go on in its other
//! assembly without any force telling. |σ| of a dyad is a sine of the angle between two directions, so that it changes no faster than
//! both bodies turn: between two places of a step it stays above zero where its sum at both is more than that. A step that may pass
//! zero is looked into, and ends before it; from there the way leads over the change point.

use super::coordinates::CAREFUL;
use super::equations::Equations;
use super::going::{AGAIN, Going};
use super::records::within_step;
use crate::math::ode::Integrator;
use crate::plan::MotionStep;
use crate::solve::failure::Halt;

/// Two bodies turn against each other at most so much faster than the faster one.
const AGAINST: f64 = 2.0;
/// Parts of a step that are looked at first.
const PARTS: usize = 4;
/// Where |σ| is known to pass no place below this, none passes zero.
const NOTHING: f64 = 1e-3;
/// Where the step begins with less, the way over was looked for already; otherwise it is to end with about so much.
const LOOKED: f64 = AGAIN * CAREFUL;
const BEFORE: f64 = 0.8 * LOOKED;

/// Of stages of a step, two that follow each other are so far apart at most, parts of the step; there are so many of them.
const APART: f64 = 0.35;
const STAGES: u32 = 11;

/// A place of a step: the instant, s, |σ|, and how fast it may change, 1/s.
type Place = (f64, f64, f64);

impl Going<'_, '_> {
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
        if is_clear(begin, end) || equations.seen.is_clear((to - from) * begin.2.max(end.2)) {
            return Ok(());
        }
        let Some((before, zero)) = self.first_zero(equations, method, (begin, end)) else { return Ok(()) };
        if begin.1 <= LOOKED {
            // it was looked for from there
            let group = equations.least_group();
            return group.map_or(Ok(()), |group| Err(Halt::Dead { group, condition: before.1 }));
        }
        let part = BEFORE / begin.1;
        let t = zero - part * (zero - from);
        if method.shorten(equations, t).is_err() {
            return Err(equations.halt());
        }
        Ok(())
    }

    /// The last place before the first zero of |σ| in a step, and where that is, s.
    fn first_zero<M: Integrator<f64>>(
        &mut self,
        equations: &mut Equations<'_, '_>,
        method: &mut M,
        (begin, end): (Place, Place),
    ) -> Option<(Place, f64)> {
        let mut last = begin;
        let mut ahead = vec![end];
        #[allow(clippy::cast_precision_loss)] // few
        for part in (1..PARTS).rev() {
            let t = begin.0 + (end.0 - begin.0) * part as f64 / PARTS as f64;
            ahead.push(self.place(equations, method, t)?);
        }
        while let Some(next) = ahead.pop() {
            if is_clear(last, next) {
                last = next;
            } else if last.1.max(next.1) < NOTHING || !(next.0 - last.0 > f64::EPSILON * next.0.abs()) {
                return Some((last, 0.5 * (last.0 + next.0)));
            } else {
                ahead.push(next);
                ahead.push(self.place(equations, method, 0.5 * (last.0 + next.0))?);
            }
        }
        None
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

/// Whether |σ| stays above zero between two places.
fn is_clear((t, a, speed): Place, (to, b, other): Place) -> bool {
    a + b > (to - t) * speed.max(other)
}

/// What was seen of |σ| in the stages since the present step began.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Seen {
    least: f64,
    stages: u32,
}

impl Seen {
    /// A step begins where |σ| is so.
    pub const fn begin(condition: f64) -> Self {
        Self { least: condition, stages: 0 }
    }

    fn is_clear(self, turned: f64) -> bool {
        self.stages >= STAGES && self.least > 0.5 * APART * turned
    }
}

impl Equations<'_, '_> {
    /// A stage has been evaluated.
    pub fn note_stage(&mut self) {
        self.seen.least = self.seen.least.min(self.trial_condition());
        self.seen.stages += 1;
    }

    /// Whether the step that was made last leads over a change point.
    fn is_on_the_way_over(&self) -> bool {
        self.bridge.is_some() || self.passage.is_some()
    }

    /// The least condition figure of the state that was evaluated last.
    pub fn trial_condition(&self) -> f64 {
        self.trial.motion.conditions.iter().fold(1.0, |least, c| least.min(c.abs()))
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
