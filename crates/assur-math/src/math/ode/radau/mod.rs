//! Radau IIA of order 5: implicit, with three stages, stable for every decay (Hairer and Wanner, volume II, sections IV.5 to
//! IV.8). Its continuous output is the polynomial of the stages, of order 3, without more evaluations.

mod newton;

use super::progress::Trial;
use super::tolerance::first_step;
use super::{
    Integrator, Progress, Real, Step, Stopped, System, Tolerance, Undefined, epsilon, finite, nonzero, wide,
};
use newton::PLACES;
use newton::{Ended, FAST, MOST, Stages};

const SAFETY: f64 = 0.9;

/// The method for n unknowns.
#[derive(Clone, Debug)]
pub struct Radau<S> {
    progress: Progress<S>,
    /// As the estimate of order 3 needs it.
    tolerance: Tolerance<S>,
    /// What the iterations may leave.
    enough: S,
    stages: Stages<S>,
    /// What is allowed of each component in this step.
    allowed: Vec<S>,
    polynomial: Polynomial<S>,
    /// The polynomial is of a step of this length.
    known: Option<S>,
    derived: Derived,
    /// Length for which the matrices are factored.
    factored: Option<S>,
    /// Length and error of the accepted step before.
    before: Option<(S, S)>,
}

/// y = y₁ + s(a + (s + 1 − c₂)(b + (s + 1 − c₁)c)), s from −1 to 0 over the step.
#[derive(Clone, Debug)]
struct Polynomial<S>([Vec<S>; 3]);

impl<S: Real> Polynomial<S> {
    /// The value less y₁.
    fn rise(&self, i: usize, s: S) -> S {
        let [a, b, c] = &self.0;
        let (first, second) = (S::one() - wide(PLACES[0]), S::one() - wide(PLACES[1]));
        s * (a[i] + (s + second) * (b[i] + (s + first) * c[i]))
    }

    fn set(&mut self, [z_1, z_2, z_3]: &[Vec<S>; 3]) {
        let [c_1, c_2, one] = PLACES.map(wide::<S>);
        let [a, b, c] = &mut self.0;
        for i in 0..a.len() {
            a[i] = (z_2[i] - z_3[i]) / (c_2 - one);
            let inner = (z_1[i] - z_2[i]) / (c_1 - c_2);
            b[i] = (inner - a[i]) / (c_1 - one);
            c[i] = b[i] - (inner - z_1[i] / c_1) / c_2;
        }
    }
}

/// Of when the derivatives are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Derived {
    Never,
    Earlier,
    Here,
}

/// Where the stages lie on the polynomial of the last step.
#[derive(Clone, Copy, Debug)]
enum Guess {
    Beyond,
    Within,
}

/// What a trial comes to.
enum Outcome<S> {
    Accepted(S),
    Rejected(S),
}

impl<S: Real> Radau<S> {
    /// Room for as many unknowns as have a tolerance.
    #[must_use]
    pub fn new(tolerance: &Tolerance<S>) -> Self {
        let n = tolerance.order();
        let zeros = || vec![S::zero(); n];
        let (tolerance, finest) = tolerance.of_third_order();
        let enough = (S::of(10.0) * epsilon::<S>() / finest).max(finest.sqrt().min(S::of(0.03)));
        Self {
            progress: Progress::new(n),
            tolerance,
            enough: enough.min(S::of(0.03)),
            stages: Stages::new(n),
            allowed: zeros(),
            polynomial: Polynomial([zeros(), zeros(), zeros()]),
            known: None,
            derived: Derived::Never,
            factored: None,
            before: None,
        }
    }

    /// Nothing is known of what was before.
    fn forget(&mut self) {
        (self.known, self.derived, self.factored, self.before) = (None, Derived::Never, None, None);
    }

    /// Matrices for a step from here; `false` where they are singular.
    fn prepare<F: System<S> + ?Sized>(&mut self, system: &mut F, h: S) -> Result<bool, Undefined> {
        if self.derived == Derived::Never {
            self.factored = None;
            self.stages.derive(system, &mut self.progress)?;
            self.derived = Derived::Here;
        }
        if self.factored.is_none_or(|factored| nonzero(factored - h)) {
            self.factored = if self.stages.factor(h) { Some(h) } else { None };
        }
        for (i, (allowed, y)) in self.allowed.iter_mut().zip(&self.progress.y0).enumerate() {
            *allowed = self.tolerance.scale(i, y.abs());
        }
        Ok(self.factored.is_some())
    }

    /// Newton's iterations for a step of this length.
    fn solve<F: System<S> + ?Sized>(
        &mut self,
        system: &mut F,
        h: S,
        guess: Guess,
    ) -> Result<Ended<S>, Undefined> {
        let (progress, polynomial) = (&self.progress, &self.polynomial);
        let ratio = self.known.map_or(S::zero(), |known| h / known);
        self.stages.guess(|i, place| match guess {
            // without a step before the ratio is zero
            Guess::Beyond => polynomial.rise(i, ratio * place),
            Guess::Within => progress.y1[i] - progress.y0[i] + polynomial.rise(i, ratio * place - S::one()),
        });
        let ended = self.stages.iterate(system, &mut self.progress, h, (&self.allowed, self.enough));
        if let Ok(Ended::Converged(_)) = ended {
            let progress = &mut self.progress;
            let values = progress.y0.iter().zip(&self.stages.z[2]);
            progress.y1.iter_mut().zip(values).for_each(|(y1, (y0, z))| *y1 = *y0 + *z);
        }
        ended
    }

