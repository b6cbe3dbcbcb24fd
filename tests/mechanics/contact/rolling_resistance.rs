//! Rolling resistance of contacts against closed forms: a wheel that coasts, is held on a slope, is driven, and lands.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

use assur::Problem;
use proptest::prelude::*;
use serde_json::Value;

/// Of the number.
const SAME: f64 = 1e-9;
const G: f64 = 9.81;

/// The value of a quantity at the last position.
fn last(text: &str, quantity: &str) -> Result<f64, String> {
    let solution: Value = serde_json::from_str(&Problem::new("rolling", text).solve_json()).unwrap();
    let last = solution["poses"].as_array().and_then(|poses| poses.last()).cloned().unwrap_or_default();
    last["quantities"][quantity].as_f64().ok_or_else(|| format!("{text}{}", solution["diagnostics"]))
}

fn wheel(slope: f64, arm: f64, properties: &str, start: &str, time: f64) -> String {
    format!(
        "gravity {G} m/s^2
ground {{ O (0, 0); line slope through O along {slope} deg }}
link wheel {{ C (0, 0); circle rim centre C radius 200 mm; mass 3 kg disc centre C radius 200 mm }}
contact K: wheel.rim - ground.slope {{ friction 0.9; rolling {arm} mm{properties} }}
start wheel.C = (-200 mm*sin({slope} deg), 200 mm*cos({slope} deg)){start}
simulate 0 s .. {time} s in 1 steps
find velocity(wheel.C), omega(wheel), moment(K, wheel), normal(K, wheel)
"
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// On a slope a wheel rolls down with 2/3 g (sin a - arm/r cos a), or is held; one that parts as well.
    #[test]
    fn a_wheel_on_a_slope_rolls_by_what_is_above_its_resistance(
        slope in 0.5..12.0_f64, arm in 1.0..40.0_f64, parts: bool,
    ) {
        let (sin, cos) = libm::sincos(slope.to_radians());
        let pull = sin - arm / 200.0 * cos;
        prop_assume!(pull.abs() > 1e-3);
        let text = wheel(slope, arm, if parts { "; parts" } else { "" }, "\nstart wheel = 0 deg", 0.5);
        let omega = last(&text, "omega(wheel)").map_err(TestCaseError::fail)?;
        let right = 2.0 / 3.0 * G * pull.max(0.0) * 0.5 / 0.2;
        prop_assert!((omega - right).abs() <= SAME * right.max(1.0), "{omega} {right}\n{text}");
        // what holds is the couple that equilibrium needs
        let couple = last(&text, "moment(K, wheel)").map_err(TestCaseError::fail)?;
        let right = -3.0 * G * (arm * 1e-3 * cos).min(0.2 * sin);
        prop_assert!((couple - right).abs() <= SAME * right.abs(), "{couple} {right}\n{text}");
    }
}

/// A cam that turns on a lever: the couple acts at one position too, and the balance has its power.
#[test]
fn a_driven_contact_has_its_couple_in_a_sweep() {
    let text = |rolling: &str, moment: &str| {
        format!(
            "ground {{ A (0, 0); C (-110 mm, 20 mm) }}
link disc A-O 15 mm {{ circle rim centre O radius 40 mm }}
link lever {{ C (0, 0); P (0, -8 mm); E (200 mm, 0); line face through P along 0 deg; S (80 mm, 5 mm) }}
revolute A: ground - disc
revolute C: ground - lever
contact N: disc.rim - lever.face {{ friction 0.1{rolling} }}
drive disc = 50 deg at 10 rad/s
assemble lever.S near (-30 mm, 70 mm)
force on lever at E = (0, -70 N) in lever
balance torque Mb on disc
find Mb, omega(disc), omega(lever), normal(N, lever){moment}
"
        )
    };
    let (plain, rolling) = (text("", ""), text("; rolling 2 mm", ", moment(N, lever)"));
    let of = |text: &str, quantity: &str| last(text, quantity).unwrap();
    let (normal, couple) = (of(&rolling, "normal(N, lever)"), of(&rolling, "moment(N, lever)"));
    let relative = of(&rolling, "omega(disc)") - of(&rolling, "omega(lever)");
    assert!((couple - 2e-3 * normal * relative.signum()).abs() <= SAME * couple.abs(), "{couple} {normal}");
    // the lever is turned by the couple, so that the normal force is not that of the plain contact
    assert!((of(&rolling, "Mb") - of(&plain, "Mb")).abs() > 1e-3 * couple.abs());
}

/// A wheel whose resistance keeps it from turning slides: the contact does not stick while it does.
#[test]
fn a_wheel_that_does_not_turn_slides() {
    let text = "gravity 9.81 m/s^2
ground { F (0, 0); line floor through F along 0 deg }
link disc { C (0, 0); circle rim centre C radius 0.2 m; mass 3 kg disc centre C radius 0.2 m }
contact K: disc.rim - ground.floor { friction 0.1; rolling 60 mm }
start disc.C = (0, 0.2 m) at (1 m/s, 0)
start disc = 0 deg
event halts: sticks(K)
simulate 0 s .. 0.5 s in 1 steps
find velocity(disc.C).x, omega(disc), moment(K, disc), friction(K, disc), sticks(K)
";
    let solution: Value = serde_json::from_str(&Problem::new("rolling", text).solve_json()).unwrap();
    let last = solution["poses"].as_array().and_then(|poses| poses.last()).unwrap();
    let of = |quantity: &str| last["quantities"][quantity].as_f64().unwrap();
    let weight = 3.0 * G;
    let near =
        |found: f64, right: f64| assert!((found - right).abs() <= SAME * right.abs(), "{found} {right}");
    assert_eq!(last["quantities"]["sticks(K)"].as_bool(), Some(false));
    assert!(of("omega(disc)") == 0.0);
    near(of("velocity(disc.C).x"), 1.0 - 0.1 * G * 0.5);
    near(of("friction(K, disc)"), -0.1 * weight);
    near(of("moment(K, disc)"), 0.1 * weight * 0.2);
}
