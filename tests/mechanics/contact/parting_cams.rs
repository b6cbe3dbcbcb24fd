//! Followers that leave their designed cams: flights against closed forms, and as long as a follower stays, the same machine with a
//! contact that does not part.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

use assur::Problem;
use proptest::prelude::*;
use serde_json::Value;
use std::f64::consts::PI;

/// Values of quantities at all instants.
fn values(text: &str, quantities: &[&str]) -> Result<Vec<Vec<f64>>, String> {
    let solution: Value = serde_json::from_str(&Problem::new("cam", text).solve_json()).unwrap();
    let poses = solution["poses"].as_array().cloned().unwrap_or_default();
    let of = |pose: &Value| quantities.iter().map(|name| pose["quantities"][name].as_f64()).collect();
    let found: Option<Vec<Vec<f64>>> = poses.iter().map(of).collect();
    found.filter(|found| !found.is_empty()).ok_or_else(|| format!("{text}{}", solution["diagnostics"]))
}

/// A cam with a harmonic rise and fall, and its lifter under gravity.
struct Lifter {
    lift: f64,
    rise: f64,
    dwell: f64,
    fall: f64,
    omega: f64,
    bounce: f64,
}

const G: f64 = 9.81;

impl Lifter {
    /// The lift with two derivatives by time.
    fn law(&self, t: f64) -> [f64; 3] {
        let phi = (self.omega * t).rem_euclid(2.0 * PI);
        let wave = |x: f64, over: f64| {
            let rate = PI / over * self.omega;
            let (sin, cos) = libm::sincos(PI * x / over);
            [0.5 * self.lift * (1.0 - cos), 0.5 * self.lift * rate * sin, 0.5 * self.lift * rate * rate * cos]
        };
        let (top, down) = (self.rise + self.dwell, self.rise + self.dwell + self.fall);
        if phi < self.rise {
            wave(phi, self.rise)
        } else if phi < top {
            [self.lift, 0.0, 0.0]
        } else if phi < down {
            let [s, v, a] = wave(phi - top, self.fall);
            [self.lift - s, -v, -a]
        } else {
            [0.0; 3]
        }
    }

    /// Heights at these instants: on the cam or in flight, one flight after the other. Nothing where a flight is so short or flat that
    /// nothing can be told.
    fn heights(&self, instants: &[f64]) -> Option<Vec<f64>> {
        let step = 1e-5;
        let (mut t, mut flight): (f64, Option<(f64, f64, f64)>) = (0.0, None);
        let height =
            |(from, h, v): (f64, f64, f64), t: f64| h + v * (t - from) - 0.5 * G * (t - from) * (t - from);
        let mut found = Vec::new();
        for &wanted in instants {
            while t < wanted {
                let next = (t + step).min(wanted);
                match flight {
                    None => {
                        if self.law(next)[2] < -G {
                            let (mut low, mut high) = (t, next);
                            for _ in 0..60 {
                                let middle = 0.5 * (low + high);
                                if self.law(middle)[2] < -G { high = middle } else { low = middle }
                            }
                            let [s, v, _] = self.law(high);
                            flight = Some((high, s, v));
                        }
                    }
                    Some(own) => {
                        let gap = |t: f64| height(own, t) - self.law(t)[0];
                        if next - own.0 > 2.0 * step && gap(next) < 0.0 {
                            let (mut low, mut high) = (t, next);
                            for _ in 0..60 {
                                let middle = 0.5 * (low + high);
                                if gap(middle) < 0.0 { high = middle } else { low = middle }
                            }
                            let [s, v, a] = self.law(high);
                            let closing = v - (own.2 - G * (high - own.0));
                            let away = self.bounce * closing;
                            if closing < 1e-3 || (away > 0.0 && away < 2e-2) || (a + G).abs() < 0.1 {
                                return None;
                            }
                            let flies = away > 0.0 || a < -G;
                            flight = flies.then_some((high, s, v + away));
                        }
                    }
                }
                t = next;
            }
            found.push(flight.map_or_else(|| self.law(t)[0], |own| height(own, t)));
        }
        Some(found)
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, max_global_rejects: 4000, ..ProptestConfig::default() })]

    #[test]
    fn a_lifter_leaves_its_cam_and_lands(
        lift in 5.0..30.0_f64, rise in 50.0..120.0_f64, dwell in 5.0..60.0_f64, fall in 60.0..150.0_f64,
        speed in 10.0..45.0_f64, bounce in prop_oneof![Just(0.0), 0.2..0.7_f64], flat: bool,
    ) {
        let rad = |deg: f64| deg * PI / 180.0;
        let own = Lifter { lift: 1e-3 * lift, rise: rad(rise), dwell: rad(dwell), fall: rad(fall), omega: speed, bounce };
        let end = 4.0 / speed;
        let instants: Vec<f64> = (0..=40).map(|k| end * f64::from(k) / 40.0).collect();
        let right = own.heights(&instants);
        prop_assume!(right.is_some());
        let right = right.unwrap();
        prop_assume!(own.law(0.0)[2] > 0.1);
        let follower = if flat { "translating flat" } else { "translating roller { radius 10 mm }" };
        let profile = if flat {
            "line face through P along 90 deg"
        } else {
            "circle face centre P radius 10 mm"
        };
        let text = format!(
            "gravity 9.81 m/s^2
cam plate {{
  base_radius 60 mm
  turning ccw
  follower {follower}
  rise {rise} deg through {lift} mm harmonic
  dwell {dwell} deg
  fall {fall} deg harmonic
}}
ground {{ O (0, 0); line way through O along 90 deg }}
link disk {{ O (0, 0); profile rim of plate centre O; mass 2 kg at O; inertia 0.01 kg*m^2 }}
link lifter {{ P (0, 0); {profile}; mass 0.7 kg at P }}
revolute O: ground - disk
prismatic V: lifter.P - ground.way
contact K: disk.rim - lifter.face {{ parts; restitution {bounce} }}
drive O = 90 deg + {speed} rad/s*time
simulate 0 s .. {end} s in 40 steps
find t = time, y = displacement(V) - 60 mm
",
        );
        let printed = values(&text, &["t", "y"]).map_err(TestCaseError::fail)?;
        for row in printed {
            let near = instants.iter().position(|t| (t - row[0]).abs() < 1e-12);
            let Some(at) = near else { continue };
            let (got, right) = (row[1], right[at]);
            prop_assert!((got - right).abs() < 2e-8, "{} s: {got}, not {right}\n{text}", row[0]);
        }
    }
}

