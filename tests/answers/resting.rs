//! What friction bears at rest, and events at the corners of loads.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

/// A block on a rough floor, pulled by a spring.
const BLOCK: &str = "gravity 9.81 m/s^2
ground { O (0, 0); W (-1 m, 0); line floor through O along 0 deg }
link block { B (0, 0); mass 1 kg at B }
prismatic P: block.B - ground.floor { friction 0.25 }
spring s: ground.W - block.B { stiffness 100 N/m; free_length 1 m }
start P = 500 mm
simulate 5 s in 50 steps within 1e-10
find x = displacement(P), F = friction(P, block), R = reaction(P, block), held = sticks(P)
";

#[test]
fn a_pair_that_holds_alone_bears_what_is_left() {
    let solution = assur::solve(BLOCK).unwrap();
    let number = |pose: usize, name: &str| solution.poses()[pose][name].number().unwrap();
    let last = solution.poses().len() - 1;
    assert!((number(last, "F") - 100.0 * number(last, "x")).abs() < 1e-9);
    assert!(number(last, "F").abs() > 0.5);
    // at first it begins to slide back: friction is at its limit
    assert!((number(0, "F") - 0.25 * 9.81).abs() < 1e-9, "{}", number(0, "F"));
}

/// A slider-crank that rests by two pairs that rub.
const SHARING: &str = "link crank A-B 60 mm { mass 2 kg at A; inertia 0.03 kg*m^2 }
link rod B-C 210 mm { S (70 mm, 0); mass 0.9 kg at S; inertia 0.006 kg*m^2 }
link piston { C (0, 0); mass 0.7 kg at C }
revolute A: ground - crank
revolute B: crank - rod { friction_circle 20 mm }
revolute C: rod - piston
prismatic D: piston.C - ground.guide { friction 0.5 }
assemble C ahead of B
torque M on crank = 0.3 N*m
start crank = 30 deg
";

#[test]
fn what_several_pairs_share_is_not_determined() {
    let ground = "gravity 9.81 m/s^2\nground { A (0, 0); line guide through A along 0 deg }\n";
    let find = "simulate 1 s in 2 steps
find omega(crank), F = friction(D, piston), T = moment(B, rod), R = mag(reaction(C)), W = friction_work()
";
    let solution = assur::solve(format!("{ground}{SHARING}{find}")).unwrap();
    for pose in solution.poses() {
        assert_eq!(pose["omega(crank)"].number(), Some(0.0));
        assert_eq!(pose["W"].number(), Some(0.0));
        for name in ["F", "T", "R"] {
            assert!(pose[name].number().is_none_or(f64::is_nan), "{name} {:?}", pose[name].number());
        }
    }
}

#[test]
fn what_they_share_leaves_other_chains_alone() {
    // the pendulum next to it is joined to the ground alone
    let ground = "ground { A (0, 0); line guide through A along 0 deg; H (1 m, 1 m) }\n";
    let block = "link pendulum H-P 300 mm { mass 1 kg at P; inertia 0.01 kg*m^2 }
revolute H: ground - pendulum
start pendulum = -40 deg
";
    let end = "gravity 9.81 m/s^2\nsimulate 1 s in 4 steps within 1e-9\n";
    let both = format!("{end}{ground}{SHARING}{block}find R = mag(reaction(C)), Q = reaction(H, pendulum)\n");
    let alone = format!("{end}ground {{ H (1 m, 1 m) }}\n{block}find Q = reaction(H, pendulum)\n");
    let (both, alone) = (assur::solve(&both).unwrap(), assur::solve(&alone).unwrap());
    for (one, other) in both.poses().iter().zip(alone.poses()) {
        assert!(one["R"].number().is_none_or(f64::is_nan));
        let ((x, y), (u, v)) = (one["Q"].vector().unwrap(), other["Q"].vector().unwrap());
        assert!((x - u).abs() + (y - v).abs() < 1e-6, "({x}, {y}) and ({u}, {v})");
    }
}

/// Counts of an event either way, rising and falling, and of the turns: of a block on a spring whose load has a corner there.
fn counts(at: f64, speed: f64, load: usize, within: f64) -> [f64; 4] {
    let load = [
        format!("force F on block at B = (2 N, 0) when displacement(P) > {at} mm"),
        format!(
            "curve c linear held {{\n  s [mm], F [N]\n  0, 3\n  {at}, 1\n  1000, 7\n}}\nforce F on block at B = (c(displacement(P)), 0)"
        ),
        format!("force F on block at B = (min(0 N, -100 N/m*(displacement(P) - {at} mm)), 0)"),
    ][load]
        .clone();
    let text = format!(
        "ground {{ O (0, 0); W (-1 m, 0); line floor through O along 0 deg }}
link block {{ B (0, 0); mass 1 kg at B }}
prismatic P: block.B - ground.floor
spring s: ground.W - block.B {{ stiffness 40 N/m; free_length 1 m; damping 0.3 N*s/m }}
{load}
start P = 0 mm at {speed} m/s
simulate 3 s in 5 steps within {within}
event e: displacement(P) = {at} mm
event r: displacement(P) = {at} mm rising
event f: displacement(P) = {at} mm falling
event t: relative_velocity(P) = 0 m/s
find e = count(e), r = count(r), f = count(f), t = count(t)
"
    );
    let solution = assur::solve(&text).unwrap_or_else(|error| panic!("{error}"));
    ["e", "r", "f", "t"].map(|name| solution.poses()[0][name].number().unwrap())
}

