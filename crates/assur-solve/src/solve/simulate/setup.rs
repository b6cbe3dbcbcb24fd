//! What a run starts from: the instants wanted and the first position.

use crate::answer::first_angles;
use crate::model::{At, Mechanism, Simulation};
use crate::position::{DriveValue, Model, PoseOrigin, State};
use crate::solve::assemble::assemble;
use crate::solve::failure::Failure;
use crate::solve::inputs::Rates;

/// An instant that is wanted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Output {
    /// The instant, s.
    pub time: f64,
    /// What wants it.
    pub origin: PoseOrigin,
}

/// The instants that are printed and those of expectations, in order of time.
pub(super) fn outputs(mechanism: &Mechanism, simulation: &Simulation) -> Vec<Output> {
    let printed = (0..simulation.instants())
        .map(|i| Output { time: simulation.instant(i), origin: PoseOrigin::Sweep(i) });
    let expected = mechanism.expects.iter().enumerate().filter_map(|(i, expect)| match expect.at {
        Some(At::Time(time)) => Some(Output { time, origin: PoseOrigin::Expected(i) }),
        _ => None,
    });
    let mut outputs: Vec<Output> = printed.chain(expected).collect();
    outputs.sort_by(|a, b| a.time.total_cmp(&b.time));
    outputs
}

/// The state at the first instant, with the angles of its bodies.
pub(super) fn assembled(
    model: &Model<'_>,
    rates: &Rates,
    first: &[DriveValue],
) -> Result<(State, Vec<f64>), Failure> {
    let mut state = State::new(model.plan);
    rates.at(first, &mut state.motion.inputs);
    let state = assemble(model, state)?;
    let angles = first_angles(model, &state);
    Ok((state, angles))
}
