//! Animations of machines: every body that the answers move is moved by its own motion, in every frame.

use crate::drawn::solved;
use crate::every_example::examples;
use crate::frames::{all_series, lists, motion, page, series};
use crate::support::random::Random;
use assur::internals::Solved;
use assur::internals::math::Vec2;
use assur::internals::model::{LinkId, PairKind, Transmission, TransmissionKind};
use assur::internals::pipeline::{turn, turn_in};
use std::fmt::Write;

/// Frames of an animation of a random machine.
const FRAMES: usize = 41;
/// What a series may be off: turns are rounded to a hundredth of a degree, places to a hundredth of a millimetre.
const OFF: f64 = 0.03;

/// How a group of marks moves: of each body in it right and down, mm, and its turn, deg, in every frame.
type Series = [Vec<f64>; 3];

/// The bodies of the marks of a group.
fn bodies(page: &str, class: &str, name: &str) -> Vec<Series> {
    let motion = motion(page);
    let (all, bodies) = (all_series(&motion["series"]), lists(&motion["bodies"]));
    let start = format!("<g class=\"{class}\" data-name=\"{name}\">");
    let mut found = Vec::new();
    for group in page.split(&start).skip(1) {
        // the group of the next thing has a name too
        let group = group.split("data-name=").next().unwrap_or_default();
        for mark in group.split("<g class=\"m").skip(1) {
            let index: String = mark.chars().take_while(char::is_ascii_digit).collect();
            let body = &bodies[index.parse::<usize>().expect("a number")];
            let column = |i: usize| match body.get(i) {
                Some(k) => all[*k as usize].iter().map(|x| x / 100.0).collect(),
                None => vec![0.0; all[body[2] as usize].len()],
            };
            found.push([column(2), column(3), column(4)]);
        }
    }
    found
}

/// The numbers below the picture with the size of their last digit.
fn answers(page: &str) -> Vec<(String, Vec<f64>, f64)> {
    let values = motion(page)["values"].clone();
    let one = |value: &serde_json::Value| {
        let last = 10_f64.powi(-i32::try_from(value[2].as_i64().expect("decimals")).expect("few"));
        let all = series(value[3].as_str().unwrap_or_default()).into_iter().map(|x| x * last);
        (value[0].as_str().expect("a name").to_owned(), all.collect(), last)
    };
    values.as_array().expect("a list").iter().map(one).collect()
}

/// How far an angle is from another but for whole turns, deg.
fn apart(a: f64, b: f64) -> f64 {
    let d = (a - b).rem_euclid(360.0);
    d.min(360.0 - d)
}

/// A random machine whose file asks for the angle of every shaft and the way of every slider, with the wheels of each shaft.
struct Machine {
    text: String,
    /// Shafts or links with one of their wheels.
    wheels: Vec<(String, String)>,
    sliders: Vec<String>,
}

