//! Motions that are not smooth, or stiff and small, or long, against closed forms: what is found and the error that is reported.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]
#![allow(clippy::unwrap_used)] // a test that cannot read its values has failed

use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::solve::Method;
use assur::internals::source::Source;
use proptest::test_runner::{Config, TestRunner};

/// Tests a file, and all that is said about it.
fn tested(text: &str) -> (Solved, String) {
    let source = Source::new("case.mech", text);
    let (solved, problems) = assur::internals::test_source(&source, &Overrides::none());
    let words = render(&problems, &source, Style::PLAIN);
    (solved.unwrap_or_else(|| panic!("{words}")), words)
}

/// Angle, or place on the x axis, of the first link at the last instant.
fn last(solved: &Solved) -> (f64, f64) {
    let state = &solved.solution.poses.last().unwrap().outcome.as_ref().unwrap().state;
    (state.motion.bodies[1].p.x, state.motion.bodies[1].v.x)
}

fn reported(solved: &Solved) -> f64 {
    solved.solution.simulation.as_ref().unwrap().error
}

#[test]
fn a_short_piece_of_a_curve_is_not_stepped_over() {
    let (_, words) = tested(include_str!("../cases/use3/narrow-pulse-of-a-curve.mech"));
    assert!(words.is_empty(), "{words}");
}

#[test]
fn seams_of_cams_end_a_step() {
    for text in [
        include_str!("../cases/use3/cam-reported-error.mech"),
        include_str!("../cases/use3/cam-reported-error-parabolic.mech"),
    ] {
        let (_, words) = tested(text);
        assert!(words.is_empty(), "{words}");
    }
}

/// Pulses of a table, at random instants and of random widths: the impulse is their area.
#[test]
fn random_pulses_of_curves_have_their_impulse() {
    let pulses = proptest::collection::vec((0.05_f64..0.95, -6.0_f64..-2.0, -2.0_f64..2.0), 3);
    let config = Config { failure_persistence: None, ..Config::with_cases(crate::share::part(24)) };
    TestRunner::new_with_rng(config, proptest::test_runner::TestRng::deterministic_rng(
        proptest::test_runner::RngAlgorithm::ChaCha,
    ))
    .run(&pulses, |pulses| {
        let mut rows = String::from("  0, 0\n");
        let mut impulse = 0.0;
        for (i, (place, width, area)) in pulses.iter().enumerate() {
            let (at, width) = (3.0 * i as f64 + 3.0 * place, 10.0_f64.powf(*width));
            let (from, middle, to) = (at, at + width, at + 2.0 * width);
            let height = area / width;
            rows += &format!("  {from:?}, 0\n  {middle:?}, {height:?}\n  {to:?}, 0\n");
            impulse += 0.5 * height * (to - from);
        }
        let text = format!(
            "mech 1\ncurve p linear held {{\n  t [s], F [N]\n{rows}  10, 0\n}}\nground {{ O (0, 0); line way through O along 0 deg }}
link b {{ B (0, 0); mass 1 kg at B }}\nprismatic P: b.B - ground.way\nforce F on b at B = (p(time), 0)
start P = 0 m\nsimulate 10 s\nfind v = relative_velocity(P)\n"
        );
        let (solved, words) = tested(&text);
        assert!(words.is_empty(), "{words}\n{text}");
        let off = (last(&solved).1 - impulse).abs();
        assert!(off < 1e-8, "{off:e}\n{text}");
        Ok(())
    })
    .unwrap();
}

/// x = x₀ exp(−kt/c), the mass without effect.
#[test]
fn stiffness_is_found_where_the_motion_is_small() {
    for x in [1e-3, 1e-5, 1e-7] {
        let text = include_str!("../cases/use3/stiff-and-small.mech").replace("1e-5 m", &format!("{x:e} m"));
        let (solved, words) = tested(&text);
        assert!(words.is_empty(), "{words}");
        let report = solved.solution.simulation.as_ref().unwrap();
        assert!(report.method == Method::Radau && report.evaluations < 100_000, "{report:?}");
        assert!(last(&solved).0.abs() < 1e-9, "{}", last(&solved).0);
    }
}

/// Over a thousandth of its time the motion itself, at several instants.
#[test]
fn a_small_stiff_motion_is_its_exponential() {
    let text = include_str!("../cases/use3/stiff-and-small.mech")
        .replace("simulate 1 s", "simulate 3e-6 s in 6 steps");
    let (solved, words) = tested(&text);
    assert!(words.is_empty(), "{words}");
    for pose in &solved.solution.poses {
        let (t, x) =
            (pose.name.parse::<f64>().unwrap(), pose.outcome.as_ref().unwrap().state.motion.bodies[1].p.x);
        assert!((x - 1e-5 * (-1e6 * t).exp()).abs() < 2e-8, "{x} at {t}");
    }
}

