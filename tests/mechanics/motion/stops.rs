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
