//! Near the limit of self-locking: on which side of it a mechanism is, and `critical(…)`, against closed forms.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]

use super::masses::within;
use super::quick_rows::random;
use std::f64::consts::FRAC_PI_2;

fn first(text: &str, name: &str) -> f64 {
    let solution = assur::solve(text).unwrap_or_else(|e| panic!("{text}\n{e}"));
    solution.poses()[0][name].number().unwrap_or(f64::NAN)
}

fn is_locked(text: &str) -> bool {
    first(&format!("{text}find efficiency()\n"), "efficiency()") <= 0.0
}

/// A body that is pushed up a plane by a level force.
fn wedge(slope: f64, friction: f64) -> String {
    format!(
        "ground {{ O (0, 0); line plane through O along {slope:?} rad }}\nlink body {{ B (0, 0) }}\n\
         prismatic P: body.B - ground.plane {{ friction {friction:?} }}\ndrive P = 0 m moving forward\n\
         force on body at B = 93 N @ 270 deg\nbalance force F on body at B along 0 deg\n"
    )
}

/// A lever whose effort passes its bearing at a small angle to it.
fn lever(radius: f64, friction: f64, length: f64, angle: f64) -> String {
    format!(
        "ground {{ O (0, 0) }}\nlink bar O-A {length:?} m\nrevolute O: ground - bar {{ radius {radius:?} m; friction {friction:?} }}\n\
         drive bar = 0 deg turning ccw\ntorque on bar = -3 N*m\nbalance force F on bar at A along {angle:?} rad\n"
    )
}

/// A drawer that is pushed beside its middle.
fn drawer(length: f64, friction: f64, beside: f64) -> String {
    format!(
        "ground {{ O (0, 0); line way through O along 0 deg }}\nlink box {{ B (0, 0); H (0, {beside:?} m) }}\n\
         prismatic P: box.B - ground.way {{ friction {friction:?}; contacts {:?} m, {:?} m }}\ndrive P = 0 m moving forward\n\
         force on box at B = -40 N @ 0 deg\nbalance force F on box at H along 0 deg\n",
        -0.5 * length,
        0.5 * length
    )
}

#[test]
fn both_sides_of_the_limit_are_told_to_the_digits_of_the_data() {
    let mut state = 5;
    for digits in 6..=12 {
        let near = 10_f64.powi(-digits);
        for _ in 0..4 {
            let (slope, length) = (within(&mut state, 0.1, 1.2), within(&mut state, 0.1, 0.4));
            let (radius, friction) = (within(&mut state, 0.02, 0.05), 0.1 + 0.5 * random(&mut state));
            for (side, locks) in [(near, true), (-near, false)] {
                let steep = (FRAC_PI_2 - slope).tan() * (1.0 + side);
                assert_eq!(is_locked(&wedge(slope, steep)), locks, "{slope} {side}");
                let angle = (radius * friction / length * (1.0 - side)).asin();
                assert_eq!(is_locked(&lever(radius, friction, length, angle)), locks, "{angle} {side}");
                let beside = 0.5 * length / friction * (1.0 + side);
                assert_eq!(is_locked(&drawer(length, friction, beside)), locks, "{beside} {side}");
            }
        }
    }
}

#[test]
fn the_effort_near_the_limit_has_the_digits_that_are_left() {
    // F = W (tan α + f)/(1 − f tan α)
    let (slope, f): (f64, f64) = (0.306_917_106_903_981_9, 3.155_254_517_572_815);
    let text = wedge(slope, f) + "find F, locked()\n";
    let wanted = 93.0 * (slope.sin() + f * slope.cos()) / (slope.cos() - f * slope.sin());
    let found = first(&text, "F");
    assert!((found / wanted - 1.0).abs() < 1e-6, "{found} {wanted}");
}

fn press(turning: &str, phi: f64) -> String {
    format!(
        "given phi = {phi} deg\nground {{ A (0, 0); line way through A along 0 deg }}\nlink crank A-B 60 mm\nlink rod B-C 200 mm\n\
         link ram {{ C (0, 0) }}\nrevolute A: ground - crank {{ radius 20 mm; friction 0.1 }}\n\
         revolute B: crank - rod {{ radius 25 mm; friction 0.12 }}\nrevolute C: rod - ram {{ radius 15 mm; friction 0.1; fit even }}\n\
         prismatic D: ram.C - ground.way {{ friction 0.15 }}\ndrive crank = phi turning {turning}\nassemble C ahead of B\n\
         balance torque M on crank\nforce P on ram at C = 1 kN @ 180 deg\n"
    )
}

fn critical(text: &str) -> f64 {
    let source = assur::internals::source::Source::new("press.mech", format!("{text}find critical(phi)\n"));
    let (solved, _) = assur::internals::solve_source(&source, &assur::internals::check::Overrides::none());
    let found = solved.map_or(f64::NAN, |s| s.solution.statics.criticals[0]);
    found.to_degrees()
}

#[test]
fn locking_begins_where_the_ideal_effort_changes_its_sign() {
    // by the law of sines M without friction is zero in both dead positions
    for phi in [80.0, 60.0, 45.0, 20.0, 5.0, 0.5] {
        let found = critical(&press("cw", phi));
        assert!(found.abs() < 1e-9, "{phi}: {found}");
    }
    for phi in [170.0, 135.0] {
        let found = critical(&press("cw", phi));
        assert!((found - 180.0).abs() < 1e-9, "{phi}: {found}");
    }
    // from within the range that locks the nearer of its ends: beyond the other one the load drives
    let end = critical(&press("cw", -14.0));
    let at = |phi: f64| first(&format!("{}find efficiency()\n", press("cw", phi)), "efficiency()");
    assert!((-14.0..0.0).contains(&end) && at(end - 1e-6) > 0.0 && at(end + 1e-6) < 0.0, "{end}");
    assert!(critical(&press("cw", -0.5)).abs() < 1e-9);
    // nothing locks where nothing rubs
    let smooth =
        press("cw", 45.0).replace("friction 0.1 ", "friction 0 ").replace("friction 0.12", "friction 0");
    let smooth = smooth.replace("friction 0.15", "friction 0").replace("friction 0.1;", "friction 0;");
    assert!(critical(&smooth).is_nan());
}

/// Where the ideal power passes zero the efficiency has a pole: its least value is not bounded, its greatest is that of fine sweeps.
#[test]
fn the_greatest_efficiency_is_found_beside_a_pole() {
    let text = |steps: usize, find: &str| {
        format!(
            "ground {{ O (0, 0); line way through O along 0 deg }}
link crank O-A 100 mm
link rod A-B 300 mm
link slider {{ B (0, 0) }}
revolute O: ground - crank
revolute A: crank - rod {{ friction 0.1; radius 20 mm }}
revolute B: rod - slider {{ friction 0.1; radius 20 mm }}
prismatic G: slider.B - ground.way {{ friction 0.15 }}
drive crank = 0 deg .. 360 deg in {steps} steps at 100 rpm
assemble B ahead of A
force F on slider at B = (-1000 N, 0)
balance torque M on crank
find {find}
"
        )
    };
    let whole = assur::solve(text(24, "max(efficiency())")).unwrap();
    let most = whole.poses()[0]["max(efficiency())"].number().unwrap();
    let swept = assur::solve(text(3600, "efficiency()")).unwrap();
    let values = swept.poses().iter().map(|pose| pose["efficiency()"].number().unwrap());
    let greatest = values.fold(0.0, f64::max);
    assert!((0.0..1e-6).contains(&(most - greatest)), "{most} {greatest}");
}
