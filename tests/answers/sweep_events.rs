//! Events and ends of sweeps: against roots found in other files by sections, each a list of positions, and motions that are given
//! against the same sweeps.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]

use super::masses::within;
use super::quick_rows::random;
use crate::share::first;
use std::f64::consts::TAU;

/// Positions of the dense list.
const DENSE: usize = 720;
/// Parts of a section.
const PARTS: usize = 24;

fn one_of<'t>(state: &mut u64, all: &[&'t str]) -> &'t str {
    all[((random(state) * all.len() as f64) as usize).min(all.len() - 1)]
}

struct Case {
    text: String,
    numbers: &'static [&'static str],
    speed: f64,
}

/// A crank-slider, a four-bar or an eccentric, with what may be asked of it.
fn machine(state: &mut u64, kind: u64) -> Case {
    let r = within(state, 0.08, 0.15);
    let speed = within(state, 2.0, 12.0) * if random(state) < 0.3 { -1.0 } else { 1.0 };
    let mass = within(state, 0.5, 3.0);
    let friction = if random(state) < 0.5 {
        format!(" {{ friction {} }}", within(state, 0.05, 0.2))
    } else {
        String::new()
    };
    let (text, numbers): (String, &[&str]) = match kind % 3 {
        0 => (
            format!(
                "ground {{ A (0, 0); O (0, {} m); line way through O along 0 deg }}\nlink crank A-B {r} m {{ mass 1 kg at B }}\n\
                 link rod B-C {} m\nlink piston {{ C (0, 0); mass {mass} kg at C }}\nrevolute A: ground - crank\nrevolute B: \
                 crank - rod\nrevolute C: rod - piston\nprismatic G: piston.C - ground.way{friction}\nassemble G > 0\nforce P \
                 on piston at C = {} N @ 180 deg\n",
                within(state, -0.03, 0.03),
                within(state, 0.3, 0.5),
                within(state, 5.0, 50.0)
            ),
            &[
                "displacement(G)",
                "relative_velocity(G)",
                "acceleration(C).x",
                "omega(rod)",
                "M",
                "normal(G, piston)",
                "reaction(B, rod).x",
                "min(displacement(G), 0.3 m)",
            ],
        ),
        1 => (
            format!(
                "ground {{ A (0, 0); D (0.5 m, 0) }}\nlink crank A-B {r} m\nlink rod B-C {} m {{ S (0.2 m, 0.05 m); mass {mass} \
                 kg at S; inertia 0.02 kg*m^2 }}\nlink rocker D-C {} m {{ mass 1 kg at C }}\nrevolute A: ground - \
                 crank\nrevolute B: crank - rod\nrevolute C: rod - rocker\nrevolute D: ground - rocker\nassemble C left of B-D\n",
                within(state, 0.4, 0.55),
                within(state, 0.4, 0.55)
            ),
            &[
                "angle(rocker)",
                "omega(rocker)",
                "alpha(rod)",
                "M",
                "reaction(D, rocker).y",
                "mag(reaction(B, rod))",
                "sin(angle(rod))*omega(rocker)",
            ],
        ),
        _ => (
            format!(
                "ground {{ O (0, 0); T (0, 0.4 m); line way through O along 90 deg }}\nlink crank O-E {r} m {{ circle rim centre \
                 E radius 0.2 m }}\nlink follower {{ F (0, 0); line face through F along 90 deg; mass {mass} kg at F }}\nrevolute \
                 O: ground - crank\nprismatic V: follower.F - ground.way{friction}\ncontact K: crank.rim - \
                 follower.face\nassemble V > 0\nspring k: follower.F - ground.T {{ stiffness {} N/m; free_length 0.5 m }}\n",
                within(state, 100.0, 900.0)
            ),
            &[
                "displacement(V)",
                "relative_velocity(V)",
                "normal(K, follower)",
                "M",
                "relative_acceleration(V)",
            ],
        ),
    };
    Case { text: format!("gravity 9.81 m/s^2\n{text}balance torque M on crank\n"), numbers, speed }
}

