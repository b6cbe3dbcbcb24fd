//! Contacts that part move as what they stand for: a pair while they are closed, a stop that is hit, a hinge about which a body tips.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

use assur::Problem;
use proptest::prelude::*;
use serde_json::Value;

/// Of the number, or of one.
const SAME: f64 = 1e-7;

/// The values of a quantity at all instants that both texts print.
fn values(text: &str, quantity: &str) -> Result<Vec<(f64, f64)>, String> {
    let solution: Value = serde_json::from_str(&Problem::new("parting", text).solve_json()).unwrap();
    let poses = solution["poses"].as_array().cloned().unwrap_or_default();
    let of = |pose: &Value| Some((pose["time"].as_f64()?, pose["quantities"][quantity].as_f64()?));
    let found: Vec<(f64, f64)> = poses.iter().filter_map(of).collect();
    if found.is_empty() { Err(format!("{text}{}", solution["diagnostics"])) } else { Ok(found) }
}

/// Whether two texts have the same values up to an instant.
fn agree(texts: [(&str, &str); 2], until: f64) -> Result<usize, String> {
    let [one, other] = texts.map(|(text, quantity)| values(text, quantity));
    let (one, other) = (one?, other?);
    let mut compared = 0;
    for ((t, a), (_, b)) in one.iter().zip(&other).filter(|(a, b)| a.0 == b.0 && a.0 < until) {
        if (a - b).abs() > SAME * a.abs().max(1.0) {
            return Err(format!("{a} and {b} at {t} s\n{}\n{}", texts[0].0, texts[1].0));
        }
        compared += 1;
    }
    Ok(compared)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// As long as it presses, a contact that parts is one that does not.
    #[test]
    fn a_ladder_slides_as_on_contacts_that_cannot_part(
        angle in 110.0..130.0_f64, friction in 0.0..0.1_f64, mass in 5.0..40.0_f64,
    ) {
        let text = |parts: &str| format!("gravity 9.81 m/s^2
ground {{ O (0, 0); line floor through O along 0 deg; line wall through O along 90 deg }}
link ladder A-B 3 m {{ mass {mass} kg rod A to B }}
contact F: ladder.A - ground.floor {{ {parts} friction {friction} }}
contact W: ladder.B - ground.wall {{ {parts} friction {friction} }}
start ladder = {angle} deg at 0.2 rad/s
simulate 0 s .. 0.4 s in 8 steps
find omega(ladder), normal(W, ladder), friction(F, ladder)
");
        let (parting, closed) = (text("parts;"), text(""));
        for (quantity, least) in [("omega(ladder)", 2), ("normal(W, ladder)", 1), ("friction(F, ladder)", 1)] {
            let same = agree([(&parting, quantity), (&closed, quantity)], 0.41);
            // a ladder that comes to rest is held at both ends, in unknown shares
            prop_assert!(same.as_ref().is_ok_and(|count| *count >= least), "{same:?}");
        }
    }

    /// A point that falls on a floor rebounds as a slider does from its stop.
    #[test]
    fn a_ball_bounces_as_a_block_on_its_stop(
        height in 0.2..2.0_f64, restitution in 0.0..0.95_f64, radius in 0.01..0.1_f64,
    ) {
        let ball = format!("gravity 9.81 m/s^2
ground {{ O (0, 0); line floor through O along 0 deg }}
link ball {{ C (0, 0); circle rim centre C radius {radius} m; mass 2 kg at C; inertia 0.01 kg*m^2 }}
contact K: ball.rim - ground.floor {{ parts; restitution {restitution} }}
start ball.C = (0, {height} m + {radius} m) at (1 m/s, 0)
start ball = 0 deg at 3 rad/s
simulate 0 s .. 2 s in 20 steps
find velocity(ball.C).y
");
        let block = format!("gravity 9.81 m/s^2
ground {{ O (0, 0); line up through O along 90 deg }}
link block {{ C (0, 0); mass 2 kg at C }}
prismatic G: block.C - ground.up
start G = {height} m
stop G > 0 m {{ restitution {restitution} }}
simulate 0 s .. 2 s in 20 steps
find velocity(block.C).y
");
        let same = agree([(&ball, "velocity(ball.C).y"), (&block, "velocity(block.C).y")], 3.0);
        prop_assert!(same.as_ref().is_ok_and(|count| *count >= 20), "{same:?}");
    }

    /// A crate on a truck that brakes hard tips about its front edge, as about a hinge there.
    #[test]
    fn a_crate_tips_as_about_a_hinge(brake in 4.0..6.0_f64, height in 0.8..1.1_f64) {
        let text = |joins: &str, starts: &str| format!("gravity 9.81 m/s^2
ground {{ O (0, 0); line road through O along 0 deg }}
link truck {{ P (0, 0); B (1.5 m, 0); line bed through P along 0 deg }}
prismatic T: truck.P - ground.road
link box {{ A (0, 0); B (500 mm, 0); S (250 mm, {height} m); mass 10 kg at S; inertia 2 kg*m^2 }}
{joins}drive T = 10 m/s*time - {}*time^2
{starts}start box = 0 deg
simulate 0 s .. 0.5 s in 10 steps
find angle(box)
", format_args!("{} m/s^2", brake / 2.0));
        let crate_ = text(
            "contact a: box.A - truck.bed { parts; friction 0.9 }\ncontact b: box.B - truck.bed { parts; friction 0.9 }\n",
            "start box.A = (1 m, 0) at (10 m/s, 0)\n",
        );
        let hinged = text("revolute B: truck - box\n", "");
        let same = agree([(&crate_, "angle(box)"), (&hinged, "angle(box)")], 0.51);
        prop_assert!(same.as_ref().is_ok_and(|count| *count >= 10), "{same:?}");
    }
}

/// A block of 2 kg falls by 1 m on a stop, a ball on a floor: each gives m (1 + e) v, at the event alone.
#[test]
fn an_impulse_is_given_at_its_event() {
    let block = "gravity 9.81 m/s^2
ground { O (0, 0); line up through O along 90 deg }
link block { C (0, 0); mass 2 kg at C }
prismatic G: block.C - ground.up
start G = 1 m
stop G > 0 m { restitution 0.5 }
event hits: displacement(G) = 0 m
simulate 0 s .. 0.8 s
find impulse(G)
";
    let ball = "gravity 9.81 m/s^2
ground { O (0, 0); line floor through O along 0 deg }
link ball { C (0, 0); circle rim centre C radius 100 mm; mass 2 kg sphere centre C radius 100 mm }
contact G: ball.rim - ground.floor { parts; restitution 0.5 }
start ball.C = (0, 1.1 m)
start ball = 0 deg
event hits: position(ball.C).y = 100 mm
simulate 0 s .. 0.8 s
find impulse(G)
";
    let right = 2.0 * 1.5 * (2.0 * 9.81_f64).sqrt();
    for text in [block, ball] {
        let found = values(text, "impulse(G)").unwrap();
        let hits: Vec<f64> =
            found.iter().map(|(_, impulse)| *impulse).filter(|impulse| *impulse != 0.0).collect();
        assert!(
            matches!(hits[..], [impulse] if (impulse - right).abs() < 1e-8),
            "{found:?}, not {right}\n{text}"
        );
    }
}
