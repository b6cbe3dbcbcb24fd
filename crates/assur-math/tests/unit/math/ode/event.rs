//! Roots within a step.

use super::{kepler, orbit, perihelion};
use assur_math::math::ode::event::{Crossing, Touching, crossings, crossings_and_touches, first_crossing};
use assur_math::math::ode::{Dop853, Integrator, Step, Tolerance};
use assur_math::math::{Double, Scalar};
use std::ops::ControlFlow;

fn all(step: (f64, f64), passed: Option<bool>, g: impl FnMut(f64) -> f64) -> Vec<Crossing<f64>> {
    let mut found = Vec::new();
    let _ = crossings::<_, ()>(step, passed, g, |crossing| {
        found.push(crossing);
        ControlFlow::Continue(())
    });
    found
}

#[test]
fn every_root_is_found_in_order() {
    for step in [(0.0, 1.0), (1.0, 0.0), (-3.0, 5.0), (100.0, 100.25)] {
        let at = |part: f64| step.0 + part * (step.1 - step.0);
        let roots = [0.05, 0.3, 0.31, 0.8, 0.97].map(at);
        let found = all(step, None, |t| roots.iter().map(|root| t - root).product());
        assert_eq!(found.len(), 5, "{found:?}");
        for (i, (crossing, root)) in found.iter().zip(roots).enumerate() {
            assert!((crossing.t - root).abs() < 2e-14 * root.abs().max(1.0), "{crossing:?} {root}");
            // of five factors that are negative before all roots
            assert_eq!(crossing.rising, (i % 2 == 0) == (step.1 > step.0), "{crossing:?}");
        }
    }
}

#[test]
fn pairs_are_found_however_close() {
    for gap in [0.25, 0.1, 1e-2, 1e-3, 1e-5] {
        for i in 1..1000 {
            let middle = f64::from(i) * 0.001;
            let (a, b) = (middle - 0.5 * gap, middle + 0.5 * gap);
            if a < 0.005 || b > 0.995 {
                continue;
            }
            let found = all((0.0, 1.0), None, |t| (t - a) * (t - b) * (2.0 + libm::sin(7.0 * t)));
            assert_eq!(found.len(), 2, "{gap} {middle}: {found:?}");
            assert!((found[0].t - a).abs() < 1e-9 && (found[1].t - b).abs() < 1e-9 && !found[0].rising);
        }
    }
    // however the others lie: a pair beside a third root
    for i in 1..1000 {
        let (a, third) = (f64::from(i) * 0.001, 0.05);
        if (a - third).abs() < 0.04 || !(0.005..0.98).contains(&a) {
            continue;
        }
        let found = all((0.0, 1.0), None, |t| (t - third) * (t - a) * (t - a - 1e-3));
        assert_eq!(found.len(), 3, "{a}: {found:?}");
    }
    // what turns before zero has none
    assert!(all((0.0, 1.0), None, |t| (t - 0.4) * (t - 0.4) + 1e-9).is_empty());
    assert!(all((0.0, 1.0), None, |t| -(t - 0.4) * (t - 0.4) - 1e-9).is_empty());
}

/// Places where a function touches zero, over steps of one length from 0 to 1.
fn touches(steps: u32, g: impl Fn(f64) -> f64) -> Vec<f64> {
    let (mut found, mut passed, step) = (Vec::new(), None, 1.0 / f64::from(steps));
    for i in 0..steps {
        let touching = Touching { part: 1e-11, greatest: 1.0 };
        let step = (f64::from(i) * step, f64::from(i + 1) * step);
        let _ = crossings_and_touches::<_, ()>(step, passed.take(), touching, &g, |crossing| {
            assert!(crossing.touches && crossing.leads_up() != crossing.rising, "{crossing:?}");
            found.push(crossing.t);
            passed = (crossing.t == step.1).then_some(crossing.leads_up());
            ControlFlow::Continue(())
        });
    }
    found
}