    fn attempt<F: System<S> + ?Sized>(
        &mut self,
        system: &mut F,
        trial: Trial<S>,
    ) -> Result<Outcome<S>, Undefined> {
        let h = trial.h;
        if !self.prepare(system, h)? {
            return Ok(Outcome::Rejected(S::of(0.5) * h));
        }
        let turns = match self.solve(system, h, Guess::Beyond)? {
            Ended::Converged(turns) => turns,
            Ended::Failed(factor) => {
                self.renew();
                return Ok(Outcome::Rejected(h * factor));
            }
        };
        let first = self.before.is_none();
        let again = first || self.progress.again;
        let error = self.stages.error(system, &mut self.progress, h, &self.allowed, again);
        if !finite(error) {
            return Err(Undefined);
        }
        let error = error.max(S::of(1e-10));
        let safety = S::of(SAFETY) * (small::<S>(1 + 2 * MOST) / small(turns + 2 * MOST));
        let root = |x: S| x.sqrt().sqrt();
        let bounded = |x: S| x.max(S::of(0.125)).min(S::of(5.0));
        let mut ratio = bounded(root(error) / safety);
        if !error.lt(S::one()) {
            self.renew();
            return Ok(Outcome::Rejected(if first { S::of(0.1) * h } else { h / ratio }));
        }
        self.progress.counts.evaluations += 1;
        system.rates(trial.t, &self.progress.y1, &mut self.progress.f1)?;
        self.progress.note_error(error);
        if let Some((length, before)) = self.before {
            // Gustafsson: the trend of the error goes on
            let trend = (length / h).abs() * root(error * error / before) / S::of(SAFETY);
            ratio = ratio.max(bounded(trend));
        }
        self.before = Some((h, error.max(S::of(0.01))));
        self.polynomial.set(&self.stages.z);
        self.known = Some(h);
        Ok(Outcome::Accepted(self.keep(h, h / ratio)))
    }

    /// Decides what of the matrices serves the next step; its length.
    fn keep(&mut self, h: S, next: S) -> S {
        if S::of(FAST).lt(self.stages.theta) {
            self.derived = Derived::Never;
            return next;
        }
        self.derived = Derived::Earlier;
        let growth = next / h;
        // little longer is not worth another elimination
        if growth.lt(S::one()) || S::of(1.2).lt(growth) { next } else { h }
    }

    /// Derivatives of an earlier state are not to blame twice.
    fn renew(&mut self) {
        if self.derived == Derived::Earlier {
            self.derived = Derived::Never;
        }
    }

    /// The last step again with another length; with new derivatives where those at hand do not serve.
    fn redo<F: System<S> + ?Sized>(&mut self, system: &mut F, t: S) -> Result<(), Undefined> {
        let h = t - self.progress.t0;
        for renewed in [false, true] {
            if renewed {
                self.derived = Derived::Never;
            }
            if self.prepare(system, h)?
                && matches!(self.solve(system, h, Guess::Within)?, Ended::Converged(_))
            {
                self.progress.counts.evaluations += 1;
                system.rates(t, &self.progress.y1, &mut self.progress.f1)?;
                self.polynomial.set(&self.stages.z);
                self.known = Some(h);
                self.derived = Derived::Earlier;
                return Ok(());
            }
        }
        Err(Undefined)
    }
}

impl<S: Real> Integrator<S> for Radau<S> {
    fn progress(&self) -> &Progress<S> {
        &self.progress
    }

    fn progress_mut(&mut self) -> &mut Progress<S> {
        &mut self.progress
    }

    fn start<F: System<S> + ?Sized>(
        &mut self,
        system: &mut F,
        t: S,
        y: &[S],
        end: S,
    ) -> Result<(), Undefined> {
        self.progress.place(system, Some(t), y, end)?;
        self.forget();
        if nonzero(end - t) {
            let [trial, rates, _] = &mut self.polynomial.0;
            let root = |x: S| x.sqrt().sqrt();
            self.progress.next =
                first_step(system, &mut self.progress, &self.tolerance, (trial, rates), root)?;
        }
        Ok(())
    }

    fn restart<F: System<S> + ?Sized>(&mut self, system: &mut F, y: &[S], end: S) -> Result<(), Undefined> {
        self.forget();
        self.progress.place(system, None, y, end)
    }

    fn step<F: System<S> + ?Sized>(&mut self, system: &mut F) -> Result<Step, Stopped> {
        if !self.progress.begin(system) {
            return Ok(Step::Last);
        }
        loop {
            let trial = self.progress.trial()?;
            match self.attempt(system, trial) {
                Ok(Outcome::Accepted(next)) => return Ok(self.progress.accept(trial, next)),
                Ok(Outcome::Rejected(next)) => self.progress.reject(next),
                Err(Undefined) => {
                    self.renew();
                    self.progress.reject_undefined(trial);
                }
            }
        }
    }

    fn shorten<F: System<S> + ?Sized>(&mut self, system: &mut F, t: S) -> Result<(), Undefined> {
        if !nonzero(t - self.progress.t0) {
            self.progress.undo();
            self.known = None;
        } else if let Err(undefined) = self.redo(system, t) {
            self.progress.undo();
            self.forget();
            return Err(undefined);
        }
        self.progress.shortened(t);
        Ok(())
    }

    /// There is nothing to do.
    fn prepare_dense<F: System<S> + ?Sized>(&mut self, _: &mut F) -> Result<(), Undefined> {
        Ok(())
    }

    /// Of order 3, from the stages.
    fn dense(&self, t: S, y: &mut [S]) {
        let h = self.progress.length();
        let s = if nonzero(h) { (t - self.progress.t1) / h } else { S::zero() };
        for (i, y) in y.iter_mut().enumerate() {
            *y = self.progress.y1[i] + self.polynomial.rise(i, s);
        }
    }
}

#[allow(clippy::cast_precision_loss)] // far below 2^52
fn small<S: Real>(n: usize) -> S {
    S::of(n as f64)
}
