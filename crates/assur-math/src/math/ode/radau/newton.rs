//! The equations of the stages and their solution by simplified Newton iterations (volume II, section IV.8).
//!
//! With z_i what a stage adds to y₀, w = T⁻¹z and A⁻¹ = TΛT⁻¹ the 3n equations fall into n real ones with γ/h − J and n
//! complex ones with (α + iβ)/h − J, written as 2n real ones.

use super::super::{
    Progress, Real, System, Undefined, eighth_root, elimination::Elimination, epsilon, finite, wide,
};

pub(super) const MOST: usize = 7;
/// Where convergence is at least so fast the derivatives are kept.
pub(super) const FAST: f64 = 1e-3;

/// How the iterations ended.
#[derive(Clone, Copy, Debug)]
pub(super) enum Ended<S> {
    Converged(usize),
    /// They do not converge, or too slowly: the step is to be changed by this factor.
    Failed(S),
}

/// The unknowns and matrices of a step.
#[derive(Clone, Debug)]
pub(super) struct Stages<S> {
    n: usize,
    /// ∂f_i/∂y_j in row i.
    jacobian: Vec<S>,
    real: Elimination<S>,
    complex: Elimination<S>,
    /// What each stage adds to y₀.
    pub z: [Vec<S>; 3],
    w: [Vec<S>; 3],
    rates: [Vec<S>; 3],
    pair: Vec<S>,
    trial: Vec<S>,
    /// θ/(1 − θ) of the last iterations, θ the ratio of two changes.
    contraction: S,
    pub theta: S,
}

impl<S: Real> Stages<S> {
    pub(super) fn new(n: usize) -> Self {
        let zeros = || vec![S::zero(); n];
        let three = || [zeros(), zeros(), zeros()];
        Self {
            n,
            jacobian: vec![S::zero(); n * n],
            real: Elimination::new(n),
            complex: Elimination::new(2 * n),
            z: three(),
            w: three(),
            rates: three(),
            pair: vec![S::zero(); 2 * n],
            trial: zeros(),
            contraction: S::one(),
            theta: S::of(FAST),
        }
    }

    /// The derivatives of the rates at the beginning of the step: as given, or by differences.
    pub(super) fn derive<F: System<S> + ?Sized>(
        &mut self,
        system: &mut F,
        progress: &mut Progress<S>,
    ) -> Result<(), Undefined> {
        if system.jacobian(progress.t0, &progress.y0, &mut self.jacobian)? {
            return Ok(());
        }
        let n = self.n;
        self.trial.copy_from_slice(&progress.y0);
        for j in 0..n {
            let y = progress.y0[j];
            let mut step = (epsilon::<S>() * y.abs().max(S::of(1e-5))).sqrt();
            for side in 0..2 {
                self.trial[j] = y + step;
                progress.counts.evaluations += 1;
                match system.rates(progress.t0, &self.trial, &mut self.rates[0]) {
                    Ok(()) => break,
                    Err(Undefined) if side == 1 => return Err(Undefined),
                    Err(Undefined) => step = -step,
                }
            }
            // the difference as it was rounded
            let step = self.trial[j] - y;
            self.trial[j] = y;
            for i in 0..n {
                self.jacobian[i * n + j] = (self.rates[0][i] - progress.f0[i]) / step;
            }
        }
        Ok(())
    }

    /// Factors both matrices for a step length.
    pub(super) fn factor(&mut self, h: S) -> bool {
        let n = self.n;
        let (gamma, alpha, beta) = (wide::<S>(REAL) / h, wide::<S>(ALPHA) / h, wide::<S>(BETA) / h);
        let jacobian = &self.jacobian;
        let shifted = |shift: S, i: usize, j: usize| {
            let derivative = jacobian[i * n + j];
            if i == j { shift - derivative } else { -derivative }
        };
        let off = |beta: S, i: usize, j: usize| if i == j { beta } else { S::zero() };
        self.real.factor(|i, j| shifted(gamma, i, j))
            && self.complex.factor(|i, j| match (i < n, j < n) {
                (true, true) => shifted(alpha, i, j),
                (false, false) => shifted(alpha, i - n, j - n),
                (true, false) => off(-beta, i, j - n),
                (false, true) => off(beta, i - n, j),
            })
    }

    /// Begins with these values of the stages.
    pub(super) fn guess(&mut self, value: impl Fn(usize, S) -> S) {
        for (z, place) in self.z.iter_mut().zip(PLACES.map(wide::<S>)) {
            z.iter_mut().enumerate().for_each(|(i, z)| *z = value(i, place));
        }
        turn(BACK, &self.z, &mut self.w);
    }

