//! Random cams.

use assur::internals::element::cam::{Cam, Follower, Law, Program, Shape};
use assur::internals::math::{Between, Beyond, TableFunction};
use std::f64::consts::TAU;

const LAWS: [Law; 7] = [
    Law::Parabolic,
    Law::Harmonic,
    Law::Cycloidal,
    Law::Poly345,
    Law::Poly4567,
    Law::ModifiedTrapezoid,
    Law::ModifiedSine,
];

/// Numbers that look random: splitmix64.
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.unit()
    }

    pub fn law(&mut self) -> Law {
        LAWS[(self.unit() * LAWS.len() as f64) as usize]
    }
}

/// A random table of lifts, as a periodic spline over the turn or as one with a dwell behind it.
fn table(random: &mut Random, lift: f64) -> Program {
    let whole = random.unit() < 0.5;
    let rows = 7 + (random.unit() * 8.0) as usize;
    let end = if whole { TAU } else { random.between(4.0, 5.5) };
    let (phase, second) = (random.between(-0.4, 0.4), random.between(-0.1, 0.1));
    let points: Vec<(f64, f64)> = (0..=rows)
        .map(|i| {
            let x =
                if i == 0 || i == rows { 0.0 } else { (i as f64 + random.between(-0.1, 0.1)) / rows as f64 };
            let at = if i == rows { end } else { x * end };
            let raised =
                0.5 - 0.5 * (TAU * x + phase * (TAU * x).sin()).cos() + second * (TAU * x).sin().powi(2);
            (at, lift * raised)
        })
        .collect();
    let beyond = if whole { Beyond::Repeated } else { Beyond::Nothing };
    let spline = TableFunction::new(&points, Between::Spline, beyond).expect("a table");
    let pieces: Vec<(f64, f64, Law)> =
        spline.cubics().map(|(h, change, terms)| (h, change, Law::Spline(terms))).collect();
    Program::from_lift(0.0, &pieces)
}

/// A random cam that its follower can follow: `kind` from 0 to 4.
pub fn random_cam(random: &mut Random, kind: usize) -> Cam {
    loop {
        let base = random.between(0.03, 0.06);
        let ccw = random.unit() < 0.5;
        let with_cam = random.unit() < 0.5;
        let roller = Shape::Roller(random.between(0.005, 0.015));
        let distance = random.between(2.5, 3.5) * base;
        let arm = distance * random.between(0.85, 1.1);
        let (follower, lift) = match kind {
            0 => {
                let offset = random.between(-0.4, 0.4) * base;
                (Follower::Translating { shape: roller, offset }, random.between(0.1, 0.5) * base)
            }
            1 => {
                let offset = random.between(-0.4, 0.4) * base;
                (Follower::Translating { shape: Shape::Knife, offset }, random.between(0.1, 0.5) * base)
            }
            2 => {
                (Follower::Translating { shape: Shape::Flat, offset: 0.0 }, random.between(0.05, 0.3) * base)
            }
            3 => {
                let offset = random.between(-0.2, 0.2) * base;
                let shape = Shape::Flat;
                let follower =
                    Follower::Oscillating { shape, arm: 0.0, pivot_distance: distance, with_cam, offset };
                (follower, random.between(0.02, 0.12))
            }
            _ => {
                let follower = Follower::Oscillating {
                    shape: roller,
                    arm,
                    pivot_distance: distance,
                    with_cam,
                    offset: 0.0,
                };
                (follower, random.between(0.1, 0.4))
            }
        };
        let (rise, dwell, fall) =
            (random.between(1.2, 2.4), random.between(0.0, 0.5), random.between(1.2, 2.4));
        let program = if random.unit() < 0.3 {
            table(random, lift)
        } else {
            Program::new(&[(rise, lift, random.law()), (dwell, 0.0, Law::Dwell), (fall, -lift, random.law())])
        };
        if let Ok(cam) = Cam::new(base, ccw, follower, program)
            && cam.fault().is_none()
        {
            return cam;
        }
    }
}
