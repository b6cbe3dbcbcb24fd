//! Means over a period.

use assur_math::math::quadrature::mean;
use std::f64::consts::TAU;

/// 1/(1 − 2q cos x + q²) has the mean 1/(1 − q²) and the coefficients q^k.
fn poisson(q: f64, n: usize) -> Vec<f64> {
    (0..n).map(|i| 1.0 / (1.0 - 2.0 * q * libm::cos(TAU * i as f64 / n as f64) + q * q)).collect()
}

#[test]
fn the_estimate_bounds_the_error_and_is_not_far_from_it() {
    for q in [0.1, 0.2, 0.3, 0.5, 0.7] {
        for n in [8, 16, 32, 64] {
            let got = mean(&poisson(q, n));
            let error = (got.value - 1.0 / (1.0 - q * q)).abs();
            assert!(error <= got.error, "{q} {n}: {error:e} {:e}", got.error);
            let true_error = 2.0 * libm::pow(q, n as f64);
            assert!(got.error < 1e2 * true_error + 1e-14, "{q} {n}: {:e} {true_error:e}", got.error);
        }
    }
}

#[test]
fn a_kink_does_not_converge() {
    let samples: Vec<f64> = (0..128).map(|i| libm::cos(TAU * f64::from(i) / 128.0).abs()).collect();
    let got = mean(&samples);
    assert!(!got.has_converged(1e-6));
    assert!((got.value - 2.0 / std::f64::consts::PI).abs() < got.error);
}
