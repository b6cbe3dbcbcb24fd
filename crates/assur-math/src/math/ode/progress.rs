//! Where an integration stands: both ends of the last step, the length of the next, what it cost.

use super::{Real, Step, Stopped, System, Undefined, epsilon, nonzero};

/// What an integration cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Evaluations of the rates.
    pub evaluations: usize,
    pub steps: usize,
    /// Trials that were rejected: by their error, or because a stage had no value.
    pub rejected: usize,
    /// Steps that were ended before their end.
    pub shortened: usize,
}

/// Where an integration stands.
#[derive(Clone, Debug)]
pub struct Progress<S> {
    pub(super) t0: S,
    pub(super) t1: S,
    pub(super) y0: Vec<S>,
    pub(super) y1: Vec<S>,
    pub(super) f0: Vec<S>,
    pub(super) f1: Vec<S>,
    pub(super) end: S,
    /// Length of the next trial, with its sign.
    pub(super) next: S,
    /// The system knows of (t1, y1).
    known: bool,
    /// A trial from here was rejected: the next step does not grow.
    pub(super) again: bool,
    /// The last rejected trial had a stage without a value.
    undefined: bool,
    pub(super) counts: Counts,
    /// Steps that were done at the start.
    before: usize,
    /// Accepted and rejected steps together that are allowed from a start.
    pub most_steps: usize,
    /// No step is longer.
    pub longest: Option<S>,
    /// Errors of accepted steps as the method estimates them, over what is allowed: the greatest, and their sum.
    pub errors: (S, S),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Trial<S> {
    pub h: S,
    pub t: S,
    /// It ends at the end.
    pub last: bool,
}

impl<S: Real> Progress<S> {
    pub(super) fn new(n: usize) -> Self {
        let zeros = || vec![S::zero(); n];
        Self {
            t0: S::zero(),
            t1: S::zero(),
            y0: zeros(),
            y1: zeros(),
            f0: zeros(),
            f1: zeros(),
            end: S::zero(),
            next: S::zero(),
            known: true,
            again: false,
            undefined: false,
            counts: Counts::default(),
            before: 0,
            most_steps: 1_000_000,
            longest: None,
            errors: (S::zero(), S::zero()),
        }
    }

    /// Stands at a state, at another t where one is given.
    pub(super) fn place<F: System<S> + ?Sized>(
        &mut self,
        system: &mut F,
        t: Option<S>,
        y: &[S],
        end: S,
    ) -> Result<(), Undefined> {
        if let Some(t) = t {
            self.t1 = t;
            self.before = self.tried();
        }
        self.y1.copy_from_slice(y);
        self.end = end;
        self.counts.evaluations += 1;
        system.rates(self.t1, &self.y1, &mut self.f1)?;
        (self.known, self.again) = (false, false);
        self.leave();
        Ok(())
    }

    fn tried(&self) -> usize {
        self.counts.steps + self.counts.rejected
    }

    /// A step of no length at the end of the last.
    fn leave(&mut self) {
        self.t0 = self.t1;
        self.y0.copy_from_slice(&self.y1);
        self.f0.copy_from_slice(&self.f1);
    }

    /// The last step ends where it began.
    pub(super) fn undo(&mut self) {
        self.t1 = self.t0;
        self.y1.copy_from_slice(&self.y0);
        self.f1.copy_from_slice(&self.f0);
    }

    /// Length of the last step.
    pub(super) fn length(&self) -> S {
        self.t1 - self.t0
    }

    /// A step length that is not longer than the longest.
    pub(super) fn bounded(&self, h: S) -> S {
        self.longest.map_or(h, |longest| if longest.lt(h.abs()) { signed(longest, h) } else { h })
    }

    /// Makes the next trial no longer than this.
    pub fn begin_with(&mut self, longest: S) {
        if longest.lt(self.next.abs()) {
            self.next = signed(longest, self.next);
        }
    }

    /// Begins a step where the last one ended; false where nothing is left to do.
    pub(super) fn begin<F: System<S> + ?Sized>(&mut self, system: &mut F) -> bool {
        if !nonzero(self.end - self.t1) {
            return false;
        }
        if !self.known {
            system.accepted(self.t1, &self.y1);
            self.known = true;
        }
        self.leave();
        (self.again, self.undefined) = (false, false);
        true
    }

    /// The next trial, or why there is none.
    pub(super) fn trial(&mut self) -> Result<Trial<S>, Stopped> {
        let left = self.end - self.t0;
        let h = signed(self.bounded(self.next), left);
        let stopped = if self.tried() - self.before >= self.most_steps {
            Some(Stopped::TooManySteps)
        } else if !(S::of(10.0) * epsilon::<S>() * self.t0.abs().max(S::of(1e-10) * left.abs())).lt(h.abs()) {
            Some(if self.undefined { Stopped::Undefined } else { Stopped::StepTooSmall })
        } else {
            None
        };
        if let Some(stopped) = stopped {
            self.undo();
            return Err(stopped);
        }
        // a hundredth more does not leave a step behind
        let last = left.abs().lt(S::of(1.01) * h.abs());
        if last {
            return Ok(Trial { h: left, t: self.end, last });
        }
        // as long as t moves: what rounding leaves off each time would add up over a long run
        let t = self.t0 + h;
        Ok(Trial { h: t - self.t0, t, last })
    }

    /// The trial is rejected for its error.
    pub(super) fn reject(&mut self, next: S) {
        self.next = next;
        (self.again, self.undefined) = (true, false);
        self.counts.rejected += 1;
    }

    /// The trial is rejected because a stage has no value.
    pub(super) fn reject_undefined(&mut self, trial: Trial<S>) {
        self.reject(trial.h * S::of(0.5));
        self.undefined = true;
    }

    /// The trial is accepted; y1 and f1 are its end.
    pub(super) fn accept(&mut self, trial: Trial<S>, next: S) -> Step {
        self.t1 = trial.t;
        self.known = false;
        self.counts.steps += 1;
        let next = if self.again { signed(next.abs().min(trial.h.abs()), next) } else { next };
        // a last step that was cut says little of the next
        let cut = trial.last && !self.again && trial.h.abs().lt(self.next.abs());
        self.next = if cut { signed(next.abs().max(self.next.abs()), next) } else { next };
        self.again = false;
        if trial.last { Step::Last } else { Step::Within }
    }

    /// Notes the error of a step that is accepted.
    pub(super) fn note_error(&mut self, error: S) {
        self.errors = (self.errors.0.max(error), self.errors.1 + error);
    }

    /// The last step ends at t.
    pub(super) fn shortened(&mut self, t: S) {
        self.t1 = t;
        self.known = false;
        self.counts.shortened += 1;
    }

    /// The cubic through values and rates at both ends of the last step: its terms of component i for
    /// y = a + s(b + (1 − s)(c + s(d + …))), s the part of the step (volume I, section II.6).
    #[inline]
    pub(super) fn cubic(&self, i: usize) -> [S; 4] {
        let h = self.length();
        let rise = self.y1[i] - self.y0[i];
        let bend = h * self.f0[i] - rise;
        [self.y0[i], rise, bend, rise - h * self.f1[i] - bend]
    }
}

/// A magnitude with the sign of another number.
pub(super) fn signed<S: Real>(magnitude: S, of: S) -> S {
    let magnitude = magnitude.abs();
    if of.lt(S::zero()) { -magnitude } else { magnitude }
}
