//! What drives move rubs in the sense of its speed, through all reversals: alone, and next to something free, against closed forms.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed
#![allow(clippy::disallowed_methods, reason = "an independent computation")]

use assur::Problem;
use serde_json::Value;

const MASS: f64 = 2.0;
const GRAVITY: f64 = 9.81;
const FRICTION: f64 = 0.3;
const AGAINST: f64 = 12.0;
const INERTIA: f64 = 0.8;
const EFFICIENCY: f64 = 0.9;
const RATE: f64 = 5.0;
const SIZE: f64 = 0.3;

/// The speed and the acceleration of a law at an instant.
type Rates = fn(f64) -> [f64; 2];

/// Laws of a drive, of size 1 and rate 1.
const LAWS: [(&str, Rates); 4] = [
    ("sin(x)", |x| [x.cos(), -x.sin()]),
    ("cos(x)", |x| [-x.sin(), -x.cos()]),
    ("(1 - cos(x))", |x| [x.sin(), x.cos()]),
    ("sin(x)^3", |x| {
        [3.0 * x.sin().powi(2) * x.cos(), 3.0 * (2.0 * x.sin() * x.cos().powi(2) - x.sin().powi(3))]
    }),
];

/// What is free next to it, or nothing.
const BESIDE: [&str; 3] = [
    "",
    "link fan { Q (0, 0); mass 1 kg at Q; inertia 1 kg*m^2 }\nrevolute Q: ground - fan\nstart fan = 0 deg\n",
    "link fan { Q (0, 0); mass 1 kg at Q; inertia 1 kg*m^2 }\nrevolute Q: ground - fan\nstart fan = 0 deg at 2 rad/s\n",
];

/// A machine that rubs in a way of its own: its text but for the drive's law, and the effort of its drive from speed and acceleration.
struct Kind {
    text: &'static str,
    effort: fn(f64, f64) -> f64,
}

const CART: &str = "link cart { A (0, 0); mass 2 kg at A }
drive G = 0.3 m*LAW
balance force E on cart at A along 0 deg
";

const KINDS: [Kind; 5] = [
    Kind {
        text: "prismatic G: cart.A - ground.way { friction 0.3 }\n",
        effort: |v, a| MASS * a + FRICTION * MASS * GRAVITY * v.signum(),
    },
    Kind {
        text: "prismatic G: cart.A - ground.way\nforce R on cart at A = 12 N against motion\n",
        effort: |v, a| MASS * a + AGAINST * v.signum(),
    },
    Kind {
        text: "link rotor { B (0, 0); mass 1 kg at B; inertia 0.8 kg*m^2 }
revolute B: ground - rotor
drive B = 0.3 rad*LAW
brake T on rotor { capacity 12 N*m }
balance torque E on rotor\n",
        effort: |v, a| INERTIA * a + AGAINST * v.signum(),
    },
    Kind {
        text: "shaft I { wheel w1 teeth 20; inertia 0.8 kg*m^2 }
shaft II { wheel w2 teeth 40; inertia 0.8 kg*m^2 }
mesh g: w1 - w2 { efficiency 0.9 }
drive I = 0.3 rad*LAW
balance torque E on I\n",
        effort: |v, a| {
            let over = INERTIA * a / 4.0;
            INERTIA * a + over * if over * v > 0.0 { 1.0 / EFFICIENCY } else { EFFICIENCY }
        },
    },
    Kind {
        text: "link plate { A (0, 0); mass 2 kg at A; line top through A along 0 deg }
link block { A (0, 0); mass 2 kg at A }
prismatic G: plate.A - ground.way
prismatic H: block.A - plate.top { friction 0.3 }
drive G = 0.3 m*LAW
drive H = 0.1 m - 0.3 m*LAW
balance force E on plate at A along 0 deg
balance force E2 on block at A along 0 deg\n",
        // the block stands in the plane and rubs on the plate
        effort: |v, a| MASS * a + FRICTION * MASS * GRAVITY * v.signum(),
    },
];

#[test]
fn what_drives_move_rubs_in_the_sense_of_its_speed() {
    let mut failures = Vec::new();
    for (number, kind) in KINDS.iter().enumerate() {
        for (law, rates) in LAWS {
            for beside in BESIDE {
                let own = if kind.text.contains("drive") { "" } else { CART };
                let text = format!(
                    "gravity 9.81 m/s^2\nground {{ O (0, 0); A (0, 0); B (0, 0); Q (0, 1 m); line way through O along 0 deg }}
{}{}{beside}simulate 0 s .. 1.9 s in 19 steps\nfind E\n",
                    own.replace("LAW", &law.replace('x', "5 rad/s*time")),
                    kind.text.replace("LAW", &law.replace('x', "5 rad/s*time"))
                );
                let solution: Value =
                    serde_json::from_str(&Problem::new("driven", text.as_str()).solve_json()).unwrap();
                let poses = solution["poses"].as_array().cloned().unwrap_or_default();
                let wrong = poses.iter().skip(1).find_map(|pose| {
                    let t = pose["time"].as_f64().unwrap();
                    let [v, a] = rates(RATE * t);
                    let right = (kind.effort)(SIZE * RATE * v, SIZE * RATE * RATE * a);
                    let got = pose["quantities"]["E"].as_f64();
                    let near = got.is_some_and(|got| (got - right).abs() < 1e-8 * AGAINST);
                    (!near).then(|| format!("{got:?}, not {right} at {t} s"))
                });
                if poses.len() != 20 || wrong.is_some() {
                    failures
                        .push(format!("kind {number}, {law}: {wrong:?}\n{text}{}", solution["diagnostics"]));
                }
            }
        }
    }
    assert!(failures.is_empty(), "{} of 60\n{}", failures.len(), failures.join("\n"));
}
