//! DOP853.

use super::{Rates, distance, jacobi, kepler, orbit, perihelion, run};
use assur_math::math::ode::{Control, Dop853, Integrator, Real, Step, Stopped, System, Tolerance, Undefined};
use assur_math::math::{Double, Scalar};
use std::f64::consts::TAU;

/// A method that goes by equal steps: nothing is an error.
fn fixed<S: Real>(n: usize, h: S) -> Dop853<S> {
    let mut method = Dop853::new(Tolerance::uniform(n, 0.0, 1e3));
    method.progress_mut().longest = Some(h);
    method
}

#[test]
fn halved_steps_show_order_eight() {
    let two_pi = Double::PI + Double::PI;
    let error = |steps: f64| {
        let mut method = fixed(4, two_pi / Double::of(steps));
        run(&mut method, &mut kepler(), Double::zero(), &perihelion(0.25), two_pi);
        assert_eq!(method.counts().steps, steps as usize);
        distance(method.y(), &perihelion(0.25)).rounded()
    };
    let errors = [100.0, 200.0, 400.0, 800.0].map(error);
    for pair in errors.windows(2) {
        let order = libm::log2(pair[0] / pair[1]);
        assert!((7.8..8.6).contains(&order), "{order} {errors:?}");
    }
    assert!(errors[3] < 1e-17, "{errors:?}");
}

#[test]
fn halved_steps_show_order_seven_within() {
    // of one step the error is of one order more
    let error = |h: f64| {
        let (mut method, mut system) = (fixed(4, Double::of(h)), kepler());
        method.start(&mut system, Double::zero(), &perihelion(0.25), Double::of(3.0)).expect("starts");
        let _ = method.step(&mut system).expect("steps");
        method.prepare_dense(&mut system).expect("is defined");
        let (mut most, mut y) = (0.0_f64, [Double::zero(); 4]);
        for part in [0.2, 0.45, 0.7, 0.9] {
            let t = Double::of(part * h);
            method.dense(t, &mut y);
            let mut fine = fixed(4, t / Double::of(64.0));
            run(&mut fine, &mut kepler(), Double::zero(), &perihelion(0.25), t);
            most = most.max(distance(&y, fine.y()).rounded());
        }
        most
    };
    let errors = [0.2, 0.1, 0.05, 0.025].map(error);
    let orders: Vec<f64> = errors.windows(2).map(|pair| libm::log2(pair[0] / pair[1])).collect();
    assert!(orders.iter().all(|order| (7.6..8.6).contains(order)), "{orders:?} {errors:?}");
}

#[test]
fn without_preparation_the_output_is_a_cubic() {
    let (mut method, mut system) = (Dop853::new(Tolerance::uniform(4, 1e-9, 1e-9)), kepler());
    method.start(&mut system, 0.0, &perihelion(0.25), 3.0).expect("starts");
    for _ in 0..4 {
        let _ = method.step(&mut system).expect("steps");
    }
    let (t0, t1, mut y) = (method.previous_t(), method.t(), [0.0; 4]);
    let before = method.counts().evaluations;
    let t = 0.5 * (t0 + t1);
    method.dense(t, &mut y);
    let cubic = distance(&y, &orbit(0.25, t));
    assert_eq!(method.counts().evaluations, before);
    method.prepare_dense(&mut system).expect("is defined");
    method.prepare_dense(&mut system).expect("is defined");
    assert_eq!(method.counts().evaluations, before + 3);
    method.dense(t, &mut y);
    let prepared = distance(&y, &orbit(0.25, t));
    assert!(prepared < 1e-8 && cubic > 100.0 * prepared && cubic < 0.1, "{cubic:e} {prepared:e}");
    // both ends are met
    for (t, end) in [(t0, method.previous_y()), (t1, method.y())] {
        method.dense(t, &mut y);
        assert!(distance(&y, end) < 1e-15);
    }
}

