//! The length of the first step: volume I, section II.4, "starting step size".

use super::{Progress, Real, System, Tolerance, Undefined, finite};

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
