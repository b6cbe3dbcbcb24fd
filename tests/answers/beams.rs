//! Loads per length.

use super::masses::{values, within};
use super::quick_rows::random;
use std::fmt::Write;

#[track_caller]
fn near(found: f64, wanted: f64, scale: f64, text: &str) {
    assert!((found - wanted).abs() <= 1e-9 * scale.max(1.0), "{found} is not {wanted}\n{text}");
}

/// Where Gauss's two points are on a segment.
const GAUSS: [f64; 2] = [0.211_324_865_405_187_12, 0.788_675_134_594_812_9];

/// A four-bar in motion, and the length of a segment PQ of its rod with Gauss's points.
fn four_bar(state: &mut u64) -> (String, f64) {
    let (a, b, c, d) =
        (within(state, 0.1, 0.2), within(state, 0.5, 0.6), within(state, 0.4, 0.5), within(state, 0.5, 0.6));
    let mut at = || [within(state, -0.3, 0.6), within(state, -0.2, 0.3)];
    let (p, q) = (at(), at());
    let along = |s: f64| [0, 1].map(|k| p[k] + (q[k] - p[k]) * s);
    let [p, q, g, h] = [0.0, 1.0, GAUSS[0], GAUSS[1]].map(along).map(|[x, y]| format!("({x} m, {y} m)"));
    let length = libm::hypot(along(1.0)[0] - along(0.0)[0], along(1.0)[1] - along(0.0)[1]);
    let angle = within(state, 0.0, 360.0);
    let text = format!(
        "ground {{ A (0, 0); D ({d} m, 0) }}\nlink crank A-B {a} m\nlink rod B-C {b} m {{ P {p}; Q {q}; G0 {g}; G1 {h}; S (0.2 m, 0.1 m); mass 3 kg at S; \
         inertia 0.2 kg*m^2 }}\nlink rocker D-C {c} m\nrevolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - \
         rocker\nrevolute D: ground - rocker\nassemble C left of B-D\ndrive crank = {angle} deg at 8 rad/s\nbalance torque M on crank\n"
    );
    (text, length)
}

/// Two forces at Gauss's points have the force and the moment of any load that changes linearly.
#[test]
fn a_load_per_length_is_two_forces_at_the_points_of_gauss() {
    let mut state = 41;
    for _ in 0..200 {
        let (machine, length) = four_bar(&mut state);
        let (q_1, q_2, phi) =
            (within(&mut state, -1.0, 5.0), within(&mut state, -1.0, 5.0), within(&mut state, -180.0, 180.0));
        let frame = if random(&mut state) < 0.5 { " in rod" } else { "" };
        let spread = match (random(&mut state) * 3.0) as usize {
            0 => format!("force q on rod from P to Q = {q_1} N/m .. {q_2} N/m @ {phi} deg{frame}\n"),
            1 => format!(
                "force q on rod from P to Q = {q_1} N/m*cos(omega(rod)/(1 rad/s)*1 rad) .. 0 @ {phi} deg{frame}\n\
                 force r on rod from P to Q = 0 N/m .. {q_2}*(1 N/m*cos(omega(rod)/(1 rad/s)*1 rad)) @ {phi} deg{frame}\n"
            ),
            _ => format!(
                "given q1 = {q_1} N/m\nforce q on rod from P to Q = q1 @ {phi} deg .. ({q_2} N/m @ {phi} deg){frame}\n"
            ),
        };
        let factor = if spread.contains("cos") { "*cos(omega(rod)/(1 rad/s)*1 rad)" } else { "" };
        let mut points = String::new();
        for (i, s) in GAUSS.into_iter().enumerate() {
            let half = (q_1 + (q_2 - q_1) * s) * length / 2.0;
            let _ = writeln!(points, "force F{i} on rod at G{i} = {half} N{factor} @ {phi} deg{frame}");
        }
        let names =
            ["M", "reaction(B, rod).x", "reaction(B, rod).y", "reaction(C, rod).x", "reaction(C, rod).y"];
        let names = names.map(str::to_owned);
        let (one, other) =
            (values(&(machine.clone() + &spread), &names), values(&(machine + &points), &names));
        let scale = other.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        one.into_iter().zip(other).for_each(|(found, wanted)| near(found, wanted, scale, &spread));
    }
}