fn machine(random: &mut Random) -> Machine {
    let mut made = Machine { text: String::new(), wheels: Vec::new(), sliders: Vec::new() };
    let module = random.within(2.0, 6.0);
    let wheel =
        |made: &mut Machine, link: &str, name: &str| made.wheels.push((link.to_owned(), name.to_owned()));
    let [z1, z2] = [17 + random.below(24), 30 + random.below(60)];
    let (r1, r2) = (module * z1 as f64 / 2.0, module * z2 as f64 / 2.0);
    let at = random.within(0.0, std::f64::consts::TAU);
    let place = |made: &mut Machine, random: &mut Random| -> [&'static str; 2] {
        if random.below(2) == 0 {
            return ["", ""];
        }
        let Vec2 { x, y } = Vec2::direction(at) * (r1 + r2);
        let _ = writeln!(made.text, "ground {{ P (0, 0); Q ({x:.12} mm, {y:.12} mm) }}");
        match random.below(3) {
            0 => [" at P", ""],
            1 => ["", " at Q"],
            _ => [" at P", " at Q"],
        }
    };
    let kind = random.below(6);
    match kind {
        // gears, and what the second shaft moves
        0..=3 => {
            let [p, q] = place(&mut made, random);
            let drum = random.within(0.4, 1.6) * r2;
            let own = match kind {
                0 => format!("wheel c radius {drum:.6} mm{q}"),
                1 => format!("wheel c teeth {} module {module:.6} mm{q}", 18 + random.below(42)),
                _ => format!("wheel c diameter {drum:.6} mm{q}"),
            };
            let _ = write!(
                made.text,
                "shaft M {{ wheel a teeth {z1} module {module:.6} mm{p} }}\nshaft N {{ wheel b teeth {z2} module {module:.6} mm{q}; {own} }}\nmesh ab: a - b\n"
            );
            for (link, name) in [("M", "a"), ("N", "b"), ("N", "c")] {
                wheel(&mut made, link, name);
            }
            match kind {
                0 => made.text += "shaft R { wheel d radius 55 mm }\nbelt cd: c - d\n",
                1 => made.text += "slider L\nrack cl: c - L\n",
                2 => {
                    made.text += [
                        "slider L\nrope cl: L - c\n",
                        "slider L\nrope cl: c - over(C) - L\n",
                        "slider L\nrope cl: c - over(C) - under(L) - ground\n",
                    ][random.below(3)]
                }
                _ => made.text += "slider L\nrope cl: L - c\nslider K\nrope ck: K - b\n",
            }
            match kind {
                0 => wheel(&mut made, "R", "d"),
                3 => made.sliders.extend(["L".to_owned(), "K".to_owned()]),
                _ => made.sliders.push("L".to_owned()),
            }
        }
        // a planetary train
        4 => {
            let ring = z1 + 2 * z2;
            let _ = write!(
                made.text,
                "shaft M {{ wheel a teeth {z1} module {module:.6} mm }}\nshaft H\nshaft P on H {{ wheel p teeth {z2} }}\nground {{ wheel r teeth {ring} }}\nmesh ap: a - p\nmesh pr: p - r {{ internal }}\n"
            );
            for (link, name) in [("M", "a"), ("P", "p")] {
                wheel(&mut made, link, name);
            }
        }
        // a wheel on the crank of a linkage
        _ => {
            let _ = write!(
                made.text,
                "ground {{ O (0, 0); D ({:.6} mm, 0) }}\nlink crank O-A {:.6} mm {{ wheel b teeth {z2} module {module:.6} mm at O }}\n\
                 link rod A-B {:.6} mm\nlink rocker D-B {:.6} mm\nrevolute O: ground - crank\nrevolute A: crank - rod\nrevolute B: rod - rocker\n\
                 revolute D: ground - rocker\nassemble B left of A-D\nshaft M {{ wheel a teeth {z1} module {module:.6} mm }}\nmesh ab: a - b\n",
                2.2 * r2,
                0.6 * r2,
                2.0 * r2,
                1.5 * r2,
            );
            for (link, name) in [("M", "a"), ("crank", "b")] {
                wheel(&mut made, link, name);
            }
        }
    }
    let end = random.within(40.0, 700.0);
    let sense = ["at 60 rpm", "at -60 rpm", "turning cw", ""][random.below(4)];
    let _ = writeln!(made.text, "drive M = 0 deg .. {end:.6} deg in 40 steps {sense}");
    let links: std::collections::BTreeSet<&str> = made.wheels.iter().map(|w| w.0.as_str()).collect();
    let angles = links.iter().map(|link| format!("angle({link}) as deg"));
    let ways = made.sliders.iter().map(|slider| format!("displacement({slider}) as mm"));
    let _ = writeln!(made.text, "find {}", angles.chain(ways).collect::<Vec<_>>().join(", "));
    made
}

/// What is wrong with the page of a machine.
fn judge(name: &str, made: &Machine) -> Vec<String> {
    let mut wrong = Vec::new();
    let Some((source, solved)) = solved(name, &made.text) else {
        return vec![format!("{name} is not solved:\n{}", made.text)];
    };
    let way = turn_in(&solved.compiled, &solved.solution, FRAMES);
    let Some(page) = page(&source, &solved, &way) else {
        return vec![format!("{name} does not move:\n{}", made.text)];
    };
    let answers = answers(&page);
    let answer = |name: &str| answers.iter().find(|a| a.0 == name);
    for (link, own) in &made.wheels {
        let Some((_, angles, last)) = answer(&format!("angle({link})")) else {
            wrong.push(format!("{name}: no angle of {link}"));
            continue;
        };
        // y of paper is down
        let follows = |[_, _, turn]: &Series| {
            turn.iter().zip(angles).all(|(turn, angle)| apart(-turn, angle - angles[0]) < OFF + 1.1 * last)
        };
        if !bodies(&page, "wheel", own).iter().any(follows) {
            wrong.push(format!("{name}: wheel {own} does not turn as {link}"));
        }
    }
    for slider in &made.sliders {
        let Some((_, ways, last)) = answer(&format!("displacement({slider})")) else {
            wrong.push(format!("{name}: no way of {slider}"));
            continue;
        };
        let far = ways.iter().map(|s| (s - ways[0]).abs()).fold(0.0, f64::max);
        let follows = |[right, down, _]: &Series| {
            let gone: Vec<f64> =
                right.iter().zip(down).map(|(x, y)| if x.abs() > y.abs() { *x } else { *y }).collect();
            let most = gone.iter().copied().fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
            let scale = most
                / ways
                    .iter()
                    .map(|s| s - ways[0])
                    .fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
            most.abs() > 1.0
                && gone
                    .iter()
                    .zip(ways)
                    .all(|(gone, s)| (gone - (s - ways[0]) * scale).abs() < OFF + 2.2 * last * scale.abs())
        };
        let classes = ["link", "pair"].into_iter().zip([slider.as_str(), "cl"]);
        if far > 0.0
            && !classes.flat_map(|(class, name)| bodies(&page, class, name)).any(|body| follows(&body))
        {
            wrong.push(format!("{name}: {slider} does not go as its answer"));
        }
    }
    if !wrong.is_empty() {
        wrong.push(made.text.clone());
    }
    wrong
}

