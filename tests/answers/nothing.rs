//! What is zero but for rounding is zero: functions over a sweep of straight lines, of couplers that do not turn, of loads that
//! name definitions.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::report::{AccuracyShown, PrintedDigits, of_answers};
use assur::internals::source::Source;
use proptest::prelude::*;

fn solve(name: &str, text: &str) -> (Solved, String) {
    let source = Source::new(name, text);
    let (solved, problems) = assur::internals::solve_source(&source, &Overrides::none());
    let solved = solved.unwrap_or_else(|| panic!("{name}: {problems:?}\n{text}"));
    (solved, format!("{problems:?}"))
}

/// The functions over the sweep, in the order of the file.
fn functions(text: &str) -> Vec<f64> {
    let (solved, problems) = solve("case.mech", text);
    let all = &solved.solution.statics.cycles;
    assert!(all.iter().all(|c| c.why.is_none()), "{problems}\n{text}");
    all.iter().map(|c| c.value).collect()
}

fn case(name: &str) -> String {
    std::fs::read_to_string(format!("{}/tests/cases/use3/numbers/{name}.mech", env!("CARGO_MANIFEST_DIR")))
        .unwrap()
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * b.abs()
}

#[test]
fn cases() {
    let found = functions(&case("max-of-nothing-in-a-sweep"));
    assert!(found[0] == 0.0 && near(found[1], -3.0), "{found:?}");
    assert_eq!(functions(&case("deviation-of-a-straight-line")), [0.0; 3]);
    assert_eq!(functions(&case("mean-of-nothing")), [0.0]);
    // by its closed form: 40 N s/m times the greatest speed of the piston
    let found = functions(&case("let-in-load-stale-value"));
    assert!(found[0] == 0.0 && (found[1] - 50.1279).abs() < 5e-5, "{found:?}");
    let found = functions(&case("let-in-load-mean"));
    let turn = std::f64::consts::TAU;
    for (got, right) in found.iter().zip([1e4, 1.2e4, 1e4 * turn, 1e4, 1.2e4, 1e4 * turn]) {
        assert!((got / right - 1.0).abs() < 1e-12, "{found:?}");
    }
}

#[test]
fn residuals_of_nothing_are_nothing() {
    for name in ["power-of-nothing", "mean-of-nothing"] {
        let (solved, _) = solve(name, &case(name));
        let report = of_answers("case.mech", &solved.answers(PrintedDigits::READABLE), AccuracyShown::Worst);
        let page = format!("{:?}", report.sections);
        assert!(!page.contains("e0\"") && !page.contains("e0,"), "{page}");
    }
}

/// In its dwell a cam has no power, however its follower and the force are directed: not the product of two roundings.
#[test]
fn the_power_of_a_dwell_is_zero() {
    for direction in (0..360).step_by(17) {
        let text = case("power-of-nothing")
            .replace("through O along 90 deg", &format!("through O along {direction} deg"))
            .replace("@ -90 deg", &format!("@ {} deg", direction - 180))
            .replace("disk = 50 deg", &format!("disk = {} deg", direction + 320));
        let (solved, words) = solve("case.mech", &text);
        let pose = solved.solution.poses[0].outcome.as_ref().expect(&words);
        let power = pose.residuals.power.expect("forces are found");
        assert!(power == 0.0 || power > 1e-25, "{power:e}\n{text}");
    }
}

