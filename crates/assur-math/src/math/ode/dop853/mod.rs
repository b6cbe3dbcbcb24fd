//! DOP853: the explicit Runge–Kutta method of order 8 by Dormand and Prince with error estimates of orders 5 and 3, twelve
//! evaluations for a step, and a continuous output of order 7 for three more (Hairer, Nørsett, Wanner, volume I, sections
//! II.5 and II.6).

#[doc(hidden)]
pub mod coefficients;

use super::progress::Trial;
use super::tolerance::first_step;
use super::{
    Integrator, Progress, Real, Step, Stopped, System, Tolerance, Undefined, eighth_root, epsilon, finite,
    nonzero, wide,
};
use coefficients::{
    DENSE_4, DENSE_5, DENSE_6, DENSE_7, END, FIFTH, Row, STAGE_2, STAGE_3, STAGE_4, STAGE_5, STAGE_6,
    STAGE_7, STAGE_8, STAGE_9, STAGE_10, STAGE_11, STAGE_12, STAGE_14, STAGE_15, STAGE_16, THIRD,
};

/// The next step is so much shorter than its error would allow: by the error alone, and by its trend.
const SAFE: (f64, f64) = (0.9, 0.8);
/// A step is at most so much longer than the last, and a trial not shorter than this part of the one that is rejected.
const GROWTH: f64 = 6.0;
const LEAST: f64 = 0.333;
/// Errors below these parts of what is allowed say nothing of the next: of a step, and of the one before.
const SMALL: (f64, f64) = (1e-8, 1e-4);
/// The rates at the end of the step among the stages.
const LAST: usize = 12;
/// Stages beside the first and the one at the end.
const ROWS: usize = 14;
/// h λ at the edge of the domain of stability, on the negative axis, squared.
const STABLE: f64 = 6.1 * 6.1;
/// So many steps at the edge make a problem stiff, and so many within in a row make it forget them.
const STIFF: (u32, u32) = (15, 6);
/// Where rounding hides that, the derivatives tell: they are looked at after so many steps, and h λ beyond this makes a problem
/// stiff.
const STRETCH: usize = 1000;
const BEYOND: f64 = 4.0;
/// Stiff, too, although rounding bounds the steps: the number of steps left, the least h λ, and the greatest ratio of the solution's
/// own rate to λ.
const ENDLESS: f64 = 2e4;
const NEAR: f64 = 0.1;
const SLOW: f64 = 0.02;
/// Times that a direction goes through the derivatives.
const TIMES: usize = 4;

/// How the length of the next step is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Control {
    /// From the error of the last step alone, as in the program of the book.
    Error,
    /// From its trend too (volume II, section IV.2): a growing error is met before it rejects a step.
    Trend,
}

/// The method for n unknowns.
#[derive(Clone, Debug)]
pub struct Dop853<S> {
    control: Control,
    progress: Progress<S>,
    tolerance: Tolerance<S>,
    stages: Stages<S>,
    /// Argument of the last stage that was evaluated.
    trial: Vec<S>,
    /// Mean rates over the step.
    slope: Vec<S>,
    /// Factors of the polynomial of the last step beyond the cubic.
    dense: [Vec<S>; 4],
    prepared: bool,
    /// Steps at the edge of stability, and steps within since.
    edge: (u32, u32),
    /// Steps when the derivatives were looked at.
    looked: usize,
    /// The error of the accepted step before.
    before: Option<S>,
}

/// Rates of the stages 2 to 12 and 14 to 16.
#[derive(Clone, Debug)]
struct Stages<S> {
    n: usize,
    rates: Vec<S>,
}

impl<S: Real> Stages<S> {
    #[inline(always)]
    fn place(&self, stage: usize) -> std::ops::Range<usize> {
        let row = stage - if stage < LAST { 1 } else { 2 };
        row * self.n..(row + 1) * self.n
    }

    /// The rates that a row of coefficients is for, and the coefficients.
    #[inline(always)]
    fn rows<'a, const M: usize>(&'a self, progress: &'a Progress<S>, row: &Row<M>) -> ([&'a [S]; M], [S; M]) {
        // loops, not `map`, which is not always written out
        let (mut rates, mut weights): ([&[S]; M], [S; M]) = ([&[]; M], [S::zero(); M]);
        for j in 0..M {
            rates[j] = match row.from[j] {
                0 => &progress.f0[..self.n],
                LAST => &progress.f1[..self.n],
                stage => &self.rates[self.place(stage)][..self.n],
            };
            weights[j] = wide(row.of[j]);
        }
        (rates, weights)
    }
}

