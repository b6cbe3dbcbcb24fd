//! Motions end where a clutch or a belt would slip, and where a belt with a slip would be driven backwards, also between the instants
//! that are printed.

#![allow(clippy::unwrap_used)] // a test without its run has failed

use assur::internals::check::Overrides;
use assur::internals::solve_source;
use assur::internals::source::Source;

/// The last instant of a motion, s, and whether it ended with an error.
fn end(text: &str) -> (f64, bool) {
    let (solved, problems) = solve_source(&Source::new("bonds.mech", text), &Overrides::none());
    let opens = problems.has("mech::simulate::opens");
    assert_eq!(opens, problems.has_errors(), "{problems:?}");
    // what does not begin has no solution
    (solved.map_or(0.0, |solved| solved.solution.simulation.as_ref().unwrap().end), opens)
}

const SHOCK: &str = "shaft motor { wheel w1 diameter 100 mm; inertia 0.05 kg*m^2 }
shaft fan { wheel w2 diameter 200 mm; inertia 0.5 kg*m^2 }
torque M on motor = 5 N*m + 40 N*m*exp(-((time - 0.25 s)/(0.02 s))^2)
start motor at 100 rpm
simulate 1 s in 2 steps
find omega(fan)
";

/// When the shock has reached a torque, s.
fn reached(torque: f64) -> f64 {
    0.25 - 0.02 * libm::log(40.0 / (torque - 5.0)).sqrt()
}

#[test]
fn a_clutch_that_would_slip_ends_the_motion() {
    let text = format!("{SHOCK}clutch k: motor - fan {{ capacity 10 N*m }}\n");
    // the fan gets ten parts of eleven
    let (when, opens) = end(&text);
    assert!(opens && (when - reached(11.0)).abs() < 1e-11, "{when}");
    let until = text + "until abs(moment(k, motor)) > capacity(k)\n";
    let (when, opens) = end(&until);
    assert!(!opens && (when - reached(11.0)).abs() < 1e-11, "{when}");
    let firm = format!("{SHOCK}clutch k: motor - fan {{ capacity 41 N*m }}\n");
    assert_eq!(end(&firm), (1.0, false));
}

#[test]
fn a_belt_that_would_slip_ends_the_motion() {
    let (friction, wrap, pretension) = (0.3, 165_f64.to_radians(), 250.0);
    let text = format!(
        "{SHOCK}belt b: w1 - w2 {{ friction {friction}; wrap {wrap} rad; pretension {pretension} N }}\n"
    );
    let ratio = libm::exp(friction * wrap);
    let capacity = 2.0 * pretension * (ratio - 1.0) / (ratio + 1.0);
    // reduced to the motor the fan has 0.125 of 0.175 kg m²
    let torque = 0.05 * capacity * 0.175 / 0.125;
    let (when, opens) = end(&text);
    assert!(opens && (when - reached(torque)).abs() < 1e-11, "{when}");
}

#[test]
fn a_belt_with_a_slip_is_not_driven_backwards() {
    let braked = SHOCK.replace("5 N*m + 40 N*m*exp(-((time - 0.25 s)/(0.02 s))^2)", "10 N*m - 40 N*m/s*time");
    let (when, opens) = end(&format!("{braked}belt b: w1 - w2 {{ slip 2 % }}\n"));
    assert!(opens && (when - 0.25).abs() < 1e-11, "{when}");
    assert_eq!(end(&format!("{braked}belt b: w1 - w2 {{ efficiency 0.98 }}\n")), (1.0, false));
    // from the first instant on
    let at_once = braked.replace("10 N*m - 40 N*m/s*time", "-10 N*m");
    assert_eq!(end(&format!("{at_once}belt b: w1 - w2 {{ slip 2 % }}\n")), (0.0, true));
    // the fan drives, until the motor turns back with it
    let (when, opens) = end(&format!("{at_once}belt b: w2 - w1 {{ slip 2 % }}\n"));
    let ratio = 0.5 / 0.98;
    let reduced = 0.05 + 0.5 * ratio * ratio * 0.98;
    let stops = reduced * 100.0 * std::f64::consts::PI / 30.0 / 10.0;
    assert!(opens && (when - stops).abs() < 1e-9, "{when} {stops}");
}
