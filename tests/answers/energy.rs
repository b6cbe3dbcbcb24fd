//! The method of energy where what acts depends on angles that are followed, or where a group starts from where it stands: beside the
//! general method.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::solve::{IntegrationOptions, Method};
use assur::internals::source::Source;
use assur::internals::{compile, pipeline};
use std::path::Path;

const FOUR_BAR: &str = "
gravity 9.81 m/s^2
ground { A (0, 0); D (300 mm, 0); T (100 mm, 300 mm) }
link crank A-B 100 mm { mass 1 kg at B; inertia 0.02 kg*m^2 }
link coupler B-C 250 mm { S (120 mm, 30 mm); mass 0.5 kg at S; inertia 0.004 kg*m^2 }
link rocker D-C 200 mm { mass 0.8 kg at C; inertia 0.01 kg*m^2 }
revolute A: ground - crank
revolute B: crank - coupler
revolute C: coupler - rocker
revolute D: ground - rocker
assemble C left of B-D
";

const SUN: &str = "
gravity 9.81 m/s^2
ground { O (0, 0); line guide through O along 90 deg }
link arm O-A 200 mm { mass 2 kg at A; inertia 0.05 kg*m^2 }
link rod A-B 600 mm { wheel planet radius 100 mm at A; S (250 mm, 0); mass 3 kg at S; inertia 0.1 kg*m^2 }
link head { B (0, 0); mass 1.5 kg at B }
link sun { O (0, 0); wheel s radius 100 mm at O; mass 4 kg at O; inertia 0.04 kg*m^2 }
revolute O: ground - arm - sun
revolute A: arm - rod
revolute B: rod - head
prismatic D: head.B - ground.guide
mesh k: planet - s
assemble B ahead of O
";

fn solved(text: &str, method: Option<Method>) -> Solved {
    let (compiled, problems) = compile(&Source::new("run.mech", text), &Overrides::none());
    let compiled = compiled.unwrap_or_else(|| panic!("{problems:?}"));
    let conduct = IntegrationOptions { method, ..IntegrationOptions::default() };
    let (solved, problems) = pipeline::solve_conducted(compiled, None, &conduct);
    assert!(!problems.has_errors(), "{problems:?}");
    solved.unwrap_or_else(|_| panic!("{text} moves"))
}

/// Angles with their whole turns, and angular velocities, at all instants.
fn course(solved: &Solved) -> Vec<(f64, f64)> {
    let poses = solved.solution.poses.iter().map(|pose| pose.outcome.as_ref().unwrap());
    let each = poses.flat_map(|found| {
        let bodies = found.state.motion.bodies.iter().map(|body| body.omega);
        found.angles.clone().into_iter().zip(bodies).collect::<Vec<_>>()
    });
    each.collect()
}

/// By how many turns the angle of the body of a slot varies.
fn turns(solved: &Solved, body: usize) -> f64 {
    let angles = solved.solution.poses.iter().map(|pose| pose.outcome.as_ref().unwrap().angles[body]);
    let range = angles.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    (range.1 - range.0) / std::f64::consts::TAU
}

/// Solves by energy and by the general method.
fn both(text: &str) -> Solved {
    let (own, general) = (solved(text, None), solved(text, Some(Method::Dop853)));
    let of = |solved: &Solved| {
        let report = solved.solution.simulation.as_ref().unwrap();
        (report.method, report.printed)
    };
    let ((method, cost), (other, general_cost)) = (of(&own), of(&general));
    assert_eq!((method, other), (Method::Energy, Method::Dop853), "{text}");
    assert!(cost < general_cost, "{cost} {general_cost} {text}");
    let (a, b) = (course(&own), course(&general));
    let fastest = b.iter().map(|each| each.1.abs()).fold(1.0, f64::max);
    assert_eq!(a.len(), b.len());
    for (a, b) in a.iter().zip(&b) {
        let near = (a.0 - b.0).abs() < 2e-9 && (a.1 - b.1).abs() < 2e-9 * fastest;
        assert!(near, "{a:?} {b:?} {text}");
    }
    own
}

#[test]
fn a_hairspring_is_wound_up_by_many_turns() {
    let text = "ground { A (0, 0) }
link wheel { A (0, 0); S (3 mm, 0); mass 0.1 kg at S; inertia 2e-5 kg*m^2 }
revolute A: ground - wheel
gravity 9.81 m/s^2
spring hair in A { stiffness 0.002 N*m/rad; free_angle 0 deg }
start wheel = 1270 deg
simulate 2 s in 40 steps within 1e-10
find angle(wheel)";
    assert!(turns(&both(text), 1) > 2.0);
}