/// A function that cannot be given has its reason.
#[test]
fn what_cannot_be_given_has_its_reason() {
    let file = case("max-of-nothing-in-a-sweep").replace("max(omega(b))", "max(omega(a)/omega(b))");
    let (_, problems) = solve("case.mech", &file);
    assert!(problems.contains("the quantity is not defined at a = "), "{problems}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(crate::share::part(24)))]

    /// Peaucellier's cell draws a straight line.
    #[test]
    fn cells_draw_lines(long in 60.0..300.0_f64, short in 0.3..0.6_f64, bar in 0.15..0.8_f64, scale in -6..6_i32) {
        let scale = 10_f64.powi(scale);
        let (long, short) = (long * scale, short * long * scale);
        let r = 0.5 * (long - short + bar * ((long * long - short * short).sqrt() - long + short));
        let x = (long * long - short * short) / (2.0 * r);
        let file = format!(
            "ground {{ O (0, 0); Q ({r} mm, 0) }}
link crank Q-P {r} mm
link l1 O-A {long} mm
link l2 O-B {long} mm
link s1 P-A {short} mm
link s2 P-B {short} mm
link s3 A-R {short} mm
link s4 B-R {short} mm
revolute Q: ground - crank
revolute O: ground - l1 - l2
revolute P: crank - s1 - s2
revolute A: l1 - s1 - s3
revolute B: l2 - s2 - s4
revolute R: s3 - s4
drive crank = -10 deg .. 10 deg in 8 steps at 2 rad/s
assemble s3.R near ({x} mm, 0 mm), A near ({} mm, {long} mm), B near ({} mm, -{long} mm)
find D = max(abs(position(s3.R).x - {x} mm)), E = min(position(s3.R).x - {x} mm), F = max(velocity(s3.R).x),
  G = integral(velocity(s3.R).x), H = argmax(velocity(s3.R).x)
",
            2.0 * r, 2.0 * r
        );
        let found = functions(&file);
        prop_assert_eq!(&found[..4], &[0.0; 4], "{}", file);
    }

    /// The coupler of a parallelogram does not turn, and all its points go as one.
    #[test]
    fn couplers_of_parallelograms_shift(a in 20.0..200.0_f64, b in 0.3..3.0_f64, omega in 0.1..100.0_f64, scale in -6..6_i32) {
        let scale = 10_f64.powi(scale);
        let (a, b) = (a * scale, a * b * scale);
        let file = format!(
            "ground {{ A (0, 0); D ({b} mm, 0) }}
link a A-B {a} mm
link b {{ B (0, 0); C ({b} mm, 0) }}
link c D-C {a} mm
revolute A: ground - a
revolute B: a - b
revolute C: b - c
revolute D: ground - c
assemble C near ({} mm, {} mm)
drive a = 30 deg .. 150 deg in 6 steps at {omega} rad/s
let still = omega(b)
find P = max(still), Q = min(omega(b)), R = mean(abs(alpha(b))), S = integral(angle(b)), T = argmax(omega(b)),
  U = max(sqrt(abs(omega(b)/omega(a)))), V = max(mag(velocity(b.C) - velocity(b.B))), W = max(velocity(b.C).x)
",
            b + a * 0.75_f64.sqrt(), 0.5 * a
        );
        let found = functions(&file);
        prop_assert_eq!(&found[..4], &[0.0; 4], "{}", file);
        prop_assert_eq!(&found[5..7], &[0.0; 2], "{}", file);
        prop_assert!((found[4] - 30_f64.to_radians()).abs() < 1e-12);
        prop_assert!((found[7] / (-0.5 * a * 1e-3 * omega) - 1.0).abs() < 1e-11, "{:?}\n{}", found, file);
    }

    /// A load by definitions is the same load with all written out.
    #[test]
    fn definitions_in_loads(k in -9.0..9.0_f64, n in 1..4_i32, m in 0.5..5.0_f64) {
        let head = "ground { A (0, 0); line guide through A along 0 deg }
link crank A-B 60 mm
link rod B-C 200 mm
link piston { C (0, 0) }
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
prismatic D: piston.C - ground.guide
assemble C ahead of B
drive crank = 0 deg .. 360 deg in 6 steps at 20 rad/s
balance torque M on crank
";
        let q = "angle(crank)";
        let (v, c) = ("velocity(C).x", format!("cos({n}*{q} + 0.3 rad)"));
        let of = |v: &str, c: &str| format!("force F on piston at C = ({k} N*s/m*{v} + {m} N*{c}, 0)\n");
        let flywheel = "flywheel J on crank { fluctuation 0.02 }\n";
        let find = "find max(F.x), min(F.x), mean(F.x), integral(F.x*velocity(C).x), mean(M), max(power(F))\n";
        let named = format!("{head}let q = {q}\nlet v = {v}\nlet p = {n}*q + 0.3 rad\nlet c = cos(p)\n{}{flywheel}{find}", of("v", "c"));
        let whole = format!("{head}{}{flywheel}{find}", of(v, &c));
        let (named, whole) = (solve("named", &named).0, solve("whole", &whole).0);
        let (a, b) = (&named.solution.statics, &whole.solution.statics);
        for (a, b) in a.cycles.iter().zip(&b.cycles) {
            prop_assert!(a.value.is_finite() && (a.value - b.value).abs() <= 1e-11 * b.scale, "{:?} {:?}", a, b);
        }
        let (a, b) = (a.flywheels[0].inertia, b.flywheels[0].inertia);
        prop_assert!((a - b).abs() <= 1e-10 * b, "{} {}", a, b);
    }
}

/// 1 − cos² − sin² is zero, on either side by rounding: its root is a number at every position.
#[test]
fn roots_of_rounding_are_numbers() {
    let file = "mech 1\nground { O (0, 0) }\nlink a O-A 1 m\nrevolute O: ground - a\ndrive a = 0 deg .. 360 deg in 360 steps
let x = position(a.A).x/(1 m)\nlet y = position(a.A).y/(1 m)\nfind r = sqrt(1 - x^2 - y^2)\n";
    let (solved, problems) = solve("case.mech", file);
    assert!(problems.contains("items: []"), "{problems}");
    let answers = format!(
        "{:?}",
        of_answers("case.mech", &solved.answers(PrintedDigits::READABLE), AccuracyShown::Worst)
    );
    assert!(!answers.contains("NaN") && !answers.contains("\"—\""), "{answers}");
}
