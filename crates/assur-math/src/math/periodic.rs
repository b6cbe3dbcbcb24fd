//! Means of smooth periodic quantities from equally spaced samples.
//!
//! The mean of N samples over a period is wrong by the Fourier coefficients c_N, c_2N, …, which fall geometrically where
//! the quantity is analytic (Trefethen and Weideman, The exponentially convergent trapezoidal rule, SIAM Review 56, 2014).
//! The coefficients up to N/2 follow from the same samples: how they fall from the greatest of them to those between
//! 3N/8 and N/2 tells the rest.

use std::f64::consts::TAU;

/// A mean with the error it was estimated to have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    pub value: f64,
    /// Estimated error, rounding included.
    pub error: f64,
    /// The greatest magnitude of the samples.
    pub scale: f64,
}

impl Mean {
    /// Whether the error is within a part of the greatest magnitude, or more samples would not help.
    #[must_use]
    pub fn has_converged(&self, tolerance: f64) -> bool {
        self.error <= tolerance.max(16.0 * f64::EPSILON) * self.scale
    }
}

/// The mean of equally spaced samples over one period.
#[must_use]
#[allow(clippy::cast_precision_loss)] // numbers of samples are far below 2^52
pub fn mean(samples: &[f64]) -> Mean {
    let n = samples.len();
    let scale = samples.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
    let value = samples.iter().sum::<f64>() / n.max(1) as f64;
    let cosines: Vec<f64> = (0..n).map(|i| libm::cos(TAU * i as f64 / n as f64)).collect();
    let magnitude = |k: usize| {
        let (mut re, mut im) = (0.0, 0.0);
        for (j, f) in samples.iter().enumerate() {
            // sin x = cos(x − a quarter turn)
            re += f * cosines[(k * j) % n];
            im += f * cosines[(k * j + n - n / 4) % n];
        }
        libm::hypot(re, im) / n as f64
    };
    let first = 3 * n / 8 + 1;
    let (peak, head) = (1..=n / 2)
        .map(|k| (k, magnitude(k)))
        .fold((1, 0.0), |most, here| if here.1 > most.1 { here } else { most });
    let tail = (first..=n / 2).map(magnitude).fold(0.0, f64::max);
    // from the peak to the tail the coefficients fall as they go on falling to the N-th
    let further = if peak < first { (n - peak) as f64 / (first - peak) as f64 } else { 1.0 };
    let smooth = if head > 0.0 { 4.0 * head * libm::pow(tail / head, further.min(4.0)) } else { 0.0 };
    let window = |from: usize, to: usize| (from + 1..=to).map(magnitude).fold(0.0, f64::max);
    // fewer tell nothing of how they fall
    let kinked = if n < 16 { 0.0 } else { kinked(window(n / 8, n / 4), window(n / 4, 3 * n / 8), tail) };
    let left_off = smooth.max(kinked);
    Mean { value, error: left_off + 2.0 * f64::EPSILON * scale, scale }
}

/// What is left off where the coefficients fall slower and slower, as a power of their number: after a kink. Given are the
/// greatest beyond an eighth, a quarter and three eighths of the number of samples.
fn kinked(first: f64, second: f64, third: f64) -> f64 {
    // of a smooth function each is the same part of the one before, or less
    if third * first <= 1.4 * second * second {
        return 0.0;
    }
    let power = libm::log(second / third) / libm::log(1.5);
    4.0 * third * libm::pow(3.0 / 8.0, power.max(0.0))
}