#[test]
fn a_spring_in_a_hinge_between_moving_links_is_followed() {
    let found = both(&format!(
        "{FOUR_BAR}
spring k in B {{ stiffness 0.05 N*m/rad; free_angle 20 deg }}
start crank = 30 deg at 25 rad/s
simulate 2 s in 30 steps within 1e-10
find angle(coupler), displacement(B)"
    ));
    assert!(turns(&found, 1) > 3.0);
}

#[test]
fn a_load_may_depend_on_the_turns_of_a_link() {
    let found = both(&format!(
        "{FOUR_BAR}
torque M on crank = 2 N*m*cos(angle(crank)/3)
start crank = 30 deg at 25 rad/s
simulate 2 s in 20 steps within 1e-10
find angle(crank)"
    ));
    assert!(turns(&found, 1) > 2.0);
}

#[test]
fn a_triad_is_gone_through_from_where_it_stands() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/simulation/triad.mech");
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with("expect"));
    let text = lines.collect::<Vec<_>>().join("\n");
    let text = text.replace("; damping 4 N*s/m", "").replace(" - 0.05 N*m*s*omega(crank)", "");
    let text = text
        .replace("simulate 0.2 s", "simulate 0.8 s")
        .replace("= 20 deg", "= 20 deg at 30 rad/s")
        .replace("1e-11", "1e-10");
    assert!(turns(&both(&text), 1) > 0.2);
}

#[test]
fn trains_turn_with_the_links_that_drive_them() {
    let found = both(&format!(
        "{SUN}
torque M on arm = 6 N*m
start arm = 30 deg at 15 rad/s
simulate 1.5 s in 15 steps within 1e-10
find angle(sun), angle(rod)"
    ));
    assert!(turns(&found, 1) > 3.0 && turns(&found, 4) > 6.0);
}

#[test]
fn a_train_with_a_chain_in_it_is_gone_through_from_where_it_stands() {
    // the shaft of a reducer turns a heavy crank
    let found = both(
        "
gravity 9.81 m/s^2
ground { O2 (0, 0); line guide through O2 along 0 deg }
shaft motor { wheel z1 teeth 17 module 16 mm; inertia 0.01 kg*m^2 }
link crank O2-A 100 mm { wheel z2 teeth 42 at O2; mass 3 kg at A; inertia 0.2 kg*m^2 }
link rod A-B 400 mm { mass 2 kg at A; inertia 0.03 kg*m^2 }
link piston { B (0, 0); mass 2 kg at B }
revolute O2: ground - crank
revolute A: crank - rod
revolute B: rod - piston
prismatic D: piston.B - ground.guide
mesh k: z1 - z2
assemble B ahead of O2
torque M on motor = 3 N*m
start motor = -30 deg at 10 rad/s
simulate 1 s in 10 steps within 1e-10
find angle(crank), angle(rod)",
    );
    assert!(turns(&found, 1) > 1.0 || turns(&found, 4) > 1.0);
    // the sun is free: arm, rod and head are found together
    let found = both(&format!(
        "{SUN}
torque M on sun = 6 N*m
start sun = 30 deg at 20 rad/s
assemble A near (150 mm, 130 mm)
simulate 0.5 s in 10 steps within 1e-10
find angle(arm), angle(rod)"
    ));
    assert!(turns(&found, 4) > 1.0);
}

/// A place of rest on both sides of a step: the middle between them is passed, wherever rounding puts it.
#[test]
fn a_swing_passes_its_middle() {
    for amplitude in 1..40 {
        let amplitude = f64::from(amplitude) * 10.0;
        for within in ["1e-3", "1e-4", "1e-6", "1e-9"] {
            let text = format!(
                "ground {{ O (-1 m, 0); Q (0, 0); line way through Q along 0 deg }}
link m {{ P (0, 0); mass 1 kg at P }}
prismatic G: m.P - ground.way
spring k: ground.O - m.P {{ stiffness 100 N/m; free_length 1 m }}
start G = {amplitude} mm
simulate 3 s within {within}
find displacement(G)
"
            );
            let solved = solved(&text, Some(Method::Energy));
            let run = solved.solution.simulation.as_ref().unwrap();
            assert_eq!(run.method, Method::Energy, "{amplitude} mm within {within}");
            let last = solved.solution.poses.last().unwrap().outcome.as_ref().unwrap();
            let x = last.state.motion.bodies[1].p.x;
            let off = (x - 1e-3 * amplitude * libm::cos(30.0)).abs() / (1e-3 * amplitude);
            assert!(off < within.parse().unwrap(), "{amplitude} mm within {within}: {off:e}");
        }
    }
}
