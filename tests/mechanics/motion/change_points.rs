//! Change points of several free coordinates: parallelograms on a bar that swings on a cart, against the laws of motion of all bodies with
//! multipliers for hinges and guide, which the solver does not use.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

use crate::support::random::Random;
use assur::internals::check::Overrides;
use assur::internals::math::Vec2;
use assur::internals::model::Mechanism;
use assur::internals::position::State;
use assur::internals::solve_source;
use assur::internals::source::Source;
use nalgebra::{DMatrix, DVector};

/// What laws are kept to, of the greatest force.
const TOLERANCE: f64 = 1e-8;
/// Links in the order of the file, the ground first.
const CART: usize = 1;
const BAR: usize = 2;
const LEFT: usize = 3;
const RIGHT: usize = 4;
const COUPLER: usize = 5;

/// A scene and its hinges: a place on one link that is one on another.
struct Scene {
    text: String,
    hinges: [(usize, Vec2, usize, Vec2); 5],
    rolls: bool,
}

fn scene(seed: u64) -> Scene {
    let mut random = Random::new(seed);
    let mut between = |low: f64, high: f64| random.within(low, high);
    let (p, base, crank) = (between(0.1, 0.6), between(0.3, 0.6), between(0.1, 0.28));
    let (q, angle, relative) = (p + base, between(-120.0, 120.0_f64), between(50.0, 130.0_f64));
    let rate = if between(0.0, 1.0) < 0.5 { between(8.0, 16.0) } else { -between(8.0, 16.0) };
    let masses = [(); 5].map(|()| (between(0.5, 3.0), between(0.005, 0.1)));
    let rolls = between(0.0, 1.0) < 0.5;
    let mass = |i: usize, x: f64| {
        let (mass, inertia) = masses[i];
        format!("S ({x} m, 0); mass {mass} kg at S; inertia {inertia} kg*m^2")
    };
    let turned = |angle: f64, length: f64| Vec2::direction(angle.to_radians()) * length;
    let b = turned(angle, q) + turned(angle + relative, crank);
    let start = if rolls { "start G = 0 m" } else { "drive G = 0 m" };
    let text = format!(
        "gravity 9.81 m/s^2
ground {{ O (0, 0); line way through O along 0 deg }}
link cart {{ C (0, 0); mass {} kg at C }}
link bar {{ O (0, 0); P ({p} m, 0); Q ({q} m, 0); {} }}
link left P-A {crank} m {{ {} }}
link right Q-B {crank} m {{ {} }}
link coupler A-B {base} m {{ {} }}
prismatic G: cart.C - ground.way
revolute O: cart.C - bar.O
revolute P: bar - left
revolute Q: bar - right
revolute A: left - coupler
revolute B: right - coupler
assemble B near ({} m, {} m)
{start}
start bar = {angle} deg at {} rad/s
start left = {} deg at {rate} rad/s
simulate 0.5 s in 100 steps within 1e-9
find energy()
",
        masses[0].0,
        mass(1, 0.5 * q),
        mass(2, 0.4 * crank),
        mass(3, 0.6 * crank),
        mass(4, 0.3 * base),
        b.x,
        b.y,
        between(-2.0, 2.0),
        angle + relative,
    );
    let at = |x: f64| Vec2::new(x, 0.0);
    let hinges = [
        (CART, at(0.0), BAR, at(0.0)),
        (BAR, at(p), LEFT, at(0.0)),
        (BAR, at(q), RIGHT, at(0.0)),
        (LEFT, at(crank), COUPLER, at(0.0)),
        (RIGHT, at(crank), COUPLER, at(base)),
    ];
    Scene { text, hinges, rolls }
}