#[test]
fn orbits_keep_to_the_tolerance() {
    let mut errors = Vec::new();
    for digits in 3..=13 {
        let tolerance = libm::pow(10.0, -f64::from(digits));
        let mut method = Dop853::new(Tolerance::uniform(4, tolerance, tolerance));
        run(&mut method, &mut kepler(), 0.0, &perihelion(0.5), 20.0);
        let error = distance(method.y(), &orbit(0.5, 20.0));
        assert!(error < 300.0 * tolerance, "{tolerance:e}: {error:e}");
        errors.push(libm::log10(error));
    }
    // in proportion to the tolerance: a digit for a digit, on the mean
    let slope = (errors[0] - errors[9]) / 9.0;
    assert!((0.85..1.25).contains(&slope), "{slope} {errors:?}");
}

#[test]
fn double_double_reaches_24_digits() {
    let tau = Double::PI + Double::PI;
    let mut method = Dop853::new(Tolerance::uniform(4, 1e-24, 1e-24));
    run(&mut method, &mut kepler(), Double::zero(), &perihelion(0.25), tau);
    let error = distance(method.y(), &perihelion(0.25)).rounded();
    assert!(error < 1e-22, "{error:e}");
}

/// The restricted problem of three bodies: a probe beside earth and moon.
fn arenstorf() -> impl System<f64> {
    let mu = 0.012_277_471;
    Rates(move |_, y: &[f64], dy: &mut [f64]| {
        let (far, near) = (y[0] + mu, y[0] - (1.0 - mu));
        let (a, b) = (far * far + y[1] * y[1], near * near + y[1] * y[1]);
        let (a, b) = ((1.0 - mu) / (a * a.sqrt()), mu / (b * b.sqrt()));
        dy[0] = y[2];
        dy[1] = y[3];
        dy[2] = y[0] + 2.0 * y[3] - a * far - b * near;
        dy[3] = y[1] - 2.0 * y[2] - (a + b) * y[1];
    })
}

/// Where it begins and how long it takes to come back.
const PROBE: ([f64; 4], f64) = ([0.994, 0.0, 0.0, -2.001_585_106_379_082_5], 17.065_216_560_157_964);

#[test]
fn the_orbit_of_arenstorf_closes() {
    let (mut system, (start, period)) = (arenstorf(), PROBE);
    for (tolerance, allowed, evaluations) in [(1e-7, 0.2, 1400), (1e-13, 1e-7, 5500)] {
        let mut of = |control| {
            let mut method = Dop853::controlled(Tolerance::uniform(4, tolerance, tolerance), control);
            run(&mut method, &mut system, 0.0, &start, period);
            let counts = method.counts();
            assert!(counts.evaluations <= 12 * (counts.steps + counts.rejected) + 2, "{counts:?}");
            (distance(method.y(), &start), counts)
        };
        let (error, counts) = of(Control::Error);
        assert!(error < allowed && counts.evaluations < evaluations, "{error:e} {counts:?}");
        assert!(counts.rejected > 0);
        // the trend of the error saves most of the steps that are rejected, and more than its shorter steps take
        let (with_trend, fewer) = of(Control::Trend);
        let cost = |error: f64, evaluations: usize| evaluations as f64 * libm::pow(error, 0.125);
        assert!(2 * fewer.rejected < counts.rejected, "{fewer:?} {counts:?}");
        let costs = (cost(with_trend, fewer.evaluations), cost(error, counts.evaluations));
        assert!(costs.0 < costs.1, "{costs:?} {fewer:?} {counts:?}");
    }
}

