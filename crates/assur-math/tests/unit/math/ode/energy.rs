use assur_math::math::ode::{Energy, Integrator, Step, System, Undefined};

/// A body whose mass and force depend on its place, and what is counted of them.
struct Body<M, F> {
    mass: M,
    force: F,
    places: usize,
}

impl<M: Fn(f64) -> f64, F: Fn(f64) -> f64> System<f64> for Body<M, F> {
    fn rates(&mut self, _t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Undefined> {
        let h = 1e-6;
        let slope = ((self.mass)(y[0] + h) - (self.mass)(y[0] - h)) / (2.0 * h);
        dy[0] = y[1];
        dy[1] = ((self.force)(y[0]) - 0.5 * slope * y[1] * y[1]) / (self.mass)(y[0]);
        dy[2] = (self.force)(y[0]) * y[1];
        if let Some(further) = dy.get_mut(3) {
            *further = y[0] * y[1];
        }
        Ok(())
    }

    fn along(&mut self, q: f64, out: &mut [f64]) -> Result<bool, Undefined> {
        self.places += 1;
        (out[0], out[1]) = ((self.mass)(q), (self.force)(q));
        if let Some(further) = out.get_mut(2) {
            *further = q;
        }
        Ok(true)
    }
}

fn body<M: Fn(f64) -> f64, F: Fn(f64) -> f64>(mass: M, force: F) -> Body<M, F> {
    Body { mass, force, places: 0 }
}

fn run(system: &mut impl System<f64>, tolerance: f64, y: &[f64], end: f64) -> Energy {
    let mut method = Energy::new(y.len(), 0, tolerance, 1.0);
    method.start(system, 0.0, y, end).expect("it has a value");
    while method.step(system).expect("it has a value") != Step::Last {}
    method
}

#[test]
fn an_oscillator_keeps_its_time_and_its_energy() {
    let mut spring = body(|_| 1.0, |q: f64| -q);
    let method = run(&mut spring, 1e-12, &[0.3, 0.0, 0.0], 1000.0);
    let [q, rate, work] = method.y() else { panic!("three unknowns") };
    assert!((q - 0.3 * libm::cos(1000.0)).abs() < 1e-11, "{q}");
    assert!((rate + 0.3 * libm::sin(1000.0)).abs() < 1e-11, "{rate}");
    // every stretch rounds its work, and there are some hundreds: 10 to 20 times the rounding of the energy
    let apart = work - 0.5 * rate * rate;
    assert!(apart.abs() < 5e-15, "{apart}");
    // what was gone once is not evaluated again
    assert!(spring.places < 100, "{}", spring.places);
}

#[test]
fn a_pendulum_that_turns_over_agrees_with_its_integral() {
    // rate² = rate₀² + 2 (cos q − 1); from q = 0 with rate₀ = 2.2 it takes K-like time, known from 30 digits by quadrature of
    // 1 / √(rate₀² − 4 sin²(q/2)) over a turn
    let rate = |q: f64| (2.2_f64 * 2.2 - 4.0 * libm::sin(0.5 * q).powi(2)).sqrt();
    let n = 4000;
    let turn = 2.0 * std::f64::consts::PI;
    // the trapezoidal rule of a smooth periodic function has all digits
    let period: f64 = (0..n).map(|i| turn / f64::from(n) / rate(turn * f64::from(i) / f64::from(n))).sum();
    let mut pendulum = body(|_| 1.0, |q: f64| -libm::sin(q));
    let method = run(&mut pendulum, 1e-12, &[0.0, 2.2, 0.0], 3.0 * period);
    assert!((method.y()[0] - 3.0 * turn).abs() < 1e-11, "{}", method.y()[0] - 3.0 * turn);
    assert!((method.y()[1] - 2.2).abs() < 1e-11);
}

#[test]
fn a_mass_that_changes_falls_in_the_known_time() {
    // J = 1 + q² with force q: from q₀ with rate q₀/√(1 + q₀²)·√… it keeps J rate² − q² constant
    let mut system = body(|q: f64| 1.0 + q * q, |q: f64| q);
    let method = run(&mut system, 1e-12, &[1.0, 0.5, 0.0, 0.0], 1.5);
    let [q, rate, _, further] = method.y() else { panic!("four unknowns") };
    let kept = (1.0 + q * q) * rate * rate - q * q;
    assert!((kept - (2.0 * 0.25 - 1.0)).abs() < 1e-12, "{kept}");
    assert!((further - 0.5 * (q * q - 1.0)).abs() < 1e-12, "{further}");
    // the time to there by Simpson's rule over the coordinate
    let speed = |q: f64| ((q * q - 0.5) / (1.0 + q * q)).sqrt();
    let n = 20_000;
    let h = (q - 1.0) / f64::from(n);
    let weight = |i: i32| {
        if i == 0 || i == n {
            1.0
        } else if i % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    let time: f64 = (0..=n).map(|i| weight(i) * h / 3.0 / speed(1.0 + f64::from(i) * h)).sum();
    assert!((time - 1.5).abs() < 1e-11, "{time}");
}

#[test]
fn a_step_can_be_looked_into_and_cut() {
    let mut spring = body(|_| 2.0, |q: f64| -8.0 * q);
    let mut method = Energy::new(3, 0, 1e-12, 1.0);
    method.start(&mut spring, 0.0, &[0.4, 0.0, 0.0], 10.0).expect("it has a value");
    let mut y = [0.0; 3];
    for _ in 0..20 {
        method.step(&mut spring).expect("it has a value");
        let middle = 0.5 * (method.previous_t() + method.t());
        method.dense(middle, &mut y);
        assert!((y[0] - 0.4 * libm::cos(2.0 * middle)).abs() < 1e-12, "{middle}");
        assert!((y[1] + 0.8 * libm::sin(2.0 * middle)).abs() < 1e-12, "{middle}");
        method.shorten(&mut spring, middle).expect("it has a value");
        assert_eq!(method.t(), middle);
        assert!((method.y()[0] - y[0]).abs() < 1e-14);
    }
}

#[test]
fn a_body_at_rest_without_force_stays() {
    let mut still = body(|_| 1.0, |_| 0.0);
    let method = run(&mut still, 1e-9, &[0.7, 0.0, 0.0], 5.0);
    assert_eq!((method.t(), method.y()[0], method.y()[1]), (5.0, 0.7, 0.0));
}

#[test]
fn other_forces_begin_where_it_is_restarted() {
    let mut spring = body(|_| 1.0, |q: f64| -q);
    let mut method = Energy::new(3, 0, 1e-12, 1.0);
    method.start(&mut spring, 0.0, &[1.0, 0.0, 0.0], 3.0).expect("it has a value");
    method.step(&mut spring).expect("it has a value");
    let t = 0.5 * method.t();
    method.shorten(&mut spring, t).expect("it has a value");
    let y = method.y().to_vec();
    let mut free = body(|_| 1.0, |_| 0.0);
    method.restart(&mut free, &y, 3.0).expect("it has a value");
    while method.step(&mut free).expect("it has a value") != Step::Last {}
    assert!((method.y()[0] - (libm::cos(t) - libm::sin(t) * (3.0 - t))).abs() < 1e-12);
}

#[test]
fn where_nothing_is_known_it_says_so() {
    struct Nowhere;
    impl System<f64> for Nowhere {
        fn rates(&mut self, _t: f64, _y: &[f64], dy: &mut [f64]) -> Result<(), Undefined> {
            dy.fill(0.0);
            Ok(())
        }
    }
    let mut method = Energy::new(3, 0, 1e-9, 1.0);
    assert!(method.start(&mut Nowhere, 0.0, &[0.0, 1.0, 0.0], 1.0).is_err());
}