/// A pendulum over 10,000 s: the phase by the arithmetic-geometric mean, at whole periods.
#[test]
fn time_of_a_long_run_is_summed_exactly() {
    let (mut a, mut b) = (1.0_f64, (1.25_f64).cos());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    let period = 2.0 * std::f64::consts::PI / a / (9.81_f64 / 0.7).sqrt();
    let count = (10_000.0 / period).floor();
    let text = include_str!("../cases/use3/long-run-energy.mech")
        .lines()
        .filter(|line| !line.starts_with("expect"))
        .map(|line| {
            line.replace(
                "simulate 100000 s within 1e-4",
                &format!("simulate {:?} s within 1e-9", (count + 0.25) * period),
            )
        })
        .collect::<Vec<_>>()
        .join("\n")
        + "\n";
    let (solved, words) = tested(&text);
    assert!(words.is_empty(), "{words}");
    let state = &solved.solution.poses.last().unwrap().outcome.as_ref().unwrap().state;
    // a quarter after whole periods it hangs down, at its greatest speed
    let off = state.motion.bodies[1].u.x.abs();
    assert!(off < 3.0 * reported(&solved) + 1e-15, "{off:e}, reported {:e}", reported(&solved));
    assert!(off < 1e-9, "{off:e}");
}

#[test]
fn a_run_of_days_keeps_its_phase() {
    let (_, words) = tested(include_str!("../cases/use3/long-run-energy.mech"));
    assert!(words.is_empty(), "{words}");
}

const LAWS: [&str; 7] =
    ["parabolic", "harmonic", "cycloidal", "poly345", "poly4567", "modified_trapezoid", "modified_sine"];

/// A cam under a torque of the angle alone, so that its energy is that of the closed lift: the same by both methods, and as it is
/// reported.
#[test]
fn reported_errors_of_cams_are_honest() {
    let mut honest = 0;
    for (i, law) in LAWS.iter().enumerate() {
        let (rise, dwell, start) = (100.0 + 7.0 * i as f64, 20.0 + 3.0 * i as f64, -150.0 + 31.0 * i as f64);
        let file = |within: &str, damping: &str| {
            format!(
                "mech 1\ngravity 9.81 m/s^2\ncam plate {{\n  base_radius 50 mm\n  turning ccw\n  follower translating roller {{ radius 10 mm }}
  rise {rise} deg through 15 mm {law}\n  dwell {dwell} deg\n  fall {rise} deg {law}\n}}
ground {{ O (0, 0); line way through O along 90 deg }}
link disk {{ O (0, 0); profile rim of plate centre O; mass 1 kg at O; inertia 0.02 kg*m^2 }}
link pl {{ F (0, 0); circle roller centre F radius 10 mm; mass 0.8 kg at F }}
revolute O: ground - disk\nprismatic V: pl.F - ground.way\ncontact K: disk.rim - pl.roller
force sp on pl at F = (0, -200 N - 500 N/m*(displacement(V) - 50 mm))
torque M on disk = 0 N*m{damping}
start disk = {start} deg at 25 rad/s\nsimulate 0.3 s in 6 steps within {within}\nfind p = angle(disk), w = omega(disk)\n"
            )
        };
        let angles = |solved: &Solved| -> Vec<f64> {
            let poses = solved.solution.poses.iter().map(|p| p.outcome.as_ref().unwrap());
            poses.map(|pose| pose.state.motion.bodies[1].omega).collect()
        };
        let exact = angles(&tested(&file("1e-11", " + 0 N*m*s*omega(disk)")).0);
        let greatest = exact.iter().fold(0.0_f64, |m, w| m.max(w.abs()));
        for damping in ["", " + 0 N*m*s*omega(disk)"] {
            for within in ["1e-4", "1e-6", "1e-8"] {
                let (solved, words) = tested(&file(within, damping));
                assert!(words.is_empty(), "{words}");
                let pairs = angles(&solved);
                let off = pairs.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / greatest;
                assert!(
                    off < 3.0 * reported(&solved) + 1e-10,
                    "{law} {within} {damping}: {off:e}, reported {:e}",
                    reported(&solved)
                );
                honest += 1;
            }
        }
    }
    assert_eq!(honest, 6 * LAWS.len());
}