#[inline(always)]
fn sum<S: Real, const M: usize>((rates, weights): &([&[S]; M], [S; M]), i: usize) -> S {
    let mut sum = weights[0] * rates[0][i];
    for j in 1..M {
        sum = sum + weights[j] * rates[j][i];
    }
    sum
}

impl<S: Real> Dop853<S> {
    /// Room for as many unknowns as have a tolerance.
    #[must_use]
    pub fn new(tolerance: Tolerance<S>) -> Self {
        Self::controlled(tolerance, Control::Trend)
    }

    /// The same with another control of its steps.
    #[must_use]
    pub fn controlled(tolerance: Tolerance<S>, control: Control) -> Self {
        let n = tolerance.order();
        let zeros = || vec![S::zero(); n];
        Self {
            control,
            progress: Progress::new(n),
            tolerance,
            stages: Stages { n, rates: vec![S::zero(); ROWS * n] },
            trial: zeros(),
            slope: zeros(),
            dense: std::array::from_fn(|_| zeros()),
            prepared: false,
            edge: (0, 0),
            looked: 0,
            before: None,
        }
    }

    #[inline(always)]
    fn stage<F: System<S> + ?Sized, const M: usize>(
        &mut self,
        system: &mut F,
        h: S,
        stage: usize,
        row: &Row<M>,
    ) -> Result<(), Undefined> {
        let n = self.stages.n;
        let rows = self.stages.rows(&self.progress, row);
        let (y, trial) = (&self.progress.y0[..n], &mut self.trial[..n]);
        for i in 0..n {
            trial[i] = y[i] + h * sum(&rows, i);
        }
        self.progress.counts.evaluations += 1;
        let place = self.stages.place(stage);
        let t = self.progress.t0 + wide::<S>(row.at) * h;
        evaluate(system, t, &self.trial, &mut self.stages.rates[place])
    }

    /// All stages of a step and the state at its end, without the rates there.
    fn stages<F: System<S> + ?Sized>(&mut self, system: &mut F, h: S) -> Result<(), Undefined> {
        self.prepared = false;
        self.stage(system, h, 1, &STAGE_2)?;
        self.stage(system, h, 2, &STAGE_3)?;
        self.stage(system, h, 3, &STAGE_4)?;
        self.stage(system, h, 4, &STAGE_5)?;
        self.stage(system, h, 5, &STAGE_6)?;
        self.stage(system, h, 6, &STAGE_7)?;
        self.stage(system, h, 7, &STAGE_8)?;
        self.stage(system, h, 8, &STAGE_9)?;
        self.stage(system, h, 9, &STAGE_10)?;
        self.stage(system, h, 10, &STAGE_11)?;
        self.stage(system, h, 11, &STAGE_12)?;
        // the argument of stage 12 stays in `trial`
        let rows = self.stages.rows(&self.progress, &END);
        for (i, slope) in self.slope.iter_mut().enumerate() {
            *slope = sum(&rows, i);
        }
        let Progress { y0, y1, .. } = &mut self.progress;
        for (y1, (y0, slope)) in y1.iter_mut().zip(y0.iter().zip(&self.slope)) {
            *y1 = *y0 + h * *slope;
        }
        Ok(())
    }

    /// The error of the step over what is allowed.
    fn error(&self, h: S) -> S {
        let (progress, n) = (&self.progress, self.stages.n);
        let (fifth, third) = (self.stages.rows(progress, &FIFTH), self.stages.rows(progress, &THIRD));
        let (mut of_fifth, mut of_third) = (S::zero(), S::zero());
        for i in 0..n {
            let allowed = self.tolerance.scale(i, progress.y0[i].abs().max(progress.y1[i].abs()));
            let (a, b) = (sum(&fifth, i) / allowed, (self.slope[i] - sum(&third, i)) / allowed);
            of_fifth = of_fifth + a * a;
            of_third = of_third + b * b;
        }
        let both = of_fifth + S::of(0.01) * of_third;
        if nonzero(both) { h.abs() * of_fifth / (count::<S>(n) * both).sqrt() } else { both }
    }

