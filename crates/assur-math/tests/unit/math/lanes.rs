//! Numbers side by side.

use assur_math::math::{LaneMask, Lanes, Scalar};

const X: [f64; 4] = [0.1, -2.0, f64::NAN, 7.5];
const Y: [f64; 4] = [3.0, -2.0, 1.0, f64::INFINITY];

/// The bits of every lane are those of the operation on one number.
fn same(got: Lanes<4>, one: impl Fn(f64, f64) -> f64) {
    for i in 0..4 {
        let want = one(X[i], Y[i]);
        assert!(got.0[i].to_bits() == want.to_bits() || got.0[i].is_nan() && want.is_nan());
    }
}

#[test]
fn every_lane_is_the_number_alone() {
    let (x, y) = (Lanes(X), Lanes(Y));
    same(x + y, |x, y| x + y);
    same(x - y, |x, y| x - y);
    same(x * y, |x, y| x * y);
    same(x / y, |x, y| x / y);
    same(-x, |x, _| -x);
    same(x.sqrt(), |x, _| x.sqrt());
    same(x.abs(), |x, _| x.abs());
    same(x.max(y), Scalar::max);
    same(x.min(y), Scalar::min);
    same(x.two_product(y).1, |x, y| x.two_product(y).1);
    assert_eq!(x.lt(y), [u64::MAX, 0, 0, u64::MAX]);
    same(Lanes::select(x.lt(y), x, y), |x, y| if x < y { x } else { y });
}

#[test]
fn all_lanes() {
    assert!([u64::MAX; 3].all() && ![u64::MAX, 0, u64::MAX].all());
    assert!(true.all() && !false.all());
}

#[test]
fn a_product_and_its_error_are_exact() {
    // (1 + 2⁻⁵²)² = 1 + 2⁻⁵¹ + 2⁻¹⁰⁴
    let x = 1.0 + f64::EPSILON;
    assert_eq!(x.two_product(x), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
}