/// A cam that starts where two parts of its law meet goes on in the part to which it turns: at the end it stands as placed there.
#[test]
fn cams_start_where_their_parts_meet_in_both_senses() {
    let last = |text: &str| {
        let (solved, words) = tested(text);
        assert!(words.is_empty(), "{words}\n{text}");
        solved.solution.poses.last().unwrap().outcome.as_ref().unwrap().state.motion.bodies[2].p.y
    };
    for turning in ["ccw", "cw"] {
        for law in LAWS {
            for start in [-90.0, 0.0, 90.0, 180.0] {
                for (way, turned) in [("2 rad/s*time", 0.78_f64), ("3 rad/s^2*time^2", 0.4563)] {
                    for (sign, sense) in [("+", 1.0), ("-", -1.0)] {
                        let file = |drive: &str| {
                            format!(
                                "mech 1\ncam plate {{\n  base_radius 80 mm\n  turning {turning}\n  follower translating roller {{ radius 10 mm }}
  rise 90 deg through 20 mm {law}\n  dwell 90 deg\n  fall 90 deg {law}\n}}
ground {{ O (0, 0); line way through O along 90 deg }}
link disk {{ O (0, 0); profile rim of plate centre O }}
link pl {{ F (0, 0); circle roller centre F radius 10 mm; mass 1 kg at F }}
revolute O: ground - disk\nprismatic V: pl.F - ground.way\ncontact K: disk.rim - pl.roller
force on pl at F = 1000 N down\ndrive disk = {drive}\nfind displacement(V)\n"
                            )
                        };
                        let at_rest = file(&format!("{} deg", start + sense * turned.to_degrees()));
                        let there = last(&at_rest.replace("; mass 1 kg at F", ""));
                        let moved = last(&file(&format!("{start} deg {sign} {way}\nsimulate 0.39 s")));
                        assert!((moved - there).abs() < 1e-12, "{law} {start} {sign} {way}: {moved} {there}");
                    }
                }
            }
        }
    }
}

/// A mass between ends of a spring at ±x: x + (start − l₀) (1 − cos ωt) passes zero where cos ωt = −l₀/(|start| − l₀). There its force
/// turns round, and the motion ends; beside its line, and without a free length, it goes on.
#[test]
fn springs_through_length_zero_end_a_motion_there() {
    for (k, free, start) in
        [(100.0_f64, 0.05, 0.12), (37.0, 0.2, 0.61), (2500.0, 0.01, 0.03), (8.0, 0.3, 0.7)]
    {
        let quarter = f64::acos(-free / (start - free)) / k.sqrt();
        let file = |free: f64, aside: f64, more: &str| {
            format!(
                "mech 1\nground {{ O (0, {aside} m); A (0, 0); line way through A along 0 deg }}\nlink m {{ P (0, 0); mass 1 kg at P }}
prismatic G: m.P - ground.way\nspring s: ground.O - m.P {{ stiffness {k} N/m; free_length {free} m }}
{more}start G = {} m\nsimulate 3 s in 5 steps\nfind displacement(G)\n",
                -start
            )
        };
        for more in ["", "force F on m at P = (0 N*s/m*relative_velocity(G), 0)\n"] {
            let (_, words) = tested(&file(free, 0.0, more));
            let (_, rest) = words.split_once("the force of spring `s` has no direction at ").unwrap();
            let found: f64 = rest.split_once(" s:").unwrap().0.parse().unwrap();
            assert!((found / quarter - 1.0).abs() < 1e-3, "{quarter} {words}");
            for smooth in [file(free, 0.1 * free, more), file(0.0, 0.0, more)] {
                let (_, words) = tested(&smooth);
                assert!(words.is_empty(), "{words}\n{smooth}");
            }
        }
    }
}

/// The mean of |x − c| up to an instant, for x = k sin(w t + p), between the places where it is c.
fn mean_apart((k, w, p): (f64, f64, f64), c: f64, end: f64) -> f64 {
    let integral = |t: f64| -k / w * (w * t + p).cos() - c * t;
    let first = (c / k).asin();
    let phases = (-9..9).flat_map(|i| {
        let turn = 2.0 * std::f64::consts::PI * f64::from(i);
        [first + turn, std::f64::consts::PI - first + turn]
    });
    let mut at = phases.map(|phase| (phase - p) / w).filter(|t| 0.0 < *t && *t < end).collect::<Vec<_>>();
    at.extend([0.0, end]);
    at.sort_by(f64::total_cmp);
    at.windows(2).map(|pair| (integral(pair[1]) - integral(pair[0])).abs()).sum::<f64>() / end
}