#[test]
fn steps_are_those_of_another_program() {
    // instants of the package ode_solvers 0.6.2 at 1e-7, which goes by the same book: 83 steps, 1362 evaluations
    let theirs = [
        (20, 1.111_520_687_950_670_7),
        (40, 6.962_150_327_003_743_5),
        (60, 14.900_404_795_822_519),
        (80, 17.060_197_912_724_817),
    ];
    let tolerance = Tolerance::uniform(4, 1e-7, 1e-7);
    let (mut method, mut system) = (Dop853::controlled(tolerance, Control::Error), arenstorf());
    method.start(&mut system, 0.0, &PROBE.0, PROBE.1).expect("starts");
    let mut instants = vec![0.0];
    while method.step(&mut system).expect("goes on") == Step::Within {
        instants.push(method.t());
    }
    for (step, t) in theirs {
        assert!((instants[step] - t).abs() < 1e-8, "{step}: {} {t}", instants[step]);
    }
    assert_eq!((method.counts().steps, method.counts().evaluations), (83, 1361));
}

#[test]
fn a_pendulum_follows_the_elliptic_function() {
    // from rest, horizontal: sin(θ/2) = k cd(ω t), k = sin 45°
    let (omega, k) = (9.81_f64.sqrt(), 0.5_f64.sqrt());
    let mut system = Rates(|_, y: &[f64], dy: &mut [f64]| (dy[0], dy[1]) = (y[1], -9.81 * libm::sin(y[0])));
    let mut method = Dop853::new(Tolerance::uniform(2, 1e-13, 1e-13));
    method.start(&mut system, 0.0, &[TAU / 4.0, 0.0], 10.0).expect("starts");
    let mut y = [0.0; 2];
    let mut printed = 0.0;
    loop {
        let step = method.step(&mut system).expect("goes on");
        method.prepare_dense(&mut system).expect("is defined");
        while printed <= method.t() {
            method.dense(printed, &mut y);
            let (sn, _, _) = jacobi(omega * printed + jacobi(0.0, k).2, k);
            let exact = 2.0 * libm::asin(k * sn);
            assert!((y[0] - exact).abs() < 3e-12, "{printed}: {} {exact}", y[0]);
            printed += 0.01;
        }
        if step == Step::Last {
            break;
        }
    }
    let (x, y) = (libm::sin(method.y()[0]), -libm::cos(method.y()[0]));
    let off = (x.abs() - 0.275_087_462_576_116_9).abs().max((y + 0.961_419_205_099_125_1).abs());
    assert!(off < 1e-11 && method.t() == 10.0, "{x} {y} {off:e}");
}

#[test]
fn linear_systems_are_exponentials() {
    // a turn with damping, and a decay driven by t: both ways in time
    let mut system = Rates(|t: f64, y: &[f64], dy: &mut [f64]| {
        dy[0] = -0.1 * y[0] - 2.0 * y[1];
        dy[1] = 2.0 * y[0] - 0.1 * y[1];
        dy[2] = t - y[2];
    });
    let exact = |t: f64| {
        let (e, (sin, cos)) = (libm::exp(-0.1 * t), libm::sincos(2.0 * t));
        [e * cos, e * sin, t - 1.0 + 2.0 * libm::exp(-t)]
    };
    for (from, to) in [(0.0, 7.0), (7.0, 0.0), (-1.0, 1.0)] {
        let mut method = Dop853::new(Tolerance::uniform(3, 1e-11, 1e-11));
        run(&mut method, &mut system, from, &exact(from), to);
        let error = distance(method.y(), &exact(to));
        // backwards an error grows as e⁷
        assert!(error < 1e-7 && (to < from || error < 1e-10), "{from} {to} {error:e}");
    }
}

#[test]
fn components_have_tolerances_of_their_own() {
    let mut system = Rates(|_, y: &[f64], dy: &mut [f64]| (dy[0], dy[1]) = (y[0], 1e6 * y[0]));
    let mut method = Dop853::new(Tolerance::each(&[(1e-10, 0.0), (0.0, 1e30)]));
    run(&mut method, &mut system, 0.0, &[1.0, 0.0], 1.0);
    let steps = method.counts().steps;
    assert!((method.y()[0] - libm::exp(1.0)).abs() < 1e-9);
    method = Dop853::new(Tolerance::each(&[(1e-10, 0.0), (0.0, 1e-10)]));
    run(&mut method, &mut system, 0.0, &[1.0, 0.0], 1.0);
    assert!(method.counts().steps > 2 * steps);
}

