//! Extrapolation of the explicit midpoint rule after Gragg, Bulirsch and Stoer, with choice of order and step (Hairer,
//! Nørsett, Wanner, volume I, section II.9): its numbers are ratios of integers, so that the order goes as far as the digits
//! do. The reference method in double-double: over an orbit its error stays near the tolerance down to 1e-26.

use super::event::Hermite;
use super::progress::Trial;
use super::tolerance::first_step;
use super::{
    Integrator, Progress, Real, Step, Stopped, System, Tolerance, Undefined, epsilon, finite, nonzero,
    rough_root,
};

/// Columns at most: of `f64`, and of numbers with more digits.
const COLUMNS: (usize, usize) = (10, 18);

/// The method for n unknowns.
#[derive(Clone, Debug)]
pub struct Extrapolation<S> {
    progress: Progress<S>,
    tolerance: Tolerance<S>,
    /// Row k: through the results of columns k to the last.
    table: Vec<Vec<S>>,
    /// The best values of the column before.
    previous: Vec<S>,
    /// The two last places of the midpoint rule, an argument and the rates there.
    places: [Vec<S>; 2],
    trial: Vec<S>,
    rates: Vec<S>,
    /// The column, counted from 0, in which convergence is expected.
    target: usize,
    /// Length of the step that each column asks for.
    wish: Vec<S>,
    /// No step was accepted yet.
    first: bool,
    dense: Hermite<S>,
}

/// Parts that the midpoint rule takes in a column.
#[inline]
fn parts(column: usize) -> usize {
    2 * (column + 1)
}

#[allow(clippy::cast_precision_loss)] // far below 2^52
fn number<S: Real>(n: usize) -> S {
    S::of(n as f64)
}

/// Evaluations for all columns up to one.
fn cost<S: Real>(column: usize) -> S {
    // Σ (2j − 1) for the parts, one at the end
    number((column + 1) * (column + 1) + 1)
}

/// What a trial comes to: the next length and column.
enum Outcome<S> {
    Accepted(S, usize),
    Rejected(S, usize),
}

impl<S: Real> Extrapolation<S> {
    /// Room for as many unknowns as have a tolerance.
    #[must_use]
    pub fn new(tolerance: Tolerance<S>) -> Self {
        let n = tolerance.order();
        let zeros = || vec![S::zero(); n];
        let columns = if S::EXTENDED { COLUMNS.1 } else { COLUMNS.0 };
        let expected = (6 * tolerance.digits()).div_ceil(10);
        Self {
            progress: Progress::new(n),
            table: vec![zeros(); columns],
            previous: zeros(),
            places: [zeros(), zeros()],
            trial: zeros(),
            rates: zeros(),
            target: expected.clamp(2, columns - 2),
            tolerance,
            wish: vec![S::zero(); columns],
            first: true,
            dense: Hermite::new(columns + 1, n),
        }
    }

    /// The midpoint rule of a column from the beginning of the step, and what follows for all columns.
    fn column<F: System<S> + ?Sized>(
        &mut self,
        system: &mut F,
        h: S,
        column: usize,
    ) -> Result<(), Undefined> {
        let n = parts(column);
        let part = h / number(n);
        let double = part + part;
        let progress = &mut self.progress;
        let [before, last] = &mut self.places;
        before.fill(S::zero());
        last.iter_mut().zip(&progress.f0).for_each(|(last, f)| *last = part * *f);
        for i in 1..n {
            let places = progress.y0.iter().zip(last.iter());
            self.trial.iter_mut().zip(places).for_each(|(trial, (y, z))| *trial = *y + *z);
            progress.counts.evaluations += 1;
            system.rates(progress.t0 + number::<S>(i) * part, &self.trial, &mut self.rates)?;
            for (before, f) in before.iter_mut().zip(&self.rates) {
                *before = *before + double * *f;
            }
            std::mem::swap(before, last);
        }
        self.previous.copy_from_slice(&self.table[0]);
        self.table[column].copy_from_slice(last);
        for k in (0..column).rev() {
            let ratio = number::<S>(n) / number(parts(k));
            let weight = S::one() / (ratio * ratio - S::one());
            let (lower, upper) = self.table.split_at_mut(k + 1);
            for (low, high) in lower[k].iter_mut().zip(&upper[0]) {
                *low = *high + (*high - *low) * weight;
            }
        }
        Ok(())
    }

