//! The angle of a spring in a hinge: as the drive is written, else within half a turn at the first pose, then followed.

const FOUR_BAR: &str = "ground { A (0, 0); D (300 mm, 0) }
link crank A-B 100 mm
link coupler B-C 250 mm
link rocker D-C 200 mm
revolute A: ground - crank
revolute B: crank - coupler
revolute C: coupler - rocker
revolute D: ground - rocker
assemble C left of B-D
spring k in B { stiffness 1 N*m/rad; free_angle 20 deg }
";

/// An arm on a crank, both driven.
const ARM: &str = "ground { A (0, 0) }
link crank A-B 100 mm
link arm B-C 250 mm
revolute A: ground - crank
revolute B: crank - arm
spring k in B { stiffness 1 N*m/rad; free_angle 20 deg }
";

/// The values of an answer at the poses, rad or N m.
fn values(text: &str, name: &str) -> Vec<f64> {
    let solution = assur::solve(text).unwrap_or_else(|e| panic!("{e}"));
    solution.poses().iter().map(|pose| pose[name].number().unwrap_or(f64::NAN)).collect()
}

#[track_caller]
fn near(found: f64, wanted: f64) {
    assert!((found - wanted).abs() < 1e-9, "{found} is not {wanted}");
}

fn arm(crank: &str, hinge: &str, name: &str) -> Vec<f64> {
    values(&format!("{ARM}drive crank = {crank}\ndrive B = {hinge}\nfind displacement(B), effort(B)\n"), name)
}

fn four_bar(crank: &str, name: &str) -> Vec<f64> {
    let asked = "find displacement(B), displacement(C), effort(crank)";
    values(&format!("{FOUR_BAR}drive crank = {crank}\n{asked}\n"), name)
}

#[test]
fn a_driven_hinge_has_the_angle_of_its_drive() {
    for crank in ["0 deg", "170 deg", "190 deg", "-175 deg", "350 deg", "730 deg"] {
        for (hinge, degrees) in [("50 deg", 50.0), ("-200 deg", -200.0), ("400 deg", 400.0)] {
            near(arm(crank, hinge, "displacement(B)")[0], degrees);
            // the drive holds against the spring: k (φ − φ₀)
            near(arm(crank, hinge, "effort(B)")[0], f64::to_radians(degrees - 20.0));
        }
    }
}

#[test]
fn a_driven_hinge_counts_its_turns_over_a_sweep() {
    let angles = arm("170 deg", "150 deg .. 510 deg in 12 steps", "displacement(B)");
    let efforts = arm("170 deg", "150 deg .. 510 deg in 12 steps", "effort(B)");
    for (i, (angle, effort)) in angles.iter().zip(efforts).enumerate() {
        let degrees = 150.0 + 30.0 * f64::from(u32::try_from(i).unwrap_or_default());
        near(*angle, degrees);
        near(effort, f64::to_radians(degrees - 20.0));
    }
    assert_eq!(angles.len(), 13);
}

/// The angle from crank to coupler by the circles about B and D, degrees within half a turn, C left of B–D.
fn between(crank: f64) -> f64 {
    let (x, y) = (100.0 * libm::cos(crank.to_radians()), 100.0 * libm::sin(crank.to_radians()));
    let (dx, dy) = (300.0 - x, -y);
    let apart = libm::hypot(dx, dy);
    let cosine = (apart * apart + 250.0 * 250.0 - 200.0 * 200.0) / (2.0 * apart * 250.0);
    let angle = (libm::atan2(dy, dx) + libm::acos(cosine)).to_degrees() - crank;
    angle - 360.0 * (angle / 360.0).round()
}

#[test]
fn a_hinge_begins_within_half_a_turn() {
    for crank in [0.0, 90.0, 190.0, 200.0, 260.0, 350.0, -10.0, 370.0, 710.0] {
        let [angle, effort] =
            ["displacement(B)", "effort(crank)"].map(|name| four_bar(&format!("{crank} deg"), name)[0]);
        near(angle, between(crank));
        // the virtual power of drive and spring: M dα + k (φ₀ − φ) dφ = 0
        let step = 1e-4;
        let rate = (between(crank + step) - between(crank - step)) / (2.0 * step);
        assert!((effort - f64::to_radians(angle - 20.0) * rate).abs() < 1e-6, "{crank}: {effort}");
    }
}