    /// The step is done but for the rates at its end.
    fn rates_at_end<F: System<S> + ?Sized>(&mut self, system: &mut F, t: S) -> Result<(), Undefined> {
        self.progress.counts.evaluations += 1;
        evaluate(system, t, &self.progress.y1, &mut self.progress.f1)
    }

    /// The step has been at the edge of stability for a while (volume II, section IV.2: |Δf|/|Δy| of the two states at its
    /// end estimates the greatest eigenvalue). All are measured by what is allowed of them: unknowns have units of their own.
    fn looks_stiff(&mut self, h: S) -> bool {
        let progress = &self.progress;
        let last = &self.stages.rates[self.stages.place(11)];
        let of_rates = self.tolerance.square_sum(&progress.y1, |i| progress.f1[i] - last[i]);
        let of_states = self.tolerance.square_sum(&progress.y1, |i| progress.y1[i] - self.trial[i]);
        if (S::of(STABLE) * of_states).lt(h * h * of_rates) {
            self.edge = (self.edge.0 + 1, 0);
        } else {
            self.edge.1 += 1;
            if self.edge.1 >= STIFF.1 {
                self.edge = (0, 0);
            }
        }
        let stiff = self.edge.0 >= STIFF.0;
        if stiff {
            self.edge = (0, 0);
        }
        stiff
    }

    /// A long stretch of short steps, though the solution is smooth: the greatest eigenvalue, by powers of the derivatives, is
    /// beyond what such steps are stable for, or faster by far than the solution, which such steps would follow without end.
    fn is_held_up<F: System<S> + ?Sized>(&mut self, system: &mut F, h: S) -> bool {
        let steps = self.progress.counts.steps;
        if steps < self.looked + STRETCH {
            return false;
        }
        self.looked = steps;
        let last = self.stages.place(11);
        // the memory of a polynomial that is not formed yet
        let way = &mut self.dense[0];
        for (v, (f, before)) in way.iter_mut().zip(self.progress.f1.iter().zip(&self.stages.rates[last])) {
            *v = *f - *before;
        }
        let mut growths = [S::zero(); TIMES];
        for growth in &mut growths {
            let Some(found) = self.growth(system) else { return false };
            *growth = found;
        }
        // of a turning pair of unknowns the growths take turns
        let fastest = h * h * growths[TIMES - 2] * growths[TIMES - 1];
        if S::of(BEYOND * BEYOND).lt(fastest) {
            return true;
        }
        let left = (self.progress.end - self.progress.t1).abs();
        if !(S::of(ENDLESS) * h.abs()).lt(left) || !S::of(NEAR * NEAR).lt(fastest) {
            return false;
        }
        self.dense[0].copy_from_slice(&self.progress.f1);
        let own = self.growth(system).map(|own| h * h * own * own);
        own.is_some_and(|own| own.lt(S::of(SLOW * SLOW) * fastest))
    }

    /// By how much a direction grows that goes through the derivatives at the end of the step. It is looked at as far as unknowns
    /// may be off, at least: a motion may be small.
    fn growth<F: System<S> + ?Sized>(&mut self, system: &mut F) -> Option<S> {
        let [way, rates, ..] = &mut self.dense;
        let (at, progress, tolerance) = (&mut self.trial, &mut self.progress, &self.tolerance);
        let size = |v: &[S]| tolerance.square_sum(&progress.y1, |i| v[i]).sqrt();
        let length = size(way);
        if !nonzero(length) {
            return None;
        }
        let part = (epsilon::<S>().sqrt() * size(&progress.y1)).max(S::one()) / length;
        for (at, (y, v)) in at.iter_mut().zip(progress.y1.iter().zip(&*way)) {
            *at = *y + part * *v;
        }
        progress.counts.evaluations += 1;
        evaluate(system, progress.t1, at, rates).ok()?;
        for (v, (f, here)) in way.iter_mut().zip(rates.iter().zip(&progress.f1)) {
            *v = (*f - *here) / part;
        }
        Some(tolerance.square_sum(&progress.y1, |i| way[i]).sqrt() / length)
    }

