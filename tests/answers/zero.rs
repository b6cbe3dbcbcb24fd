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

/// A parallelogram that turns at a speed of its own, whose crank begins at an angle, deg, at a speed, rad/s.
fn parallelogram(state: &mut u64, (angle, speed): (f64, f64)) -> String {
    let mut next = |from: f64, to: f64| from + (to - from) * random(state);
    let (x, y, ground, tilt) = (next(-1.0, 1.0), next(-1.0, 1.0), next(0.3, 2.0), next(-3.0, 3.0));
    let (crank, turned) = (ground * next(0.1, 0.9), angle.to_radians());
    let d = [x + ground * libm::cos(tilt), y + ground * libm::sin(tilt)];
    let c = [d[0] + crank * libm::cos(turned), d[1] + crank * libm::sin(turned)];
    format!(
        "mech 1
ground {{ A ({x} m, {y} m); D ({} m, {} m) }}
link a A-B {crank} m {{ mass {} kg at A; inertia {} kg*m^2 }}
link b {{ B (0, 0); C ({ground} m, 0) }}
link c D-C {crank} m {{ mass 2 kg at D; inertia {} kg*m^2 }}
revolute A: ground - a
revolute B: a - b
revolute C: b - c
revolute D: ground - c
assemble C near ({} m, {} m)
start a = {angle} deg at {speed} rad/s
simulate 0.3 s in 2 steps",
        d[0],
        d[1],
        next(0.1, 5.0),
        next(0.01, 1.0),
        next(0.01, 1.0),
        c[0],
        c[1]
    )
}

/// Light links show no force by which a step could tell that it leaps over the place where their two assemblies meet.
#[test]
fn light_links_keep_their_way_over_change_points() {
    let mut state = 11;
    for case in 0..18 {
        let mut next = |from: f64, to: f64| from + (to - from) * random(&mut state);
        let (angle, speed) = (next(-180.0, 180.0), next(3.0, 25.0));
        let text = parallelogram(&mut state, (angle, speed));
        let light = text.lines().map(|line| match line.split_once(" { mass 2 kg") {
            Some((link, _)) => link.to_owned(),
            None => line.to_owned(),
        });
        let text = light.collect::<Vec<String>>().join("\n");
        // by energy, by DOP853 beside a load that is off, and driven by time alone
        let load = if case % 3 == 1 { "torque T on a = 3 N*m when omega(a) < 0 rad/s" } else { "" };
        let (start, driven) = (
            format!("start a = {angle} deg at {speed} rad/s"),
            format!("drive a = {angle} deg + {speed} rad/s * time"),
        );
        let text = if case % 3 == 2 { text.replace(&start, &driven) } else { text };
        let end = angle + (0.3 * speed).to_degrees();
        right(
            &format!("{text}\n{load}\nfind angle(a), angle(c), omega(c)"),
            &format!(
                "expect angle(a) = {end} deg within 1e-6 deg at event end
expect angle(c) = {end} deg within 1e-6 deg at event end
expect omega(c) = {speed} rad/s within 1e-6 rad/s at event end"
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
    let mut state = 3;
    for case in 0..24 {
        let mut next = |from: f64, to: f64| from + (to - from) * random(&mut state);
        let (angle, speed) = (next(-180.0, 180.0), next(1.0, 9.0));
        let text = parallelogram(&mut state, (angle, speed));
        let angle = angle + (0.3 * speed).to_degrees();
        // loads on and across what only shifts, and one that is off while the coupler does not turn back
        let (load, works) = match case % 4 {
            0 => ("", ""),
            1 => ("torque T on b = 3 N*m * sin(2*angle(a))", ", work(T)"),
            2 => {
                ("spring T: a.B - c.C { stiffness 100 N/m; free_length 0.1 m; damping 3 N*s/m }", ", work(T)")
            }
            _ => ("torque T on a = 3 N*m when omega(b) > 0 rad/s", ", work(T)"),
        };
        let nothing =
            if works.is_empty() { "" } else { "expect work(T) = 0 N*m within 1e-300 N*m at event end" };
        right(
            &format!(
                "{text}\n{load}\nevent turns: omega(b) = 0 rad/s
event across: dot(velocity(B), velocity(C)) < mag(velocity(B))^2
find angle(a), omega(c), max(omega(b)), argmax(abs(alpha(b))), mean(alpha(c)), count(turns), count(across){works}"
            ),
            &format!(
                "expect angle(a) = {angle} deg within 1e-6 deg at event end\n{nothing}
expect max(omega(b)) = 0 rad/s within 1e-300 rad/s
expect mean(alpha(c)) = 0 rad/s^2 within 1e-300 rad/s^2
expect count(turns) = 0 within 1e-300
expect count(across) = 0 within 1e-300"
            ),
        );
    }
}

#[test]
fn what_is_zero_in_a_motion_has_no_events_and_no_extremes() {
    right(
        include_str!("../cases/use3/numbers/events-of-nothing.mech"),
        "expect count(turns) = 0 within 1e-300\nexpect count(up) = 0 within 1e-300\nexpect count(straight) = 0 within 1e-300",
    );
    right(
        include_str!("../cases/use3/numbers/max-of-nothing-in-a-motion.mech"),
        "expect X = 0 rad/s within 1e-300 rad/s",
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
