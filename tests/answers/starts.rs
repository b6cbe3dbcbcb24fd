//! Starts of motions under loads: in dead positions and change points, and close to them; motions that drives by time give alone.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]
#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use assur::internals::check::Overrides;
use assur::internals::model::{FindKind, Value};
use assur::internals::source::Source;

/// The values of all finds at every instant, and all messages.
fn solved(text: &str) -> (Vec<Vec<f64>>, String) {
    let source = Source::new("case.mech", text);
    let (solved, problems) = assur::internals::test_source(&source, &Overrides::none());
    let words =
        assur::internals::diagnostic::render(&problems, &source, assur::internals::diagnostic::Style::PLAIN);
    let Some(solved) = solved else { return (Vec::new(), words) };
    let model = solved.compiled.model();
    let poses = solved.solution.poses.iter().map(|pose| {
        let Ok(pose) = &pose.outcome else { return Vec::new() };
        let view = solved.solution.view(&model, pose);
        let finds = model.mechanism.finds.iter().filter_map(|find| match &find.kind {
            FindKind::Value { expr, .. } => match view.value(expr) {
                Value::Scalar(x) => Some(x),
                _ => None,
            },
            _ => None,
        });
        finds.collect()
    });
    (poses.collect(), words)
}

/// Numbers between 0 and 1, always the same.
fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        #[allow(clippy::cast_precision_loss)] // 53 bits
        let unit = (state >> 11) as f64 / (1_u64 << 53) as f64;
        unit
    }
}

/// The lines that a help offers, with the file's own `start` and `assemble` replaced by them.
fn offered(text: &str, words: &str) -> Vec<String> {
    let lines: Vec<&str> = words.lines().map(|line| line.trim_start_matches(['│', ' '])).collect();
    let help = lines.iter().position(|line| line.starts_with("help:")).unwrap();
    let start = lines[help..].iter().find(|line| line.starts_with("start ")).unwrap();
    let ways = lines[help..].iter().filter(|line| line.starts_with("assemble "));
    let kept = |line: &&str| !line.starts_with("start ") && !line.starts_with("assemble ");
    let kept: Vec<&str> = text.lines().filter(kept).collect();
    ways.map(|way| format!("{}\n{start}\n{way}\n", kept.join("\n"))).collect()
}

#[test]
fn two_motions_begin_in_a_change_point() {
    for text in [
        include_str!("../cases/use3/numbers/start-in-change-point.mech"),
        include_str!("../cases/use3/numbers/start-parallelogram-in-line.mech"),
    ] {
        // angular accelerations of the parallelogram are zero: with weights they are not
        let text = text.replace("start ", "gravity 9.81 m/s^2\nstart ").replace("at A", "at B");
        let (_, words) = solved(&text);
        assert!(words.contains("two_motions"), "{words}");
        let ways = offered(&text, &words);
        assert_eq!(ways.len(), 2, "{words}");
        let motions = ways.iter().map(|way| {
            let (values, words) = solved(way);
            assert!(words.is_empty() && values.len() > 2, "{words}\n{way}");
            values
        });
        let motions: Vec<_> = motions.collect();
        assert!((motions[0][1][1] - motions[1][1][1]).abs() > 1e-3, "{motions:?}");
    }
}

fn parallelogram((ground, crank): (f64, f64), (angle, rate): (f64, f64), left: bool, torque: &str) -> String {
    let side = if left { "left" } else { "right" };
    format!(
        "mech 1\nground {{ A (0, 0); D ({ground} m, 0) }}
link a A-B {crank} m {{ S (0, 0.02 m); mass 5 kg at S; inertia 0.2 kg*m^2 }}
link b {{ B (0, 0); C ({ground} m, 0) }}
link c D-C {crank} m {{ S (0, 0.02 m); mass 5 kg at S; inertia 0.2 kg*m^2 }}
revolute A: ground - a\nrevolute B: a - b\nrevolute C: b - c\nrevolute D: ground - c
gravity 9.81 m/s^2\nassemble C {side} of B-D
start a = {angle:e} rad at {rate} rad/s\n{torque}simulate 1 s in 8 steps
find angle(a), angle(c), omega(a), omega(c), energy()\n"
    )
}

