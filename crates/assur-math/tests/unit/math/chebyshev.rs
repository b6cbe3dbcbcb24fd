//! Series of Chebyshev polynomials.

use assur_math::math::chebyshev::{NODES, Nodes, Series};

fn of(from: f64, to: f64, f: impl Fn(f64) -> f64) -> Series {
    let nodes = Nodes::new();
    nodes.series(from, to, &std::array::from_fn::<_, NODES, _>(|j| f(nodes.at(from, to, j))))
}

#[test]
fn a_smooth_function_keeps_its_digits() {
    let s = of(0.3, 1.1, libm::exp);
    for x in [0.3, 0.31, 0.7, 1.1] {
        assert!((s.value(x) - libm::exp(x)).abs() < 1e-14);
        assert!((s.derivative().value(x) - libm::exp(x)).abs() < 1e-12);
        assert!((s.antiderivative(2.0).value(x) - (libm::exp(x) - libm::exp(0.3) + 2.0)).abs() < 1e-14);
    }
    assert!((s.integral() - (libm::exp(1.1) - libm::exp(0.3))).abs() < 1e-15);
    assert!(s.tail() < 1e-14);
}

#[test]
fn an_interval_may_run_backwards() {
    let s = of(1.0, -0.5, libm::sin);
    assert!((s.integral() - (libm::cos(1.0) - libm::cos(-0.5))).abs() < 1e-15);
    assert!((s.derivative().value(0.2) - libm::cos(0.2)).abs() < 1e-12);
    assert_eq!(s.roots().len(), 1);
    assert!(s.roots()[0].abs() < 1e-15);
}

#[test]
fn all_roots_are_found() {
    let s = of(0.0, 4.0, |x| (x - 0.001) * (x - 2.0) * (x - 3.5));
    let roots = s.roots();
    assert_eq!(roots.len(), 3);
    for (got, expected) in roots.iter().zip([0.001, 2.0, 3.5]) {
        assert!((got - expected).abs() < 1e-13, "{got} {expected}");
    }
}
