//! Where several things hold what one of them could, what does not depend on their shares is printed, and nothing else is.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

use assur::Problem;
use serde_json::Value;

/// Of the number, or of one.
const SAME: f64 = 1e-9;

/// The value of every quantity at the last instant: its components, or none where it is not determined.
fn last(text: &str) -> impl Fn(&str) -> Option<Vec<f64>> + use<> {
    let solution: Value = serde_json::from_str(&Problem::new("determined", text).solve_json()).unwrap();
    let last = solution["poses"].as_array().and_then(|poses| poses.last()).cloned();
    let last = last.unwrap_or_else(|| panic!("{text}{}", solution["diagnostics"]));
    move |quantity| match &last["quantities"][quantity] {
        Value::Array(parts) => parts.iter().map(Value::as_f64).collect(),
        number => number.as_f64().map(|x| vec![x]),
    }
}

fn is(found: Option<Vec<f64>>, right: &[f64]) -> bool {
    let near = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME * b.abs().max(1.0);
    found.is_some_and(|found| found.len() == right.len() && found.iter().zip(right).all(near))
}

/// A block that lies on its stop, on a rough slope.
#[test]
fn a_stop_and_friction_bear_together_what_is_determined() {
    let value = last(
        "gravity 9.81 m/s^2
ground { O (0, 0); line way through O along 30 deg }
link block { A (0, 0); mass 2 kg at A }
prismatic G: block.A - ground.way { friction 0.2 }
start G = 0.5 m
stop G > 0 m { restitution 0.5 }
simulate 0 s .. 2 s in 2 steps
find N = normal(G, block), R = reaction(G, block), M = moment(G, block), F = friction(G, block)
",
    );
    assert!(is(value("N"), &[19.62 * 0.75_f64.sqrt()]), "{:?}", value("N"));
    assert!(is(value("R"), &[0.0, 19.62]), "{:?}", value("R"));
    assert!(is(value("M"), &[0.0]), "{:?}", value("M"));
    assert_eq!(value("F"), None);
}

/// Two blocks on parallel guides, coupled by a rod along them, of which either could hold both.
#[test]
fn parallel_guides_have_their_normal_forces() {
    let value = last(
        "gravity 9.81 m/s^2
ground { O (0, 0); line way through O along 0 deg }
link one { A (0, 0); mass 2 kg at A }
link two { B (0, 0); mass 3 kg at B }
link rod A-B 500 mm
revolute A: one - rod
revolute B: rod - two
prismatic G: one.A - ground.way { friction 0.3 }
prismatic H: two.B - ground.way { friction 0.2 }
assemble B ahead of A
force P on one at A = 4 N @ 0 deg
start G = 0
simulate 0 s .. 1 s in 2 steps
find N = normal(G, one), Q = normal(H, two), F = friction(G, one), E = friction(H, two), R = reaction(A, rod)
find S = axial(rod)
",
    );
    assert!(is(value("N"), &[19.62]) && is(value("Q"), &[29.43]), "{:?} {:?}", value("N"), value("Q"));
    for open in ["F", "E", "R", "S"] {
        assert_eq!(value(open), None, "{open}");
    }
}

/// A brake and the friction of the bearing hold one shaft.
#[test]
fn a_brake_beside_friction_leaves_the_force_of_the_bearing() {
    let value = last(
        "gravity 9.81 m/s^2
ground { J (0, 0) }
link rotor J-S 100 mm { mass 2 kg at S; inertia 0.1 kg*m^2 }
revolute J: ground - rotor { friction_circle 80 mm }
torque B on rotor = 3 N*m against motion
start rotor = 0 deg
simulate 0 s .. 1 s in 2 steps
find R = reaction(J, rotor), M = moment(J, rotor), T = B, w = omega(rotor)
",
    );
    assert!(is(value("R"), &[0.0, 19.62]) && is(value("w"), &[0.0]), "{:?} {:?}", value("R"), value("w"));
    assert_eq!((value("M"), value("T")), (None, None));
}

/// A box on two feet, pushed at the height of its mass centre less than makes it slide or tip.
#[test]
fn feet_on_rough_ground_have_their_normal_forces() {
    let value = last(
        "gravity 9.81 m/s^2
ground { O (0, 0); line floor through O along 0 deg }
link box { A (0, 0); B (500 mm, 0); S (250 mm, 800 mm); mass 10 kg at S; inertia 2 kg*m^2 }
contact a: box.A - ground.floor { parts; friction 0.6 }
contact b: box.B - ground.floor { parts; friction 0.6 }
force P on box at S = 10 N/s*time right
start box.A = (0, 0)
start box = 0 deg
simulate 0 s .. 2.5 s in 5 steps
find N = normal(a, box), Q = normal(b, box), F = friction(a, box), E = friction(b, box), w = omega(box)
",
    );
    // 25 N at 800 mm over feet that are 500 mm apart
    assert!(is(value("N"), &[49.05 - 40.0]) && is(value("Q"), &[49.05 + 40.0]), "{:?}", value("N"));
    assert_eq!((value("F"), value("E")), (None, None));
    assert!(is(value("w"), &[0.0]));
}

/// Friction that slides takes its part of what is shared: what presses it on the ground is shared as well.
#[test]
fn what_slides_beside_what_is_shared_is_determined_as_its_motion_is() {
    let value = last(
        "gravity 9.81 m/s^2
ground { O (0, 0); line floor through O along 0 deg; line way through O along 0 deg }
link cart { C (0, 0); mass 4 kg at C }
link one { A (0, 0); mass 2 kg at A }
link two { B (0, 0); mass 3 kg at B }
link rod A-B 500 mm
revolute A: one - rod
revolute B: rod - two
prismatic K: cart.C - ground.floor { friction 0.1 }
prismatic G: one.A - ground.way { friction 0.3 }
prismatic H: two.B - ground.way { friction 0.2 }
assemble B ahead of A
force P on one at A = 4 N @ 0 deg
start G = 0
start K = 0 m at 5 m/s
simulate 0 s .. 1 s in 2 steps
find F = friction(K, cart), N = normal(K, cart), E = friction(H, two)
",
    );
    assert!(is(value("F"), &[-3.924]) && is(value("N"), &[39.24]), "{:?}", value("F"));
    assert_eq!(value("E"), None);
}

/// A drive that rests and the friction of what it moves share the load, in the effort of the drive too.
#[test]
fn a_drive_at_rest_has_no_effort_of_its_own() {
    let text = |until: &str| {
        format!(
            "gravity 9.81 m/s^2
ground {{ O (0, 0); line way through O along 30 deg }}
link block {{ A (0, 0); mass 2 kg at A }}
prismatic G: block.A - ground.way {{ friction 0.2 }}
drive G = 0.1 m/s*max(0 s, time - 0.5 s)
simulate 0 s .. {until} in 2 steps
find N = normal(G, block), F = friction(G, block), E = effort(G)
"
        )
    };
    let normal = 19.62 * 0.75_f64.sqrt();
    let (rests, moves) = (last(&text("0.4 s")), last(&text("1 s")));
    assert!(is(rests("N"), &[normal]) && is(moves("N"), &[normal]));
    assert_eq!((rests("F"), rests("E")), (None, None));
    assert!(is(moves("F"), &[-0.2 * normal]) && is(moves("E"), &[9.81 + 0.2 * normal]), "{:?}", moves("E"));
}
