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
