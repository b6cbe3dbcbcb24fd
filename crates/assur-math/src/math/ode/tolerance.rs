//! What error of a step is allowed.

use super::{Progress, Real, System, Undefined, epsilon, finite};

/// The allowed error of each component: absolute + relative · |y|.
#[derive(Clone, Debug)]
pub struct Tolerance<S> {
    relative: Vec<S>,
    absolute: Vec<S>,
}

impl<S: Real> Tolerance<S> {
    /// Of each component its relative and its absolute one.
    #[must_use]
    pub fn each(components: &[(f64, f64)]) -> Self {
        // nothing is divided by zero where neither is given and y vanishes
        let absolute = components.iter().map(|&(_, absolute)| S::of(absolute).max(S::tiny()));
        Self {
            relative: components.iter().map(|&(relative, _)| S::of(relative)).collect(),
            absolute: absolute.collect(),
        }
    }

    /// The same for all of n components.
    #[must_use]
    pub fn uniform(n: usize, relative: f64, absolute: f64) -> Self {
        Self::each(&vec![(relative, absolute); n])
    }

    /// What an estimate of order 3 must allow so that a method of order 5 keeps to the tolerance: a tenth of its power 2/3
    /// (volume II, section IV.8, and the authors' program); the greatest relative one among them. Where only an absolute
    /// tolerance is given it stands for a relative one.
    pub(super) fn of_third_order(&self) -> (Self, S) {
        let pairs = self.relative.iter().zip(&self.absolute);
        let new = pairs.map(|(&relative, &absolute)| {
            let unit = if S::zero().lt(relative) { relative } else { absolute };
            let root = cube_root(unit.min(S::one()));
            let factor = S::of(0.1) * root * root / unit;
            (relative * factor, (absolute * factor).max(S::tiny()), unit * factor)
        });
        let new: Vec<_> = new.collect();
        let tolerance =
            Self { relative: new.iter().map(|x| x.0).collect(), absolute: new.iter().map(|x| x.1).collect() };
        (tolerance, new.iter().fold(epsilon(), |most: S, x| most.max(x.2)))
    }

    /// Decimal digits of the finest.
    pub(super) fn digits(&self) -> usize {
        let pairs = self.relative.iter().zip(&self.absolute);
        let units = pairs.map(|(r, a)| if S::zero().lt(*r) { *r } else { *a });
        let mut finest = units.fold(S::one(), S::min);
        let mut digits = 0;
        while finest.lt(S::one()) && digits < 32 {
            finest = finest * S::of(10.0);
            digits += 1;
        }
        digits
    }

    /// How many components it is for.
    pub(super) fn order(&self) -> usize {
        self.absolute.len()
    }

    /// The error that is allowed of component i where it has this magnitude.
    #[inline]
    pub(super) fn scale(&self, i: usize, magnitude: S) -> S {
        self.absolute[i] + self.relative[i] * magnitude
    }

    /// Σ (error / allowed)², at these values.
    #[inline]
    pub(super) fn square_sum(&self, y: &[S], mut error: impl FnMut(usize) -> S) -> S {
        let mut sum = S::zero();
        for (i, y) in y.iter().enumerate() {
            let ratio = error(i) / self.scale(i, y.abs());
            sum = sum + ratio * ratio;
        }
        sum
    }
}

/// The cube root of a number in (0, 1], by Newton's method from above.
fn cube_root<S: Real>(x: S) -> S {
    let mut root = S::one();
    loop {
        let next = root - (root - x / (root * root)) * S::of(1.0 / 3.0);
        if !next.lt(root) {
            return root;
        }
        root = next;
    }
}

// The length of the first step: volume I, section II.4, "starting step size".

/// A first step from where `progress` stands: an explicit Euler step of a hundredth of |y|/|y'| shows the second
/// derivative; the error of a method of the order whose root is given is then a hundredth of what is allowed.
pub(super) fn first_step<S: Real, F: System<S> + ?Sized>(
    system: &mut F,
    progress: &mut Progress<S>,
    tolerance: &Tolerance<S>,
    (trial, rates): (&mut [S], &mut [S]),
    root: impl Fn(S) -> S,
) -> Result<S, Undefined> {
    let span = progress.end - progress.t1;
    let (longest, small) = (progress.bounded(span).abs(), S::of(1e-10));
    let of_rates = tolerance.square_sum(&progress.y1, |i| progress.f1[i]);
    let of_values = tolerance.square_sum(&progress.y1, |i| progress.y1[i]);
    let guess = if small.lt(of_rates) && small.lt(of_values) && finite(of_rates) && finite(of_values) {
        (of_values / of_rates).sqrt() * S::of(0.01)
    } else {
        span.abs() * S::of(1e-6)
    };
    let mut h = guess.min(longest);
    let sign = if span.lt(S::zero()) { -S::one() } else { S::one() };
    let mut halvings = 0;
    loop {
        for (trial, (y, f)) in trial.iter_mut().zip(progress.y1.iter().zip(&progress.f1)) {
            *trial = *y + sign * h * *f;
        }
        progress.counts.evaluations += 1;
        match system.rates(progress.t1 + sign * h, trial, rates) {
            Ok(()) => break,
            Err(Undefined) if halvings == 60 => return Err(Undefined),
            Err(Undefined) => h = h * S::of(0.5),
        }
        halvings += 1;
    }
    let second = tolerance.square_sum(&progress.y1, |i| rates[i] - progress.f1[i]).sqrt() / h;
    let rate = second.max(of_rates.sqrt());
    let wanted = if S::of(1e-15).lt(rate) {
        root(S::of(0.01) / rate)
    } else {
        (span.abs() * S::of(1e-6)).max(h * S::of(1e-3))
    };
    Ok(sign * (S::of(100.0) * h).min(wanted).min(longest))
}
