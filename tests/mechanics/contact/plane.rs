//! Points in the plane under a force against their motion, against closed forms: how they come to rest, stay there, and begin to slide.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

use assur::Problem;
use proptest::prelude::*;
use serde_json::Value;

/// Values of quantities at all instants.
fn values(text: &str, quantities: &[&str]) -> Result<Vec<Vec<f64>>, String> {
    let solution: Value = serde_json::from_str(&Problem::new("plane", text).solve_json()).unwrap();
    let poses = solution["poses"].as_array().cloned().unwrap_or_default();
    let of = |pose: &Value| quantities.iter().map(|name| pose["quantities"][name].as_f64()).collect();
    let found: Option<Vec<Vec<f64>>> = poses.iter().map(of).collect();
    found.filter(|found| !found.is_empty()).ok_or_else(|| format!("{text}{}", solution["diagnostics"]))
}

/// A body on two guides across each other, of which the first has a mass of its own.
fn text(masses: [f64; 2], loads: &str, starts: [&str; 2], end: f64) -> String {
    let [own, body] = masses;
    let own = if own > 0.0 { format!("; mass {own} kg at P") } else { String::new() };
    let [g, h] = starts;
    format!(
        "ground {{ O (0, 0); line way through O along 0 deg }}
link a {{ P (0, 0); line rail through P along 90 deg{own} }}
link b {{ Q (0, 0); mass {body} kg at Q }}
prismatic G: a.P - ground.way
prismatic H: b.Q - a.rail
{loads}
start G = 0 mm{g}
start H = 0 mm{h}
simulate 0 s .. {end} s in 10 steps
find vx = velocity(b.Q).x, vy = velocity(b.Q).y, t = time, kx = K.x, ky = K.y
"
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// A puck under a constant pull P at the angle θ from its velocity v, with friction k P: v (cos θ + k) falls by P/m (k² − 1) a second.
    #[test]
    fn a_puck_comes_to_rest_and_stays(
        mass in 0.5..5.0_f64, pull in 0.5..5.0_f64, k in 1.05..6.0_f64,
        speed in 0.5..5.0_f64, course in -3.1..3.1_f64, along in -3.1..3.1_f64,
    ) {
        let (sin, cos) = libm::sincos(course);
        let (p_y, p_x) = libm::sincos(along);
        let first = mass * speed * (libm::cos(course - along) + k);
        let fall = pull * (k * k - 1.0);
        let end = 1.27 * first / fall;
        let loads = format!(
            "force K on b at Q = {} N against motion\nforce P on b at Q = ({} N, {} N)",
            k * pull, pull * p_x, pull * p_y
        );
        let starts = [format!(" at {} m/s", speed * cos), format!(" at {} m/s", speed * sin)];
        let text = text([0.0, mass], &loads, [&starts[0], &starts[1]], end);
        let found = values(&text, &["vx", "vy", "t", "kx", "ky"]).map_err(TestCaseError::fail)?;
        prop_assert!(found.len() >= 10);
        for row in found {
            let &[x, y, t, k_x, k_y] = row.as_slice() else { unreachable!() };
            let got = mass * (x * p_x + y * p_y + k * f64::hypot(x, y));
            let right = (first - fall * t).max(0.0);
            prop_assert!((got - right).abs() <= 1e-7 * first, "{t} s: {got}, not {right}\n{text}");
            let size = if right > 0.0 { k * pull } else { pull };
            let held = f64::hypot(k_x, k_y);
            prop_assert!((held - size).abs() <= 1e-7 * size, "{t} s: {held} N, not {size} N\n{text}");
        }
    }

    /// From rest under a pull of more than the friction, with another mass in each direction: it goes on a straight line, on which the
    /// friction acts too.
    #[test]
    fn what_begins_to_slide_has_its_direction(
        own in 0.1..20.0_f64, body in 0.2..5.0_f64, friction in 0.5..5.0_f64, more in 1.001..4.0_f64, along in -3.1..3.1_f64,
    ) {
        let (sin, cos) = libm::sincos(along);
        let pull = more * friction;
        let loads = format!(
            "force K on b at Q = {friction} N against motion\nforce P on b at Q = ({} N, {} N)",
            pull * cos, pull * sin
        );
        let text = text([own, body], &loads, ["", ""], 2.0);
        let found = values(&text, &["vx", "vy", "t"]).map_err(TestCaseError::fail)?;
        for row in &found[1..] {
            let &[x, y, t] = row.as_slice() else { unreachable!() };
            let v = f64::hypot(x, y);
            let left = [
                (own + body) * x / t + friction * x / v - pull * cos,
                body * y / t + friction * y / v - pull * sin,
            ];
            prop_assert!(left.iter().all(|left| left.abs() <= 1e-8 * pull), "{t} s: {left:?}\n{text}");
        }
    }
}

/// Held under a growing pull: it begins to slide where that is as great as the friction.
#[test]
fn a_growing_pull_lets_go() {
    let loads = "force K on b at Q = 5 N against motion
force P on b at Q = (3 N, 4 N)*(time/2 s)";
    let text = text([0.0, 2.0], loads, ["", ""], 4.0);
    let found = values(&text, &["t", "vx", "vy", "kx"]).unwrap();
    for row in found {
        let &[t, x, y, k] = row.as_slice() else { unreachable!() };
        let right = if t > 2.0 { 5.0 / 4.0 * (t - 2.0).powi(2) / 2.0 } else { 0.0 };
        assert!((f64::hypot(x, y) - right).abs() < 1e-8, "{t} s: {x}, {y}");
        assert!((k + if t < 2.0 { 1.5 * t } else { 3.0 }).abs() < 1e-8, "{t} s: {k} N");
    }
}
