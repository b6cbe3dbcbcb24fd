//! Masses in two points.

use assur_math::force::mass_substitution::{in_points, with_centre_of_oscillation};
use assur_math::math::Vec2;

#[test]
fn static_masses_keep_mass_and_centre() {
    let (r_1, r_2) = (Vec2::new(-0.3, -0.4), Vec2::new(0.9, 1.2));
    let s = in_points(8.0, 5.0, r_1, r_2);
    assert!((s.m_1 - 6.0).abs() < 1e-14 && (s.m_2 - 2.0).abs() < 1e-14);
    assert!((s.dJ - (5.0 - 6.0 * 0.25 - 2.0 * 2.25)).abs() < 1e-14);
    assert!(s.offset.abs() < 1e-16);
    let off = in_points(8.0, 5.0, Vec2::new(-1.0, -2.0), Vec2::new(3.0, -2.0));
    assert_eq!((off.m_1, off.m_2, off.offset), (6.0, 2.0, 2.0));
}

#[test]
fn dynamic_masses_keep_the_moment_of_inertia_too() {
    let (m, J_S, r_1) = (8.0, 5.0, Vec2::new(0.3, -0.4));
    let d = with_centre_of_oscillation(m, J_S, r_1);
    assert!((d.m_1 + d.m_2 - m).abs() < 1e-14);
    assert!((r_1 * d.m_1 + d.r_2 * d.m_2).norm() < 1e-14);
    assert!((d.m_1 * r_1.dot(r_1) + d.m_2 * d.r_2.dot(d.r_2) - J_S).abs() < 1e-14);
    assert!((d.l_2 - 1.25).abs() < 1e-15);
}