/// What the laws of motion leave over, of the greatest force, and what hinges are open by, m and m/s.
fn left(scene: &Scene, mechanism: &Mechanism, state: &State) -> (f64, f64) {
    let bodies = &state.motion.bodies;
    let count = bodies.len() - 1;
    let centre = |i: usize| bodies[i].position(mechanism.links[i].mass.as_ref().unwrap().centre);
    let mut wanted = DVector::zeros(3 * count);
    for i in 1..=count {
        let mass = mechanism.links[i].mass.as_ref().unwrap();
        let a = bodies[i].acceleration(mass.centre);
        wanted[3 * i - 3] = mass.mass * a.x;
        wanted[3 * i - 2] = mass.mass * (a.y + 9.81);
        wanted[3 * i - 1] = mass.inertia * bodies[i].alpha;
    }
    // forces of hinges, then of the guide, then of the drive
    let columns = 10 + 2 + usize::from(!scene.rolls);
    let mut directions = DMatrix::zeros(3 * count, columns);
    let mut open = 0.0_f64;
    for (k, (one, at, other, there)) in scene.hinges.iter().enumerate() {
        let place = bodies[*one].position(*at);
        open = open.max((place - bodies[*other].position(*there)).norm());
        open = open.max((bodies[*one].velocity(*at) - bodies[*other].velocity(*there)).norm());
        for (body, sign) in [(*one, 1.0), (*other, -1.0)] {
            let arm = place - centre(body);
            let row = 3 * (body - 1);
            directions[(row, 2 * k)] = sign;
            directions[(row + 1, 2 * k + 1)] = sign;
            directions[(row + 2, 2 * k)] = -sign * arm.y;
            directions[(row + 2, 2 * k + 1)] = sign * arm.x;
        }
    }
    (directions[(1, 10)], directions[(2, 11)]) = (1.0, 1.0);
    if !scene.rolls {
        directions[(0, 12)] = 1.0;
    }
    let found = directions.clone().svd(true, true).solve(&wanted, 1e-12).unwrap();
    ((directions * &found - &wanted).norm() / wanted.norm(), open)
}

#[test]
fn parallelograms_on_a_swing_go_on_as_all_bodies_at_once() {
    let (mut passed, mut instants, mut worst) = (0, 0, 0.0_f64);
    for seed in 0..super::many(12) {
        let scene = scene(seed);
        let (solved, problems) = solve_source(&Source::new("swing", &scene.text), &Overrides::none());
        let solved = solved.filter(|_| !problems.has_errors());
        let solved = solved.unwrap_or_else(|| panic!("seed {seed}\n{}\n{problems:?}", scene.text));
        let mechanism = &solved.compiled.mechanism;
        let run = solved.solution.simulation.as_ref().unwrap();
        passed += run.crossed.len();
        let mut energies: Vec<f64> = Vec::new();
        for pose in &solved.solution.poses {
            let state = &pose.outcome.as_ref().unwrap().state;
            let bodies = &state.motion.bodies;
            let name = format!("seed {seed} at {} s", state.motion.time);
            // the bars stay parallel
            let apart = |i: usize, j: usize| (bodies[i].u - bodies[j].u).norm();
            assert!(apart(LEFT, RIGHT) < 1e-8 && apart(BAR, COUPLER) < 1e-8, "{name}");
            let (forces, open) = left(&scene, mechanism, state);
            assert!(open < 1e-8 && forces < TOLERANCE, "{name}: {forces:e}, {open:e}");
            worst = worst.max(forces);
            instants += 1;
            energies.push(state.kinetic_energy(mechanism) + state.potential_energy(mechanism));
        }
        if scene.rolls {
            let off = energies.iter().map(|e| (e - energies[0]).abs()).fold(0.0, f64::max);
            let kinetic = solved.solution.poses[0].outcome.as_ref().unwrap().state.kinetic_energy(mechanism);
            assert!(off < 1e-8 * kinetic.max(1.0), "seed {seed}: energy {off:e}");
        }
    }
    println!("{instants} instants, {passed} change points passed, worst {worst:e}");
    assert!(passed > crate::share::least(12), "{passed}");
}
