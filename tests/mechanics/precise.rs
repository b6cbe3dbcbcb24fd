//! One position with twice the digits closes and balances to as many, and tells what `f64` loses.

use crate::support::machines;
use assur::internals::math::{Double, Scalar, V2, Vec2};
use assur::internals::solve::{BodyState, DriveInput, Model, precise, solve};

const LENGTHS: [f64; 4] = [0.1, 0.35, 0.3, 0.4];

fn position(b: &BodyState<Double>, x: f64) -> V2<Double> {
    b.position(Vec2::new(x, 0.0))
}

#[test]
fn a_four_bar_to_thirty_digits() {
    let mechanism = machines::four_bar(LENGTHS, true, machines::list(&[0.0]));
    let (structure, _) = assur::internals::structure::structure(&mechanism).expect("the machine is sound");
    let plan = assur::internals::plan::plan(&mechanism, &structure);
    let model = Model { mechanism: &mechanism, structure: &structure, plan: &plan };
    let solution = solve(&model).expect("the machine closes");
    let first = solution.poses[0].outcome.as_ref().expect("the first position is regular");
    let mut state = first.state.clone().ready(&plan);
    for i in 0..36 {
        let value = f64::from(i) * 0.17;
        let place = Vec2::direction(value);
        state.motion.inputs[0] = DriveInput { value, place, rate: machines::SPEED, ..DriveInput::default() };
        state.run_motion::<2>(&plan);
        state.run_loads(&model, &[]);
        state.run_forces(&plan);
        let exact = precise(&plan, &state).expect("all steps have closed forms");

        let [_, _, coupler, rocker] = &exact.motion.bodies[..] else { panic!("four bodies") };
        let gap = (position(coupler, LENGTHS[1]) - position(rocker, LENGTHS[2])).norm();
        assert!(gap.high < 1e-30, "at {value}: {gap:?}");

        // powers of weights, inertia forces and of the torque on the crank
        let mut power = exact.forces.efforts[0] * Double::of(machines::SPEED);
        for (body, length) in exact.motion.bodies[1..].iter().zip(LENGTHS) {
            let mass = 2.0 * length;
            let centre = Vec2::new(length / 2.0, 0.0);
            let (m, inertia) = (Double::of(mass), Double::of(mass * length * length / 12.0));
            let force = (V2::of(Vec2::new(0.0, -9.81)) - body.acceleration(centre)) * m;
            power = power + force.dot(body.velocity(centre)) - inertia * body.alpha * body.omega;
        }
        assert!(power.high.abs() < 1e-27, "at {value}: {power:?}");

        let lost = (exact.forces.efforts[0] - Double::of(state.forces.efforts[0])).high.abs();
        assert!(lost < 1e-13, "at {value}: f64 loses {lost:e}");
    }
}

#[test]
fn what_has_no_closed_form_has_no_such_answer() {
    let mechanism = machines::triad(machines::list(&[0.0]));
    let (structure, _) = assur::internals::structure::structure(&mechanism).expect("the machine is sound");
    let plan = assur::internals::plan::plan(&mechanism, &structure);
    assert!(!plan.is_batchable());
    assert!(precise(&plan, &assur::internals::solve::State::new(&plan)).is_none());
}