#[test]
fn an_event_at_a_corner_happens_once() {
    let cases =
        [(152.2, 2.43), (95.0, 1.9), (216.947, 1.9), (67.0, 2.95), (76.2, 2.49), (182.0, 1.4), (27.6, 2.26)];
    for (at, speed) in cases {
        for load in 0..3 {
            for within in [1e-4, 1e-6, 1e-9, 1e-11] {
                let [either, rising, falling, turns] = counts(at, speed, load, within);
                let what = format!(
                    "{at} mm at {speed} m/s, load {load}, {within:e}: {either} {rising} {falling} {turns}"
                );
                assert!((either - rising - falling).abs() < 0.5, "{what}");
                assert!((rising - falling).abs() < 1.5 && either <= turns + 1.0, "{what}");
                assert!(rising >= 1.0, "{what}");
            }
        }
    }
}

#[test]
fn clutches_that_share_what_one_could_hold_have_no_torque_of_their_own() {
    let text = "shaft one { inertia 2 kg*m^2 }
shaft two { inertia 5 kg*m^2 }
clutch k: one - two { capacity 40 N*m; slipping }
clutch l: two - one { capacity 20 N*m; slipping }
torque L on one = 10 N*m
start one at 100 rpm
start two at 0 rpm
simulate 4 s in 2 steps
find K = moment(k, two), L_2 = moment(l, two), w = omega(one) as rad/s
";
    let solution = assur::solve(text).unwrap();
    let [first, .., last] = solution.poses() else { panic!("few instants") };
    assert_eq!((first["K"].number(), first["L_2"].number()), (Some(40.0), Some(20.0)));
    for name in ["K", "L_2"] {
        assert!(last[name].number().is_none_or(f64::is_nan), "{name} {:?}", last[name].number());
    }
    // all of the momentum: 2 kg m² at 100 rpm and 10 N m for 4 s
    let w = (2.0 * 100.0 * std::f64::consts::PI / 30.0 + 40.0) / 7.0;
    assert!((last["w"].number().unwrap() - w).abs() < 1e-9 * w);
}

#[test]
fn loads_that_change_places_are_never_both_there() {
    // the brake could not hold both; at 1.5 s the second one acts
    let text = "shaft one
shaft two { inertia 0.5 kg*m^2 }
brake B on two { capacity 60 N*m }
torque on two = -37 N*m when time < 1.5 s
torque on two = -47 N*m when time >= 1.5 s
drive one at 47 rad/s
start two at 0 rad/s
simulate 3 s in 2 steps
find B, w = omega(two)
";
    let solution = assur::solve(text).unwrap();
    let torques = solution.poses().iter().map(|pose| pose["B"].number().unwrap());
    for (torque, right) in torques.zip([37.0, 47.0, 47.0]) {
        assert!((torque - right).abs() < 1e-12 * right, "{torque}, not {right}");
    }
    assert!(solution.poses().iter().all(|pose| pose["w"].number() == Some(0.0)));
}

/// What a closed stop bears is the effort of its free coordinate, 0 while it is open, for slides and hinges.
#[test]
fn the_effort_of_a_bounded_coordinate_is_that_of_its_stop() {
    let text = "gravity 10 m/s^2
ground { O (0, 0); line way through O along 90 deg; H (5 m, 0) }
link b { P (0, 0); mass 2 kg at P }
prismatic G: b.P - ground.way
stop G > 0 mm
link bar H-E 2 m { mass 3 kg rod H to E }
revolute J: ground.H - bar.H
stop J > 0 deg
start G = 190 mm
start bar = 30 deg
simulate 0 s .. 1 s in 10 steps
find e = effort(G), m = effort(J)
";
    let solution = assur::solve(text).unwrap();
    for (index, pose) in solution.poses().iter().enumerate() {
        let [e, m] = ["e", "m"].map(|name| pose[name].number().unwrap());
        let falls = index < 2;
        let right = if falls { [0.0, 0.0] } else { [20.0, m.clamp(0.0, 30.0)] };
        assert!((e - right[0]).abs() < 1e-9 && (m - right[1]).abs() < 1e-9, "{index}: {e} N, {m} N m");
    }
    let last = solution.poses().last().unwrap();
    assert!((last["m"].number().unwrap() - 30.0).abs() < 1e-9);
}