fn solved(text: &str) -> assur::Solution {
    assur::solve(text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// A number at positions of the crank.
fn at(case: &Case, angles: &[f64], number: &str) -> Vec<f64> {
    let list: Vec<String> = angles.iter().map(|a| format!("{a} rad")).collect();
    let text = format!(
        "{}drive crank = {} at {} rad/s\nfind x = {number}\n",
        case.text,
        list.join(", "),
        case.speed
    );
    let solution = solved(&text);
    solution.poses().iter().map(|pose| pose["x"].number().expect("a number")).collect()
}

/// Where a number passes a level between two angles, and whether it rises there.
fn sections(case: &Case, number: &str, level: f64, (mut from, mut to): (f64, f64)) -> f64 {
    for _ in 0..3 {
        let angles: Vec<f64> = (0..=PARTS).map(|i| from + (to - from) * i as f64 / PARTS as f64).collect();
        let values = at(case, &angles, number);
        let pair =
            (0..PARTS).find(|i| (values[*i] - level) * (values[i + 1] - level) <= 0.0).expect("a change");
        (from, to) = (angles[pair], angles[pair + 1]);
    }
    let [a, b] = [from, to].map(|x| at(case, &[x], number)[0] - level);
    if a == b { from } else { from + (to - from) * (a / (a - b)).clamp(0.0, 1.0) }
}

/// The range of a sweep, and its drive.
fn range(state: &mut u64, speed: f64) -> (f64, f64, String) {
    let from = within(state, 0.0, TAU);
    let to = if random(state) < 0.3 { from + TAU } else { from + within(state, 2.0, 6.0) };
    let (from, to) = if random(state) < 0.3 { (to, from) } else { (from, to) };
    let steps = 3 + (random(state) * 20.0) as usize;
    (from, to, format!("drive crank = {from} rad .. {to} rad in {steps} steps at {speed} rad/s\n"))
}

#[test]
fn events_of_sweeps_are_roots() {
    let mut seen = [0; 3];
    for seed in first(0..200) {
        let state = &mut (seed * 977 + 5);
        let case = machine(state, seed);
        let (from, to, drive) = range(state, case.speed);
        let number = one_of(state, case.numbers);
        let dense: Vec<f64> = (0..=DENSE).map(|i| from + (to - from) * i as f64 / DENSE as f64).collect();
        let values = at(&case, &dense, number);
        let (least, most) = values.iter().fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(*x), b.max(*x)));
        // not so near an extreme that the dense list does not see both roots
        let level = least + (most - least) * within(state, 0.05, 0.95);
        let way = one_of(state, &["=", "= rising", "= falling", "<", ">"]);
        let rises = |i: usize| values[i] < level && values[i + 1] >= level;
        let falls = |i: usize| values[i] > level && values[i + 1] <= level;
        let wanted: Vec<usize> = (0..DENSE)
            .filter(|i| match way {
                "=" => rises(*i) || falls(*i),
                "= rising" | ">" => rises(*i),
                _ => falls(*i),
            })
            .collect();
        let places: Vec<f64> =
            wanted.iter().map(|i| sections(&case, number, level, (dense[*i], dense[i + 1]))).collect();
        let (sign, direction) = way.split_once(' ').unwrap_or((way, ""));
        let unit = unit_of(number);
        let finds: String = (1..=places.len())
            .map(|k| format!(", d{k} = drive(e, {k}) as rad, t{k} = time(e, {k})"))
            .collect();
        let expects: String = (1..=places.len())
            .map(|k| format!("expect {number} = {level} {unit} within 1e-6 at event e {k}\n"))
            .collect();
        let text = format!(
            "{}{drive}event e: {number} {sign} {level} {unit} {direction}\nfind n = count(e){finds}\n{expects}",
            case.text
        );
        let jumps = values.windows(2).any(|pair| (pair[1] - pair[0]).abs() > 0.1 * (most - least));
        let text = if jumps { text.replace(&expects, "") } else { text };
        let solution = solved(&text);
        assert_eq!(solution["n"].number(), Some(places.len() as f64), "seed {seed}\n{text}\n{places:?}");
        for (k, place) in places.iter().enumerate() {
            let found = solution[format!("d{}", k + 1).as_str()].number().expect("a value");
            assert!((found - place).abs() <= 1e-9, "seed {seed}: {found} is not {place}\n{text}");
            let time = solution[format!("t{}", k + 1).as_str()].number().expect("a value");
            assert!((time - (found - from) / case.speed).abs() <= 1e-14 * time.abs().max(1.0), "{text}");
        }
        assert!(solution.expectations().iter().all(|e| e.met), "seed {seed}\n{text}");
        seen[places.len().min(2)] += 1;
    }
    assert!(seen.iter().all(|seen| *seen > 0), "{seen:?}");
}

fn unit_of(number: &str) -> &'static str {
    [
        ("sin(", "rad/s"),
        ("acceleration(", "m/s^2"),
        ("velocity(", "m/s"),
        ("displacement(", "m"),
        ("omega(", "rad/s"),
        ("alpha(", "rad/s^2"),
        ("angle(", "rad"),
        ("M", "N*m"),
    ]
    .into_iter()
    .find(|(name, _)| number.contains(name))
    .map_or("N", |(_, unit)| unit)
}

