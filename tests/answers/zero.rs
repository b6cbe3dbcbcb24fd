//! What is zero but for rounding is zero, and no error is judged by it.

use super::quick_rows::random;
use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::source::Source;

/// Solves a file with these further lines; all that it expects is met, and nothing is an error.
fn right(text: &str, more: &str) {
    let source = Source::new("case.mech", format!("{text}\n{more}\n"));
    let (_, problems) = assur::internals::test_source(&source, &Overrides::none());
    let words = render(&problems, &source, Style::PLAIN);
    assert!(!words.contains('×'), "{text}\n{more}\n{words}");
}

#[test]
fn works_that_are_zero_do_not_shorten_steps() {
    right(
        include_str!("../cases/use3/numbers/work-of-a-load-across.mech"),
        "expect work(F) = 0 N*m within 1e-300 N*m at event end
expect work(D) = -1.875 N*m within 1e-9 N*m at event end
expect displacement(G) = 625 mm within 1e-6 mm at event end",
    );
    right(
        include_str!("../cases/use3/numbers/work-of-a-damper-of-constant-length.mech"),
        "expect omega(bar) = -4.24943 rad/s within 1e-5 rad/s at event end
expect work(k) = 0 N*m within 1e-300 N*m at event end",
    );
}

#[test]
fn loads_across_random_guides_do_no_work() {
    let mut state = 5;
    for _ in 0..20 {
        let mut next = |from: f64, to: f64| from + (to - from) * random(&mut state);
        let (angle, mass, force, brake) =
            (next(-180.0, 180.0), next(0.1, 9.0), next(0.1, 1e4), next(0.1, 3.0));
        let (v, end) = (next(1.0, 5.0), next(0.1, 0.3));
        let a = brake / mass;
        let t = end.min(v / a);
        let s = v * t - 0.5 * a * t * t;
        right(
            &format!(
                "mech 1
ground {{ O (0, 0); line way through O along {angle} deg }}
link m {{ P (0, 0); mass {mass} kg at P }}
prismatic G: m.P - ground.way
force F on m at P = {force} N @ {} deg
force D on m at P = {brake} N against motion
start G = 0 mm at {v} m/s
simulate {end} s in 3 steps
find displacement(G), work(F), work(D)",
                angle + 90.0
            ),
            &format!(
                "expect work(F) = 0 N*m within 1e-300 N*m at event end
expect work(D) = {} N*m within 1e-8 N*m at event end
expect displacement(G) = {s} m within 1e-9 m at event end",
                -brake * s
            ),
        );
    }
}

#[test]
fn a_parallelogram_turns_uniformly() {
    right(
        include_str!("../cases/use3/numbers/uniform-parallelogram.mech"),
        "expect angle(a) = 602.957795130823 deg within 1e-6 deg at event end
expect omega(c) = 10 rad/s within 1e-9 at event end",
    );
}

#[test]
fn what_was_before_a_standstill_is_printed_at_its_instant() {
    let text = include_str!("../cases/use3/numbers/standstill-at-the-end.mech");
    for steps in ["1.5 s in 3 steps", "1.5 s in 9 steps", "1.6 s in 16 steps"] {
        right(
            &text.replace("1.5 s in 3 steps", steps),
            "expect al = -638.297872340426 rad/s^2 within 1e-6 rad/s^2 at time = 1.5 s",
        );
    }
    let mut state = 7;
    for _ in 0..12 {
        // a brake that stops a disk at the last instant but one that is printed
        let mut next = |from: f64, to: f64| from + (to - from) * random(&mut state);
        let (inertia, torque, stop) = (next(0.1, 3.0), next(0.5, 9.0), next(0.2, 2.0));
        let a = torque / inertia;
        right(
            &format!(
                "mech 1
ground {{ O (0, 0) }}
link disk {{ O (0, 0); inertia {inertia} kg*m^2 }}
revolute O: ground - disk
torque M on disk = {torque} N*m against motion
start disk = 0 deg at {} rad/s
simulate {} s in 5 steps
find alpha(disk), omega(disk)",
                a * stop,
                1.25 * stop
            ),
            &format!("expect alpha(disk) = {} rad/s^2 within 1e-6 rad/s^2 at time = {stop} s", -a),
        );
    }
}
