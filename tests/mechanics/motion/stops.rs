//! Impacts on stops against the laws of momentum of all bodies, which the solver does not use.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

use assur::internals::check::Overrides;
use assur::internals::solve_source;
use assur::internals::source::Source;

const KNEE: &str = "mech 1
gravity 9.81 m/s^2
ground { O (0, 0) }
link one O-A 1 m { S (0.5 m, 0); mass 1 kg at S; inertia 0.1 kg*m^2 }
link two { A (0, 0); T (0.4 m, 0); mass 2 kg at T; inertia 0.1 kg*m^2 }
revolute O: ground - one
revolute A: one - two
stop A < 30 deg { restitution 0.4 }
stop A > -10 deg
start one = 0 deg
start two = 0 deg at 2 rad/s
simulate 3 s within 1e-11
event hit: displacement(A) = 30 deg
event back: relative_velocity(A) = 0 rad/s falling
find angle(one), energy()
";

/// Angular momentum about the hinge of the ground, kinetic energy and rate of the knee, just before and after each impact.
fn around_impacts() -> Vec<[[f64; 3]; 2]> {
    let (solved, problems) = solve_source(&Source::new("knee", KNEE), &Overrides::none());
    let solved = solved.unwrap_or_else(|| panic!("{problems:?}"));
    let mechanism = &solved.compiled.mechanism;
    let states = solved.solution.poses.iter().map(|pose| &pose.outcome.as_ref().unwrap().state);
    let of = |state: &assur::internals::position::State| {
        let massive = mechanism.links.iter().zip(&state.motion.bodies);
        let momentum = massive.filter_map(|(link, body)| {
            let mass = link.mass.as_ref()?;
            let (p, v) = (body.position(mass.centre), body.velocity(mass.centre));
            Some(mass.mass * p.cross(v) + mass.inertia * body.omega)
        });
        let bodies = &state.motion.bodies;
        [momentum.sum(), state.kinetic_energy(mechanism), bodies[2].omega - bodies[1].omega]
    };
    let all: Vec<_> = states.map(|state| (state.motion.time, of(state))).collect();
    let both = all.windows(2).filter(|two| two[0].0 == two[1].0);
    both.map(|two| [two[0].1, two[1].1]).collect()
}

#[test]
fn an_impact_between_links_keeps_the_momentum_about_the_ground() {
    let impacts = around_impacts();
    assert!(impacts.len() >= 2, "{impacts:?}");
    for [before, after] in impacts {
        assert!((after[0] - before[0]).abs() <= 1e-12 * before[0].abs().max(1.0), "{before:?} {after:?}");
        assert!((after[2] + 0.4 * before[2]).abs() <= 1e-12 * before[2].abs(), "{before:?} {after:?}");
        assert!(after[1] < before[1]);
    }
}

/// A bar on two sliders with a stop each; their names are `G` and `H`.
fn bar(stops: [f64; 2], starts: [[f64; 2]; 2], time: f64) -> String {
    let [[g, h], [v_g, v_h]] = starts;
    format!(
        "mech 1
gravity 9.81 m/s^2
ground {{ O (0, 0); P (1 m, 0); line left_way through O along 90 deg; line right_way through P along 90 deg }}
link one {{ A (0, 0); mass 1 kg at A }}
link two {{ B (0, 0); mass 2 kg at B }}
link bar {{ A (0, 0); line way through A along 0 deg; S (0.7 m, 0); mass 3 kg at S; inertia 0.1 kg*m^2 }}
prismatic G: one.A - ground.left_way
prismatic H: two.B - ground.right_way
revolute A: one - bar
slot K: two.B - bar.way
assemble K > 0
stop G > 0 mm {{ restitution {} }}
stop H > 0 mm {{ restitution {} }}
start G = {g} m at {v_g} m/s
start H = {h} m at {v_h} m/s
simulate {time} s within 1e-11
event left: displacement(G) = 0 mm falling
event right: displacement(H) = 0 mm falling
event stands: rests(G)
event leaves: not rests(G)
event lies: rests(H)
event turns: relative_velocity(H) = 0 m/s rising
find displacement(G), displacement(H), rests(G), rests(H), energy()
",
        stops[0], stops[1]
    )
}