    /// A trial and its error; the next length that the error asks for.
    fn attempt<F: System<S> + ?Sized>(
        &mut self,
        system: &mut F,
        trial: Trial<S>,
    ) -> Result<(bool, S), Undefined> {
        self.stages(system, trial.h)?;
        let error = self.error(trial.h);
        if !finite(error) {
            return Err(Undefined);
        }
        let accepted = !S::one().lt(error);
        // one over what the next step is longer by; a rejected step does not grow
        let (root, safe) = match (self.control, self.before) {
            (Control::Error, _) => (eighth_root(error), SAFE.0),
            (Control::Trend, Some(before)) if accepted => {
                let error = error.max(S::of(SMALL.0));
                (eighth_root(error * error * error / before).sqrt().sqrt(), SAFE.1)
            }
            (Control::Trend, _) => (eighth_root(error), SAFE.1),
        };
        let wish = (root / S::of(safe)).max(S::of(1.0 / GROWTH)).min(S::of(1.0 / LEAST));
        if accepted {
            self.rates_at_end(system, trial.t)?;
            self.progress.note_error(error);
            self.before = Some(error.max(S::of(SMALL.1)));
        }
        Ok((accepted, trial.h / wish))
    }
}

impl<S: Real> Integrator<S> for Dop853<S> {
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
        (self.prepared, self.edge, self.before) = (false, (0, 0), None);
        if nonzero(end - t) {
            let room = (&mut self.trial[..], &mut self.stages.rates[..y.len()]);
            self.progress.next = first_step(system, &mut self.progress, &self.tolerance, room, eighth_root)?;
        }
        Ok(())
    }

    fn step<F: System<S> + ?Sized>(&mut self, system: &mut F) -> Result<Step, Stopped> {
        if !self.progress.begin(system) {
            return Ok(Step::Last);
        }
        loop {
            let trial = self.progress.trial()?;
            match self.attempt(system, trial) {
                Ok((true, next)) => {
                    let step = self.progress.accept(trial, next);
                    let stiff = self.looks_stiff(trial.h) || self.is_held_up(system, trial.h);
                    return if stiff { Err(Stopped::Stiff) } else { Ok(step) };
                }
                Ok((false, next)) => self.progress.reject(next),
                Err(Undefined) => self.progress.reject_undefined(trial),
            }
        }
    }

    fn shorten<F: System<S> + ?Sized>(&mut self, system: &mut F, t: S) -> Result<(), Undefined> {
        let h = t - self.progress.t0;
        let done = if nonzero(h) {
            self.stages(system, h).and_then(|()| self.rates_at_end(system, t))
        } else {
            self.progress.undo();
            Ok(())
        };
        match done {
            Ok(()) => self.progress.shortened(t),
            Err(Undefined) => self.progress.undo(),
        }
        done
    }

    fn prepare_dense<F: System<S> + ?Sized>(&mut self, system: &mut F) -> Result<(), Undefined> {
        let h = self.progress.length();
        if self.prepared || !nonzero(h) {
            return Ok(());
        }
        self.stage(system, h, 13, &STAGE_14)?;
        self.stage(system, h, 14, &STAGE_15)?;
        self.stage(system, h, 15, &STAGE_16)?;
        for (factors, row) in self.dense.iter_mut().zip([&DENSE_4, &DENSE_5, &DENSE_6, &DENSE_7]) {
            let rows = self.stages.rows(&self.progress, row);
            for (i, factor) in factors.iter_mut().enumerate() {
                *factor = h * sum(&rows, i);
            }
        }
        self.prepared = true;
        Ok(())
    }

    fn dense(&self, t: S, y: &mut [S]) {
        let h = self.progress.length();
        let s = if nonzero(h) { (t - self.progress.t0) / h } else { S::one() };
        let r = S::one() - s;
        let [d4, d5, d6, d7] = &self.dense;
        for (i, y) in y.iter_mut().enumerate() {
            let [a, b, c, d] = self.progress.cubic(i);
            let rest =
                if self.prepared { r * (d4[i] + s * (d5[i] + r * (d6[i] + s * d7[i]))) } else { S::zero() };
            *y = a + s * (b + r * (c + s * (d + rest)));
        }
    }
}

/// The rates, written out once.
#[inline(never)]
fn evaluate<S, F: System<S> + ?Sized>(system: &mut F, t: S, y: &[S], dy: &mut [S]) -> Result<(), Undefined> {
    system.rates(t, y, dy)
}

#[allow(clippy::cast_precision_loss)] // far below 2^52
fn count<S: Real>(n: usize) -> S {
    S::of(n as f64)
}
