//! Wedges at random angles: faces that cannot lie on each other are refused, and the angle of the help lets them.

use crate::support::random::Random;
use assur::Problem;

/// A wedge on the floor, a block on a wall, their faces on each other; the block may be held by a point or by a line.
fn wedge(floor: f64, wall: f64, top: f64, under: f64, angle: Option<f64>) -> String {
    let (side, held) = match angle {
        Some(angle) => (String::new(), format!("block.B - ground.wall {{ angle {angle} deg }}")),
        None => ("line side through B along 15 deg; ".to_owned(), "block.side - ground.wall".to_owned()),
    };
    format!(
        "ground {{ O (0, 0); line floor through O along {floor} deg; line wall through O along {wall} deg }}
link wedge {{ W (0, 0); line top through W along {top} deg }}
link block {{ B (0, 0); {side}line under through B along {under} deg }}
prismatic a: wedge.W - ground.floor
prismatic b: {held}
prismatic c: block.under - wedge.top
drive a = -200 mm
find displacement(b)
"
    )
}

#[test]
fn faces_lie_on_each_other_or_the_help_lets_them() {
    let mut random = Random::new(51);
    for case in 0..40 {
        let [floor, wall, top] =
            [(-20.0, 20.0), (70.0, 110.0), (25.0, 50.0)].map(|(a, b)| random.within(a, b));
        let angle = (case % 2 == 0).then(|| random.within(-100.0, 100.0));
        // the block lies at the angle of the wall, less that of its own line
        let block = angle.map_or(wall - 15.0, |angle| wall + angle);
        let right = floor + top - block;
        assert!(
            assur::solve(wedge(floor, wall, top, right, angle)).is_ok(),
            "{floor} {wall} {top} {angle:?}"
        );
        assert!(assur::solve(wedge(floor, wall, top, right + 360.0, angle)).is_ok(), "a turn more");
        let text = wedge(floor, wall, top, right + random.within(1.0, 359.0), angle);
        let found = Problem::new("wedge", text.as_str()).check();
        let error = found.iter().find(|d| d.code.as_deref() == Some("mech::determinacy::not_parallel"));
        let help =
            error.and_then(|error| error.help.clone()).unwrap_or_else(|| panic!("nothing said\n{text}"));
        let line = help.split('`').nth(1).unwrap_or_default();
        let own = text.split("; ").find(|part| part.starts_with("line under")).unwrap_or_default();
        let own = own.split(" }").next().unwrap_or_default();
        let mended = text.replace(own, line);
        assert!(assur::solve(mended.as_str()).is_ok(), "{help}\n{mended}");
    }
}

/// A slider on two parallel guides, whose lines lie `across` from each other and those of the slider `own`.
fn two_guides(along: f64, turned: f64, across: f64, own: f64) -> String {
    let at = |angle: f64, x: f64, y: f64| {
        let (sin, cos) = libm::sincos(angle.to_radians());
        format!("({:.12} mm, {:.12} mm)", cos * x - sin * y, sin * x + cos * y)
    };
    let (q, t) = (at(along, 30.0, across), at(-turned, 5.0, own));
    format!(
        "ground {{ O (0, 0); Q {q}; line low through O along {along} deg; line high through Q along {along} deg }}
link box {{ B (0, 0); T {t}; line top through T along {} deg }}
prismatic a: box.B - ground.low {{ angle {turned} deg }}
prismatic b: box.top - ground.high
drive a = 30 mm
",
        -turned
    )
}

#[test]
fn guides_are_one_distance_apart_or_the_help_makes_them_so() {
    let said = |text: &str| {
        let found = Problem::new("guides", text).check();
        let error = found.iter().next().unwrap_or_else(|| panic!("nothing said\n{text}"));
        (error.code.clone().unwrap_or_default(), error.help.clone().unwrap_or_default())
    };
    let mut random = Random::new(52);
    for _ in 0..20 {
        let [along, turned] = [0, 1].map(|_| random.within(-80.0, 80.0));
        let across = random.within(5.0, 20.0);
        let right = two_guides(along, turned, across, across);
        assert_eq!(said(&right).0, "mech::determinacy::repeated", "{right}");
        let text = two_guides(along, turned, across, across + random.within(0.1, 4.0));
        let (code, help) = said(&text);
        assert_eq!(code, "mech::determinacy::apart", "{text}");
        let point = help.split('`').nth(1).unwrap_or_default();
        let (before, rest) = text.split_once("T (").unwrap_or_default();
        let (_, behind) = rest.split_once(')').unwrap_or_default();
        let mended = format!("{before}{point}{behind}");
        assert_eq!(said(&mended).0, "mech::determinacy::repeated", "{help}\n{mended}");
    }
}

#[test]
fn a_wedge_without_a_slope_is_driven_by_its_own_guide_alone() {
    let wedge = |slope: f64, drive: &str| {
        wedge(0.0, 90.0, slope, slope - 75.0, None).replace("drive a = -200 mm", drive)
    };
    for (slope, drive, is_right) in [
        (0.0, "drive a = -200 mm", true),
        (0.0, "drive b = 0 mm", false),
        (0.0, "drive b = 41 mm", false),
        (10.0, "drive b = 41 mm", true),
    ] {
        let text = wedge(slope, drive);
        let found = Problem::new("wedge", text.as_str()).check();
        let says = found.iter().any(|d| d.code.as_deref() == Some("mech::determinacy::parallel"));
        assert_eq!(says, !is_right, "{text}");
        assert_eq!(assur::solve(text.as_str()).is_ok(), is_right, "{text}");
    }
}
