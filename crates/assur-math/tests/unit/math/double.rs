//! Numbers with twice the digits.

use assur_math::math::{Double, Scalar, V2};

/// |got − (high + low)| ≤ 2⁻¹⁰² of it.
#[track_caller]
fn close(got: Double, high: f64, low: f64) {
    let error = (got - Double { high, low }).high.abs();
    assert!(error <= 2.0_f64.powi(-102) * high.abs(), "{got:?}: off by {error:e}");
}

// values by Python's `decimal` with 80 digits

#[test]
fn operations_have_32_digits() {
    let of = Double::of;
    close(of(1.0) / of(7.0), 0.142_857_142_857_142_85, 7.930_164_461_608_26e-18);
    close(of(0.1) * of(0.3), 0.03, 1.665_334_536_937_734_8e-18);
    close(of(0.1) + of(1e-20), 0.1, 1e-20);
    close((of(0.1) + of(1e-20)) - of(0.1), 1e-20, 0.0);
    close(of(2.0).sqrt(), std::f64::consts::SQRT_2, -9.667_293_313_452_913e-17);
    close(of(10.0).sqrt(), 3.162_277_660_168_379_5, -1.907_881_697_071_660_3e-16);
    let seventh = of(1.0) / of(7.0);
    close(seventh * of(7.0), 1.0, 0.0);
    let root = (of(2.0) + seventh).sqrt();
    close(root * root - of(2.0), seventh.high, seventh.low);
}

#[test]
fn directions_have_31_digits() {
    let near = |got: Double, high: f64, low: f64| {
        let error = (got - Double { high, low }).high.abs();
        assert!(error <= 1e-30, "{got:?}: off by {error:e}");
    };
    for (angle, sin, cos) in [
        (
            0.7,
            (0.644_217_687_237_691, 2.874_056_792_733_875_5e-18),
            (0.764_842_187_284_488_5, -4.013_780_434_022_238e-17),
        ),
        (
            -2.5,
            (-0.598_472_144_103_956_5, 5.521_403_334_082_375e-17),
            (-0.801_143_615_546_933_7, -1.867_474_270_508_555_3e-17),
        ),
        (
            30.0,
            (-0.988_031_624_092_861_8, 3.655_935_837_727_403e-17),
            (0.154_251_449_887_584_05, 3.980_208_666_184_612e-18),
        ),
    ] {
        let u = Double::direction(angle);
        near(u.y, sin.0, sin.1);
        near(u.x, cos.0, cos.1);
    }
    assert_eq!(Double::direction(0.0), V2::new(Double::one(), Double::zero()));
}

#[test]
fn angles_come_back() {
    for angle in [0.0, 1e-20, 0.3, -0.7, 1.6, 3.1, -3.1] {
        let angle = Double { high: angle, low: angle * 3e-17 };
        let back = Double::angle_of(angle.as_direction());
        assert!((back - angle).high.abs() <= 1e-30, "{angle:?}: {back:?}");
    }
    let straight = V2::new(-Double::one(), Double::zero());
    assert!((Double::angle_of(straight) - Double::PI).high.abs() <= 1e-31);
}

#[test]
fn order_and_edges() {
    let (x, y) = (Double { high: 1.0, low: 1e-20 }, Double { high: 1.0, low: 2e-20 });
    assert!(x.lt(y) && !y.lt(x) && x.max(y) == y && x.min(y) == x);
    assert_eq!((-x).abs(), x);
    assert_eq!(Double::zero().sqrt(), Double::zero());
    assert!(Double::of(-1.0).sqrt().high.is_nan());
    assert!((Double::one() / Double::zero()).high.is_infinite());
}