#[test]
fn wheels_and_loads_of_random_machines_move_as_their_answers() {
    let count = crate::share::part(300);
    let mut wrong = Vec::new();
    for seed in 0..count {
        let made = machine(&mut Random::new(seed));
        wrong.extend(judge(&format!("machine {seed}"), &made));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The links of an example that turn, or would at the speeds of its position.
fn turning(solved: &Solved) -> Vec<LinkId> {
    let way = turn(&solved.compiled, &solved.solution);
    let poses = if way.is_empty() { &solved.solution.poses } else { &way };
    let states: Vec<_> =
        poses.iter().filter_map(|pose| pose.outcome.as_ref().ok()).map(|solved| &solved.state).collect();
    let links = (1..solved.compiled.mechanism.links.len()).map(LinkId::at);
    let turns = |link: &LinkId| {
        let body = |i: usize| &states[i].motion.bodies[link.index()];
        (1..states.len()).any(|i| (body(i).u - body(0).u).norm() > 0.05)
    };
    if states.is_empty() { Vec::new() } else { links.filter(turns).collect() }
}

#[test]
fn wheels_of_all_examples_turn_where_their_links_do() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let Some(page) = crate::drawn::animated(&source, &solved) else { continue };
        let data = motion(&page);
        let moves =
            ["bodies", "redrawn"].into_iter().any(|part| !data[part].as_array().expect("a list").is_empty());
        if !moves {
            wrong.push(format!("{name}: nothing moves"));
        }
        if let Some((_, values, _)) = answers(&page).first() {
            let steps = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
            let mut steps: Vec<f64> = steps.collect();
            steps.sort_by(f64::total_cmp);
            let (median, most) = (steps[steps.len() / 2], steps[steps.len() - 1]);
            if solved.compiled.mechanism.simulation.is_none() && most > 4.0 * median {
                wrong.push(format!("{name}: the drive jumps by {most}, its usual step is {median}"));
            }
        }
        let mechanism = &solved.compiled.mechanism;
        let is_bevel = |t: &Transmission| t.bevel.is_some();
        let transmissions = || {
            mechanism.pairs.iter().filter_map(|pair| match &pair.kind {
                PairKind::Transmission(t) => Some(t),
                _ => None,
            })
        };
        if transmissions().any(is_bevel) {
            continue;
        }
        let worms: Vec<&str> = transmissions()
            .filter(|t| t.kind == TransmissionKind::Worm)
            .filter_map(|t| t.ends.first())
            .map(String::as_str)
            .collect();
        let turning = turning(&solved);
        for wheel in
            mechanism.wheels.iter().filter(|w| turning.contains(&w.link) && !worms.contains(&w.name.as_str()))
        {
            count += 1;
            let turns = |[_, _, turn]: &Series| turn.iter().any(|t| (t - turn[0]).abs() > 1.0);
            if !bodies(&page, "wheel", &wheel.name).iter().any(turns) {
                wrong.push(format!("{name}: wheel {} stands still", wheel.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 30, "{count} wheels");
}

#[test]
fn a_link_with_a_mark_of_its_own_gets_no_disc() {
    let text = "ground { A (0, 0); line guide through A along 0 deg }\nlink crank A-B 40 mm\nlink rod B-C 120 mm\n\
                link ram { C (0, 0) }\nrevolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - ram\n\
                prismatic D: ram.C - ground.guide\nassemble C ahead of A\ndrive crank = 30 deg at 60 rpm\nfind velocity(C)\n";
    let (source, solved) = solved("crank-slider", text).expect("it is solved");
    let page = crate::drawn::animated(&source, &solved).expect("it moves");
    let links = page.split("<g class=\"link\" data-name=\"ram\">").skip(1);
    let own = links.map(|group| group.split("data-name=").next().unwrap_or_default());
    assert!(own.into_iter().all(|group| !group.contains("<circle")), "the ram has its block");
    let text = "ground { A (0, 0) }\nlink rotor { A (0, 0) }\nrevolute A: ground - rotor\ndrive rotor = 0 deg at 60 rpm\nfind omega(rotor)\n";
    let (source, solved) = crate::drawn::solved("rotor", text).expect("it is solved");
    let page = crate::drawn::animated(&source, &solved).expect("it moves");
    assert!(bodies(&page, "link", "rotor").iter().any(|[_, _, turn]| turn.iter().any(|t| t.abs() > 90.0)));
}
