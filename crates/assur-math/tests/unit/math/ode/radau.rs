//! Radau IIA.

use super::{Rates, distance, kepler, orbit, perihelion, run};
use assur_math::math::ode::{Integrator, Radau, Real, Step, Stopped, System, Tolerance, Undefined};
use assur_math::math::{Double, Scalar};

fn method<S: Real>(n: usize, tolerance: f64) -> Radau<S> {
    Radau::new(&Tolerance::uniform(n, tolerance, tolerance))
}

/// A smooth system that is not linear: y' = −2t y², y = 1/(1 + t²).
fn bell<S: Real>() -> impl System<S> {
    Rates(|t: S, y: &[S], dy: &mut [S]| dy[0] = -(t + t) * y[0] * y[0])
}

#[test]
fn shorter_steps_show_order_five_and_three_within() {
    // a step of a given length, by `shorten`; its error is of one order more. What the iterations leave is less
    let errors = |h: f64| {
        let (mut radau, mut system) = (method::<Double>(1, 1e-14), bell());
        let (t, one) = (Double::of(0.5), Double::one());
        radau.start(&mut system, t, &[one / Double::of(1.25)], Double::of(2.0)).expect("starts");
        let _ = radau.step(&mut system).expect("steps");
        let end = t + Double::of(h);
        radau.shorten(&mut system, end).expect("is defined");
        let off = |t: Double, y: Double| (y - one / (one + t * t)).abs().rounded();
        let mut y = [Double::zero()];
        let middle = t + Double::of(0.4 * h);
        radau.dense(middle, &mut y);
        (off(end, radau.y()[0]), off(middle, y[0]))
    };
    let all = [0.1, 0.05, 0.025, 0.0125].map(errors);
    for pair in all.windows(2) {
        let (end, within) = (libm::log2(pair[0].0 / pair[1].0), libm::log2(pair[0].1 / pair[1].1));
        assert!((5.8..6.2).contains(&end) && (3.7..5.1).contains(&within), "{end} {within} {all:?}");
    }
}

#[test]
fn two_exponentials_of_very_different_rate() {
    // y₁ decays at 0.4 and y₂ at 5e6, seen through coordinates that mix them
    let mut system = Rates(|_, y: &[f64], dy: &mut [f64]| {
        let (slow, fast) = (y[0] + y[1], y[0] - y[1]);
        dy[0] = 0.5 * (-0.4 * slow - 5e6 * fast);
        dy[1] = 0.5 * (-0.4 * slow + 5e6 * fast);
    });
    for (tolerance, most) in [(1e-4, 40), (1e-6, 60), (1e-9, 180)] {
        let mut radau = method(2, tolerance);
        run(&mut radau, &mut system, 0.0, &[1.0, 0.0], 5.0);
        let exact = 0.5 * libm::exp(-2.0);
        let error = distance(radau.y(), &[exact, exact]);
        let counts = radau.counts();
        assert!(error < tolerance && counts.steps < most, "{tolerance:e}: {error:e} {counts:?}");
    }
}

/// Robertson's reaction, with its derivatives: a second component of 1e-13 is too small for differences.
struct Robertson;

