//! The involute and its inverse.

use assur_math::element::gear::{inverse_involute, involute};

/// mpmath, 30 digits: tan(x) − x.
#[test]
fn involute_is_accurate_for_all_angles() {
    let key = [
        (0.001, 3.333_334_666_667_206_5e-10),
        (0.1, 3.346_720_854_505_451_3e-4),
        (0.3490658503988659, 0.014_904_383_867_336_443),
        (std::f64::consts::FRAC_PI_4, 0.214_601_836_602_551_67),
        (1.2, 1.372_151_622_126_318_6),
    ];
    for (x, inv) in key {
        assert!((involute(x) - inv).abs() <= 4e-16 * inv, "{x}: {:e}", involute(x));
    }
}

#[test]
fn inverse_goes_back() {
    for i in 1..150 {
        let alpha = f64::from(i) / 100.0;
        let back = inverse_involute(involute(alpha)).unwrap_or(f64::NAN);
        assert!((back - alpha).abs() <= 4e-16 * alpha, "{alpha} {back}");
    }
    assert_eq!(inverse_involute(-1e-3), None);
}
