//! Freewheels against closed forms: a flywheel that runs on, a backstop, an overload.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

use assur::Problem;
use proptest::prelude::*;
use serde_json::Value;

/// Of the greatest speed.
const SAME: f64 = 1e-9;

/// The values of a quantity at all instants.
fn values(text: &str, quantity: &str) -> Result<Vec<f64>, String> {
    let solution: Value = serde_json::from_str(&Problem::new("freewheel", text).solve_json()).unwrap();
    let poses = solution["poses"].as_array().cloned().unwrap_or_default();
    let found: Option<Vec<f64>> = poses.iter().map(|pose| pose["quantities"][quantity].as_f64()).collect();
    found.filter(|found| !found.is_empty()).ok_or_else(|| format!("{text}{}", solution["diagnostics"]))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 16, ..ProptestConfig::default() })]

    /// Driven for 1 s, braked for 1 s, driven again: the second shaft runs on until the first has caught up. Beyond its capacity it
    /// slips, and the second shaft gets the capacity.
    #[test]
    fn a_flywheel_runs_on_behind_a_freewheel(
        one in 0.05..0.3_f64, two in 0.2..0.8_f64, torque in 2.0..8.0_f64, part in 0.3..3.0_f64, clockwise: bool,
    ) {
        let passed = torque * two / (one + two);
        let capacity = part * passed;
        prop_assume!((part - 1.0).abs() > 1e-3);
        let (sign, word) = if clockwise { (-1.0, " cw") } else { (1.0, "") };
        let drive = sign * torque;
        let text = format!(
            "shaft I {{ inertia {one} kg*m^2 }}
shaft II {{ inertia {two} kg*m^2 }}
clutch k: I - II {{ capacity {capacity} N*m; freewheel{word} }}
torque M on I = {drive} N*m when time < 1 s or time > 2 s
torque B on I = {} N*m when time > 1 s and time < 2 s
start I = 0 deg
start II = 0 deg
simulate 0 s .. 4 s in 4 steps
find omega(I), omega(II)
",
            -drive
        );
        // by hand: accelerations of both while the first drives, alone, and as one
        let through = capacity.min(passed);
        let driving = ((torque - through) / one, through / two);
        let (first, second) = (driving.0, driving.1);
        let mut state = (first, second);
        if first > second {
            // it goes on to slip until the speeds are equal
            let rate = (-(torque + through) / one, through / two);
            let until = (first - second) / (rate.1 - rate.0);
            prop_assume!(until < 0.99);
            state = (first + rate.0 * until, second + rate.1 * until);
            state.0 -= torque / one * (1.0 - until);
        } else {
            state.0 -= torque / one;
        }
        let catches = (state.1 - state.0) * one / torque;
        prop_assume!((catches - 2.0).abs() > 1e-3 && (catches - 1.0).abs() > 1e-3);
        let last = if catches < 2.0 {
            let left = 2.0 - catches;
            (state.1 + driving.0 * left, state.1 + driving.1 * left)
        } else {
            (state.0 + torque / one * 2.0, state.1)
        };
        let scale = last.0.abs().max(state.0.abs());
        for (quantity, right) in [("omega(I)", last.0), ("omega(II)", last.1)] {
            let found = values(&text, quantity).map_err(TestCaseError::fail)?;
            let end = found[found.len() - 1] * sign;
            prop_assert!((end - right).abs() <= SAME * scale, "{quantity}: {end} {right}\n{text}");
        }
    }
}

/// A hoist whose drum may turn up, and is held by its backstop when the load would turn it down.
#[test]
fn a_backstop_holds_a_load_that_has_come_to_rest() {
    let text = "gravity 9.81 m/s^2
shaft D { wheel d radius 100 mm; inertia 0.2 kg*m^2 }
slider L { mass 20 kg }
rope r: d - L
clutch k: ground - D { capacity 100 N*m; freewheel cw }
start D = 0 deg at -3 rad/s
simulate 0 s .. 1 s in 2 steps
find omega(D), moment(k, D)
";
    let torque = 20.0 * 9.81 * 0.1;
    let omega = values(text, "omega(D)").unwrap();
    let moment = values(text, "moment(k, D)").unwrap();
    assert!(omega[0] == -3.0 && moment[0] == 0.0 && omega[2] == 0.0, "{omega:?} {moment:?}");
    assert!((moment[2].abs() - torque).abs() <= SAME * torque, "{moment:?}");
}

/// Two shafts at given speeds: the capacity where the first would be ahead, nothing where the second is.
#[test]
fn a_freewheel_between_driven_shafts_transmits_in_one_sense() {
    let text = |speed: f64| {
        format!(
            "shaft I {{ inertia 0.1 kg*m^2 }}
shaft II {{ inertia 0.4 kg*m^2 }}
clutch k: I - II {{ capacity 100 N*m; freewheel }}
drive I = 0 deg at 10 rad/s
drive II = 0 deg at {speed} rad/s
balance torque M on I
balance torque N on II
find M, N, moment(k, II)
"
        )
    };
    for (speed, right) in [(8.0, 100.0), (10.0, 0.0), (12.0, 0.0)] {
        let of = |quantity: &str| values(&text(speed), quantity).unwrap()[0];
        assert_eq!((of("M"), of("N"), of("moment(k, II)")), (right, -right, right));
    }
}
