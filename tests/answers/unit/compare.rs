//! How values are compared.

use assur::internals::exercise::expect::equal::{difference, shaped_like};
use assur::internals::exercise::expect::is_within;
use assur::internals::math::Vec2;
use assur::internals::model::Value;
use std::f64::consts::{PI, TAU};

#[test]
fn one_unit_in_the_last_digit_is_allowed() {
    assert!(is_within(1.73 - 1.72, 0.01));
    assert!(!is_within(0.0101, 0.01));
    assert!(is_within(0.0, 0.0));
    assert!(!is_within(f64::NAN, 1.0));
}

#[test]
fn angles_are_compared_modulo_a_turn() {
    let apart = |a, b| difference(Value::Scalar(a), Value::Scalar(b), true).magnitude();
    assert!(apart(1.0 + TAU, 1.0) < 1e-15);
    assert!(apart(PI - 1e-9, 1e-9 - PI) < 2.1e-9);
    assert!((apart(0.0, PI) - PI).abs() < 1e-15);
}

#[test]
fn vectors_are_compared_by_the_magnitude_of_their_difference() {
    let got = Value::Vector(Vec2::new(3.0, 4.0));
    assert_eq!(difference(got, shaped_like(got, Value::Scalar(0.0)), false).magnitude(), 5.0);
}
