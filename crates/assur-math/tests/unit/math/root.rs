//! Roots of a function of one variable.

use assur_math::math::root;

#[test]
fn a_root_is_found_to_the_last_digit() {
    let f = |x: f64| x * x - 2.0;
    assert!((root(1.0, 2.0, -1.0, 2.0, f) - 2.0_f64.sqrt()).abs() <= f64::EPSILON);
    let g = |x: f64| libm::cos(x);
    let half_pi = std::f64::consts::FRAC_PI_2;
    assert!((root(2.0, 1.0, g(2.0), g(1.0), g) - half_pi).abs() <= 2.0 * f64::EPSILON);
}
