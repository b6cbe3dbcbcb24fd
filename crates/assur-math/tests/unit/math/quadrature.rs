//! Integrals.

use assur_math::math::quadrature::{End, Place, Quadrature};
use assur_math::math::{Double, Scalar};
use std::convert::Infallible;

const SMOOTH: (End, End) = (End::Smooth, End::Smooth);

fn sure<S>(f: impl Fn(Place<S>) -> S) -> impl FnMut(Place<S>) -> Result<S, Infallible> {
    move |place| Ok(f(place))
}

#[test]
fn one_part_has_degree_22() {
    let mut quadrature = Quadrature::new(1);
    for power in 0..=23_u32 {
        let f = sure(|at: Place<Double>| (0..power).fold(Double::one(), |product, _| product * at.x));
        let range = (Double::of(-1.0), Double::of(2.0));
        let Ok(integral) = quadrature.integrate(range, SMOOTH, (0.0, 0.0), f);
        let sign = if power % 2 == 0 { 1.0 } else { -1.0 };
        let exact = Double::of(2.0_f64.powi(power as i32 + 1) + sign) / Double::of(f64::from(power + 1));
        let error = ((integral.value - exact) / exact).abs().rounded();
        assert!(error < 1e-29, "{power}: {error:e}");
    }
}

#[test]
fn errors_are_within_the_estimate() {
    type Case<'a> = (&'a dyn Fn(f64) -> f64, f64, f64, f64);
    let cases: [Case; 5] = [
        (&|x| libm::exp(x), 0.0, 3.0, libm::exp(3.0) - 1.0),
        (&|x| 1.0 / (1.0 + 100.0 * x * x), -1.0, 1.0, 0.2 * libm::atan(10.0)),
        (&|x| libm::sin(40.0 * x), 0.0, 1.0, (1.0 - libm::cos(40.0)) / 40.0),
        (&|x| (x - 0.3_f64).abs(), 0.0, 1.0, 0.5 * (0.09 + 0.49)),
        (&|x| libm::log(x), 0.0, 1.0, -1.0),
    ];
    let mut quadrature = Quadrature::new(100);
    for (i, (f, a, b, exact)) in cases.iter().enumerate() {
        for digits in [3, 6, 9, 12] {
            let relative = libm::pow(10.0, -f64::from(digits));
            let Ok(integral) = quadrature.integrate((*a, *b), SMOOTH, (0.0, relative), sure(|at| f(at.x)));
            let error = (integral.value - exact).abs();
            assert!(integral.reached && error <= integral.error.max(1e-15), "{i}: {error:e} {integral:?}");
            assert!(integral.error <= relative * integral.value.abs() || error < 1e-15, "{i}: {integral:?}");
            let Ok(back) = quadrature.integrate((*b, *a), SMOOTH, (0.0, relative), sure(|at| f(at.x)));
            assert!((back.value + integral.value).abs() <= 2.0 * integral.error);
        }
    }
}

#[test]
fn a_quarter_period_of_a_pendulum_is_exact() {
    // ∫ dφ/√(2(cos φ − cos α)), from the bottom to the turning point: cos φ − cos α from the distance to it
    let mut quadrature = Quadrature::new(20);
    for (alpha, evaluations) in [(0.1_f64, 75), (1.5, 105), (3.0, 285)] {
        let mut mean = (1.0, libm::cos(0.5 * alpha));
        for _ in 0..8 {
            mean = (0.5 * (mean.0 + mean.1), (mean.0 * mean.1).sqrt());
        }
        let exact = std::f64::consts::FRAC_PI_2 / mean.0;
        let speed = |place: Place<f64>| {
            let (half_sum, half) = (alpha - 0.5 * place.to_end, 0.5 * place.to_end);
            (4.0 * libm::sin(half_sum) * libm::sin(half)).sqrt()
        };
        let one_end = (End::Smooth, End::InverseRoot);
        let f = sure(|place| 1.0 / speed(place));
        let Ok(integral) = quadrature.integrate((0.0, alpha), one_end, (0.0, 1e-13), f);
        let error = (integral.value - exact).abs() / exact;
        assert!(integral.reached && error < 1e-14 && integral.evaluations <= evaluations, "{integral:?}");
        // the other way round, and from one turning point to the other
        let f = sure(|place: Place<f64>| {
            let place = Place { to_end: place.from_start, ..place };
            1.0 / speed(place)
        });
        let Ok(back) = quadrature.integrate((-alpha, 0.0), (End::InverseRoot, End::Smooth), (0.0, 1e-13), f);
        assert!((back.value - exact).abs() < 1e-14 * exact);
        let f = sure(|place: Place<f64>| {
            let (half_sum, half) = (0.5 * place.from_start, 0.5 * place.to_end);
            1.0 / (4.0 * libm::sin(half_sum) * libm::sin(half)).sqrt()
        });
        let both = (End::InverseRoot, End::InverseRoot);
        let Ok(whole) = quadrature.integrate((-alpha, alpha), both, (0.0, 1e-13), f);
        assert!((whole.value - 2.0 * exact).abs() < 3e-14 * exact, "{whole:?}");
    }
}

#[test]
fn double_double_has_25_digits() {
    let mut quadrature = Quadrature::new(200);
    let one = Double::one();
    let f = sure(|at: Place<Double>| one / (one + at.x * at.x));
    let Ok(integral) = quadrature.integrate((Double::zero(), one), SMOOTH, (0.0, 1e-26), f);
    let error = (integral.value * Double::of(4.0) - Double::PI).abs().rounded();
    assert!(integral.reached && error < 1e-26, "{error:e} {integral:?}");
}

#[test]
fn it_says_what_it_cannot_reach() {
    let mut quadrature = Quadrature::new(5);
    let f = sure(|at: Place<f64>| libm::sin(1.0 / at.x));
    let Ok(integral) = quadrature.integrate((0.0, 1.0), SMOOTH, (0.0, 1e-12), f);
    assert!(!integral.reached && integral.error > 1e-6 && integral.evaluations == 135, "{integral:?}");
    let Ok(none) = quadrature.integrate((0.0, 1.0), SMOOTH, (1e-3, 0.0), sure(|_| f64::NAN));
    assert!(!none.reached);
    let fault = quadrature
        .integrate((0.0, 1.0), SMOOTH, (1e-3, 0.0), |at| if at.x < 0.5 { Ok(1.0) } else { Err("beyond") });
    assert_eq!(fault, Err("beyond"));
}
