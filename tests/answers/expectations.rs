//! The rules by which an answer is held against the answer key.

use assur::internals::check::Overrides;
use assur::internals::source::Source;

const CRANK_SLIDER: &str = r#"mechanism "Crank-slider"
given r = 100 mm
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B r
link rod   B-C 350 mm
link piston { C (0, 0) }
revolute  A: ground - crank
revolute  B: crank - rod
revolute  C: rod - piston
prismatic D: piston.C - ground.guide
assemble C ahead of B
"#;
const ONE_POSE: &str = "drive crank = 0 deg at 100 rad/s\n";
const SWEEP: &str = "drive crank = 0 deg, 90 deg, 360 deg at 100 rad/s\npose quarter at crank = 90 deg\n";

/// Truths of the outcomes of the last line, with the names of their poses.
fn outcomes(drive: &str, expect: &str) -> Vec<(Option<String>, bool)> {
    let source = Source::new("a.mech", format!("{CRANK_SLIDER}{drive}{expect}\n"));
    let (solved, problems) = assur::internals::solve_source(&source, &Overrides::none());
    let said =
        assur::internals::diagnostic::render(&problems, &source, assur::internals::diagnostic::Style::PLAIN);
    let solved = solved.unwrap_or_else(|| panic!("{expect}: {said}"));
    assert!(!problems.has_errors(), "{expect}: {said}");
    solved.outcomes.into_iter().map(|o| (o.pose, o.passed)).collect()
}

fn holds(drive: &str, expect: &str) -> bool {
    let outcomes = outcomes(drive, expect);
    assert_eq!(outcomes.len(), 1, "{expect}");
    outcomes[0].1
}

/// A flywheel is braked from 100 rad/s to rest: 79.58 turns. A crank goes through two turns, and through one.
#[test]
fn whole_turns_count_where_something_turns_many_times() {
    const BRAKED: &str = "ground { O (0, 0) }\nlink rotor { O (0, 0); inertia 2 kg*m^2 }\nrevolute O: ground - rotor\n\
        torque B on rotor = 20 N*m cw\nstart rotor = 0 deg at 100 rad/s\nsimulate 0 s .. 20 s\nuntil omega(rotor) = 0 rad/s\n";
    let holds_of = |text: String| {
        let (solved, _) = assur::internals::solve_source(&Source::new("a.mech", text), &Overrides::none());
        solved.unwrap().outcomes.iter().all(|outcome| outcome.passed)
    };
    for (expect, wanted) in [
        ("n = 79.577 rev", true),
        ("n = 78.577 rev", false),
        ("n = 0.577 rev", false),
        ("n = 207.9 deg within 0.2 deg", false),
        ("n = 28647.9 deg within 0.2 deg", true),
    ] {
        let text = format!("{BRAKED}find n = max(angle(rotor)) as rev\nexpect {expect}\n");
        assert_eq!(holds_of(text), wanted, "{expect}");
    }
    let sweep = |to: &str, expect: &str| {
        holds(&format!("drive crank = 0 deg .. {to} in 8 steps at 1 rad/s\n"), &format!("expect {expect}"))
    };
    for (to, expect, wanted) in [
        ("360 deg", "angle(crank) = 450 deg at pose 3", false),
        ("360 deg", "angle(crank) = -270 deg at pose 3", true),
        // no direction is further off than half a turn
        ("360 deg", "angle(crank) = -274 deg within 3 % at pose 3", true),
        ("360 deg", "angle(crank) = -278 deg within 3 % at pose 3", false),
        ("360 deg", "max(angle(crank)) = 0 deg within 1 deg", false),
        ("720 deg", "angle(crank) = 0 deg within 1 deg at pose 5", false),
        ("720 deg", "angle(crank) = 360 deg at pose 5", true),
        ("360 deg", "dir(position(B)) = -270 deg at pose 3", true),
    ] {
        assert_eq!(sweep(to, expect), wanted, "{to}: {expect}");
    }
}

