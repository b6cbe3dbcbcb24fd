//! Curvature of coupler curves: against circles through near positions of a four-bar that is solved here, at any speed of the drive.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]

use super::masses::{values, within};

/// A four-bar on A (0, 0) and D (0.5 m, 0), with a point on its rod.
struct FourBar {
    crank: f64,
    rod: f64,
    rocker: f64,
    point: [f64; 2],
}

impl FourBar {
    fn random(state: &mut u64) -> Self {
        Self {
            crank: within(state, 0.1, 0.2),
            rod: within(state, 0.4, 0.6),
            rocker: within(state, 0.4, 0.6),
            point: [within(state, -0.3, 0.6), within(state, -0.4, 0.4)],
        }
    }

    /// The point at a crank angle; C lies left of the line from B to D.
    fn at(&self, q: f64) -> [f64; 2] {
        let b = [self.crank * q.cos(), self.crank * q.sin()];
        let to_d = [0.5 - b[0], -b[1]];
        let apart = to_d[0].hypot(to_d[1]);
        let along = (self.rod.powi(2) - self.rocker.powi(2) + apart * apart) / (2.0 * apart);
        let across = (self.rod.powi(2) - along * along).sqrt();
        // the rod's direction, as a complex number
        let u = [
            (along * to_d[0] - across * to_d[1]) / (apart * self.rod),
            (along * to_d[1] + across * to_d[0]) / (apart * self.rod),
        ];
        let [x, y] = self.point;
        [b[0] + x * u[0] - y * u[1], b[1] + x * u[1] + y * u[0]]
    }

    fn text(&self, drive: &str) -> String {
        let [x, y] = self.point;
        format!(
            "ground {{ A (0, 0); D (0.5 m, 0) }}\nlink crank A-B {} m\nlink rod B-C {} m {{ E ({x} m, {y} m) }}\n\
             link rocker D-C {} m\nrevolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - rocker\n\
             revolute D: ground - rocker\nassemble C left of B-D\ndrive crank = {drive}\n",
            self.crank, self.rod, self.rocker
        )
    }

    /// Radius and centre of curvature, by differences of positions.
    fn curvature(&self, q: f64) -> (f64, [f64; 2]) {
        let h = 2e-3;
        let p = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|i| self.at(q + i * h));
        let first = [0, 1].map(|k| (8.0 * (p[3][k] - p[1][k]) - (p[4][k] - p[0][k])) / (12.0 * h));
        let second = [0, 1]
            .map(|k| (16.0 * (p[3][k] + p[1][k]) - (p[4][k] + p[0][k]) - 30.0 * p[2][k]) / (12.0 * h * h));
        let speed = first[0].hypot(first[1]);
        let radius = speed.powi(3) / (first[0] * second[1] - first[1] * second[0]);
        let centre = [p[2][0] - radius * first[1] / speed, p[2][1] + radius * first[0] / speed];
        (radius, centre)
    }
}

fn asked(text: &str) -> [f64; 3] {
    let names = ["curvature_radius(rod.E)", "curvature_centre(rod.E).x", "curvature_centre(rod.E).y"];
    let found = values(text, &names.map(str::to_owned));
    [found[0], found[1], found[2]]
}

#[test]
fn curvature_is_that_of_near_positions_at_any_speed() {
    let mut state = 41;
    for _ in 0..200 {
        let bars = FourBar::random(&mut state);
        let degrees = within(&mut state, 0.0, 360.0);
        let (radius, centre) = bars.curvature(degrees.to_radians());
        if radius.abs() > 5.0 {
            continue;
        }
        let text = bars.text(&format!("{degrees} deg"));
        let found = asked(&text);
        for (found, wanted) in found.into_iter().zip([radius, centre[0], centre[1]]) {
            assert!((found - wanted).abs() < 1e-6 * (1.0 + radius.abs()), "{found} is not {wanted}\n{text}");
        }
        let drives =
            [(" turning ccw", 1.0), (" turning cw", -1.0), (" at 50 rpm accelerating 9 rad/s^2", 1.0)];
        for (drive, sign) in drives.into_iter().chain([(" at -3 rad/s accelerating 20 rad/s^2", -1.0)]) {
            let again = asked(&bars.text(&format!("{degrees} deg{drive}")));
            for (k, sign) in [(0, sign), (1, 1.0), (2, 1.0)] {
                let near = 1e-9 * (1.0 + radius.abs()).powi(2);
                assert!((again[k] - sign * found[k]).abs() < near, "{again:?} {found:?}{drive}\n{text}");
            }
        }
    }
}

/// What moves along a line or on a circle is known exactly.
#[test]
fn a_circle_has_its_own_centre_and_a_line_none() {
    let text = "ground { A (0.1 m, 0.2 m); line way through A along 0 deg }\nlink crank A-B 0.1 m\nlink rod B-C 0.3 m\n\
                link ram { C (0, 0) }\nrevolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - ram\n\
                prismatic G: ram.C - ground.way\nassemble C ahead of B\ndrive crank = 30 deg\n";
    let found = values(text, &["curvature_radius(B)", "curvature_centre(B).x"].map(str::to_owned));
    assert!((found[0] - 0.1).abs() < 1e-15 && (found[1] - 0.1).abs() < 1e-15, "{found:?}");
    let asked = format!("{text}find r = curvature_radius(ram.C)\n");
    let solution = assur::solve(&asked).expect("solved");
    assert!(solution.poses()[0]["r"].number().is_none());
}

#[test]
fn the_names_of_the_functions_stay_names() {
    let text = "given curvature_centre = 0.1 m\nground { A (0, 0) }\nlink curvature_radius A-B curvature_centre\n\
                revolute A: ground - curvature_radius\ndrive curvature_radius = 30 deg\nlet curvature = 2*curvature_centre\n";
    let names =
        ["curvature_centre", "curvature", "curvature_radius(B)", "curvature_centre(curvature_radius.B).x"];
    let found = values(text, &names.map(str::to_owned));
    assert!(found[0] == 0.1 && found[1] == 0.2 && found[2] == 0.1 && found[3].abs() < 1e-16, "{found:?}");
    let text = "curve curvature_centre {\n  t [m], p [N]\n  0, 0\n  1, 10\n}\nground { A (0, 0) }\nlink crank A-B 0.8 m\n\
                revolute A: ground - crank\ndrive crank = 30 deg\n";
    let found = values(text, &["curvature_centre(0.25 m)".to_owned()]);
    assert!((found[0] - 2.5).abs() < 1e-14, "{found:?}");
}