#[test]
fn parallelograms_start_close_to_a_line() {
    let mut random = random(7);
    for i in 0..24 {
        let sizes = (0.3 + 0.3 * random(), 0.1 + 0.1 * random());
        // the sense away from the line and towards it, on either side of it
        let angle = 10_f64.powf(-6.0 + 4.0 * random() + 0.1) * if random() < 0.5 { -1.0 } else { 1.0 };
        let rate = (3.0 + 5.0 * random()) * if random() < 0.5 { -1.0 } else { 1.0 };
        // by energy, and by DOP853
        let torque = if i % 2 == 0 { "" } else { "torque on a = -0.01 N*m*s/rad*omega(a)\n" };
        let text = parallelogram(sizes, (angle, rate), angle > 0.0, torque);
        let (values, words) = solved(&text);
        assert!(words.is_empty(), "{words}\n{text}");
        // C left of B-D where the crank is above the line: b stays parallel to the ground
        for pose in &values {
            let [a, c, wa, wc, energy] = pose[..] else { panic!("{text}") };
            assert!((a - c).abs() < 1e-8 && (wa - wc).abs() < 1e-7, "{pose:?}\n{text}");
            assert!(i % 2 == 1 || (energy - values[0][4]).abs() < 1e-8, "{pose:?}\n{text}");
        }
        let text = parallelogram(sizes, (angle, rate), angle < 0.0, torque);
        let (values, words) = solved(&text);
        assert!(words.is_empty(), "{words}\n{text}");
        // the other one: both bars of the loop cross
        let (g, r) = sizes;
        for pose in &values {
            let [a, c, ..] = pose[..] else { panic!("{text}") };
            let apart = (g + r * c.cos() - r * a.cos()).hypot(r * c.sin() - r * a.sin());
            assert!((apart - g).abs() < 1e-8, "{pose:?}\n{text}");
        }
        // its cranks turn against each other
        assert!(values.iter().all(|pose| pose[2] * pose[3] < 0.0), "{values:?}");
    }
}

#[test]
fn what_is_closer_is_refused() {
    for distance in [0.0, 1e-12, 1e-10, -1e-9, 1e-8, -1e-7] {
        let text = parallelogram((0.4, 0.15), (distance, 5.0), true, "");
        let (values, words) = solved(&text);
        assert!(values.is_empty() && words.contains("two_motions"), "{words}\n{text}");
    }
}

#[test]
fn equal_slider_cranks_keep_to_their_assembly() {
    for (side, angle) in [("ahead of", 90.3_f64), ("behind", 90.3), ("ahead of", 89.9), ("behind", 89.9)] {
        let text = include_str!("../cases/use3/numbers/start-in-change-point.mech")
            .replace("assemble C near (0, 0)", &format!("assemble C {side} B"))
            .replace("start crank = 90 deg", &format!("start crank = {angle} deg"));
        let (values, words) = solved(&text);
        assert!(words.is_empty(), "{words}\n{text}");
        let together = (side == "ahead of") == (angle > 90.0);
        let omega = 5.0_f64;
        for [crank, place, rod, energy] in values.iter().map(|pose| <[f64; 4]>::try_from(&pose[..]).unwrap())
        {
            if together {
                let expected = angle.to_radians() + omega * (crank - angle.to_radians()) / omega;
                assert!(place.abs() < 1e-9 && (rod - omega).abs() < 1e-7, "{crank} {place} {rod} {expected}");
            } else {
                assert!((place - 0.2 * crank.cos()).abs() < 1e-9 && rod < 0.0, "{crank} {place} {rod}");
            }
            assert!((energy - values[0][3]).abs() < 1e-9 && energy > 0.125, "{energy}");
        }
    }
}

#[test]
fn what_is_impossible_in_a_dead_centre_is_said() {
    let text = include_str!("../cases/use3/numbers/start-impossible-speed.mech");
    let mut random = random(3);
    for i in 0..16 {
        let (crank, rod) = (50.0 + 100.0 * random(), 200.0 + 200.0 * random());
        let (crank, rod) = (crank.round(), rod.round());
        let dead = if i % 2 == 0 { rod + crank } else { rod - crank };
        let text = text
            .replace("A-B 100 mm", &format!("A-B {crank} mm"))
            .replace("B-C 300 mm", &format!("B-C {rod} mm"))
            // two assemblies that rounding alone sets apart
            .replace("assemble C ahead of B", "assemble C ahead of B, B left of A-C");
        let with = |start: &str| text.replace("start D = 400 mm at 50 m/s", start);
        let speed = 0.1 + 10.0 * random();
        let (values, words) = solved(&with(&format!("start D = {dead} mm at {speed} m/s")));
        assert!(values.is_empty() && words.contains("can have no speed where it starts"), "{words}");
        let (values, words) = solved(&with(&format!("start D = {dead} mm")));
        assert!(!values.is_empty() && !words.contains("no speed"), "{words}");
        // what the help offers runs, from there
        let angle = if i % 2 == 0 { "0 deg" } else { "180 deg" };
        let crank = with(&format!("start crank = {angle} at 1 rad/s")).replace(", B left of A-C", "");
        let (values, words) = solved(&crank);
        assert!(words.is_empty() && (values[0][1] - 1.0).abs() < 1e-12, "{words}");
        assert!((values[0][4] - dead * 1e-3).abs() < 1e-12, "{values:?}");
    }
}

