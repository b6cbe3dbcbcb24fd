//! Extrapolation of the midpoint rule.

use super::{Rates, distance, kepler, orbit, perihelion, run};
use assur_math::math::ode::{Dop853, Extrapolation, Integrator, Step, Stopped, System, Tolerance, Undefined};
use assur_math::math::{Double, Scalar};

fn wide(n: usize, tolerance: f64) -> Extrapolation<Double> {
    Extrapolation::new(Tolerance::uniform(n, tolerance, tolerance))
}

#[test]
fn orbits_keep_to_the_tolerance_in_double_double() {
    let tau = Double::PI + Double::PI;
    let mut evaluations = Vec::new();
    for digits in [6, 12, 18, 22, 26] {
        let tolerance = libm::pow(10.0, -f64::from(digits));
        let mut method = wide(4, tolerance);
        run(&mut method, &mut kepler(), Double::zero(), &perihelion(0.5), tau);
        let error = distance(method.y(), &perihelion(0.5)).rounded();
        assert!(error < 10.0 * tolerance, "{tolerance:e}: {error:e} {:?}", method.counts());
        evaluations.push(method.counts().evaluations);
    }
    assert!(evaluations[2] < 3000 && evaluations[4] < 8000, "{evaluations:?}");
    // far fewer than order eight needs
    let mut eighth = Dop853::new(Tolerance::uniform(4, 1e-22, 1e-22));
    run(&mut eighth, &mut kepler(), Double::zero(), &perihelion(0.5), tau);
    assert!(eighth.counts().evaluations > 3 * evaluations[3], "{:?} {evaluations:?}", eighth.counts());
}

#[test]
fn orbits_keep_to_the_tolerance_in_f64() {
    for digits in 3..=13 {
        let tolerance = libm::pow(10.0, -f64::from(digits));
        let mut method = Extrapolation::new(Tolerance::uniform(4, tolerance, tolerance));
        run(&mut method, &mut kepler(), 0.0, &perihelion(0.5), 20.0);
        let error = distance(method.y(), &orbit(0.5, 20.0));
        let counts = method.counts();
        assert!(error < 40.0 * tolerance && counts.evaluations < 4000, "{tolerance:e}: {error:e} {counts:?}");
        // and back, to where a small delay is a great distance
        run(&mut method, &mut kepler(), 20.0, &orbit(0.5, 20.0), 0.0);
        assert!(distance(method.y(), &perihelion(0.5)) < 1000.0 * tolerance);
    }
}

#[test]
fn the_output_within_keeps_the_digits_of_the_step() {
    for (tolerance, allowed) in [(1e-8, 1e-6), (1e-18, 1e-16), (1e-24, 1e-22)] {
        let (mut method, mut system) = (wide(4, tolerance), kepler());
        let three = Double::of(3.0);
        method.start(&mut system, Double::zero(), &perihelion(0.25), three).expect("starts");
        loop {
            let step = method.step(&mut system).expect("goes on");
            method.prepare_dense(&mut system).expect("is defined");
            let h = method.t() - method.previous_t();
            let mut y = [Double::zero(); 4];
            for part in [0.0, 0.03, 0.37, 0.5, 0.81, 1.0] {
                let t = method.previous_t() + Double::of(part) * h;
                method.dense(t, &mut y);
                let mut fine = wide(4, 1e-28);
                run(&mut fine, &mut system, Double::zero(), &perihelion(0.25), t);
                let error = distance(&y, fine.y()).rounded();
                assert!(error < allowed, "{tolerance:e} {part}: {error:e}");
            }
            if step == Step::Last {
                break;
            }
        }
    }
}

#[test]
fn a_pendulum_in_double_double() {
    // from rest, horizontal: cos θ = −y; the place at 10 s, to 20 digits
    let mut system = Rates(|_, y: &[Double], dy: &mut [Double]| {
        let gravity = Double { high: 9.81, low: -4.973_799_150_320_702e-16 };
        (dy[0], dy[1]) = (y[1], -gravity * y[0].as_direction().y);
    });
    let mut method = wide(2, 1e-22);
    let start = [Double::PI * Double::of(0.5), Double::zero()];
    run(&mut method, &mut system, Double::zero(), &start, Double::of(10.0));
    let place = method.y()[0].as_direction();
    let x = Double { high: 0.275_087_462_576_116_9, low: -2.119_100_624_008_861e-17 };
    let y = Double { high: 0.961_419_205_099_125, low: 2.382_208_396_480_884_5e-17 };
    // as far as the reference is written
    let off = (place.y.abs() - x).abs().max((place.x - y).abs()).rounded();
    assert!(off < 2e-20, "{off:e}");
}

/// y = √(1 − t).
struct Root;

impl System<f64> for Root {
    fn rates(&mut self, _: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Undefined> {
        dy[0] = -0.5 / y[0];
        if y[0] > 0.0 { Ok(()) } else { Err(Undefined) }
    }
}

#[test]
fn it_says_why_it_does_not_go_on() {
    let mut method = Extrapolation::new(Tolerance::uniform(1, 1e-9, 1e-9));
    method.start(&mut Root, 0.0, &[1.0], 2.0).expect("starts");
    let stopped = loop {
        if let Err(stopped) = method.step(&mut Root) {
            break stopped;
        }
    };
    assert!(matches!(stopped, Stopped::Undefined | Stopped::StepTooSmall), "{stopped}");
    let t = method.t();
    assert!((t - 1.0).abs() < 1e-6 && (method.y()[0] - (1.0 - t).abs().sqrt()).abs() < 1e-4, "{t}");
}

#[test]
fn a_step_ends_where_it_is_told_to() {
    let (mut method, mut system) = (Extrapolation::new(Tolerance::uniform(4, 1e-11, 1e-11)), kepler());
    method.start(&mut system, 0.0, &perihelion(0.4), 6.0).expect("starts");
    for _ in 0..5 {
        let _ = method.step(&mut system).expect("steps");
    }
    let t = 0.3 * method.previous_t() + 0.7 * method.t();
    method.shorten(&mut system, t).expect("is defined");
    assert!(method.t() == t && distance(method.y(), &orbit(0.4, t)) < 1e-10);
    method.restart(&mut system, &orbit(0.4, t), 6.0).expect("is defined");
    while method.step(&mut system).expect("goes on") == Step::Within {}
    assert!(distance(method.y(), &orbit(0.4, 6.0)) < 1e-9);
}