#[test]
fn a_touch_is_one_place_wherever_it_lies() {
    let bend = |t: f64| 1.0 + 0.4 * libm::sin(5.0 * t);
    let step = 0.125;
    let parts =
        [0.5, 0.17, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 0.0, 1.0 - 1e-3, 1.0 - 1e-5, 1.0 - 1e-7, 1.0 - 1e-9];
    let more = (1..400).map(|i| f64::from(i) / 400.0);
    for place in parts.into_iter().chain(more).map(|part| step * (3.0 + part)) {
        let shapes: [(&str, &dyn Fn(f64) -> f64); 4] = [
            ("magnitude", &|t| (libm::sin(t - place) * bend(t)).abs()),
            ("below", &|t| -(libm::sin(t - place) * bend(t)).abs()),
            ("square", &|t| 3.0 * (t - place) * (t - place) * bend(t)),
            ("extreme", &|t| libm::cos(2.0 * (t - place)) - 1.0),
        ];
        for (name, g) in shapes {
            let found = touches(8, g);
            assert!(found.len() == 1 && (found[0] - place).abs() < 3e-9, "{name} {place}: {found:?}");
        }
    }
    // what turns before zero, rests in it or begins there touches nothing
    assert!(touches(8, |t| (t - 0.4).abs() + 1e-9).is_empty());
    assert!(touches(8, |t| (t - 0.4) * (t - 0.4) + 1e-9).is_empty());
    assert!(touches(8, |t| 1e-13 * libm::sin(40.0 * t).abs()).is_empty());
    assert!(touches(8, |t| t * t).is_empty() && touches(8, f64::abs).is_empty());
}

#[test]
fn zeros_at_the_ends_and_in_a_place() {
    let found = all((0.0, 1.0), None, |t| t - 0.5);
    assert_eq!(found, [Crossing { t: 0.5, rising: true, touches: false }]);
    // the first place does not count, the last does
    assert!(all((0.0, 1.0), None, |t| t).is_empty());
    assert_eq!(all((0.0, 1.0), None, |t| t - 1.0), [Crossing { t: 1.0, rising: true, touches: false }]);
    assert!(all((0.0, 1.0), None, |_| 0.0).is_empty());
    // what is left of a root that was passed does not count
    let left = |t: f64| t - 1e-17;
    assert_eq!(all((0.0, 1.0), None, left).len(), 1);
    assert!(all((0.0, 1.0), Some(true), left).is_empty());
    let falls_back = |t: f64| (t - 1e-17) * (0.3 - t);
    let found = all((0.0, 1.0), Some(true), falls_back);
    assert!(found.len() == 1 && (found[0].t - 0.3).abs() < 1e-15 && !found[0].rising, "{found:?}");
    // a function that was rising and turned at once
    assert_eq!(all((0.0, 1.0), Some(true), |t| -t - 1e-9).len(), 1);
}

#[test]
fn the_first_is_enough() {
    let mut evaluations = 0;
    let first = first_crossing((0.0, 2.0), None, |t: f64| {
        evaluations += 1;
        libm::cos(4.0 * t)
    });
    let t = first.expect("there is one").t;
    assert!((t - std::f64::consts::FRAC_PI_8).abs() < 1e-15 && evaluations < 25, "{t} {evaluations}");
    assert_eq!(first_crossing((0.0, 2.0), None, libm::cosh), None);
}

#[test]
fn double_double_has_roots_of_30_digits() {
    let two = Double::of(2.0);
    let found = first_crossing((Double::one(), two), None, |t| t * t - two).expect("there is one");
    assert!((found.t - two.sqrt()).abs().rounded() < 1e-30);
}

#[test]
fn a_run_stops_at_its_events() {
    // passages of the axis: at multiples of half a turn
    let (mut method, mut system) = (Dop853::new(Tolerance::uniform(4, 1e-12, 1e-12)), kepler());
    method.start(&mut system, 0.0, &perihelion(0.3), 20.0).expect("starts");
    let (mut passed, mut instants) = (None, Vec::new());
    loop {
        let step = method.step(&mut system).expect("goes on");
        method.prepare_dense(&mut system).expect("is defined");
        let mut y = [0.0; 4];
        let found = first_crossing((method.previous_t(), method.t()), passed.take(), |t| {
            method.dense(t, &mut y);
            y[1]
        });
        if let Some(found) = found {
            method.shorten(&mut system, found.t).expect("is defined");
            instants.push(found.t);
            passed = Some(found.rising);
        } else if step == Step::Last {
            break;
        }
    }
    assert_eq!(instants.len(), 6, "{instants:?}");
    for (i, t) in instants.iter().enumerate() {
        let exact = std::f64::consts::PI * (i + 1) as f64;
        assert!((t - exact).abs() < 1e-10, "{t} {exact}");
    }
    assert!((method.y()[0] - orbit(0.3, 20.0)[0]).abs() < 1e-9);
}
