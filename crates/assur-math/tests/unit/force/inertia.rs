//! Forces of inertia.

use assur_math::force::inertia::{about, about_centre, arm, line};
use assur_math::math::Vec2;

#[test]
fn a_rod_thrown_round_its_end() {
    // Uniform rod, length 2, mass 3, J_S = m l²/12 = 1, about its end: moment −(J_S + m) α.
    let (m, J_S, alpha, omega) = (3.0, 1.0, 5.0, 2.0);
    let r = Vec2::new(0.6, 0.8);
    let a_S = r.perp() * alpha - r * (omega * omega);
    let w = about(m, J_S, a_S, alpha, r);
    assert!((w.M + (J_S + m) * alpha).abs() < 1e-14);
    assert_eq!(w.F, -(a_S * m));
}

#[test]
fn the_resultant_replaces_force_and_couple() {
    let (m, J_S, a_S, alpha) = (3.0, 2.0, Vec2::new(1.0, -4.0), 5.0);
    let w = about_centre(m, J_S, a_S, alpha);
    let r = line(m, J_S, a_S, alpha);
    assert!((r.cross(w.F) - w.M).abs() < 1e-14);
    assert!((r.norm() - arm(m, J_S, a_S, alpha)).abs() < 1e-15);
}
