//! A root between two values of opposite sign.

use super::Real;

/// As near as a root can be found, see [`root_within`].
pub const NEAREST: f64 = 4.0 * f64::EPSILON;

/// The root of `f` between `a` and `b`, where it has the values `f_a` and `f_b` of opposite sign, to the last digit of
/// the greater of |a| and |b|.
#[must_use]
pub fn root(a: f64, b: f64, f_a: f64, f_b: f64, f: impl FnMut(f64) -> f64) -> f64 {
    root_within(NEAREST, (a, b), (f_a, f_b), f)
}

/// The root of `f` between two places, where it has these values of opposite sign, to `tolerance` times the greater
/// magnitude of the places: regula falsi in the variant called Illinois, which halves the value at an end that stays.
#[must_use]
pub fn root_within<S: Real>(
    tolerance: f64,
    (a, b): (S, S),
    (f_a, f_b): (S, S),
    mut f: impl FnMut(S) -> S,
) -> S {
    let (zero, half) = (S::zero(), S::of(0.5));
    let (mut low, mut high, mut f_low, mut f_high) = (a, b, f_a, f_b);
    let small = S::of(tolerance) * a.abs().max(b.abs());
    let mut side = 0;
    for _ in 0..100 {
        let x = low + (high - low) * (f_low / (f_low - f_high));
        let value = f(x);
        if is_zero(value) || !small.lt((high - low).abs()) {
            return x;
        }
        if zero.lt(value * f_low) {
            (low, f_low) = (x, value);
            if side == -1 {
                f_high = f_high * half;
            }
            side = -1;
        } else {
            (high, f_high) = (x, value);
            if side == 1 {
                f_low = f_low * half;
            }
            side = 1;
        }
    }
    half * (low + high)
}

/// Zero of either sign; not NaN.
fn is_zero<S: Real>(x: S) -> bool {
    x.abs().lt(S::of(f64::from_bits(1)))
}
