//! Jerks: drives by formulas of time against differences of their accelerations, coordinates along turning lines against those of theirs,
//! closed forms of cams. That of all bodies of all kinds of groups is in `mechanics/jerks`.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]

use crate::share::part;
use assur::internals::check::Overrides;
use assur::internals::model::{FindKind, Value};
use assur::internals::source::Source;
use std::f64::consts::{PI, TAU};

/// The numbers of all finds at every position; a vector is two.
fn solved(text: &str) -> Vec<Vec<f64>> {
    let source = Source::new("jerk.mech", text);
    let (solved, problems) = assur::internals::test_source(&source, &Overrides::none());
    let words =
        assur::internals::diagnostic::render(&problems, &source, assur::internals::diagnostic::Style::PLAIN);
    let solved = solved.unwrap_or_else(|| panic!("{words}\n{text}"));
    let model = solved.compiled.model();
    let poses = solved.solution.poses.iter().map(|pose| {
        let pose = pose.outcome.as_ref().unwrap_or_else(|e| panic!("{e:?}\n{text}"));
        let view = solved.solution.view(&model, pose);
        let finds = model.mechanism.finds.iter().flat_map(|find| match &find.kind {
            FindKind::Value { expr, .. } => match view.value(expr) {
                Value::Scalar(x) => vec![x],
                Value::Vector(v) => vec![v.x, v.y],
                Value::Bool(_) => Vec::new(),
            },
            _ => Vec::new(),
        });
        finds.collect()
    });
    poses.collect()
}

/// Numbers between two others, always the same.
struct Random(u64);

impl Random {
    fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        #[allow(clippy::cast_precision_loss)] // 53 bits
        let unit = (self.0 >> 11) as f64 / (1_u64 << 53) as f64;
        from + (to - from) * unit
    }
}

fn close(got: f64, wanted: f64, within: f64, size: f64, text: &str) {
    assert!((got - wanted).abs() <= within * size.max(wanted.abs()), "{got} {wanted}\n{text}");
}

/// The rate in the middle of five numbers.
fn rate(of: impl Fn(usize) -> f64, h: f64) -> f64 {
    (8.0 * (of(3) - of(1)) - (of(4) - of(0))) / (12.0 * h)
}

#[test]
fn drives_by_formulas_of_time_have_jerks() {
    let mut random = Random(3);
    for _ in 0..part(20) {
        let [a, b, c, d] =
            [(0.3, 1.2), (1.0, 3.0), (0.2, 0.6), (0.5, 2.0)].map(|(x, y)| random.between(x, y));
        // t runs near d
        let u = format!("({d} + time/(1 s))");
        for formula in [
            format!("{a}*sin({b} rad*{u})"),
            format!("{a}*cos({b} rad*{u}) + {c}*{u}^3"),
            format!("{c}*tan({c} rad*{u})"),
            format!("asin({c}*sin({b} rad*{u}))/(1 rad)"),
            format!("acos({c}*cos({b} rad*{u}))/(1 rad)"),
            format!("atan({a}*{u}^2)/(1 rad)"),
            format!("atan2({u}, {a} + {u}^2)/(1 rad)"),
            format!("{c}*exp(-{a}*{u})*{u}"),
            format!("{a}*log({u} + {b})"),
            format!("sqrt({a} + {u}^2)"),
            format!("{a}/({b} + {u}*{u})"),
            format!("abs({u} + {b})^{b}/30"),
            format!("{u}^{u}*{c}"),
            format!("max({a}*{u}^2, -{b}) - p({u})"),
            format!("slope(p({u}))"),
        ] {
            let text = format!(
                "mech 1\nmechanism \"Jerk\"\nground {{ A (0, 0) }}\nlink crank A-B 100 mm\nrevolute A: ground - crank\n\
                 curve p smooth {{\n  x, y\n  0, 0\n  0.3, 0.4\n  1.1, 0.2\n  2.3, 0.5\n  4, 0.1\n}}\n\
                 drive crank = 1 rad*({formula})\nsimulate 0.004 s in 4 steps\n\
                 find alpha(crank), angular_jerk(crank), omega(crank), acceleration(crank.B), jerk(crank.B)\n"
            );
            let all = solved(&text);
            let size = all[2][0].abs().max(all[2][2].abs().powi(3)).max(0.1);
            // within 2 ms of a row of the curve it is another cubic
            let rows = [0.3, 1.1, 2.3].iter().any(|row| (d + 0.002 - row).abs() < 0.003);
            if formula.contains('p') && !formula.contains("exp") && rows {
                continue;
            }
            close(all[2][1], rate(|i| all[i][0], 1e-3), 1e-7, size, &text);
            for part in 0..2 {
                close(all[2][5 + part], rate(|i| all[i][3 + part], 1e-3), 1e-7, 0.1 * size, &text);
            }
        }
    }
}

