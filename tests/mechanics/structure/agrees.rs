//! What is too many and true all the same, and by how much it is not: a bar on two rails whose middle a crank leads.

use crate::support::random::Random;
use assur::Problem;

/// The help for a bar of twice the crank's length, whose pin is off the middle by `along` it, at an angle of the crank.
fn said(crank: f64, along: f64, angle: f64) -> String {
    let text = format!(
        "ground {{ A (0, 0); line floor through A along 0 deg; line wall through A along 90 deg }}
link crank A-M {crank} mm
link bar {{ B (0, 0); M ({} mm, 0); C ({} mm, 0) }}
revolute A: ground - crank
revolute M: crank - bar
slot B: bar.B - ground.floor
slot C: bar.C - ground.wall
drive crank = {angle} deg
assemble B right of A-M
",
        crank + along,
        2.0 * crank
    );
    let found = Problem::new("trammel", text.as_str()).check();
    let error = found.iter().find(|d| d.code.as_deref() == Some("mech::determinacy::overconstrained"));
    error.and_then(|error| error.help.clone()).unwrap_or_else(|| panic!("nothing said\n{text}"))
}

#[test]
fn a_crank_in_the_middle_repeats_the_rails() {
    let mut random = Random::new(53);
    for _ in 0..10 {
        let help = said(random.within(20.0, 90.0), 0.0, random.within(20.0, 70.0));
        assert!(help.contains("the motion is the same without"), "{help}");
    }
}

#[test]
fn a_crank_beside_the_middle_misses_a_rail_by_what_the_help_says() {
    let mut random = Random::new(54);
    for _ in 0..10 {
        let (crank, along) = (random.within(40.0, 90.0), random.within(1.0, 5.0));
        let angle: f64 = random.within(30.0, 60.0);
        let help = said(crank, along, angle);
        // B on the floor, at its distance from M; C beyond M
        let (sin, cos) = libm::sincos(angle.to_radians());
        let (x, y, r) = (crank * cos, crank * sin, crank + along);
        let b = x + (r * r - y * y).sqrt();
        let c = b + 2.0 * crank * (x - b) / r;
        let miss = help.split("its ends are ").nth(1).and_then(|rest| rest.split(" mm apart").next());
        let miss: f64 = miss.and_then(|miss| miss.parse().ok()).unwrap_or_else(|| panic!("{help}"));
        assert!((miss - c.abs()).abs() < 1e-3 * c.abs(), "{} {help}", c.abs());
    }
}

/// The help for two cranks and a rod between them, with a line that is too many.
fn of_cranks(second: f64, line: &str) -> String {
    let text = format!(
        "ground {{ A (0, 0); D (300 mm, 0) }}
link one A-B 80 mm {{ wheel w1 radius 100 mm at A }}
link two D-E {second} mm {{ wheel w2 radius 100 mm at D }}
link rod B-E 300 mm
revolute A: ground - one
revolute D: ground - two
revolute B: one - rod
revolute E: two - rod
drive one = 60 deg
assemble E left of B-D
{line}
"
    );
    let found = Problem::new("cranks", text.as_str()).check();
    let error = found.iter().find(|d| d.code.as_deref() == Some("mech::determinacy::overconstrained"));
    error.and_then(|error| error.help.clone()).unwrap_or_else(|| panic!("nothing said\n{text}{found:?}"))
}

/// The angle of the second crank, deg, at an angle of the first, where the rod does not cross the ground.
fn second_crank(second: f64, one: f64) -> f64 {
    let (sin, cos) = libm::sincos(one.to_radians());
    let (x, y) = (300.0 - 80.0 * cos, -80.0 * sin);
    let (d, to) = (libm::hypot(x, y), libm::atan2(y, x));
    // the triangle B, D, E
    let at_d = libm::acos((d * d + second * second - 300.0 * 300.0) / (2.0 * d * second));
    (to + std::f64::consts::PI - at_d).to_degrees()
}

#[test]
fn a_belt_beside_equal_cranks_repeats_the_rod() {
    let help = of_cranks(80.0, "belt k: w1 - w2");
    assert!(help.contains("the motion is the same without `belt k`"), "{help}");
}

#[test]
fn a_belt_beside_other_cranks_turns_one_too_far() {
    let help = of_cranks(90.0, "belt k: w1 - w2");
    let number = |before: &str| {
        let rest = help.split(before).nth(1).and_then(|rest| rest.split(" deg").next());
        rest.and_then(|x| x.parse::<f64>().ok()).unwrap_or_else(|| panic!("{before}: {help}"))
    };
    let turned = second_crank(90.0, 70.8) - second_crank(90.0, 60.0);
    assert!((number("`two` turns by ") - turned).abs() < 1e-2, "{turned} {help}");
    assert!((number("it wants ") - 10.8).abs() < 1e-9, "{help}");
}

#[test]
fn a_drive_too_many_is_told_where_its_link_is() {
    for second in [80.0, 90.0, 120.0] {
        let help = of_cranks(second, "drive two = 100 deg");
        let is = help.split("its value is ").nth(1).and_then(|rest| rest.split(" deg").next());
        let is: f64 = is.and_then(|is| is.parse().ok()).unwrap_or_else(|| panic!("{help}"));
        let wanted = second_crank(second, 60.0);
        assert!((is - wanted).abs() < 1e-2 && help.contains("asks for 100 deg"), "{wanted} {help}");
    }
}
