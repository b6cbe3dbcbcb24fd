//! Directions side by side have the bits of one alone.

use assur_position::position::{WIDTH, directions};
use std::f64::consts::FRAC_PI_4;

fn compare(angles: [f64; WIDTH]) {
    let found = directions(assur_math::math::Lanes(angles));
    for (lane, angle) in angles.into_iter().enumerate() {
        let (sin, cos) = libm::sincos(angle);
        let bits = [found.x.0[lane], found.y.0[lane]].map(f64::to_bits);
        assert_eq!(bits, [cos, sin].map(f64::to_bits), "{angle:?}");
    }
}

fn compare_all(angles: impl Iterator<Item = f64>) {
    let all: Vec<f64> = angles.collect();
    all.chunks_exact(WIDTH).for_each(|row| compare(std::array::from_fn(|lane| row[lane])));
}

#[test]
fn of_any_angle() {
    for size in [1e-9, 1e-3, 0.7, 3.0, 7.0, 100.0, 1e4, 1.6e6, 1e9] {
        let mut state = 7_u64;
        compare_all((0..40_000).map(|_| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            size * (2.0 * (f64::from((state >> 32) as u32) / f64::from(u32::MAX)) - 1.0)
        }));
    }
}

#[test]
fn beside_whole_eighths_of_a_turn() {
    let near = |eighth: i32| {
        (-60..60).map(move |bits: i64| {
            let at = f64::from(eighth) * FRAC_PI_4;
            f64::from_bits(at.to_bits().wrapping_add_signed(bits << (bits.unsigned_abs() / 2)))
        })
    };
    compare_all((-40..40).flat_map(near).filter(|x| x.is_finite()));
}

#[test]
fn of_what_is_no_angle() {
    let mut angles = [0.25; WIDTH];
    for odd in [0.0, -0.0, 5e-324, -1e-300, 1e300] {
        angles[0] = odd;
        compare(angles);
    }
    let nothing = directions(assur_math::math::Lanes([f64::NAN; WIDTH]));
    assert!(nothing.x.0.iter().chain(&nothing.y.0).all(|x| x.is_nan()));
}