#[test]
fn a_hinge_is_followed_from_there() {
    // from 350 deg on, through the turn of the crank and through ±180 deg of the hinge
    let found = four_bar("350 deg .. 1070 deg step 10 deg", "displacement(B)");
    let mut wanted = between(350.0);
    for (i, angle) in found.iter().enumerate() {
        let here = between(350.0 + 10.0 * f64::from(u32::try_from(i).unwrap_or_default()));
        wanted = here + 360.0 * ((wanted - here) / 360.0).round();
        near(*angle, wanted);
    }
    // a whole turn of the crank against the coupler winds the spring by a turn
    near(found[36] - found[0], -360.0);
    assert_eq!(found.len(), 73);
    assert!(found.iter().any(|angle| *angle < -500.0));
}

#[test]
fn a_named_pose_is_followed_from_the_sweep() {
    let text = format!(
        "{FOUR_BAR}drive crank = 0 deg .. 400 deg step 50 deg\npose q at crank = 355 deg\nfind displacement(B)\n"
    );
    let found = values(&text, "displacement(B)");
    near(found[found.len() - 1], between(355.0) - 360.0);
}

#[test]
fn the_travel_of_a_hinge_does_not_depend_on_the_first_pose() {
    // the rocker goes through 180 deg
    let bars = FOUR_BAR.replace("D (300 mm, 0)", "D (126.785 mm, 271.892 mm)");
    let travels =
        |crank: &str| values(&format!("{bars}drive crank = {crank}\nfind travel(D)\n"), "travel(D)");
    let from_the_side = travels("-10 deg .. 300 deg in 31 steps");
    let from_above = travels("60 deg .. 300 deg in 24 steps");
    for (a, b) in from_the_side[7..].iter().zip(&from_above) {
        near(*a, *b);
        assert!((0.0..61.0).contains(b), "{b}");
    }
}

/// An arm that is driven, with something that acts on it.
fn poses(what: &str) -> Vec<f64> {
    let arm = "ground { O (0, 0) }\nlink arm O-A 100 mm { mass 1 kg at A }\nrevolute O: ground - arm\ngravity 9.81 m/s^2\n";
    let drive = "drive arm = 0 deg .. 720 deg in 8 steps at 1 rad/s\nbalance torque M on arm\nfind M\n";
    values(&format!("{arm}{drive}{what}\n"), "M")
}

#[test]
fn a_pose_that_whole_turns_change_is_not_left_out() {
    let weight = 9.81 * 0.1;
    let wound = poses("spring s in O { stiffness 2 N*m/rad; free_angle 0 deg }");
    assert_eq!(wound.len(), 9);
    near(wound[8], weight + 8.0 * std::f64::consts::PI);
    // a load by the drive's own value, through a quantity of the file
    let by_angle = poses("let more = 0.5 N*m*angle(arm)/(1 rad)\ntorque T on arm = -more");
    near(by_angle[8], weight + 2.0 * std::f64::consts::PI);
    // what comes again is the first pose
    for again in [
        "",
        "torque T on arm = 3 N*m*sin(angle(arm))",
        // it jumps at the first pose
        "torque T on arm = 3 N*m when sin(angle(arm)) > 0",
        "torque T on arm = 3 N*m*cos(angle(arm)/2)^2",
        "spring s in O { damping 2 N*m*s/rad }",
        "spring s: arm.A - ground.O { stiffness 10 N/m; free_length 10 mm }",
    ] {
        assert_eq!(poses(again).len(), 8, "{again}");
    }
}

