//! Lengths by given performance.

use assur_math::element::synthesis::{Impossible, crank_rocker, crank_slider, guide_bar};
use std::f64::consts::PI;

fn degrees(x: f64) -> f64 {
    x.to_radians()
}

#[test]
fn the_shaper_of_the_course_project() {
    let found = guide_bar(0.6, 1.8, 0.37).expect("it exists");
    assert!((found.swing - degrees(360.0 / 7.0)).abs() < 1e-15);
    assert!((found.bar - 0.691_429_461_288_745_9).abs() < 1e-15);
    assert!((found.crank - 0.160_536_983_473_496_51).abs() < 1e-15);
    assert!((found.guide - 0.657_192_940_130_223_4).abs() < 1e-15);
    assert!(matches!(guide_bar(0.6, 1.0, 0.37), Err(Impossible::TimeRatio { .. })));
}

/// The ends of the stroke from the lengths: r + l and l − r from the crank's centre.
#[test]
fn a_crank_slider_has_its_stroke_and_its_time_ratio() {
    for (stroke, offset, ratio) in [(0.3, 0.05, 1.2), (0.5, 0.1, 1.4), (0.05, 0.02, 1.25)] {
        let found = crank_slider(stroke, offset, ratio).expect("it exists");
        let (near, far) = (found.rod - found.crank, found.rod + found.crank);
        let (x_1, x_2) = ((near * near - offset * offset).sqrt(), (far * far - offset * offset).sqrt());
        assert!((x_2 - x_1 - stroke).abs() < 1e-14, "{found:?}");
        let theta = libm::asin(offset / near) - libm::asin(offset / far);
        assert!(((PI + theta) / (PI - theta) - ratio).abs() < 1e-13, "{found:?}");
    }
    assert!(matches!(crank_slider(0.3, 0.9, 1.4), Err(Impossible::Offset { .. })));
    assert!(matches!(crank_slider(0.3, 0.1, 0.9), Err(Impossible::TimeRatio { .. })));
}

/// Swing and angle of the crank between the dead positions from the lengths, by the law of cosines.
#[test]
fn a_crank_rocker_has_its_swing_and_its_time_ratio() {
    for (c, swing, ratio, d) in
        [(0.3, 40.0, 1.0, 0.5), (0.3, 50.0, 1.25, 0.31), (0.5, 60.0, 1.1, 0.7), (0.3, 30.0, 1.4, 0.2)]
    {
        let found = crank_rocker(c, degrees(swing), ratio, d).expect("it exists");
        let (near, far) = (found.coupler - found.crank, found.coupler + found.crank);
        let at =
            |x: f64, y: f64, opposite: f64| libm::acos((x * x + y * y - opposite * opposite) / (2.0 * x * y));
        let got = at(c, d, far) - at(c, d, near);
        assert!((got.abs() - degrees(swing)).abs() < 1e-13, "{found:?} {got}");
        let theta = (at(near, d, c) - at(far, d, c)).abs();
        assert!(((PI + theta) / (PI - theta) - ratio).abs() < 1e-13, "{found:?}");
    }
    assert!(matches!(crank_rocker(0.3, degrees(40.0), 1.25, 5.0), Err(Impossible::Ground { .. })));
    assert!(matches!(crank_rocker(0.3, degrees(190.0), 1.25, 0.4), Err(Impossible::NotPositive { .. })));
    assert!(crank_rocker(0.3, degrees(40.0), 1.25, 0.05).is_err());
}
