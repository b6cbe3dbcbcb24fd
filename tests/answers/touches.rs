//! Events of values that only touch theirs: magnitudes, energies, extremes.

use assur::internals::check::Overrides;
use assur::internals::source::Source;
use assur::internals::{Solved, test_source};

fn solved(text: &str) -> Solved {
    let (solved, problems) = test_source(&Source::new("touch.mech", text), &Overrides::none());
    solved.unwrap_or_else(|| panic!("{text}\n{problems:?}"))
}

/// Where the events of a file happen, one list after another: s, or what its drive is in.
fn events(text: &str) -> Vec<Vec<f64>> {
    solved(text).solution.statics.events
}

/// All events happen where the first one does.
#[track_caller]
fn at_once(text: &str, count: usize, within: f64) {
    let all = events(text);
    for (index, times) in all.iter().enumerate() {
        assert_eq!(times.len(), count, "{text}\n{index}: {times:?}, {:?}", all[0]);
        for (t, first) in times.iter().zip(&all[0]) {
            assert!((t - first).abs() < within, "{text}\n{index}: {t} {first}");
        }
    }
}

const REVERSES: &str = "event r: omega(bar) = 0 rad/s
event a: abs(omega(bar)) = 0 rad/s
event b: -abs(omega(bar)) = 0 rad/s
event m: mag(velocity(bar.A)) = 0 m/s
event s: omega(bar)^2 = 0 rad^2/s^2
event k: kinetic_energy() = 0 J
";

fn pendulum(more: &str) -> String {
    format!(
        "gravity 9.81 m/s^2\nground {{ O (0, 0) }}\nlink bar O-A 400 mm {{ mass 3 kg rod O to A }}\nrevolute O: ground - bar\n\
         start bar = 10 deg\nsimulate 0 s .. 3 s\n{REVERSES}find angle(bar)\n{more}\n"
    )
}

#[test]
fn a_magnitude_happens_where_its_value_does() {
    // by energy and quadrature, by DOP853, stiff
    at_once(&pendulum(""), 4, 1e-9);
    at_once(&pendulum("torque D on bar = -0.3 N*m*s*omega(bar)"), 5, 1e-9);
    at_once(&pendulum("torque D on bar = -0.0001 N*m*s*omega(bar)"), 4, 1e-9);
    let stiff = "link tip A-B 1 mm { mass 0.001 kg rod A to B }\nrevolute A: bar - tip\nstart A = 0 deg
spring t in A { stiffness 2000 N*m/rad; free_angle 0 deg; damping 20 N*m*s/rad }";
    let without_energy = pendulum(stiff).replace("event k: kinetic_energy() = 0 J\n", "");
    at_once(&without_energy, 4, 1e-8);
}

#[test]
fn the_place_it_started_from_is_reached_again() {
    let text = pendulum("event back: angle(bar) = 10 deg\nevent rises: angle(bar) = 10 deg rising");
    let all = events(&text);
    let [.., back, rises] = all.as_slice() else { panic!("{all:?}") };
    let wanted = [all[0][1], all[0][3]];
    for found in [back, rises] {
        assert!(found.len() == 2 && (found[0] - wanted[0]).abs() < 1e-7, "{found:?} {wanted:?}");
    }
    // with friction it is not reached
    let damped = text.replace("find", "torque D on bar = -0.001 N*m*s*omega(bar)\nfind");
    assert!(events(&damped)[6].is_empty());
}

#[test]
fn what_rests_touches_nothing() {
    let text = pendulum("torque D on bar = -40 N*m*s*omega(bar)").replace("10 deg", "-89.9 deg");
    assert!(events(&text.replace("3 s", "200 s")).iter().all(Vec::is_empty));
}

fn yoke(drive: &str, more: &str) -> Vec<Vec<f64>> {
    events(&format!(
        "ground {{ A (0, 0); line way through A along 0 deg }}\nlink crank A-B 50 mm\n\
         link yoke {{ C (0, 0); line slot through C along 90 deg }}\nrevolute A: ground - crank\n\
         slot K: crank.B - yoke.slot\nprismatic D: yoke.C - ground.way\ndrive crank = {drive} at 600 rpm\n{more}\nfind displacement(D)\n"
    ))
}

#[test]
fn a_sweep_touches_inside_and_at_its_end() {
    let degrees =
        |found: &[f64]| found.iter().map(|x| (x.to_degrees() * 1e6).round() / 1e6).collect::<Vec<_>>();
    let most = "event c: displacement(D) = 50 mm\nevent m: abs(velocity(yoke.C).x) = 0 m/s";
    for (drive, tops, rests) in [
        ("0 deg .. 720 deg in 8 steps", vec![360.0, 720.0], vec![180.0, 360.0, 540.0, 720.0]),
        ("0 deg .. 720 deg in 7 steps", vec![360.0, 720.0], vec![180.0, 360.0, 540.0, 720.0]),
        ("17 deg .. 721 deg in 4 steps", vec![360.0, 720.0], vec![180.0, 360.0, 540.0, 720.0]),
        ("10 deg .. 360 deg in 5 steps", vec![360.0], vec![180.0, 360.0]),
        ("350 deg .. -10 deg in 3 steps", vec![0.0], vec![180.0, 0.0]),
        ("0 deg .. -720 deg in 11 steps", vec![-360.0, -720.0], vec![-180.0, -360.0, -540.0, -720.0]),
    ] {
        let found = yoke(drive, most);
        assert_eq!(degrees(&found[0]), tops, "{drive}");
        assert_eq!(degrees(&found[1]), rests, "{drive}");
    }
    // a strict condition is not met there, and what turns before is not reached
    let none = yoke(
        "10 deg .. 700 deg in 8 steps",
        "event c: displacement(D) > 50 mm\nevent d: displacement(D) = 50.000001 mm",
    );
    assert!(none.iter().all(Vec::is_empty), "{none:?}");
}

#[test]
fn a_drive_that_time_gives_touches_too() {
    let text = "ground { A (0, 0) }\nlink crank A-B 50 mm\nrevolute A: ground - crank\ndrive crank = 1 rad*sin(2 rad/s*time)
simulate 0 s .. 7 s\nevent r: omega(crank) = 0 rad/s\nevent top: abs(angle(crank)) = 1 rad\nevent m: mag(velocity(B)) = 0 m/s
find angle(crank)\n";
    at_once(text, 4, 1e-9);
}