/// A turn of radius 1 whose rates have no value beyond a little more.
struct Bounded {
    radius: f64,
    asked: usize,
    told: Vec<f64>,
}

impl System<f64> for Bounded {
    fn rates(&mut self, _: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Undefined> {
        (dy[0], dy[1]) = (-y[1], y[0]);
        if y[0] * y[0] + y[1] * y[1] <= self.radius {
            return Ok(());
        }
        self.asked += 1;
        Err(Undefined)
    }

    fn accepted(&mut self, t: f64, y: &[f64]) {
        assert!((libm::cos(t) - y[0]).abs() < 1e-3);
        self.told.push(t);
    }
}

#[test]
fn a_trial_without_a_value_is_halved() {
    let mut system = Bounded { radius: 1.0 + 1e-5, asked: 0, told: Vec::new() };
    let mut method = Dop853::new(Tolerance::uniform(2, 1e-4, 1e-4));
    run(&mut method, &mut system, 0.0, &[1.0, 0.0], TAU);
    assert!(system.asked > 0 && method.counts().rejected >= system.asked - 1);
    assert!(distance(method.y(), &[1.0, 0.0]) < 1e-3);
    // of each accepted step but the last the system hears once, and of the start
    assert_eq!(system.told.len(), method.counts().steps);
    assert!(system.told[0] == 0.0 && system.told.is_sorted());
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
    let mut method = Dop853::new(Tolerance::uniform(1, 1e-9, 1e-9));
    method.start(&mut Root, 0.0, &[1.0], 2.0).expect("starts");
    let stopped = loop {
        match method.step(&mut Root) {
            Ok(_) => {}
            Err(stopped) => break stopped,
        }
    };
    assert!(matches!(stopped, Stopped::Undefined | Stopped::StepTooSmall), "{stopped}");
    // the state is the last accepted one
    let t = method.t();
    assert!((t - 1.0).abs() < 1e-6 && method.previous_t() == t, "{t}");
    assert!((method.y()[0] - (1.0 - t).abs().sqrt()).abs() < 1e-4);
    assert_eq!(method.start(&mut Root, 0.0, &[-1.0], 2.0), Err(Undefined));

    let mut few = Dop853::new(Tolerance::uniform(4, 1e-9, 1e-9));
    few.progress_mut().most_steps = 7;
    few.start(&mut kepler(), 0.0, &perihelion(0.5), 20.0).expect("starts");
    let stopped = loop {
        if let Err(stopped) = few.step(&mut kepler()) {
            break stopped;
        }
    };
    assert_eq!(stopped, Stopped::TooManySteps);
    assert!(few.counts().steps + few.counts().rejected == 7 && few.t() > 0.0);
}

#[test]
fn rates_that_are_not_numbers_are_rejected() {
    let mut system = Rates(|_, y: &[f64], dy: &mut [f64]| dy[0] = -0.5 / y[0].sqrt());
    let mut method = Dop853::new(Tolerance::uniform(1, 1e-6, 1e-6));
    method.start(&mut system, 0.0, &[1.0], 3.0).expect("starts");
    let stopped = loop {
        if let Err(stopped) = method.step(&mut system) {
            break stopped;
        }
    };
    assert!(stopped != Stopped::TooManySteps && method.y()[0].is_finite());
    assert!((method.t() - 4.0 / 3.0).abs() < 1e-3, "{}", method.t());
}

#[test]
fn stiffness_is_seen_and_only_there() {
    let mut decay = Rates(|t: f64, y: &[f64], dy: &mut [f64]| dy[0] = -1e5 * (y[0] - libm::cos(t)));
    let mut method = Dop853::new(Tolerance::uniform(1, 1e-6, 1e-6));
    method.start(&mut decay, 0.0, &[1.0], 1.0).expect("starts");
    let stopped = loop {
        if let Err(stopped) = method.step(&mut decay) {
            break stopped;
        }
    };
    assert_eq!(stopped, Stopped::Stiff);
    assert!(method.counts().steps < 100 && (method.y()[0] - 1.0).abs() < 1e-3, "{:?}", method.counts());
    // it goes on where it is told to
    assert!(method.step(&mut decay).is_ok());

    for digits in 1..=12 {
        let tolerance = libm::pow(10.0, -f64::from(digits));
        let mut turn = Rates(|_, y: &[f64], dy: &mut [f64]| (dy[0], dy[1]) = (-y[1], y[0]));
        let mut method = Dop853::new(Tolerance::uniform(2, tolerance, tolerance));
        run(&mut method, &mut turn, 0.0, &[1.0, 0.0], 300.0);
        let mut method = Dop853::new(Tolerance::uniform(4, tolerance, tolerance));
        run(&mut method, &mut kepler(), 0.0, &perihelion(0.7), 60.0);
    }
}

/// A body in thick oil that is pulled to and fro: the speed follows at once, and rounding of the place hides it.
#[test]
fn stiffness_is_seen_at_the_last_digits() {
    let oil = |t: f64, y: &[f64], dy: &mut [f64]| {
        (dy[0], dy[1]) = (y[1], -5e6 * (y[1] + 0.4 * y[0] - libm::sin(t)))
    };
    for digits in [11, 13, 14] {
        let tolerance = libm::pow(10.0, -f64::from(digits));
        let mut method = Dop853::new(Tolerance::each(&[(0.0, tolerance), (tolerance, tolerance)]));
        let mut system = Rates(oil);
        method.start(&mut system, 0.0, &[1.0, -0.4], 5.0).expect("starts");
        let stopped = loop {
            if let Err(stopped) = method.step(&mut system) {
                break stopped;
            }
        };
        assert!(stopped == Stopped::Stiff && method.counts().steps < 3000, "{digits}: {:?}", method.counts());
    }
}

#[test]
fn a_step_ends_where_it_is_told_to() {
    let (mut method, mut system) = (Dop853::new(Tolerance::uniform(4, 1e-11, 1e-11)), kepler());
    method.start(&mut system, 0.0, &perihelion(0.4), 6.0).expect("starts");
    for _ in 0..9 {
        let _ = method.step(&mut system).expect("steps");
    }
    let (t0, t1) = (method.previous_t(), method.t());
    let t = t0 + 0.37 * (t1 - t0);
    method.prepare_dense(&mut system).expect("is defined");
    method.shorten(&mut system, t).expect("is defined");
    assert!(method.t() == t && method.counts().shortened == 1);
    assert!(distance(method.y(), &orbit(0.4, t)) < 1e-10);
    let mut dy = [0.0; 4];
    system.rates(t, method.y(), &mut dy).expect("is defined");
    assert_eq!(dy, method.rates());
    // the rest as if nothing had been
    while method.step(&mut system).expect("goes on") == Step::Within {}
    assert!(method.t() == 6.0 && distance(method.y(), &orbit(0.4, 6.0)) < 1e-9);
    assert_eq!(method.step(&mut system), Ok(Step::Last));
    // another state at the same instant
    method.restart(&mut system, &orbit(0.4, 2.0), 7.0).expect("is defined");
    while method.step(&mut system).expect("goes on") == Step::Within {}
    assert!(distance(method.y(), &orbit(0.4, 3.0)) < 1e-9);
    // and nothing at all of a step
    let (t0, y0) = (method.previous_t(), method.previous_y().to_vec());
    method.shorten(&mut system, t0).expect("is defined");
    assert!(method.t() == t0 && method.y() == y0);
}
