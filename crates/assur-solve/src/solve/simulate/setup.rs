//! What a run starts from: the instants wanted, the first position and the errors allowed.

use super::equations::Equations;
use super::records::Origin;
use crate::answer::first_angles;
use crate::math::ode::Tolerance;
use crate::model::{At, DriveTarget, Mechanism, Occasion, Simulation};
use crate::position::{DriveValue, Model, State, extent, turns};
use crate::solve::assemble::assemble;
use crate::solve::failure::Failure;
use crate::solve::inputs::Rates;

/// The instants that are wanted.
#[derive(Clone, Debug, Default)]
pub(super) struct Outputs {
    /// Those that are known beforehand, in order of time, with what wants them.
    pub known: Vec<(f64, Origin)>,
    /// Events that expectations name: the event, which time, counted from 1, and the expectation.
    pub events: Vec<(usize, usize, usize)>,
    /// Expectations of the last instant, wherever it is.
    pub end: Vec<usize>,
    /// Events are printed.
    pub prints_events: bool,
}

impl Outputs {
    /// The longest time between two instants that are known beforehand, s, in a run of this length.
    pub fn longest_gap(&self, length: f64) -> f64 {
        let gaps = self.known.windows(2).map(|two| two[1].0 - two[0].0);
        let longest = gaps.fold(0.0, f64::max);
        if longest > 0.0 { longest } else { length }
    }
}

/// The instants that are printed and those of expectations.
pub(super) fn outputs(mechanism: &Mechanism, simulation: &Simulation) -> Outputs {
    let printed = (0..simulation.instants()).map(|i| (simulation.instant(i), Origin::Printed));
    let mut outputs =
        Outputs { known: printed.collect(), prints_events: simulation.steps.is_none(), ..Outputs::default() };
    for (index, expect) in mechanism.expects.iter().enumerate() {
        match expect.at {
            Some(At::Time(time)) => outputs.known.push((time, Origin::Expected(index))),
            Some(At::Occasion(Occasion::Begin)) => {
                outputs.known.push((simulation.from, Origin::Expected(index)));
            }
            Some(At::Occasion(Occasion::End)) => outputs.end.push(index),
            Some(At::Occasion(Occasion::Event(event, which))) => outputs.events.push((event, which, index)),
            _ => {}
        }
    }
    outputs.known.sort_by(|a, b| a.0.total_cmp(&b.0));
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

/// The errors allowed: of coordinates absolute, since angles and places are read off them whatever their turns; of rates
/// relative, and where they pass zero by what would move a coordinate in the time of the run. The work is not judged.
pub(super) fn allowed(equations: &Equations<'_, '_>, tolerance: f64, length: f64) -> Tolerance<f64> {
    let model = equations.model;
    let scale = |&drive: &usize| {
        let drive = &model.mechanism.drives[drive];
        let lengths = !matches!(drive.target, DriveTarget::Point(..)) && !turns(model, drive);
        if lengths { extent(model) } else { 1.0 }
    };
    let scales: Vec<f64> = equations.reduced.free().iter().map(scale).collect();
    let coordinates = scales.iter().map(|scale| (0.0, tolerance * scale));
    let rates = scales.iter().map(|scale| (tolerance, tolerance * scale / length));
    let each: Vec<(f64, f64)> = coordinates.chain(rates).chain([(0.0, f64::MAX)]).collect();
    Tolerance::each(&each)
}