#[test]
fn a_rack_that_goes_on_is_at_another_place() {
    let rack = "ground { O (0, 0); Q (0, -50 mm); line way through Q along 0 deg }
link gear { O (0, 0); wheel w radius 50 mm at O }
link bar { Q (0, 0); line top through Q along 0 deg }
revolute O: ground - gear
prismatic P: bar.Q - ground.way
rack k: w - bar.top
drive gear = 0 deg .. 360 deg in 4 steps
find displacement(P)
";
    let hoist = "shaft drum { wheel d radius 50 mm }
slider load { mass 20 kg }
rope r: load - d
drive drum = 0 deg .. 360 deg in 4 steps
find displacement(load)
";
    for (text, name) in [(rack, "displacement(P)"), (hoist, "displacement(load)")] {
        let places = values(text, name);
        assert_eq!(places.len(), 5, "{places:?}");
        near(places[4] / places[1], 4.0);
    }
    // a wheel that turns is as it was, whatever the ratio
    let wheels = "shaft one { wheel a teeth 20 }\nshaft two { wheel b teeth 37 }\nmesh m: a - b\ndrive one = 0 deg .. 360 deg in 4 steps\nfind angle(two)\n";
    assert_eq!(values(wheels, "angle(two)").len(), 4);
}

/// The value of an answer at the first pose.
fn first(text: &str, name: &str) -> f64 {
    values(text, name)[0]
}

#[test]
fn a_damper_in_a_hinge_at_rest_is_nothing() {
    let arms = "gravity 9.81 m/s^2
ground { O (0, 0) }
link b1 O-A 300 mm { mass 2 kg rod O to A }
link b2 A-B 250 mm { mass 1.2 kg rod A to B }
revolute O: ground - b1
revolute A: b1 - b2
spring s1 in O { stiffness 12 N*m/rad; free_angle 60 deg; damping 0.1 N*m*s/rad }
spring s2 in A { stiffness 5 N*m/rad; free_angle -30 deg; damping 0.2 N*m*s/rad }
";
    let text = format!(
        "{arms}equilibrium b1 near 50 deg, b2 near 20 deg\nfind angle(b1), angle(b2), damping_ratio(1)\n"
    );
    let [a, b] = ["angle(b1)", "angle(b2)"].map(|name| first(&text, name).to_radians());
    let elbow = 5.0 * (f64::to_radians(-30.0) - (b - a));
    let shoulder = 12.0 * (f64::to_radians(60.0) - a) - elbow;
    assert!((elbow - 1.2 * 9.81 * 0.125 * libm::cos(b)).abs() < 1e-9, "{elbow}");
    assert!((shoulder - (2.0 * 0.15 + 1.2 * 0.3) * 9.81 * libm::cos(a)).abs() < 1e-9, "{shoulder}");
    // they still act in the vibrations about it
    let without = text.replace("; damping 0.2 N*m*s/rad", "").replace("; damping 0.1 N*m*s/rad", "");
    assert!(first(&text, "damping_ratio(1)") > 0.01);
    near(first(&without, "angle(b1)"), a.to_degrees());
    // held by drives, and the file is told that dampers are left out
    let held = format!("{arms}drive b1 = 25 deg\ndrive b2 = -20 deg\nfind effort(b1)\n");
    let still = first(
        &held.replace("; damping 0.2 N*m*s/rad", "").replace("; damping 0.1 N*m*s/rad", ""),
        "effort(b1)",
    );
    near(first(&held, "effort(b1)"), still);
    let source = assur::internals::source::Source::new("held.mech", held);
    let (_, problems) = assur::internals::test_source(&source, &assur::internals::check::Overrides::none());
    let text =
        assur::internals::diagnostic::render(&problems, &source, assur::internals::diagnostic::Style::PLAIN);
    assert!(text.contains("mech::request::no_damping"), "{text}");
    // a load of the file's own that names a speed still needs one
    let own = format!(
        "{arms}torque T on b1 = -0.3 N*m*s*omega(b1)\nequilibrium b1 near 50 deg, b2 near 20 deg\nfind angle(b1)\n"
    );
    assert!(assur::solve(&own).is_err());
}