    /// What the best values differ from the second best and from the best of the column before, the greater, over what is
    /// allowed. Either alone is small by chance where the solution turns sharply.
    fn error(&self) -> S {
        let (progress, best, next) = (&self.progress, &self.table[0], &self.table[1]);
        let (mut second, mut before) = (S::zero(), S::zero());
        for (i, best) in best.iter().enumerate() {
            let y = progress.y0[i];
            let allowed = self.tolerance.scale(i, y.abs().max((y + *best).abs()));
            let (a, b) = ((*best - next[i]) / allowed, (*best - self.previous[i]) / allowed);
            (second, before) = (second + a * a, before + b * b);
        }
        (second.max(before) / number(best.len())).sqrt()
    }

    /// Columns until the difference is a part of what is allowed, or there are no more; the last one.
    fn columns_until<F: System<S> + ?Sized>(
        &mut self,
        system: &mut F,
        h: S,
        enough: f64,
    ) -> Result<(), Undefined> {
        for column in 0..self.table.len() {
            self.column(system, h, column)?;
            if column > 0 && !S::of(enough).lt(self.error()) {
                break;
            }
        }
        Ok(())
    }

    fn set_end(&mut self) {
        let Progress { y0, y1, .. } = &mut self.progress;
        y1.iter_mut().zip(y0.iter().zip(&self.table[0])).for_each(|(y1, (y0, rise))| *y1 = *y0 + *rise);
    }

    fn rates_at_end<F: System<S> + ?Sized>(&mut self, system: &mut F, t: S) -> Result<(), Undefined> {
        self.progress.counts.evaluations += 1;
        system.rates(t, &self.progress.y1, &mut self.progress.f1)
    }

    fn attempt<F: System<S> + ?Sized>(
        &mut self,
        system: &mut F,
        trial: Trial<S>,
    ) -> Result<Outcome<S>, Undefined> {
        self.dense.used = 0;
        let (h, target) = (trial.h, self.target);
        for column in 0..=target + 1 {
            self.column(system, h, column)?;
            if column == 0 {
                continue;
            }
            let error = self.error();
            if !finite(error) {
                return Err(Undefined);
            }
            // h · 0.94 (0.65/error)^(1/(2k − 1)), within bounds that open with the order
            let (power, bound) = (2 * column + 1, rough_root(S::of(0.02), 2 * column + 1));
            let longer = S::of(0.94) / rough_root((error / S::of(0.65)).max(epsilon()), power);
            self.wish[column] = h * longer.max(bound * S::of(0.25)).min(S::one() / bound);
            if column + 1 < target && !(self.first || trial.last) {
                continue;
            }
            if !S::one().lt(error) {
                self.set_end();
                self.rates_at_end(system, trial.t)?;
                return Ok(self.accepted(column));
            }
            if self.hopeless(error, column) {
                return Ok(self.rejected(column));
            }
        }
        Ok(self.rejected(target + 1))
    }

    /// The error will not come down to what is allowed by the columns that are left.
    fn hopeless(&self, error: S, column: usize) -> bool {
        let ratio = |column: usize| number::<S>(parts(column)) / number(parts(0));
        let fall = match (column + 1).checked_sub(self.target) {
            Some(0) => ratio(self.target + 1) * ratio(self.target),
            Some(1) => ratio(self.target + 1),
            _ => return false,
        };
        (fall * fall).lt(error)
    }

    /// Evaluations of a column for a unit of t.
    fn work(&self, column: usize) -> S {
        cost::<S>(column) / self.wish[column].abs()
    }

    /// Little less work than another column.
    fn cheaper(&self, column: usize, than: usize, part: f64) -> bool {
        column >= 1 && self.work(column).lt(S::of(part) * self.work(than))
    }

