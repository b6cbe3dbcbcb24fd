//! The involute function inv α = tan α − α and its inverse.

/// Beyond this angle tan α − α loses nothing, rad.
const DIRECT: f64 = 1.0;

/// inv α = tan α − α, rad, accurate for small angles too: tan α − α = (sin α − α cos α) / cos α with the series
/// sin α − α cos α = Σ (−1)ⁿ⁺¹ 2n α²ⁿ⁺¹ / (2n + 1)!.
#[must_use]
pub fn involute(alpha: f64) -> f64 {
    if alpha.abs() > DIRECT {
        return libm::tan(alpha) - alpha;
    }
    let square = alpha * alpha;
    // αⁿ/n! with its sign, n = 2k + 1
    let (mut power, mut sum, mut n) = (alpha, 0.0, 1.0);
    for _ in 0..12 {
        power *= -square / ((n + 1.0) * (n + 2.0));
        n += 2.0;
        sum -= power * (n - 1.0);
    }
    sum / libm::cos(alpha)
}

/// The angle in [0, π/2) whose involute is `value`; `None` where that is negative or not finite.
///
/// Newton's method from above, d(inv α)/dα = tan² α; started at the root of the leading term it converges monotonically.
#[must_use]
pub fn inverse_involute(value: f64) -> Option<f64> {
    if !(value >= 0.0 && value.is_finite()) {
        return None;
    }
    if value == 0.0 {
        return Some(0.0);
    }
    // inv α ≥ α³/3, and α < π/2
    let mut alpha = libm::cbrt(3.0 * value).min(std::f64::consts::FRAC_PI_2 - 1.0 / (value + 2.0));
    for _ in 0..100 {
        let tan = libm::tan(alpha);
        let step = (involute(alpha) - value) / (tan * tan);
        alpha -= step;
        if step.abs() <= 2.0 * f64::EPSILON * alpha {
            break;
        }
    }
    Some(alpha)
}