#[test]
fn tolerances() {
    for (expect, wanted) in [
        // one unit in the last digit, at most 1 %
        ("expect position(C).x = 451 mm", true),
        ("expect position(C).x = 452 mm", false),
        ("expect position(C).x = 450.0 mm", true),
        ("expect position(C).x = 450.2 mm", false),
        ("expect position(C).x = 0.5 m", false),
        // relative, absolute
        ("expect position(C).x = 460 mm within 3 %", true),
        ("expect position(C).x = 460 mm within 2 %", false),
        ("expect position(C).x = 450 mm within 1e-9", true),
        ("expect position(C).x = 455 mm within 5 mm", true),
        ("expect position(C).x = 455 mm within 4.9 mm", false),
        ("expect position(C).y = 0 mm within 1e-9 mm", true),
        // of givens alone
        ("expect r = 100 mm within 1e-15", true),
    ] {
        assert_eq!(holds(ONE_POSE, expect), wanted, "{expect}");
    }
}

#[test]
fn vectors_angles_comparisons_and_truths() {
    for (expect, wanted) in [
        ("expect position(C) = (450 mm, 0) within 1e-9", true),
        ("expect position(C) = (447 mm, 4 mm) within 5 mm", true),
        ("expect position(C) = (447 mm, 4.1 mm) within 5 mm", false),
        ("expect velocity(piston.C) = (0, 0) within 1e-9 m/s", true),
        // more than a turn is counted
        ("expect angle(crank) = 720 deg within 1e-9 deg", false),
        ("expect angle(crank) = -360 deg within 1e-9 deg", true),
        ("expect angle(crank) = 180 deg within 1 deg", false),
        ("expect position(C).x > 449 mm", true),
        ("expect position(C).x < 449 mm", false),
        ("expect 0 m < position(C).x < 1 m", true),
        ("expect not (position(C).x < 449 mm)", true),
        ("expect position(C).x > 1 m or r < 1 m", true),
    ] {
        assert_eq!(holds(ONE_POSE, expect), wanted, "{expect}");
    }
}

#[test]
fn poses() {
    let named = |list: &[(&str, bool)]| {
        list.iter().map(|(name, passed)| (Some((*name).to_owned()), *passed)).collect::<Vec<_>>()
    };
    let list = "expect position(C).x = 450 mm, 335.41 mm, 451 mm within 0.5 mm";
    assert_eq!(outcomes(SWEEP, list), named(&[("1", true), ("2", true), ("3", false)]));
    let pose = "expect position(C).x = 335.41 mm at pose 2";
    assert_eq!(outcomes(SWEEP, pose), named(&[("2", true)]));
    let own = "expect position(C).x = 335.41 mm at pose quarter";
    assert_eq!(outcomes(SWEEP, own), named(&[("quarter", true)]));
    let added = "expect position(C).x = 250 mm at crank = 180 deg";
    assert_eq!(outcomes(SWEEP, added), named(&[("crank = 180 deg", true)]));
    assert_eq!(outcomes(SWEEP, "expect 2*r = 200 mm"), [(None, true)]);
    // the angle of a link goes on over the sweep, and an expectation does not mind the turn
    assert_eq!(
        outcomes(SWEEP, "expect angle(crank) = 0 deg within 1e-9 deg at pose 3"),
        named(&[("3", true)])
    );
    assert_eq!(outcomes(SWEEP, "expect angle(crank) > 300 deg at pose 3"), named(&[("3", true)]));
}

/// The code of the first error of a file that ends with these lines.
fn error(drive: &str, expect: &str) -> Option<String> {
    let source = Source::new("a.mech", format!("{CRANK_SLIDER}{drive}{expect}\n"));
    let (_, problems) = assur::internals::test_source(&source, &Overrides::none());
    problems.views(&source).into_iter().find_map(|d| d.code)
}

