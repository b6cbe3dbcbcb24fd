//! One position with twice the digits: the reference for what `f64` loses.

use super::state::{DriveInput, State};
use crate::math::{Double, Scalar, V2, Vec2};
use crate::plan::{Level, Plan};

/// Motion, loads and forces of the position that a state's inputs ask for, with its assemblies, all operations with twice
/// the digits; angles of drives are turned into directions with as many. `None` where a step has no closed form or a load
/// is evaluated at every position, see [`Plan::laned`]. What the plan forms of points, directions, masses and gravity is
/// formed with twice the digits too. The closed forms with more digits: what they are worth shows [`super::reference()`], which
/// does not use them.
#[must_use]
pub fn precise(plan: &Plan, reference: &State) -> Option<State<Double>> {
    if !plan.laned() {
        return None;
    }
    let mut state = State::closed(plan);
    state.branches.clone_from(&reference.branches);
    for (out, input) in state.inputs.iter_mut().zip(&reference.inputs) {
        *out = input_of(input);
    }
    state.start(plan);
    for step in &plan.motion {
        match plan.effects.level {
            Level::Positions => state.closed_form::<0>(step),
            Level::Velocities => state.closed_form::<1>(step),
            Level::Accelerations => state.closed_form::<2>(step),
        }
    }
    if plan.effects.forces {
        state.known_loads(plan);
        state.set_lines(plan);
        for (index, step) in plan.forces.iter().enumerate() {
            state.force_sines[index] = state.closed_force(step);
        }
    }
    Some(state)
}

fn input_of(input: &DriveInput) -> DriveInput<Double> {
    // a point has no value of its own
    let angle = input.place == Vec2::direction(input.value);
    DriveInput {
        place: if angle { Double::direction(input.value) } else { V2::of(input.place) },
        value: Double::of(input.value),
        rate: Double::of(input.rate),
        acceleration: Double::of(input.acceleration),
        velocity: V2::of(input.velocity),
        point_acceleration: V2::of(input.point_acceleration),
    }
}