/// Rates of both sliders, and the kinetic energy, at all printed instants.
fn rates(text: &str) -> Vec<(f64, [f64; 2], f64)> {
    let (solved, problems) = solve_source(&Source::new("bar", text), &Overrides::none());
    let solved = solved.filter(|_| !problems.has_errors()).unwrap_or_else(|| panic!("{problems:?}"));
    let mechanism = &solved.compiled.mechanism;
    let states = solved.solution.poses.iter().map(|pose| &pose.outcome.as_ref().unwrap().state);
    let each = states.map(|state| {
        let bodies = &state.motion.bodies;
        (state.motion.time, [bodies[1].v.y, bodies[2].v.y], state.kinetic_energy(mechanism))
    });
    each.collect()
}

/// The masses of both coordinates at a place, from kinetic energies.
fn masses(place: [f64; 2]) -> [[f64; 2]; 2] {
    let energy = |speeds| rates(&bar([0.0; 2], [[place[0] + 1.0, place[1] + 1.0], speeds], 1e-3))[0].2;
    let (one, other, both) = (energy([1.0, 0.0]), energy([0.0, 1.0]), energy([1.0, 1.0]));
    [[2.0 * one, both - one - other], [both - one - other, 2.0 * other]]
}

/// Impulses from the rates before and after.
fn impulses(masses: [[f64; 2]; 2], before: [f64; 2], after: [f64; 2]) -> [f64; 2] {
    let change = [after[0] - before[0], after[1] - before[1]];
    masses.map(|row| row[0] * change[0] + row[1] * change[1])
}

#[test]
fn a_bar_that_stands_on_one_end_lands_on_the_other() {
    for restitution in [0.0, 0.4] {
        let found = rates(&bar([0.0, restitution], [[0.3, 0.6], [0.0; 2]], 0.6));
        let both: Vec<_> = found.windows(2).filter(|two| two[0].0 == two[1].0).collect();
        // first the left end lands
        let (before, after) = (both[0][0].1, both[0][1].1);
        assert!(before[0] < -2.0 && after[0].abs() < 1e-12, "{both:?}");
        // the right end presses on the left one, which stands
        let second = both.iter().find(|two| two[0].1[1] < -1.0 && two[0].1[0].abs() < 1e-9).unwrap();
        let (before, after) = (second[0].1, second[1].1);
        assert!((after[1] + restitution * before[1]).abs() < 1e-9, "{second:?}");
        let given = impulses(masses([0.0, 0.0]), before, after);
        let greatest = given[0].abs().max(given[1].abs());
        // no end pulls, and what is left presses nothing
        assert!(given.iter().all(|impulse| *impulse > -1e-9 * greatest), "{given:?}");
        assert!(after[0] > -1e-9 && (given[0] * after[0]).abs() < 1e-9 * greatest, "{given:?} {after:?}");
        assert!(second[1].2 < second[0].2 + 1e-9);
    }
}

#[test]
fn both_ends_land_at_once_without_rebound() {
    let found = rates(&bar([0.0, 0.0], [[0.5, 0.5], [0.0; 2]], 0.6));
    let last = found.last().unwrap();
    assert!(last.1.iter().all(|rate| rate.abs() < 1e-12) && last.2 < 1e-20, "{found:?}");
}