#[test]
fn nothing_is_met_by_any_value() {
    let any = "mech::expect::any_value";
    for (expect, code) in [
        ("expect position(C).x = 451 mm within 3", any),
        ("expect position(C).x = 451 mm within 100 %", any),
        ("expect position(C).x = 451 mm within 1", any),
        ("expect position(C).x = 451 mm within 50*2 %", any),
        ("expect position(C).x = 451 mm within 1 m", any),
        ("expect position(C).x = 1 mm within 350 mm", any),
        ("expect position(C).y = 0 mm within 350 mm", any),
        ("expect position(C) = (1 mm, 2 mm) within 350 mm", any),
        ("expect position(C) = 400 mm @ 10 deg within 150 %", any),
        ("expect mag(position(C)) = 430 mm within 5", any),
        ("expect velocity(C).x = 0 m/s within 0 m/s", "mech::expect::tolerance"),
        ("expect omega(rod) = 0 rad/s within 100 rad/s", any),
        ("expect angle(rod) = 5 deg within 180 deg", any),
        ("expect angle(rod) = 300 deg within 60 %", any),
        ("expect angle(rod) = 2e4 deg", any),
        ("expect r/(1 mm) = 100 within 7", any),
        ("expect r/(1 mm) - 100 = 0 within 7", any),
        ("expect r = r", any),
        ("expect position(C).x = position( C ).x within 1e-9", any),
        ("expect position(C).x <= position(C).x", any),
        ("expect r = 100 mm within -3 %", "mech::expect::tolerance"),
        ("expect r = 100 mm within 0/1", "mech::expect::tolerance"),
        ("expect r = 100 mm within 1e-999", "mech::expect::tolerance"),
    ] {
        assert_eq!(error(ONE_POSE, expect).as_deref(), Some(code), "{expect}");
    }
    for expect in [
        // near zero, where the mechanism is much larger
        "expect position(C).y = 0.001 mm within 5 mm",
        "expect position(C).x = 1 mm within 349 mm",
        "expect angle(rod) = -5 deg within 10 deg",
        "expect angle(rod) = 5 deg within 179 deg",
        "expect position(C).x = 451 mm within 99 %",
        // velocities are written nowhere
        "expect velocity(C).x = 0 m/s within 1e-9 m/s",
        "expect position(rod.C) = position(C) within 1e-9",
    ] {
        assert!(error(ONE_POSE, expect).is_none_or(|code| code == "mech::expect::mismatch"), "{expect}");
    }
}

#[test]
fn a_list_is_for_poses() {
    for expect in [
        "expect 2*r = 200 mm, 300 mm",
        "expect stroke(D) = 200 mm, 200 mm",
        "expect max(angle(rod)) = 2 deg, 1 deg",
    ] {
        assert_eq!(error(SWEEP, expect).as_deref(), Some("mech::expect::count"), "{expect}");
    }
    assert_eq!(
        error(SWEEP, "expect 2*r = 200 mm, 200 mm at pose 1").as_deref(),
        Some("mech::expect::list_at_pose")
    );
    assert_eq!(error(SWEEP, "expect 2*r = 200 mm"), None);
}

/// An answer that does not exist is met by nothing.
#[test]
fn what_has_no_value_is_not_met() {
    let root = "let q = asin(position(C).x/(1 mm))\nlet less = q < 1 rad\n";
    for expect in [
        "expect q = 1 rad",
        "expect q > 1 rad",
        "expect not (q < 1 rad)",
        "expect not less",
        "expect not (less and r > 1 mm)",
        "expect r < 1 mm or not less",
        "expect 0 rad < max(q, 1 rad)",
        "expect max(q, 1 rad) = 1 rad",
        "expect min(1 rad, q) = 1 rad",
        "expect q^0 = 1",
        "expect position(C).x = 1 mm*q/(1 rad) within 1 %",
    ] {
        let all = format!("{root}{expect}");
        assert_eq!(error(ONE_POSE, &all).as_deref(), Some("mech::expect::undefined"), "{expect}");
    }
    // what decides exists
    for expect in ["expect r > 1 mm or less", "expect not (less and r < 1 mm)"] {
        assert_eq!(error(ONE_POSE, &format!("{root}{expect}")), None, "{expect}");
    }
    // no pose is like that
    for expect in ["expect r = 100 mm at pose 4", "expect position(C).x = 1 m at pose third"] {
        assert_eq!(error(SWEEP, expect).as_deref(), Some("mech::expect::unknown_pose"), "{expect}");
    }
    let open = "drive D = 300 mm\nassemble B left of A-C\n";
    let failed = error(open, "expect angle(crank) = 90 deg at D = 900 mm");
    assert!(
        failed.is_some_and(|code| code.starts_with("mech::assembly") || code == "mech::expect::pose_failed")
    );
}
