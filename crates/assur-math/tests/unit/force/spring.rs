//! Springs.

use assur_math::force::spring::spring;
use assur_math::math::Vec2;

#[test]
fn pulls_its_ends_together_when_long() {
    let s = spring(Vec2::new(3.0, 4.0), Vec2::new(5.0, 0.0), 100.0, 4.0, 10.0);
    assert_eq!((s.extension, s.tension), (1.0, 130.0));
    assert!((s.f_1 - Vec2::new(78.0, 104.0)).norm() < 1e-13);
    let pushed = spring(Vec2::new(3.0, 4.0), Vec2::zero(), 100.0, 6.0, 0.0);
    assert!((pushed.tension + 100.0).abs() < 1e-12);
}

#[test]
fn keeps_its_digits_near_the_free_length() {
    // r = (1, q): l − 1 = q²/2 − q⁴/8 + …, far below the last place of l.
    let q = 1e-9;
    let s = spring(Vec2::new(1.0, q), Vec2::zero(), 1.0, 1.0, 0.0);
    assert!((s.extension / (q * q / 2.0) - 1.0).abs() < 1e-15);
}

#[test]
fn ends_that_coincide() {
    let s = spring(Vec2::zero(), Vec2::zero(), 100.0, 0.5, 1.0);
    assert_eq!((s.extension, s.f_1), (-0.5, Vec2::zero()));
    let s = spring(Vec2::zero(), Vec2::zero(), 100.0, 0.0, 1.0);
    assert_eq!((s.extension, s.f_1), (0.0, Vec2::zero()));
}