impl System<f64> for Robertson {
    fn rates(&mut self, _: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Undefined> {
        dy[0] = -0.04 * y[0] + 1e4 * y[1] * y[2];
        dy[2] = 3e7 * y[1] * y[1];
        dy[1] = -dy[0] - dy[2];
        Ok(())
    }

    fn jacobian(&mut self, _: f64, y: &[f64], d: &mut [f64]) -> Result<bool, Undefined> {
        d[..3].copy_from_slice(&[-0.04, 1e4 * y[2], 1e4 * y[1]]);
        d[6..].copy_from_slice(&[0.0, 6e7 * y[1], 0.0]);
        (0..3).for_each(|j| d[3 + j] = -d[j] - d[6 + j]);
        Ok(true)
    }
}

#[test]
fn the_reaction_of_robertson() {
    // at t = 40 and 1e11, from the test set of Bari and the book
    let late = [0.208_334_014_970_122e-7, 0.833_336_077_033_471e-13, 0.999_999_979_166_505];
    let early = [0.715_827_068_719_39, 0.918_553_476_456_4e-5, 0.284_163_745_745_82];
    for (end, exact, most) in [(40.0, early, 85), (1e11, late, 380)] {
        let tolerance = Tolerance::each(&[(1e-7, 1e-13), (1e-7, 1e-13), (1e-7, 1e-13)]);
        let mut radau = Radau::new(&tolerance);
        run(&mut radau, &mut Robertson, 0.0, &[1.0, 0.0, 0.0], end);
        let errors = radau.y().iter().zip(exact).map(|(y, exact)| (y / exact - 1.0).abs());
        let worst = errors.fold(0.0, f64::max);
        let counts = radau.counts();
        assert!(worst < 1e-5 && counts.steps < most, "{end}: {worst:e} {counts:?} {:?}", radau.y());
    }
}

/// Van der Pol's oscillator in fast time, with its derivatives if asked for.
struct VanDerPol {
    epsilon: f64,
    given: bool,
    evaluations: usize,
}

impl System<f64> for VanDerPol {
    fn rates(&mut self, _: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Undefined> {
        self.evaluations += 1;
        (dy[0], dy[1]) = (y[1], ((1.0 - y[0] * y[0]) * y[1] - y[0]) / self.epsilon);
        Ok(())
    }

    fn jacobian(&mut self, _: f64, y: &[f64], d: &mut [f64]) -> Result<bool, Undefined> {
        (d[0], d[1]) = (0.0, 1.0);
        (d[2], d[3]) = ((-2.0 * y[0] * y[1] - 1.0) / self.epsilon, (1.0 - y[0] * y[0]) / self.epsilon);
        Ok(self.given)
    }
}

#[test]
fn the_oscillator_of_van_der_pol() {
    // at t = 2, ε = 1e-6, from the test set of Bari
    let exact = [1.706_167_732_170_483, -0.892_809_701_024_795_1];
    let mut errors = Vec::new();
    for (tolerance, most) in [(1e-4, 260), (1e-6, 500), (1e-8, 1100)] {
        for given in [false, true] {
            let mut system = VanDerPol { epsilon: 1e-6, given, evaluations: 0 };
            let mut radau = method(2, tolerance);
            run(&mut radau, &mut system, 0.0, &[2.0, 0.0], 2.0);
            let error = distance(radau.y(), &exact);
            let counts = radau.counts();
            assert_eq!(counts.evaluations, system.evaluations);
            assert!(error < 30.0 * tolerance && counts.steps < most, "{tolerance:e}: {error:e} {counts:?}");
            errors.push(error);
        }
    }
    assert!(errors[4] < 0.1 * errors[0], "{errors:?}");
}

#[test]
fn smooth_problems_in_both_directions_and_numbers() {
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
        let mut radau = method(4, tolerance);
        run(&mut radau, &mut kepler(), 0.0, &perihelion(0.3), 6.0);
        let error = distance(radau.y(), &orbit(0.3, 6.0));
        assert!(error < 300.0 * tolerance, "{tolerance:e} {error:e} {:?}", radau.counts());
        run(&mut radau, &mut kepler(), 6.0, &orbit(0.3, 6.0), 0.0);
        assert!(distance(radau.y(), &perihelion(0.3)) < 300.0 * tolerance);
    }
    let mut radau = method(1, 1e-19);
    run(&mut radau, &mut bell(), Double::zero(), &[Double::one()], Double::of(0.75));
    let error = (radau.y()[0] - Double::of(0.64)).abs().rounded();
    assert!(error < 1e-16, "{error:e} {:?}", radau.counts());
}

#[test]
fn a_step_ends_where_it_is_told_to() {
    let (mut radau, mut system) = (method(4, 1e-8), kepler());
    radau.start(&mut system, 0.0, &perihelion(0.4), 6.0).expect("starts");
    for i in 0..40 {
        let _ = radau.step(&mut system).expect("steps");
        if i % 7 == 3 {
            let t = 0.4 * radau.previous_t() + 0.6 * radau.t();
            let mut y = [0.0; 4];
            radau.dense(t, &mut y);
            assert!(distance(&y, &orbit(0.4, t)) < 1e-4);
            radau.shorten(&mut system, t).expect("is defined");
            assert!(radau.t() == t && distance(radau.y(), &orbit(0.4, t)) < 1e-6);
        }
    }
    while radau.step(&mut system).expect("goes on") == Step::Within {}
    assert!(distance(radau.y(), &orbit(0.4, 6.0)) < 1e-5);
    radau.restart(&mut system, &orbit(0.4, 2.0), 7.0).expect("is defined");
    while radau.step(&mut system).expect("goes on") == Step::Within {}
    assert!(distance(radau.y(), &orbit(0.4, 3.0)) < 1e-6);
    let (t0, y0) = (radau.previous_t(), radau.previous_y().to_vec());
    radau.shorten(&mut system, t0).expect("is defined");
    assert!(radau.t() == t0 && radau.y() == y0);
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
    let mut radau = method(1, 1e-7);
    radau.start(&mut Root, 0.0, &[1.0], 2.0).expect("starts");
    let stopped = loop {
        if let Err(stopped) = radau.step(&mut Root) {
            break stopped;
        }
    };
    assert!(matches!(stopped, Stopped::Undefined | Stopped::StepTooSmall), "{stopped}");
    let t = radau.t();
    assert!((t - 1.0).abs() < 1e-4 && (radau.y()[0] - (1.0 - t).abs().sqrt()).abs() < 1e-3, "{t}");
}