#[test]
fn points_by_formulas_of_time_have_jerks() {
    let text = "mech 1\nmechanism \"Jerk\"\nground { A (0, 0) }\nlink upper A-B 400 mm\nlink lower B-H 300 mm\n\
                link hand { H (0, 0) }\nrevolute A: ground - upper\nrevolute B: upper - lower\nrevolute H: lower - hand\n\
                assemble B left of A - H\n\
                drive hand.H = (500 mm + 30 mm*sin(4 rad/s*time), 100 mm*cos(3 rad/s*time))\nsimulate 0.004 s in 4 steps\n\
                find acceleration(lower.H), jerk(lower.H), alpha(upper), angular_jerk(upper), alpha(lower), angular_jerk(lower)\n";
    let all = solved(text);
    let now = &all[2];
    let t: f64 = 0.002;
    close(now[2], -0.03 * 64.0 * (4.0 * t).cos(), 1e-10, 1.0, text);
    close(now[3], 0.1 * 27.0 * (3.0 * t).sin(), 1e-10, 1.0, text);
    close(now[5], rate(|i| all[i][4], 1e-3), 1e-8, 1.0, text);
    close(now[7], rate(|i| all[i][6], 1e-3), 1e-8, 1.0, text);
}

#[test]
fn coordinates_along_turning_lines_have_jerks() {
    let mut random = Random(5);
    for case in 0..part(40) {
        let [r, height, angle, speed] =
            [(0.05, 0.1), (0.15, 0.3), (0.0, 360.0), (5.0, 30.0)].map(|(x, y)| random.between(x, y));
        let h = 1e-3 / speed;
        let places: Vec<String> =
            (-2..=2).map(|k| format!("{} rad", angle.to_radians() + f64::from(k) * 1e-3)).collect();
        let (joints, pair) = match case % 2 {
            0 => (
                "link block { B (0, 0) }\nlink lever { C (0, 0); D (0, 20 mm); line slot through D along 10 deg }\n\
                 revolute B: crank - block\nprismatic s: block.B - lever.slot\nrevolute C: ground - lever\nassemble s > 0\n",
                "s",
            ),
            _ => (
                "link lever { C (0, 0); D (0, 20 mm); line slot through D along 10 deg }\n\
                 slot s: crank.B - lever.slot\nrevolute C: ground - lever\nassemble s > 0\n",
                "s",
            ),
        };
        let text = format!(
            "mech 1\nmechanism \"Jerk\"\nground {{ C (0, 0); A (0, {height} m) }}\nlink crank A-B {r} m\nrevolute A: ground - crank\n\
             {joints}drive crank = {} at {speed} rad/s\n\
             find relative_acceleration({pair}), jerk({pair}), acceleration(lever, crank.B), jerk(lever, crank.B), alpha(lever), angular_jerk(lever)\n",
            places.join(", ")
        );
        let all = solved(&text);
        let size = r * speed.powi(3);
        close(all[2][1], rate(|i| all[i][0], h), 1e-8, size, &text);
        close(all[2][7], rate(|i| all[i][6], h), 1e-8, speed.powi(3), &text);
    }
}

/// s‴ = 4π² h ω³ cos(2πφ/β)/β³ while a cycloidal follower rises, nothing in a dwell, and at a seam what follows it.
#[test]
fn cycloidal_cams_have_the_jerk_of_their_law() {
    let mut random = Random(7);
    for case in 0..part(20) {
        let [lift, rise, speed] =
            [(5.0, 20.0), (60.0, 150.0), (2.0, 20.0)].map(|(x, y)| random.between(x, y));
        let phi = if case % 4 == 0 { 0.0 } else { random.between(0.01, 0.99) * rise };
        // seen from a cam that turns clockwise its follower goes counter-clockwise
        let text = format!(
            "mech 1\nmechanism \"Jerk\"\ncam plate {{\n  base_radius 30 mm\n  turning cw\n  follower translating knife\n  \
             rise {rise} deg through {lift} mm cycloidal\n  dwell 30 deg\n  fall 100 deg through {lift} mm harmonic\n}}\n\
             ground {{ O (0, 0); line guide through O along 90 deg }}\nlink disk {{ O (0, 0); profile rim of plate centre O }}\nlink rod {{ T (0, 0) }}\n\
             revolute O: ground - disk\nprismatic G: rod.T - ground.guide\ncontact K: disk.rim - rod.T\n\
             drive disk = {} deg, {} deg at -{speed} rad/s\nfind jerk(G), jerk(rod.T)\n",
            90.0 - phi,
            90.0 - rise - 10.0,
        );
        let all = solved(&text);
        let size = 4.0 * PI * PI * (lift / 1000.0) * (speed / rise.to_radians()).powi(3);
        let wanted = size * (TAU * phi / rise).cos();
        close(all[0][0], wanted, 1e-9, size, &text);
        close(all[0][2], wanted, 1e-9, size, &text);
        close(all[1][0], 0.0, 1e-9, size, &text);
    }
}

#[test]
fn a_point_comes_before_a_pair_of_its_name() {
    let text = "mech 1\nmechanism \"Jerk\"\nground { A (0, 0); line way through A along 0 deg }\nlink crank A-B 100 mm\nlink rod B-C 300 mm\n\
                link piston { C (0, 0) }\nrevolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - piston\n\
                prismatic D: piston.C - ground.way\nassemble C ahead of B\ndrive crank = 40 deg at 10 rad/s\n";
    let of = |find: &str| solved(&format!("{text}find {find}\n"))[0].len();
    assert_eq!((of("jerk(C)"), of("jerk(D)"), of("jerk(rod.C)")), (2, 1, 2));
}
