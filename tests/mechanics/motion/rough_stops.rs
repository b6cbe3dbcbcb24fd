//! Stops next to hinges that rub: random chains of three links against the laws of momentum, and of motion with Coulomb's friction in
//! every hinge, of all bodies with multipliers, which the solver does not use.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

use super::impacts::{Bodies, Stop, chain, judge_impact};
use crate::support::random::Random;
use assur::internals::check::Overrides;
use assur::internals::model::Mechanism;
use assur::internals::position::State;
use assur::internals::solve_source;
use assur::internals::source::Source;
use nalgebra::{DMatrix, DVector};

/// What laws are kept to, of the greatest force.
const TOLERANCE: f64 = 1e-7;
/// A stop is touched below this gap, rad.
const TOUCHED: f64 = 1e-9;
/// A hinge slides above this speed, rad/s, and rests below that one.
const SLIDES: f64 = 1e-5;
const RESTS: f64 = 1e-8;

/// A random chain with friction in its hinges, and the radii of their friction circles, m.
fn rough(seed: u64, steps: &str) -> (String, Vec<Stop>, [f64; 3]) {
    let (text, stops) = chain(seed);
    let mut random = Random::new(seed + 5_000);
    let radii = [(); 3].map(|()| if random.chance(0.2) { 0.0 } else { random.within(0.002, 0.04) });
    let lines = text.lines().map(|line| {
        let hinge = (0..3).find(|i| line.starts_with(&format!("revolute H{i}:")));
        match hinge {
            Some(i) if radii[i] > 0.0 => format!("{line} {{ friction_circle {} m }}\n", radii[i]),
            _ => format!("{line}\n"),
        }
    });
    let text: String = lines.collect();
    (text.replace("simulate 0.8 s", &format!("simulate 0.8 s{steps}")), stops, radii)
}

/// What became of the hinges and stops of an instant.
#[derive(Default, Debug)]
struct Seen {
    sliding: usize,
    held: usize,
    closed: usize,
}

/// The laws of motion of all bodies at an instant, with friction in every hinge and stops that are touched.
fn judge(
    name: &str,
    (mechanism, state): (&Mechanism, &State),
    stops: &[Stop],
    radii: [f64; 3],
    seen: &mut Seen,
) {
    let bodies = Bodies { mechanism, state };
    for stop in stops {
        assert!(bodies.gap(stop) > -TOUCHED, "{name}: {stop:?} is passed by {}", -bodies.gap(stop));
    }
    let (rates, a) = (bodies.velocities(), bodies.accelerations());
    let mut wanted = bodies.momentum(&a);
    for (i, mass) in bodies.masses().iter().enumerate() {
        wanted[3 * i + 1] += 9.81 * mass.mass;
    }
    // a torque in each hinge, whatever gives it
    let plain = bodies.directions(&[]);
    let mut columns = DMatrix::zeros(9, 9);
    columns.view_mut((0, 0), (9, 6)).copy_from(&plain);
    for hinge in 0..3 {
        columns[(3 * hinge + 2, 6 + hinge)] = 1.0;
        if hinge > 0 {
            columns[(3 * hinge - 1, 6 + hinge)] = -1.0;
        }
    }
    let found = columns.lu().solve(&wanted).unwrap();
    let scale = found.amax();
    let between =
        |of: &DVector<f64>, hinge: usize| of[3 * hinge + 2] - if hinge > 0 { of[3 * hinge - 1] } else { 0.0 };
    for hinge in 0..3 {
        let most = radii[hinge] * found.rows(2 * hinge, 2).norm();
        let (torque, speed, begins) = (found[6 + hinge], between(&rates, hinge), between(&a, hinge));
        let touched: Vec<&Stop> =
            stops.iter().filter(|s| s.hinge == hinge && bodies.gap(s) < TOUCHED).collect();
        let what = format!(
            "{name}: hinge {hinge}, torque {torque}, friction {most}, {speed}, {begins}, {touched:?}"
        );
        if speed.abs() > SLIDES {
            seen.sliding += 1;
            assert!((torque + speed.signum() * most).abs() < TOLERANCE * scale, "slides, {what}");
        } else if speed.abs() < RESTS && begins.abs() < RESTS {
            // friction holds, and stops press
            let presses = |sign: f64| touched.iter().any(|stop| stop.sign == sign);
            seen.held += usize::from(torque.abs() <= most);
            seen.closed += usize::from(torque.abs() > most + TOLERANCE * scale);
            assert!(torque < most + TOLERANCE * scale || presses(1.0), "rests, {what}");
            assert!(torque > -most - TOLERANCE * scale || presses(-1.0), "rests, {what}");
        } else if speed.abs() < RESTS && begins.abs() > SLIDES {
            assert!((torque + begins.signum() * most).abs() < TOLERANCE * scale, "begins to slide, {what}");
            assert!(touched.iter().all(|stop| stop.sign * begins > 0.0), "begins to slide, {what}");
        }
    }
}

/// The states of a run, unless its rebounds end in no series, or so small a difference decides about them that its runs do not agree.
fn states(name: &str, text: &str) -> Option<(Mechanism, Vec<State>)> {
    let (solved, problems) = solve_source(&Source::new("chain", text), &Overrides::none());
    let ended = ["mech::simulate::shaken", "mech::simulate::tolerance"].iter().any(|code| problems.has(code));
    let Some(solved) = solved.filter(|_| !problems.has_errors() || ended) else {
        panic!("{name}\n{text}\n{problems:?}")
    };
    let poses = solved.solution.poses.iter();
    let states = poses.filter_map(|p| Some(p.outcome.as_ref().ok()?.state.clone())).collect();
    (!ended).then(|| (solved.compiled.mechanism.clone(), states))
}

#[test]
fn impacts_next_to_friction_keep_the_momentum_of_all_bodies() {
    let (mut impacts, mut runs, mut shaken) = (0, 0, 0);
    for seed in 0..super::many(20) {
        let name = format!("chain {seed}");
        let (text, stops, _) = rough(seed, "");
        let Some((mechanism, states)) = states(&name, &text) else {
            shaken += 1;
            continue;
        };
        runs += 1;
        for two in states.windows(2).filter(|two| two[0].motion.time == two[1].motion.time) {
            let change = [0, 1].map(|i| Bodies { mechanism: &mechanism, state: &two[i] }.velocities());
            if (&change[1] - &change[0]).norm() > 1e-6 {
                let name = format!("{name} at {} s", two[0].motion.time);
                impacts += usize::from(judge_impact(&name, &mechanism, &stops, [&two[0], &two[1]]) > 0);
            }
        }
    }
    println!("{runs} runs, {shaken} shaken, {impacts} impacts");
    assert!(impacts > 2 * runs && 5 * shaken <= runs);
}

#[test]
fn friction_next_to_stops_keeps_the_laws_of_all_bodies() {
    let (mut seen, mut runs, mut ended) = (Seen::default(), 0, 0);
    // all of them: a fifth does not meet everything that is counted below
    for seed in 0..20 * super::times().unwrap_or(1) {
        let name = format!("chain {seed}");
        let (text, stops, radii) = rough(seed, " in 60 steps");
        let Some((mechanism, states)) = states(&name, &text) else {
            ended += 1;
            continue;
        };
        runs += 1;
        for state in &states {
            let name = format!("{name} at {} s", state.motion.time);
            judge(&name, (&mechanism, state), &stops, radii, &mut seen);
        }
    }
    println!("{runs} runs, {ended} ended, {seen:?}");
    assert!(
        ended * 5 <= runs && seen.sliding > 60 * runs && seen.closed > runs && seen.held > runs,
        "{seen:?}"
    );
}