/// Means over a driven motion of what has corners, at random places of its steps.
#[test]
fn means_are_divided_at_corners() {
    let values = (0.5_f64..4.0, -0.9_f64..0.9, -0.9_f64..0.9, 0.5_f64..8.0);
    let config = Config { failure_persistence: None, ..Config::with_cases(crate::share::part(40)) };
    TestRunner::new_with_rng(
        config,
        proptest::test_runner::TestRng::deterministic_rng(proptest::test_runner::RngAlgorithm::ChaCha),
    )
    .run(&values, |(w, x, v, end)| {
        let speed = 0.2 * w;
        let (x, v) = (0.2 * x, speed * v);
        let text = format!(
            "curve f linear {{\n  x [m], y [m]\n  -1, {:?}\n  {x:?}, 0\n  1, {:?}\n}}\n\
             ground {{ O (0, 0); line path through O along 30 deg }}\nlink b {{ B (0, 0) }}\n\
             prismatic P: b.B - ground.path\ndrive P = 0.2 m*sin({w:?} rad/s*time)\nsimulate {end:?} s in 3 steps\n\
             let slow = {v:?} m/s\nlet u = relative_velocity(P)\n\
             expect mean(abs(u)) = {:?} m/s within 1e-12 m/s\nexpect mean(mag(velocity(B))) = {:?} m/s within 1e-12 m/s\n\
             expect 2*mean(max(u, slow)) - mean(u) - slow = {:?} m/s within 1e-12 m/s\n\
             expect mean(u) + slow - 2*mean(min(u, slow)) = {:?} m/s within 1e-12 m/s\n\
             expect mean(f(displacement(P))) = {:?} m within 1e-12 m\n",
            1.0 + x,
            1.0 - x,
            mean_apart((speed, w, std::f64::consts::FRAC_PI_2), 0.0, end),
            mean_apart((speed, w, std::f64::consts::FRAC_PI_2), 0.0, end),
            mean_apart((speed, w, std::f64::consts::FRAC_PI_2), v, end),
            mean_apart((speed, w, std::f64::consts::FRAC_PI_2), v, end),
            mean_apart((0.2, w, 0.0), x, end),
        );
        let (_, words) = tested(&text);
        assert!(words.is_empty(), "{words}\n{text}");
        Ok(())
    })
    .unwrap();
}

/// The same of a motion under loads: thrown upwards, a mass is slow at one instant.
#[test]
fn means_of_a_free_motion_are_divided_at_corners() {
    let text = "gravity 9.81 m/s^2\nground { O (0, 0); line path through O along 90 deg }\n\
        link b { B (0, 0); mass 2 kg at B }\nprismatic P: b.B - ground.path\nstart P = 0 m at 5 m/s\nsimulate 1.3 s\n";
    let (g, v, end) = (9.81, 5.0, 1.3);
    let path: f64 = v * v / g - (v * end - g * end * end / 2.0);
    let (_, words) =
        tested(&format!("{text}expect mean(mag(velocity(B))) = {:?} m/s within 1e-11", path / end));
    assert!(words.is_empty(), "{words}");
}

/// What nearly touches or just passes the farthest place of a slider in every turn, after many steps in which nothing happens.
#[test]
fn events_at_the_very_reach_of_a_motion_are_found() {
    for (at, each_turn) in [("399.999", 2), ("400.001", 0), ("200.001", 2), ("199.999", 0)] {
        let text = format!(
            "mech 1\nground {{ A (0, 0); line guide through A along 0 deg }}
link crank A-B 100 mm {{ mass 1 kg at B; inertia 0.02 kg*m^2 }}
link rod B-C 300 mm {{ S (70 mm, 0); mass 0.7 kg at S; inertia 0.006 kg*m^2 }}
link piston {{ C (0, 0); mass 1.3 kg at C }}
curve unused linear held {{\n x [m], y [N]\n 0, 0\n 1, 1\n}}
revolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - piston
prismatic D: piston.C - ground.guide\nassemble C ahead of B
torque M on crank = 3 N*m - 0.1 N*m*s*omega(crank)\nstop D < 2 m
start crank = 80 deg at 5 rad/s\nsimulate 20 s in 2 steps
event e: displacement(D) = {at} mm\nfind angle(crank)\n"
        );
        let (solved, words) = tested(&text);
        assert!(words.is_empty() && !solved.compiled.mechanism.has_curves, "{words}");
        let report = solved.solution.simulation.as_ref().unwrap();
        let last = solved.solution.poses.last().unwrap().outcome.as_ref().unwrap();
        let turned = last.angles[1] / std::f64::consts::TAU;
        // the farthest place is at whole turns, the nearest at half ones
        let far = at.starts_with('3') || at.starts_with('4');
        let passed = if far { turned.floor() } else { (turned + 0.5).floor() };
        assert_eq!(report.events[0].len() as f64, f64::from(each_turn) * passed, "{at} mm, {turned} turns");
    }
}