#[test]
fn near_stands_beside_a_drive_by_time() {
    let text = include_str!("../cases/use3/numbers/near-with-drive-of-time.mech");
    let (near, words) = solved(text);
    assert!(words.is_empty(), "{words}");
    let (side, _) = solved(&text.replace("C near (330 mm, 190 mm)", "C left of B-D"));
    assert!(near.len() == 3 && near == side, "{near:?} {side:?}");
}

#[test]
fn drives_by_time_alone_give_a_motion() {
    let text = include_str!("../cases/use3/numbers/driven-by-time-alone.mech");
    let mut random = random(5);
    for _ in 0..12 {
        let (a, b, c) = (180.0 * random(), 20.0 + 100.0 * random(), 1.0 + 4.0 * random());
        let text = text
            .replace("30 deg + 20 deg*sin(3 rad/s*time)", &format!("{a} deg + {b} deg*sin({c} rad/s*time)"))
            .replace("find ", "balance torque M on crank\nforce F on piston at C = -100 N @ 0 deg\nfind work(F), M, max(displacement(D)), ");
        let (values, words) = solved(&text);
        assert!(words.is_empty() && values.len() == 5, "{words}\n{text}");
        let slide = |angle: f64| {
            let (x, y) = (0.1 * angle.cos(), 0.1 * angle.sin());
            x + (0.09 - y * y).sqrt()
        };
        let at = |t: f64| a.to_radians() + b.to_radians() * (c * t).sin();
        let greatest = (0..=20_000).map(|i| slide(at(f64::from(i) / 20_000.0))).fold(0.0, f64::max);
        for (t, pose) in [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().zip(&values) {
            let [work, torque, most, place, rod] = pose[..] else { panic!("{pose:?}") };
            let (angle, rate) = (at(t), b.to_radians() * c * (c * t).cos());
            let acceleration = -c * (b.to_radians() * c * (c * t).sin());
            // y_B + l sin φ = 0
            let turning = -0.1 * angle.cos() * rate / (0.09 - (0.1 * angle.sin()).powi(2)).sqrt();
            let e = 1e-4;
            let slope = |angle: f64| {
                let near = (slide(angle + e) - slide(angle - e)) / (2.0 * e);
                let far = (slide(angle + 2.0 * e) - slide(angle - 2.0 * e)) / (4.0 * e);
                (4.0 * near - far) / 3.0
            };
            let bend = (slope(angle + e) - slope(angle - e)) / (2.0 * e);
            let slider = slope(angle) * acceleration + bend * rate * rate;
            // the power of the torque is what speeds up and what the force takes
            let expected = (0.01 + 0.01) * acceleration + slope(angle) * (slider + 100.0);
            assert!(
                (place - slide(angle)).abs() < 1e-12 && (rod - turning).abs() < 1e-11,
                "{pose:?}\n{text}"
            );
            assert!((torque - expected).abs() < 1e-5, "{torque} {expected}\n{text}");
            assert!((work + 100.0 * (slide(angle) - slide(at(0.0)))).abs() < 1e-7, "{work}\n{text}");
            assert!((most - greatest).abs() < 1e-8, "{most} {greatest}\n{text}");
        }
    }
}

#[test]
fn four_bars_driven_by_time_are_those_of_a_sweep() {
    let mut random = random(11);
    for _ in 0..12 {
        let (ground, rod, rocker) = (0.35 + 0.1 * random(), 0.35 + 0.05 * random(), 0.25 + 0.05 * random());
        let (a, b, c) = (360.0 * random(), 20.0 + 200.0 * random(), 1.0 + 4.0 * random());
        let links = format!(
            "mech 1\nground {{ A (0, 0); D ({ground} m, 0) }}\nlink a A-B 100 mm\nlink b B-C {rod} m
link c D-C {rocker} m\nrevolute A: ground - a\nrevolute B: a - b\nrevolute C: b - c
revolute D: ground - c\nassemble C left of B-D\nfind angle(c), omega(c), alpha(c)\n"
        );
        let driven =
            format!("{links}drive a = {a} deg + {b} deg*sin({c} rad/s*time)\nsimulate 1 s in 5 steps\n");
        let (values, words) = solved(&driven);
        assert!(words.is_empty() && values.len() == 6, "{words}\n{driven}");
        for (i, pose) in values.iter().enumerate() {
            let t = 0.2 * i as f64;
            let angle = a + b * (c * t).sin();
            let (rate, acceleration) = (b * c * (c * t).cos(), -b * c * c * (c * t).sin());
            let single = format!(
                "{links}drive a = {angle} deg at {} rad/s accelerating {} rad/s^2\n",
                rate.to_radians(),
                acceleration.to_radians()
            );
            let (one, words) = solved(&single);
            assert!(words.is_empty(), "{words}\n{single}");
            let turns = ((pose[0] - one[0][0]) / std::f64::consts::TAU).round() * std::f64::consts::TAU;
            assert!((pose[0] - one[0][0] - turns).abs() < 1e-10, "{pose:?} {one:?}");
            let same = |i: usize| (pose[i] - one[0][i]).abs() < 1e-8 * one[0][i].abs().max(1.0);
            assert!(same(1) && same(2), "{pose:?} {one:?}\n{driven}");
        }
    }
}

#[test]
fn a_drive_by_time_passes_change_points_smoothly() {
    for (side, sign) in [("left", 1.0), ("right", -1.0)] {
        let text = parallelogram((0.4, 0.15), (0.0, 1.0), true, "")
            .replace("C left of", &format!("C {side} of"))
            .replace("start a = 0e0 rad at 1 rad/s", "drive a = 10 deg + 300 deg*sin(3 rad/s*time)");
        let (values, words) = solved(&text);
        assert!(words.is_empty(), "{words}\n{text}");
        // c turns with a, or against it
        let follows = |pose: &Vec<f64>| {
            if sign > 0.0 { (pose[0] - pose[1]).abs() < 1e-10 } else { pose[2] * pose[3] < 0.0 }
        };
        assert!(values.len() == 9 && values.iter().all(follows), "{values:?}");
    }
}

#[test]
fn a_stop_needs_something_free() {
    let text = include_str!("../cases/use3/numbers/driven-by-time-alone.mech");
    let (values, words) = solved(&text.replace("find", "stop D > 355 mm { restitution 0.5 }\nfind"));
    assert!(values.is_empty() && words.contains("a stop of what drives alone move"), "{words}");
}

/// A slider that a drive by time moves to its dead centre and back: the run ends there, wherever its steps and its end are.
#[test]
fn a_drive_by_time_that_touches_a_dead_centre_is_told() {
    let mut random = random(17);
    for case in 0..24 {
        let (crank, rod) = (0.1, 0.2 + 0.3 * random());
        let (least, greatest) = (rod - crank, rod + crank);
        let (amplitude, rate, phase) = (0.01 + 0.08 * random(), 0.5 + 15.0 * random(), random());
        let (dead, sign) = if case % 2 == 0 { (greatest, 1.0) } else { (least, -1.0) };
        let touch = (phase + sign * std::f64::consts::FRAC_PI_2).rem_euclid(std::f64::consts::TAU) / rate;
        // it may end just after it
        let last = touch + [1e-3, 0.1, 2.0][case % 3] / rate;
        let within = ["1e-3", "1e-6", "1e-9"][case / 3 % 3];
        let text = format!(
            "ground {{ A (0, 0); line guide through A along 0 deg }}
link crank A-B {crank} m
link rod B-C {rod} m
link piston {{ C (0, 0) }}
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
prismatic D: piston.C - ground.guide
assemble B left of A-C
drive D = {dead} m - {} m + {} m*sin({rate} rad/s*time - {phase} rad)
simulate {last} s in 3 steps within {within}
find angle(crank)
",
            sign * amplitude,
            amplitude
        );
        let (_, words) = solved(&text);
        let told = words.contains("mech::simulate::dead_position") && words.contains("moves it there");
        assert!(told, "{words}\n{text}");
        let instant = words.split("cannot go on at ").nth(1).and_then(|rest| rest.split(' ').next());
        let instant: f64 = instant.unwrap().parse().unwrap();
        // |σ| is below 1e-3 there, and the drive has yet to come to its end
        let ahead = (touch - instant) * rate;
        assert!((-1e-3..0.05).contains(&ahead), "{instant}, not {touch}\n{words}\n{text}");
    }
}

/// Nothing is asked of the motion: it is a mechanism still.
#[test]
fn a_free_shaft_of_which_nothing_is_asked_is_solved() {
    for line in [
        "shaft drum { inertia 3 kg*m^2 }\nstart drum = 0 deg at 2 rad/s",
        "slider drum { mass 3 kg }\nstart drum = 0 mm at 2 m/s",
    ] {
        let text = format!("{line}\nsimulate 0 s .. 2 s in 4 steps\nfind x = 3\n");
        let solution = assur::solve(text.as_str()).unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert_eq!(solution.poses()[0]["x"].number(), Some(3.0));
    }
}

/// A motorcycle, and where it starts.
fn motorcycle(start: &str) -> String {
    format!(
        "gravity 9.81 m/s^2\nground {{ O (0, 0); line road through O along 0 deg }}\n\
         link body {{ R (0, 0); F (1.4 m, 0); S (0.65 m, 0.35 m); mass 230 kg at S; inertia 30 kg*m^2 }}\n\
         link rear {{ R (0, 0); circle tyre centre R radius 300 mm; mass 12 kg at R; inertia 0.6 kg*m^2 }}\n\
         link front {{ F (0, 0); circle tyre centre F radius 300 mm; mass 12 kg at F; inertia 0.6 kg*m^2 }}\n\
         revolute R: body - rear\nrevolute F: body - front\n\
         contact cr: rear.tyre - ground.road {{ friction 0.9 }}\ncontact cf: front.tyre - ground.road {{ friction 0.9 }}\n\
         torque T in R = -300 N*m\nstart rear = 0 deg\nstart front = 0 deg\n{start}\n\
         simulate 0 s .. 2 s in 2 steps\nfind velocity(body.S).x\n"
    )
}

/// A crate on two feet.
fn crate_on_feet(assemble: &str) -> String {
    format!(
        "gravity 9.81 m/s^2\nground {{ O (0, 0); line road through O along 0 deg }}\n\
         link body {{ R (0, 0); F (1.4 m, 0); S (0.65 m, 0.35 m); mass 230 kg at S; inertia 30 kg*m^2 }}\n\
         contact cr: body.R - ground.road\ncontact cf: body.F - ground.road\n\
         start body.R = (0, 0) at (5 m/s, 0)\n{assemble}\nsimulate 0 s .. 2 s in 2 steps\nfind velocity(body.S).x\n"
    )
}

fn last(text: &str) -> f64 {
    let solution = assur::solve(text).unwrap_or_else(|e| panic!("{text}\n{e}"));
    solution.poses().last().and_then(|pose| pose["velocity(body.S).x"].number()).unwrap_or(f64::NAN)
}

#[test]
fn a_repeated_start_whose_assembly_is_open_lists_places_that_work() {
    let open = assur::solve(crate_on_feet("")).expect_err("two assemblies").to_string();
    assert!(open.contains("2 assemblies") && open.contains("assemble body.F near (1.4 m, 0 m)"), "{open}");
    assert!((last(&crate_on_feet("assemble body.F near (1.4 m, 0 m)")) - 5.0).abs() < 1e-9);
    let open = assur::solve(motorcycle("start body.R = (0, 300 mm)")).expect_err("several").to_string();
    assert!(open.contains("assemble body.F near (1.4 m, 0.3 m)"), "{open}");
}

#[test]
fn a_body_on_wheels_starts_at_any_of_its_points() {
    let wanted = last(&motorcycle("start rear.R = (0, 300 mm)\nassemble body.F near (1.4 m, 300 mm)"));
    let forward = "assemble body.F near (1.4 m, 300 mm)";
    for (start, assemble) in [
        ("body.R = (0, 300 mm)", forward),
        ("body.S = (0.65 m, 0.65 m)", forward),
        ("body.F = (1.4 m, 300 mm)", "assemble body.R near (0 m, 300 mm)"),
    ] {
        let found = last(&motorcycle(&format!("start {start}\n{assemble}")));
        assert!((found / wanted - 1.0).abs() < 1e-9, "{start}: {found} {wanted}");
    }
    // one that does not fit says where it is
    let off = motorcycle("start body.R = (0, 310 mm)\nassemble body.F near (1.4 m, 300 mm)");
    let off = assur::solve(off).expect_err("10 mm above").to_string();
    assert!(off.contains("starts 0.01 m from") && off.contains("`cr`"), "{off}");
}