    /// Iterates until what is left is `enough` of what is allowed.
    pub(super) fn iterate<F: System<S> + ?Sized>(
        &mut self,
        system: &mut F,
        progress: &mut Progress<S>,
        h: S,
        (allowed, enough): (&[S], S),
    ) -> Result<Ended<S>, Undefined> {
        // some of the last step's speed is trusted: its power 13/16 (the authors' program takes 0.8)
        let half = self.contraction.max(epsilon()).sqrt();
        self.contraction = half * half.sqrt() * half.sqrt().sqrt().sqrt();
        self.theta = S::of(FAST);
        let (mut last, mut last_ratio) = (S::one(), S::one());
        for turns in 1..=MOST {
            for (k, place) in PLACES.into_iter().enumerate() {
                for i in 0..self.n {
                    self.trial[i] = progress.y0[i] + self.z[k][i];
                }
                progress.counts.evaluations += 1;
                system.rates(progress.t0 + wide::<S>(place) * h, &self.trial, &mut self.rates[k])?;
            }
            let change = self.change(h, allowed);
            if !finite(change) {
                return Ok(Ended::Failed(S::of(0.5)));
            }
            if turns > 1 && turns < MOST {
                let ratio = change / last;
                self.theta = if turns == 2 { ratio } else { (ratio * last_ratio).sqrt() };
                last_ratio = ratio;
                if !self.theta.lt(S::of(0.99)) {
                    return Ok(Ended::Failed(S::of(0.5)));
                }
                self.contraction = self.theta / (S::one() - self.theta);
                // what will be left after the last iteration
                let left = (turns..MOST - 1).fold(self.contraction * change / enough, |x, _| x * self.theta);
                if !left.lt(S::one()) {
                    let left = left.max(S::of(1e-4)).min(S::of(20.0));
                    // its power 1/(10 − turns), as roots give it
                    let root = if turns < 4 { eighth_root(left) } else { left.sqrt().sqrt() };
                    return Ok(Ended::Failed(S::of(0.8) / root));
                }
            }
            last = change.max(epsilon());
            for (w, rates) in self.w.iter_mut().zip(&self.rates) {
                w.iter_mut().zip(rates).for_each(|(w, change)| *w = *w + *change);
            }
            turn(FORWARD, &self.w, &mut self.z);
            if !enough.lt(self.contraction * change) {
                return Ok(Ended::Converged(turns));
            }
        }
        Ok(Ended::Failed(S::of(0.5)))
    }

    /// The rates of the stages become the change of w; its mean over what is allowed.
    fn change(&mut self, h: S, allowed: &[S]) -> S {
        let n = self.n;
        let (gamma, alpha, beta) = (wide::<S>(REAL) / h, wide::<S>(ALPHA) / h, wide::<S>(BETA) / h);
        let [a, b, c] = &mut self.rates;
        for i in 0..n {
            let f = [a[i], b[i], c[i]];
            let w = [self.w[0][i], self.w[1][i], self.w[2][i]];
            let [x, y, z] = BACK.map(|row| dot(row, f));
            a[i] = x - gamma * w[0];
            self.pair[i] = y - alpha * w[1] + beta * w[2];
            self.pair[n + i] = z - alpha * w[2] - beta * w[1];
        }
        self.real.solve(a);
        self.complex.solve(&mut self.pair);
        b.copy_from_slice(&self.pair[..n]);
        c.copy_from_slice(&self.pair[n..]);
        mean(self.rates.iter().flat_map(|rates| rates.iter().zip(allowed)), 3 * n)
    }

    /// The error of the step over what is allowed, by the embedded formula of order 3 filtered with γ/h − J; `y1` is its end.
    /// Where that is too much and `again` the filter is applied a second time.
    pub(super) fn error<F: System<S> + ?Sized>(
        &mut self,
        system: &mut F,
        progress: &mut Progress<S>,
        h: S,
        allowed: &[S],
        again: bool,
    ) -> S {
        let [estimate, sum, rates] = &mut self.rates;
        let (estimates, [a, b, c]) = (estimate.iter_mut().zip(sum.iter_mut()), &self.z);
        for (i, (estimate, sum)) in estimates.enumerate() {
            *sum = dot(ERROR, [a[i], b[i], c[i]]) / h;
            *estimate = *sum + progress.f0[i];
        }
        self.real.solve(estimate);
        let error = mean(estimate.iter().zip(allowed), self.n);
        if !again || error.lt(S::one()) {
            return error;
        }
        let values = progress.y0.iter().zip(estimate.iter());
        self.trial.iter_mut().zip(values).for_each(|(trial, (y, e))| *trial = *y + *e);
        progress.counts.evaluations += 1;
        if system.rates(progress.t0, &self.trial, rates).is_err() {
            return error;
        }
        for (estimate, (rate, sum)) in estimate.iter_mut().zip(rates.iter().zip(sum.iter())) {
            *estimate = *rate + *sum;
        }
        self.real.solve(estimate);
        mean(estimate.iter().zip(allowed), self.n)
    }
}

