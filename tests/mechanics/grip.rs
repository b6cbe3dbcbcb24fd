//! Belts, clutches, brakes and screws with friction, in random chains, against torques computed shaft by shaft.

use crate::support::random::Random;
use assur::Quantity;
use std::f64::consts::{PI, TAU};

/// A chain motor – belt – clutch – screw – load, with a band brake on the shaft of the clutch.
struct Chain {
    radii: [f64; 2],
    distance: f64,
    crossed: bool,
    friction: f64,
    slip: f64,
    pretension: f64,
    disc: [f64; 4],
    faces: usize,
    worn: bool,
    band: [f64; 4],
    screw: [f64; 4],
    load: f64,
    raises: bool,
}

impl Chain {
    fn new(random: &mut Random) -> Self {
        let radii = [random.within(0.05, 0.3), random.within(0.05, 0.3)];
        let inner = random.within(0.02, 0.1);
        Self {
            radii,
            distance: (radii[0] + radii[1]) * random.within(1.05, 4.0),
            crossed: random.below(2) == 0,
            friction: random.within(0.1, 0.6),
            slip: random.within(0.0, 0.05),
            pretension: random.within(100.0, 2000.0),
            disc: [
                random.within(100.0, 5000.0),
                random.within(0.1, 0.5),
                inner,
                inner * random.within(1.1, 3.0),
            ],
            faces: 1 + random.below(6),
            worn: random.below(2) == 0,
            band: [
                random.within(10.0, 200.0),
                random.within(0.1, 0.5),
                random.within(0.05, 0.2),
                random.within(1.0, 6.0),
            ],
            screw: [
                random.within(0.002, 0.05),
                random.within(0.01, 0.05),
                random.within(0.02, 0.3),
                random.within(0.0, 0.5),
            ],
            load: random.within(10.0, 20_000.0),
            raises: random.below(3) > 0,
        }
    }

    fn text(&self) -> String {
        let [r_1, r_2] = self.radii;
        let [press, disc, inner, outer] = self.disc;
        let [pull, band, at, wrap] = self.band;
        let [lead, diameter, thread, flank] = self.screw;
        let (crossed, worn) =
            (if self.crossed { "crossed; " } else { "" }, if self.worn { "worn; " } else { "" });
        let pulls = if self.raises { -self.load } else { self.load };
        let (friction, distance, slip, pretension, faces) =
            (self.friction, self.distance, self.slip, self.pretension, self.faces);
        let sense = if self.crossed { -10.0 } else { 10.0 };
        format!(
            "shaft I   {{ wheel w1 radius {r_1} m }}
shaft II  {{ wheel w2 radius {r_2} m }}
shaft III
slider n
belt b: w1 - w2 {{ {crossed}slip {slip}; friction {friction}; centre_distance {distance} m; pretension {pretension} N }}
clutch k: II - III {{ load {press} N; friction {disc}; outer {outer} m; inner {inner} m; {worn}faces {faces} }}
screw s: III - n {{ lead {lead} m; diameter {diameter} m; friction {thread}; flank {flank} rad }}
brake M on III {{ load {pull} N; friction {band}; radius {at} m; wrap {wrap} rad }}
drive I at {sense} rad/s
force Q on n = {pulls} N
find omega(III), effort(I), moment(k, III), tight_side(b), slack_side(b), capacity(b), capacity(k), slips(b), slips(k)
"
        )
    }

    /// The torque with which the brake holds back.
    fn brake(&self) -> f64 {
        let [pull, friction, radius, wrap] = self.band;
        pull * (libm::exp(friction * wrap) - 1.0) * radius
    }

    /// The torque that shaft III takes from the clutch, in the sense in which it turns.
    fn on_third(&self) -> f64 {
        let [lead, diameter, friction, flank] = self.screw;
        let (lead, friction) = (libm::atan(lead / (PI * diameter)), libm::atan(friction / libm::cos(flank)));
        let arm = self.load * diameter / 2.0;
        let screw =
            if self.raises { arm * libm::tan(lead + friction) } else { arm * libm::tan(friction - lead) };
        screw + self.brake()
    }

    /// Greatest tangential force of the belt.
    fn belt(&self) -> f64 {
        let [r_1, r_2] = self.radii;
        let wrap = if self.crossed {
            PI + 2.0 * libm::asin((r_1 + r_2) / self.distance)
        } else {
            PI - 2.0 * libm::asin((r_1 - r_2).abs() / self.distance)
        };
        let ratio = libm::exp(self.friction * wrap);
        // T₁ + T₂ = 2 T₀ and T₁ = ratio T₂
        let slack = 2.0 * self.pretension / (1.0 + ratio);
        ratio * slack - slack
    }

    /// Greatest torque of the clutch, by adding up rings.
    fn clutch(&self) -> f64 {
        let [press, friction, inner, outer] = self.disc;
        let rings = 20_000;
        let width = (outer - inner) / f64::from(rings);
        let (mut force, mut torque) = (0.0, 0.0);
        for i in 0..rings {
            let r = inner + (f64::from(i) + 0.5) * width;
            let pressure = if self.worn { 1.0 / r } else { 1.0 };
            force += pressure * TAU * r * width;
            torque += friction * pressure * TAU * r * r * width;
        }
        torque / force * press * self.faces as f64
    }
}

fn near(found: f64, wanted: f64, tolerance: f64, what: &str, text: &str) {
    assert!(
        (found - wanted).abs() <= tolerance * wanted.abs().max(1e-9),
        "{what}: {found}, not {wanted}\n{text}"
    );
}

#[test]
fn grips_and_threads_of_random_chains() {
    let mut random = Random::new(0x6719);
    let (mut solved, mut backwards) = (0, 0);
    for _ in 0..400 {
        let chain = Chain::new(&mut random);
        let text = chain.text();
        let solution = assur::solve(text.as_str()).unwrap_or_else(|error| panic!("{error}\n{text}"));
        let pose = &solution.poses()[0];
        let torque = chain.on_third();
        if torque < 0.0 {
            // the load drives: its power would run backwards through the belt
            backwards += 1;
            assert!(pose.failure().is_some_and(|why| why.contains("backwards")), "{text}");
            continue;
        }
        solved += 1;
        let value = |name: &str| pose[name].number().expect("a number");
        let [r_1, r_2] = chain.radii;
        let pull = torque / r_2;
        near(value("omega(III)"), 10.0 * r_1 / r_2 * (1.0 - chain.slip), 1e-12, "speed", &text);
        near(value("moment(k, III)"), torque, 1e-9, "clutch", &text);
        near(value("effort(I)").abs(), pull * r_1, 1e-9, "motor", &text);
        near(value("tight_side(b)"), chain.pretension + pull / 2.0, 1e-9, "tight side", &text);
        near(value("slack_side(b)"), chain.pretension - pull / 2.0, 1e-6, "slack side", &text);
        near(solution["capacity(b)"].number().expect("a number"), chain.belt(), 1e-12, "belt", &text);
        near(solution["capacity(k)"].number().expect("a number"), chain.clutch(), 1e-7, "discs", &text);
        assert_eq!(pose["slips(b)"].quantity(), Quantity::Condition(pull > chain.belt()), "{text}");
        assert_eq!(pose["slips(k)"].quantity(), Quantity::Condition(torque > chain.clutch()), "{text}");
    }
    assert!(solved > 200 && backwards > 10, "{solved} solved, {backwards} backwards");
}