/// Levers on their cams, slow enough to stay: the same as where the contact does not part, whose motion the law of the cam gives.
#[test]
fn a_lever_that_stays_is_that_of_a_contact_without_parting() {
    let roller =
        ("arm 130 mm; pivot_distance 140 mm; radius 15 mm", "circle end centre R radius 15 mm", "roller { ");
    let face = ("pivot_distance 120 mm; offset 8 mm", "line end through Q along 0 deg", "flat { ");
    for (design, profile, kind) in [roller, face] {
        for with in ["with_cam", "against_cam"] {
            let pivot = if kind == "flat { " { 120 } else { 140 };
            let text = format!(
                "cam plate {{
  base_radius 50 mm
  turning cw
  follower oscillating {kind}{design}; {with} }}
  rise 120 deg through 12 deg cycloidal
  dwell 40 deg
  fall 120 deg poly345
}}
ground {{ O (0, 0); P ({pivot} mm, 0) }}
link disk {{ O (0, 0); profile rim of plate centre O; mass 3 kg at O; inertia 0.02 kg*m^2 }}
link lever {{ P (0, 0); R (130 mm, 0); Q (0, -8 mm); {profile}; S (65 mm, 0); mass 2 kg at S; inertia 0.01 kg*m^2 }}
revolute O: ground - disk
revolute P: ground - lever
contact K: disk.rim - lever.end {{ parts }}
drive O = -20 deg - 9 rad/s*time
torque Q on lever = TORQUE
simulate 0 s .. 0.5 s in 20 steps
find angle(lever), omega(lever), n = normal(K, lever), effort(O)
"
            );
            let mut held = Vec::new();
            for torque in ["60 N*m", "-60 N*m"] {
                let parts = text.replace("TORQUE", torque);
                let stays = parts.replace(" { parts }", "");
                let names = ["angle(lever)", "omega(lever)", "n", "effort(O)"];
                if let (Ok(one), Ok(other)) = (values(&parts, &names), values(&stays, &names)) {
                    held.push((parts, one, other));
                }
            }
            let [(text, one, other)] = held.as_slice() else { panic!("{} ways press\n{text}", held.len()) };
            assert_eq!(one.len(), other.len(), "{text}");
            for (one, other) in one.iter().zip(other) {
                let same = one.iter().zip(other).all(|(a, b)| (a - b).abs() <= 1e-7 * b.abs().max(1.0));
                assert!(same, "{one:?}\n{other:?}\n{text}");
            }
        }
    }
}