    /// The column and length after a step that was accepted in a column.
    fn accepted(&self, column: usize) -> Outcome<S> {
        let (most, target) = (self.table.len() - 2, self.target);
        let next = if column == 1 {
            2
        } else if column <= target {
            if self.cheaper(column - 1, column, 0.8) {
                column - 1
            } else if self.cheaper(column, column - 1, 0.9) {
                column + 1
            } else {
                column
            }
        } else {
            let next = if self.cheaper(column - 2, column - 1, 0.8) { column - 2 } else { column - 1 };
            if self.cheaper(column, next, 0.9) { column } else { next }
        };
        // a trial that was rejected here does not raise the order
        let next = if self.progress.again { next.min(column) } else { next };
        let next = next.clamp(1, most);
        let length =
            if next <= column { self.wish[next] } else { self.wish[column] * cost(next) / cost(column) };
        Outcome::Accepted(length, next.max(2))
    }

    /// The column and length after a trial that was given up in a column.
    fn rejected(&self, column: usize) -> Outcome<S> {
        let next = self.target.min(column);
        let next = if next > 2 && self.cheaper(next - 1, next, 0.8) { next - 1 } else { next };
        Outcome::Rejected(self.wish[next], next.max(2))
    }
}

impl<S: Real> Integrator<S> for Extrapolation<S> {
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
        (self.first, self.dense.used) = (true, 0);
        if nonzero(end - t) {
            let power = 2 * self.target;
            let root = |x: S| rough_root(x, power);
            let room = (&mut self.trial[..], &mut self.rates[..]);
            self.progress.next = first_step(system, &mut self.progress, &self.tolerance, room, root)?;
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
                Ok(Outcome::Accepted(next, column)) => {
                    (self.target, self.first) = (column, false);
                    return Ok(self.progress.accept(trial, next));
                }
                Ok(Outcome::Rejected(next, column)) => {
                    self.target = column;
                    self.progress.reject(next);
                }
                Err(Undefined) => self.progress.reject_undefined(trial),
            }
        }
    }

    fn shorten<F: System<S> + ?Sized>(&mut self, system: &mut F, t: S) -> Result<(), Undefined> {
        let h = t - self.progress.t0;
        self.dense.used = 0;
        let done = if nonzero(h) {
            self.columns_until(system, h, 1.0).and_then(|()| {
                self.set_end();
                self.rates_at_end(system, t)
            })
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

    /// Steps from the beginning to places within, as many as the order needs: several times the evaluations of the step.
    fn prepare_dense<F: System<S> + ?Sized>(&mut self, system: &mut F) -> Result<(), Undefined> {
        let h = self.progress.length();
        if self.dense.used > 0 || !nonzero(h) {
            return Ok(());
        }
        let used = (self.target + 3).min(self.dense.places.len());
        for place in 0..used {
            let t = self.progress.t0 + self.dense.places[place] * h;
            if place >= 2 {
                let part = t - self.progress.t0;
                self.columns_until(system, part, 0.1)?;
                let rises = self.progress.y0.iter().zip(&self.table[0]);
                self.trial.iter_mut().zip(rises).for_each(|(trial, (y, rise))| *trial = *y + *rise);
                self.progress.counts.evaluations += 1;
                system.rates(t, &self.trial, &mut self.rates)?;
            }
            let progress = &self.progress;
            let (y, rates) = match place {
                0 => (&progress.y0, &progress.f0),
                1 => (&progress.y1, &progress.f1),
                _ => (&self.trial, &self.rates),
            };
            for (i, (y, rate)) in y.iter().zip(rates).enumerate() {
                self.dense.set(place, i, *y - progress.y0[i], h * *rate);
            }
        }
        self.dense.divide(used);
        Ok(())
    }

    /// Prepared, of the order of the step.
    fn dense(&self, t: S, y: &mut [S]) {
        let h = self.progress.length();
        let s = if nonzero(h) { (t - self.progress.t0) / h } else { S::one() };
        for (i, y) in y.iter_mut().enumerate() {
            *y = if self.dense.used > 0 {
                self.progress.y0[i] + self.dense.value(i, s)
            } else {
                let [a, b, c, d] = self.progress.cubic(i);
                a + s * (b + (S::one() - s) * (c + s * d))
            };
        }
    }
}
