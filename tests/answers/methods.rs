//! Which method a motion under loads is followed by: what never acts changes none, and costs next to nothing.

#![allow(clippy::unwrap_used)] // a test whose own files do not read has failed

use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::solve::{IntegrationOptions, Method, NotByEnergy};
use assur::internals::source::Source;
use assur::internals::{compile, pipeline};
use proptest::prelude::*;

fn solved_by(text: &str, method: Option<Method>) -> Solved {
    let (compiled, problems) = compile(&Source::new("run.mech", text), &Overrides::none());
    let compiled = compiled.unwrap_or_else(|| panic!("{problems:?}\n{text}"));
    let conduct = IntegrationOptions { method, ..IntegrationOptions::default() };
    let (solved, problems) = pipeline::solve_conducted(compiled, None, &conduct);
    solved.unwrap_or_else(|_| panic!("{problems:?}\n{text}"))
}

fn solved(text: &str) -> Solved {
    solved_by(text, None)
}

/// The method, and what it took: steps, and evaluations in all runs.
fn taken(solved: &Solved) -> (Method, usize, usize) {
    let report = solved.solution.simulation.as_ref().unwrap();
    (report.method, report.steps, report.evaluations)
}

fn why(solved: &Solved) -> Option<NotByEnergy> {
    solved.solution.simulation.as_ref().unwrap().why
}

/// Angles and angular velocities of all bodies at all instants.
fn course(solved: &Solved) -> Vec<f64> {
    let poses = solved.solution.poses.iter().map(|pose| pose.outcome.as_ref().unwrap());
    poses
        .flat_map(|found| {
            let rates = found.state.motion.bodies.iter().map(|body| body.omega);
            found.angles.iter().copied().chain(rates).collect::<Vec<_>>()
        })
        .collect()
}

fn furthest(one: &[f64], other: &[f64]) -> f64 {
    assert_eq!(one.len(), other.len());
    one.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

const NEVER_HIT: &str = include_str!("../cases/use3/numbers/stop-never-hit.mech");

#[test]
fn what_never_acts_changes_no_method() {
    let bare = NEVER_HIT.replace("stop O < 4 rad\n", "");
    let plain = solved(&bare);
    let (method, steps, evaluations) = taken(&plain);
    assert_eq!(method, Method::Energy);
    let idle = [
        "stop O < 4 rad",
        "stop O < 1 rad\nstop O > -5 rad { restitution 0.5 }",
        "torque T on b = 5 N*m when time > 300 s",
        "torque T on b = 5 N*m against motion when 2*time - 10 s > 400 s",
        "torque T on b = 5 N*m when time < 0 s or time >= 200.5 s",
        "let late = time > 300 s\ntorque T on b = -2 N*m*s*omega(b) when late and angle(b) > 0 rad",
        "torque T on b = 0 N*m when time < 300 s",
        "torque T on b = -0 N*m*s*omega(b)",
        "torque T on b = 0 N*m against motion",
        "given c = 0 N*m*s\nlet m = c*omega(b)\ntorque T on b = -m",
        "let Wm = max(omega(b))\nlet Wn = 2*Wm",
        "let now = time\nlet v = mag(velocity(b.P))",
    ];
    for line in idle {
        let solved = solved(&bare.replace("start b", &format!("{line}\nstart b")));
        assert_eq!((taken(&solved), why(&solved)), ((method, steps, evaluations), None), "{line}");
        assert_eq!(course(&solved), course(&plain), "{line}");
    }
    // what acts from the begin on is a load of its own
    let pushed = solved(&bare.replace("start b", "torque T on b = 0.1 N*m when time < 300 s\nstart b"));
    let always = solved(&bare.replace("start b", "torque T on b = 0.1 N*m\nstart b"));
    assert_eq!((taken(&pushed).0, course(&pushed)), (Method::Energy, course(&always)));
}

#[test]
fn names_change_no_method() {
    let text = include_str!("../cases/use3/numbers/name-changes-the-method.mech");
    for text in [text.to_owned(), text.replace("free_length 50 mm", "free_length 0 mm")] {
        let unnamed = solved(&text.replace("x = displacement", "displacement"));
        for names in ["x = displacement", "t = time, x = displacement"] {
            let named = solved(&text.replace("x = displacement", names));
            assert_eq!(taken(&named), taken(&unnamed), "{names}");
        }
    }
    let unused = include_str!("../cases/use3/numbers/unused-let-max.mech");
    let without = unused.replace("let Wm = max(omega(b))\n", "");
    assert_eq!(taken(&solved(unused)), taken(&solved(&without)));
}

fn rocker(turn: f64, speed: f64, stops: &str) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ A (0, 0); D (300 mm, 0) }}
link crank A-B 80 mm {{ mass 1 kg at B; inertia 0.02 kg*m^2 }}
link coupler B-C 250 mm {{ S (120 mm, 30 mm); mass 0.5 kg at S; inertia 0.004 kg*m^2 }}
link rocker D-C 200 mm {{ mass 0.8 kg at C; inertia 0.01 kg*m^2 }}
revolute A: ground - crank
revolute B: crank - coupler
revolute C: coupler - rocker
revolute D: ground - rocker
assemble C left of B-D
{stops}
start crank = {turn} deg at {speed} rad/s
simulate 1.5 s in 10 steps within 1e-9
find low = min(displacement(D)), high = max(displacement(D))
"
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: crate::share::part(12), ..ProptestConfig::default() })]

    /// A stop of a rocker just beyond its range, and just within it.
    #[test]
    fn stops_are_met_where_they_are_reached(turn in 0.0..360.0_f64, speed in -9.0..9.0_f64, beyond in 1e-4..0.2_f64, e in 0.3..0.9_f64) {
        let free = solved(&rocker(turn, speed, ""));
        let first = &free.solution.poses[0].outcome.as_ref().unwrap().angles;
        let ends: Vec<f64> = free.solution.statics.cycles.iter().map(|cycle| cycle.value).collect();
        let [low, high] = ends[..] else { panic!("{ends:?}") };
        let clear = rocker(turn, speed, &format!("stop D > {} rad\nstop D < {} rad", low - beyond, high + beyond));
        let clear = solved(&clear);
        prop_assert_eq!((taken(&clear).0, why(&clear)), (Method::Energy, None));
        prop_assert!(furthest(&course(&clear), &course(&free)) < 1e-12);
        let within = high - beyond * (high - low);
        prop_assume!(first[3] < within - 0.01 || first.len() < 4);
        let met = rocker(turn, speed, &format!("stop D < {within} rad {{ restitution {e} }}"));
        let (own, other) = (solved(&met), solved_by(&met, Some(Method::Dop853)));
        prop_assert_eq!((taken(&own).0, why(&own)), (Method::Dop853, Some(NotByEnergy::Stop(0))));
        prop_assert!(furthest(&course(&own), &course(&other)) < 1e-6, "{}", furthest(&course(&own), &course(&other)));
    }
}
