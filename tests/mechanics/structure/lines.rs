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
