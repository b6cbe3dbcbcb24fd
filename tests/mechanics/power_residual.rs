//! The residuals are in proportion to what is wrong with a state.

use assur::internals::check::Overrides;
use assur::internals::solve::{Model, State, residuals};
use assur::internals::source::Source;

/// A crank-slider with friction behind a pair of wheels with losses is refused; these two together have all terms of the
/// virtual power: loads, inertia, efforts, friction, losses.
const FILES: [&str; 2] = [
    "ground { A (0, 0); line guide through A along 0 deg }
link crank A-B 100 mm
link rod B-C 350 mm { S (117 mm, 0); mass 2.5 kg at S; inertia 0.0425 kg*m^2 }
link piston { C (0, 0); mass 2 kg at C }
revolute A: ground - crank
revolute B: crank - rod { friction_circle 3 mm }
revolute C: rod - piston
prismatic D: piston.C - ground.guide { friction 0.1 }
drive crank = 50 deg at 100 rad/s
assemble C ahead of B
force P on piston at C = 900 N against motion
balance torque Mb on crank
find Mb, reactions
",
    "shaft I { wheel a teeth 20; inertia 0.1 kg*m^2 }
shaft O { wheel b teeth 50 }
mesh k: a - b { efficiency 0.9 }
drive I at 10 rad/s accelerating 3 rad/s^2
torque on O = 50 N*m
find effort(I)
",
];

/// What is changed in a state, and by what factor.
type Change = fn(&mut State, f64);

fn both(state: &State, model: &Model<'_>) -> (f64, f64) {
    let found = residuals(model, state);
    (found.equilibrium.unwrap_or(f64::NAN), found.power.unwrap_or(f64::NAN))
}

#[test]
fn a_wrong_state_has_residuals() {
    let changes: [&[(&str, Change)]; 2] = [
        &[
            ("effort", |s, by| s.forces.efforts[0] *= by),
            ("friction", |s, by| s.forces.frictions.iter_mut().for_each(|x| *x *= by)),
            ("loads", |s, by| s.forces.applied.iter_mut().for_each(|w| w.force = w.force * by)),
            ("speed", |s, by| s.motion.bodies[1].omega *= by),
        ],
        &[
            ("effort", |s, by| s.forces.efforts[0] *= by),
            ("losses", |s, by| s.forces.law_forces[0].sides[0] *= by),
            ("multiplier", |s, by| s.forces.law_forces[0].multiplier *= by),
        ],
    ];
    for (text, changes) in FILES.iter().zip(changes) {
        let (solved, problems) =
            assur::internals::solve_source(&Source::new("power.mech", *text), &Overrides::none());
        let solved = solved.unwrap_or_else(|| panic!("{problems:?}"));
        let model = solved.compiled.model();
        let state = &solved.solution.poses[0].outcome.as_ref().expect("it moves").state;
        let (equilibrium, power) = both(state, &model);
        assert!(equilibrium < 1e-14 && power < 1e-14, "{equilibrium:e}, {power:e}");
        for (name, change) in changes {
            // the residual is in proportion to what is wrong
            for by in [1e-3, 1e-6] {
                let mut wrong = state.clone();
                change(&mut wrong, 1.0 + by);
                let (equilibrium, power) = both(&wrong, &model);
                assert!(power > 1e-3 * by && power < 10.0 * by, "{name} by {by:e}: power {power:e}");
                let kinematic = *name == "speed";
                assert!(
                    kinematic || equilibrium > 1e-3 * by,
                    "{name} by {by:e}: equilibrium {equilibrium:e}"
                );
            }
        }
        let mut wrong = state.clone();
        if let Some(reaction) = wrong.forces.reactions.get_mut(1).filter(|r| r.force.norm() > 0.0) {
            reaction.force = reaction.force * 1.001;
            assert!(both(&wrong, &model).0 > 1e-5);
        }
    }
}