fn dot<S: Real>(row: [[f64; 2]; 3], x: [S; 3]) -> S {
    wide::<S>(row[0]) * x[0] + wide::<S>(row[1]) * x[1] + wide::<S>(row[2]) * x[2]
}

fn turn<S: Real>(matrix: [[[f64; 2]; 3]; 3], from: &[Vec<S>; 3], to: &mut [Vec<S>; 3]) {
    for (row, to) in matrix.into_iter().zip(to) {
        for (i, to) in to.iter_mut().enumerate() {
            *to = dot(row, [from[0][i], from[1][i], from[2][i]]);
        }
    }
}

#[allow(clippy::cast_precision_loss)] // far below 2^52
fn mean<'a, S: Real>(ratios: impl Iterator<Item = (&'a S, &'a S)>, n: usize) -> S {
    let sum = ratios.fold(S::zero(), |sum, (x, allowed)| {
        let ratio = *x / *allowed;
        sum + ratio * ratio
    });
    (sum / S::of(n as f64)).sqrt()
}

// The numbers of Radau IIA of order 5 (Hairer and Wanner, volume II, sections IV.5 and IV.8), from their closed forms with 60
// digits, each in two parts.

/// Places of the stages: (4 ∓ √6)/10 and 1.
pub(super) const PLACES: [[f64; 2]; 3] = [
    [0.155_051_025_721_682_2, -5.032_819_811_655_113e-18],
    [0.644_948_974_278_317_8, 4.389_062_567_353_559e-17],
    [1.0, 0.0],
];

/// The real eigenvalue of A⁻¹: 30/(6 + ∛81 − ∛9).
pub(super) const REAL: [f64; 2] = [3.637_834_252_744_496, -5.658_101_760_568_156e-17];

/// The others, α ± iβ.
pub(super) const ALPHA: [f64; 2] = [2.681_082_873_627_752_3, -1.937_540_961_221_905_3e-16];

/// See [`ALPHA`].
pub(super) const BETA: [f64; 2] = [3.050_430_199_247_410_5, 2.404_406_906_936_987_5e-17];

/// T, with A⁻¹ T = T Λ, Λ = diag(γ, [α, −β; β, α]).
pub(super) const FORWARD: [[[f64; 2]; 3]; 3] = [
    [
        [0.094_438_762_488_975_24, -3.236_875_075_018_586_7e-18],
        [-0.141_255_295_020_954_2, 5.097_153_543_846_629e-18],
        [-0.030_029_194_105_147_424, -3.654_270_423_242_518_3e-19],
    ],
    [
        [0.250_213_122_965_333_3, -1.193_443_450_208_261e-17],
        [0.204_129_352_293_799_94, -1.073_425_497_858_164_6e-17],
        [0.382_942_112_757_261_9, 1.678_767_066_471_906_4e-17],
    ],
    [[1.0, 0.0], [1.0, 0.0], [0.0, 0.0]],
];

/// T⁻¹.
pub(super) const BACK: [[[f64; 2]; 3]; 3] = [
    [
        [4.178_718_591_551_905, -4.430_871_935_084_940_6e-16],
        [0.327_682_820_761_062_37, 2.152_707_279_858_693e-17],
        [0.523_376_445_499_449_5, 4.281_235_710_695_699e-17],
    ],
    [
        [-4.178_718_591_551_905, 4.430_871_935_084_940_6e-16],
        [-0.327_682_820_761_062_37, -2.152_707_279_858_693e-17],
        [0.476_623_554_500_550_44, 1.269_879_412_430_084_1e-17],
    ],
    [
        [-0.502_872_634_945_786_8, -5.318_243_780_009_011_6e-17],
        [2.571_926_949_855_605, 2.135_976_914_942_942e-16],
        [-0.596_039_204_828_224_9, -2.751_960_296_811_238_6e-18],
    ],
];

/// Weights of the stages in the estimate of the error: −(13 + 7√6)/3, (−13 + 7√6)/3, −1/3.
pub(super) const ERROR: [[f64; 2]; 3] = [
    [-10.048_809_399_827_416, 3.821_678_988_093_678e-16],
    [1.382_142_733_160_749, -8.610_842_557_599_271e-17],
    [-0.333_333_333_333_333_3, -1.850_371_707_708_594e-17],
];