#[test]
fn stops_that_know_nothing_of_each_other_are_hit_at_once() {
    let text = "gravity 9.81 m/s^2
ground { O (0, 0); P (1 m, 0); line left_way through O along 90 deg; line right_way through P along 90 deg }
link one { A (0, 0); mass 1 kg at A }
link two { B (0, 0); mass 2 kg at B }
prismatic G: one.A - ground.left_way
prismatic H: two.B - ground.right_way
stop G > 0 mm { restitution 0.5 }
stop H > 0 mm { restitution 0.8 }
start G = 1 m
start H = 1 m
simulate 1 s
let t1 = sqrt(2*1 m/9.81 m/s^2)
let t2 = t1 + 2*0.5*t1
find displacement(G), displacement(H)
expect displacement(H) = 0.8*9.81 m/s^2*t1*(1 s - t1) - 0.5*9.81 m/s^2*(1 s - t1)^2 within 1e-9 at event end
expect displacement(G) = 0.25*9.81 m/s^2*t1*(1 s - t2) - 0.5*9.81 m/s^2*(1 s - t2)^2 within 1e-9 at event end
";
    let (solved, problems) = solve_source(&Source::new("blocks", text), &Overrides::none());
    let solved = solved.filter(|_| !problems.has_errors()).unwrap_or_else(|| panic!("{problems:?}"));
    assert!(solved.outcomes.iter().all(|outcome| outcome.passed), "{:?}", solved.outcomes);
}

/// Instants with heights and rates of both ends, and when the left stop opens, if it is there.
fn ends(text: &str) -> (Vec<[f64; 5]>, Vec<f64>) {
    let (solved, problems) = solve_source(&Source::new("bar", text), &Overrides::none());
    let solved = solved.filter(|_| !problems.has_errors()).unwrap_or_else(|| panic!("{problems:?}"));
    let states = solved.solution.poses.iter().map(|pose| &pose.outcome.as_ref().unwrap().state.motion);
    let each = states.map(|motion| {
        let (left, right) = (&motion.bodies[1], &motion.bodies[2]);
        [motion.time, left.p.y, right.p.y, left.v.y, right.v.y]
    });
    let times = &solved.solution.simulation.as_ref().unwrap().events;
    let events = solved.compiled.mechanism.events.iter().zip(times);
    let leaves = events
        .filter(|(event, _)| event.name.as_deref() == Some("leaves"))
        .flat_map(|(_, times)| times.clone());
    (each.collect(), leaves.collect())
}

/// The right end falls while the left one stands on its stop, until a force pulls it up: the stop would have to pull, and is gone
/// at once. From there on the motion is that of the bar without the stop.
#[test]
fn a_stop_that_would_have_to_pull_opens_at_once() {
    let pulled = |text: String, from: f64| {
        text + &format!("force F on one at A = 300 N @ 90 deg when time >= {from} s\n")
    };
    let (all, lifted) = (0.25, 0.1);
    for from in [0.0, lifted] {
        let text = bar([0.0, 0.0], [[0.0, 0.5], [0.0; 2]], all).replace(" within", " in 5 steps within");
        let (found, leaves) = ends(&pulled(text, from));
        let begin = found.iter().rfind(|state| state[0] <= from).unwrap();
        assert!(begin[0] == from && begin[1].abs() < 1e-12 && begin[3].abs() < 1e-12, "{found:?}");
        assert!(from == 0.0 || (leaves.len() == 1 && (leaves[0] - from).abs() < 1e-12), "{leaves:?}");
        // the same without the stop, from there
        let rest = bar([0.0, 0.0], [[0.0, begin[2]], [0.0, begin[4]]], all - from);
        let without = rest.lines().filter(|line| !line.contains("stop G") && !line.contains("rests(G)"));
        let without: String = without.map(|line| format!("{line}\n")).collect();
        let (alone, _) = ends(&pulled(without, 0.0));
        let (last, free) = (found.last().unwrap(), alone.last().unwrap());
        assert!(last[1] > 0.3, "{found:?}");
        assert!((1..5).all(|i| (last[i] - free[i]).abs() < 1e-9), "{last:?} {free:?}");
    }
}
