//! The rules by which an answer is held against the answer key.

use assur::check::Overrides;
use assur::source::Source;

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
    let (solved, problems) = assur::solve_source(&source, &Overrides::none());
    let said = assur::diagnostic::render(&problems, &source, assur::diagnostic::Style::PLAIN);
    let solved = solved.unwrap_or_else(|| panic!("{expect}: {said}"));
    assert!(!problems.has_errors(), "{expect}: {said}");
    solved.outcomes.into_iter().map(|o| (o.pose, o.passed)).collect()
}

fn holds(drive: &str, expect: &str) -> bool {
    let outcomes = outcomes(drive, expect);
    assert_eq!(outcomes.len(), 1, "{expect}");
    outcomes[0].1
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
        ("expect angle(crank) = 720 deg within 1e-9 deg", true),
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
