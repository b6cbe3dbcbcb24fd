//! Functions from tables: values at the points, slopes against differences, shape, continuity, and what is refused.

use assur_math::math::{Between, Beyond, TableFault, TableFunction};
use std::f64::consts::TAU;

/// Numbers in [0, 1) that look random.
struct Mix(u64);

impl Mix {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn random(mix: &mut Mix, repeated: bool) -> Vec<(f64, f64)> {
    let n = 2 + (mix.next() * 9.0) as usize;
    let mut x = -1.0;
    let mut points: Vec<(f64, f64)> = (0..=n)
        .map(|_| {
            x += 0.05 + mix.next();
            // some points level, so that there are flat stretches
            (x, (mix.next() * 8.0).floor() - 4.0)
        })
        .collect();
    if repeated {
        points[n].1 = points[0].1;
    }
    points
}

const ALL: [Between; 3] = [Between::Straight, Between::Monotone, Between::Spline];

#[test]
fn they_pass_through_their_points_and_their_slopes_are_those_of_their_values() {
    let mut mix = Mix(1);
    for round in 0..600 {
        let beyond = [Beyond::Nothing, Beyond::Held, Beyond::Repeated][round % 3];
        let points = random(&mut mix, beyond == Beyond::Repeated);
        for between in ALL {
            let f = TableFunction::new(&points, between, beyond).expect("a function");
            for (x, y) in &points {
                assert!((f.value(*x) - y).abs() < 1e-12, "{between:?} {points:?} at {x}");
            }
            for w in points.windows(2) {
                let (h, x) = (1e-5, w[0].0 + (w[1].0 - w[0].0) * (0.1 + 0.8 * mix.next()));
                let [y, slope, second, third] = f.derivatives(x);
                let [_, before, before_2, _] = f.derivatives(x - h);
                let [_, after, after_2, _] = f.derivatives(x + h);
                let near = |a: f64, b: f64| (a - b).abs() < 1e-5 * (1.0 + a.abs() + third.abs());
                assert!(near((f.value(x + h) - f.value(x - h)) / (2.0 * h), slope), "{between:?} {y}");
                assert!(near((after - before) / (2.0 * h), second));
                assert!(near((after_2 - before_2) / (2.0 * h), third));
            }
        }
    }
}

#[test]
fn monotone_cubics_stay_between_their_points() {
    let mut mix = Mix(2);
    for round in 0..300 {
        let beyond = [Beyond::Nothing, Beyond::Repeated][round % 2];
        let points = random(&mut mix, beyond == Beyond::Repeated);
        let f = TableFunction::new(&points, Between::Monotone, beyond).expect("a function");
        for w in points.windows(2) {
            let (low, high) = (w[0].1.min(w[1].1), w[0].1.max(w[1].1));
            let mut last = w[0].1;
            for i in 0..=50 {
                let y = f.value(w[0].0 + (w[1].0 - w[0].0) * f64::from(i) / 50.0);
                assert!(low - 1e-12 <= y && y <= high + 1e-12);
                assert!((y - last) * (w[1].1 - w[0].1) >= -1e-12, "no extreme between two points");
                last = y;
            }
        }
    }
}

#[test]
fn they_are_as_smooth_as_they_say() {
    let mut mix = Mix(3);
    for round in 0..300 {
        let repeated = round % 2 == 0;
        let beyond = if repeated { Beyond::Repeated } else { Beyond::Nothing };
        let points = random(&mut mix, repeated);
        let (first, last) = (points[0].0, points[points.len() - 1].0);
        for (between, continuous) in [(Between::Monotone, 2), (Between::Spline, 3)] {
            let f = TableFunction::new(&points, between, beyond).expect("a function");
            let seam = if repeated {
                vec![(first + (last - first) * 1e-12, last - (last - first) * 1e-12)]
            } else {
                vec![]
            };
            let inner = points[1..points.len() - 1].iter().map(|(x, _)| (*x, x - 1e-12));
            for (after, before) in inner.chain(seam) {
                let (a, b) = (f.derivatives(after), f.derivatives(before));
                for n in 0..continuous {
                    let greatest = a.iter().chain(&b).map(|x| x.abs()).fold(0.0, f64::max);
                    let scale = 1e-9 + 1e-11 * greatest;
                    assert!((a[n] - b[n]).abs() < scale, "{between:?} {n}: {a:?} {b:?} {points:?}");
                }
            }
        }
        if !repeated {
            let f = TableFunction::new(&points, Between::Spline, beyond).expect("a function");
            assert!(f.derivatives(first)[1].abs() < 1e-12 && f.derivatives(last)[1].abs() < 1e-9, "clamped");
        }
    }
}

#[test]
fn a_periodic_spline_of_a_sine_converges_with_the_fourth_power() {
    let error = |n: u32| {
        let at = |i: u32| TAU * f64::from(i) / f64::from(n);
        let mut points: Vec<(f64, f64)> = (0..=n).map(|i| (at(i), libm::sin(at(i)))).collect();
        points[n as usize].1 = points[0].1;
        let f = TableFunction::new(&points, Between::Spline, Beyond::Repeated).expect("a function");
        (0..1000)
            .map(|i| TAU * f64::from(i) / 1000.0)
            .map(|x| (f.value(x) - libm::sin(x)).abs())
            .fold(0.0, f64::max)
    };
    let (coarse, fine) = (error(12), error(24));
    assert!(coarse < 3e-4 && coarse / fine > 14.0, "{coarse:e} {fine:e}");
}

#[test]
fn beyond_their_ends() {
    let points = [(0.0, 1.0), (1.0, 3.0), (2.0, 1.0)];
    let of = |beyond| TableFunction::new(&points, Between::Straight, beyond).expect("a function");
    assert!(of(Beyond::Nothing).value(2.1).is_nan() && !of(Beyond::Nothing).covers(-0.1));
    assert_eq!(of(Beyond::Nothing).value(2.0 + 1e-12), 1.0);
    assert_eq!((of(Beyond::Held).value(7.0), of(Beyond::Held).derivatives(7.0)[1]), (1.0, 0.0));
    assert_eq!((of(Beyond::Repeated).value(2.5), of(Beyond::Repeated).value(-0.5)), (2.0, 2.0));
    let of = |points: &[(f64, f64)], beyond| TableFunction::new(points, Between::Monotone, beyond);
    assert_eq!(of(&points[..1], Beyond::Nothing), Err(TableFault::Short));
    assert_eq!(of(&[(0.0, 1.0), (0.0, 2.0)], Beyond::Nothing), Err(TableFault::Order(1)));
    assert_eq!(of(&points[..2], Beyond::Repeated), Err(TableFault::Ends));
    assert_eq!(of(&[(0.0, 1.0), (f64::MIN_POSITIVE, 2e300)], Beyond::Nothing), Err(TableFault::TooLarge));
}
