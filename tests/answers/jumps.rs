//! Values that jump in a motion under loads, and rates that something keeps zero for a while.

/// The numbers of a file's answers over the whole motion, by name.
fn whole(text: &str, names: &[&str]) -> Vec<f64> {
    let solution = assur::solve(text).unwrap_or_else(|e| panic!("{e:?}"));
    let pose = &solution.poses()[0];
    names.iter().map(|name| pose[*name].number().unwrap_or(f64::NAN)).collect()
}

fn near(found: f64, wanted: f64) {
    assert!((found - wanted).abs() < 1e-8 * wanted.abs().max(1.0), "{found}, wanted {wanted}");
}

#[test]
fn extremes_count_both_sides_of_an_impact() {
    let text = "gravity 9.81 m/s^2
ground { O (0, 0); line way through O along 90 deg }
link ball { P (0, 0); mass 1 kg at P }
prismatic G: ball.P - ground.way
stop G > 0 mm { restitution 0.5 }
start G = 1 m
simulate 0.7 s
event hit: displacement(G) = 0 mm
find a = min(relative_velocity(G)), b = max(relative_velocity(G))
find c = max(relative_velocity(G), before = time(hit)), d = max(relative_velocity(G), after = time(hit))
find e = min(relative_velocity(G), before = time(hit)), f = min(relative_velocity(G), after = time(hit))
";
    let v = (2.0 * 9.81_f64).sqrt();
    let last = 0.5 * v - 9.81 * (0.7 - v / 9.81);
    let found = whole(text, &["a", "b", "c", "d", "e", "f"]);
    for (found, wanted) in found.into_iter().zip([-v, 0.5 * v, 0.0, 0.5 * v, -v, last]) {
        near(found, wanted);
    }
}

#[test]
fn extremes_count_both_sides_of_conditions_and_of_friction() {
    let text = "ground { O (0, 0); line way through O along 0 deg }
link ball { P (0, 0); mass 1 kg at P }
prismatic G: ball.P - ground.way
force F on ball at P = (10 N/s*time, 0 N) when time < 0.5 s
force H on ball at P = (7 N, 0 N) when relative_velocity(G) > 0.3 m/s
start G = 0 m
simulate 1 s
find a = max(mag(F)), b = argmax(mag(F)), c = max(relative_acceleration(G)), d = min(relative_acceleration(G), after = 0.4 s)
";
    let found = whole(text, &["a", "b", "c", "d"]);
    for (found, wanted) in found.into_iter().zip([5.0, 0.5, 12.0, 7.0]) {
        near(found, wanted);
    }
    // it turns back at 1 m - (0.3 m - 2*0.01962 m), where friction changes over
    let text = "gravity 9.81 m/s^2
ground { O (0, 0); line way through O along 0 deg }
link ball { P (0, 0); mass 1 kg at P }
prismatic G: ball.P - ground.way { friction 0.1 }
spring k: ball.P - ground.O { stiffness 50 N/m; free_length 1 m }
start G = 1.3 m
simulate 0.5 s
find a = max(relative_acceleration(G)), b = min(friction(G, ball)), c = max(friction(G, ball))
";
    let found = whole(text, &["a", "b", "c"]);
    let turned = 0.3 - 2.0 * 0.1 * 9.81 / 50.0;
    for (found, wanted) in found.into_iter().zip([50.0 * turned + 0.981, -0.981, 0.981]) {
        near(found, wanted);
    }
}

/// A five-bar whose middle hinge comes to a stop, rests there and leaves it.
fn five_bar(simulate: &str) -> String {
    let bars = "gravity 9.81 m/s^2
ground { A (0, 0); E (0.5 m, 0) }
link a A-B 250 mm { S (125 mm, 0); mass 2 kg at S; inertia 0.01 kg*m^2 }
link b B-C 400 mm { T (200 mm, 0); mass 2 kg at T; inertia 0.01 kg*m^2 }
link c C-D 400 mm { U (200 mm, 0); mass 2 kg at U; inertia 0.01 kg*m^2 }
link d E-D 250 mm { V (125 mm, 0); mass 2 kg at V; inertia 0.01 kg*m^2 }
revolute A: ground - a
revolute B: a - b
revolute C: b - c
revolute D: c - d
revolute E: ground - d
assemble C left of B-D
stop C < 150 deg
start a = 100 deg
start d = 70 deg
event turns: relative_velocity(C) = 0 rad/s
find v = relative_velocity(C), lies = rests(C), n = count(turns)
";
    format!("{bars}{simulate}\n")
}

#[test]
fn a_rate_that_a_stop_keeps_zero_is_not_passed_where_it_opens() {
    let solution = assur::solve(five_bar("simulate 1 s in 2000 steps")).unwrap_or_else(|e| panic!("{e:?}"));
    let (mut turns, mut rested, mut before) = (0, 0, 0.0_f64);
    for pose in solution.poses() {
        let v = pose["v"].number().unwrap_or(f64::NAN);
        assert!(v.is_finite());
        if v.abs() < 1e-9 {
            rested += 1;
            // from a rest it goes on in whatever sense
            before = 0.0;
            continue;
        }
        turns += u32::from(v * before < 0.0);
        before = v;
    }
    assert!(rested > 20, "{rested}");
    near(solution.poses()[0]["n"].number().unwrap_or(f64::NAN), f64::from(turns));
}