#[test]
fn a_sweep_ends_as_one_that_goes_no_further() {
    for seed in first(0..60) {
        let state = &mut (seed * 31 + 7);
        let case = machine(state, seed);
        let (from, to, drive) = range(state, case.speed);
        let end = from + (to - from) * within(state, 0.2, 0.9);
        let number = one_of(state, case.numbers);
        let asked = format!(
            "find least = min({number}), most = max({number}), a = mean({number}), b = integral({number})\n"
        );
        let until = format!("{}{drive}until angle(crank) = {end} rad\n{asked}", case.text);
        let alone = format!(
            "{}drive crank = {from} rad .. {end} rad in 7 steps at {} rad/s\n{asked}",
            case.text, case.speed
        );
        let (ended, alone) = (solved(&until), solved(&alone));
        let size = ["least", "most"].map(|name| alone[name].number().expect("a value").abs());
        let size = size[0].max(size[1]);
        for name in ["least", "most", "a", "b"] {
            let [found, wanted] = [&ended, &alone].map(|s| s[name].number().expect("a value"));
            assert!(
                (found - wanted).abs() <= 1e-9 * size.max(1e-3),
                "seed {seed}: {name} {found} {wanted}\n{until}"
            );
        }
        let last = ended.poses().last().expect("a pose")["crank"].number().expect("an angle");
        assert!((last - end).abs() <= 1e-12 * end.abs().max(1.0), "{last} {end}\n{until}");
    }
}

#[test]
fn given_motions_are_sweeps() {
    for seed in first(0..60) {
        let state = &mut (seed * 131 + 3);
        let case = machine(state, seed % 2);
        // a motion that is given has no friction yet
        let text =
            case.text.lines().map(|line| line.split(" { friction").next().unwrap_or(line).to_owned() + "\n");
        let case = Case { text: text.collect(), ..case };
        let speed = case.speed.abs();
        let (from, length) = (within(state, 0.0, 3.0), within(state, 2.0, 8.0));
        let number = one_of(state, case.numbers);
        if number.starts_with("min(") {
            // what a motion's series leave off at a kink
            continue;
        }
        let (time, steps) = (length / speed, 5);
        let sweep = |events: &str, finds: &str| {
            solved(&format!(
                "{}drive crank = {from} rad .. {} rad in {steps} steps at {speed} rad/s\n{events}find x = {number}{finds}\n",
                case.text,
                from + length
            ))
        };
        let drive = if seed % 4 < 2 {
            format!("{from} rad at {speed} rad/s")
        } else {
            format!("{from} rad + {speed} rad/s*time")
        };
        let motion = |events: &str, finds: &str| {
            solved(&format!(
                "{}drive crank = {drive}\nsimulate 0 s .. {time} s in {steps} steps within 1e-10\n{events}find x = \
                 {number}{finds}\n",
                case.text
            ))
        };
        let finds = format!(", least = min({number}), most = max({number}), a = mean({number})");
        let (swept, moved) = (sweep("", &finds), motion("", &finds));
        let value = |solution: &assur::Solution, name| solution[name].number().expect("a value");
        let size = value(&swept, "least").abs().max(value(&swept, "most").abs());
        for name in ["least", "most", "a"] {
            let [a, b] = [&swept, &moved].map(|s| value(s, name));
            assert!(
                (a - b).abs() <= 1e-8 * size,
                "seed {seed}: {name} {a} {b}\n{}\n{number} {drive}",
                case.text
            );
        }
        let [a, b] = [&swept, &moved]
            .map(|s| s.poses().iter().map(|p| p["x"].number().expect("a value")).collect::<Vec<_>>());
        for (a, b) in a.iter().zip(&b) {
            assert!((a - b).abs() <= 1e-9 * size, "seed {seed}: {a} {b}\n{}\n{number} {drive}", case.text);
        }
        let level = 0.5 * (value(&swept, "least") + value(&swept, "most"));
        let event = format!("event e: {number} = {level} {}\n", unit_of(number));
        let count = sweep(&event, ", n = count(e)");
        let count = value(&count, "n");
        assert_eq!(
            Some(count),
            motion(&event, ", n = count(e)")["n"].number(),
            "seed {seed}\n{}{event}",
            case.text
        );
        for k in 1..=count as usize {
            let find = format!(", t = time(e, {k})");
            let [a, b] = [sweep(&event, &find), motion(&event, &find)].map(|s| value(&s, "t"));
            assert!((a - b).abs() <= 1e-9 * time, "seed {seed}: {a} {b}\n{}{event}", case.text);
        }
    }
}
