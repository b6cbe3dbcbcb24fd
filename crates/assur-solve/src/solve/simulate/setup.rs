//! What a run starts from: the instants wanted, the first position and the errors allowed.

use super::drives::prescribed;
use super::equations::Equations;
use super::options::IntegrationOptions;
use super::records::Origin;
use super::touching::assemble_touching;
use crate::answer::{WholeCycle, first_angles};
use crate::math::ode::Tolerance;
use crate::model::{At, Drive, DriveTarget, Mechanism, Occasion, Simulation};
use crate::plan::{Plan, plan_with};
use crate::position::{DriveInput, DriveValue, Model, State, turns};
use crate::solve::failure::{Cause, Failure, Halt};
use crate::solve::inputs::Rates;

/// A coordinate is not known to more than a few roundings.
const DIGITS: f64 = 4.0 * f64::EPSILON;

/// The instants that are wanted, and how the run between them is done.
#[derive(Clone, Default)]
pub(super) struct Outputs<'c> {
    /// Those that are known beforehand, in order of time, with what wants them.
    pub known: Vec<(f64, Origin)>,
    /// Events that expectations name: the event, which time, counted from 1, and the expectation.
    pub events: Vec<(usize, usize, usize)>,
    /// Expectations of the last instant, wherever it is.
    pub end: Vec<usize>,
    pub prints_events: bool,
    pub conduct: IntegrationOptions<'c>,
    /// An event that does not count before an instant, s; without bound the one with which a period begins and ends.
    pub guard: Option<(usize, f64)>,
}

impl Outputs<'_> {
    /// The longest time between two instants that are known beforehand, s, in a run of this length.
    pub fn longest_gap(&self, length: f64) -> f64 {
        let gaps = self.known.windows(2).map(|two| two[1].0 - two[0].0);
        let longest = gaps.fold(0.0, f64::max);
        if longest > 0.0 { longest } else { length }
    }
}

/// The instants that are printed and those of expectations.
pub(super) fn outputs<'c>(mechanism: &Mechanism, simulation: &Simulation) -> Outputs<'c> {
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

/// From where every run of a motion begins.
pub(super) struct StartState<'s> {
    /// The mechanism as it is written.
    pub model: &'s Model<'s>,
    pub statics: &'s WholeCycle,
    /// What every drive says at the first instant.
    pub first: Vec<DriveInput>,
    /// The first instant, s.
    pub from: f64,
    /// The assembly there, with the angles of its bodies.
    pub state: State,
    pub angles: Vec<f64>,
    /// The mechanism with the friction at rest, where it is another one.
    pub still: Option<&'s Model<'s>>,
}

/// The mechanism with the friction at rest, where it is another one than that of the motion.
pub(super) fn at_rest(model: &Model<'_>) -> Option<(Mechanism, Plan)> {
    if model.mechanism.friction_at_rest.is_empty() {
        return None;
    }
    let mut mechanism = model.mechanism.clone();
    for (pair, friction) in model.mechanism.friction_at_rest.iter().copied() {
        mechanism.pairs[pair.index()].friction = Some(friction);
    }
    let planned = plan_with(&mechanism, model.structure, model.plan.effects);
    Some((mechanism, planned))
}

impl<'s> StartState<'s> {
    /// The equations at the first instant.
    pub fn equations(&self) -> Equations<'s, '_> {
        let mut equations = Equations::new(self.model, self, None, (self.from, &self.state, &self.angles));
        equations.still = self.still;
        equations
    }
}

/// Assembles the mechanism at the first instant, if its position there is not known.
pub(super) fn begin<'s>(
    model: &'s Model<'s>,
    statics: &'s WholeCycle,
    rates: &Rates,
    (values, known): (&[DriveValue], Option<&State>),
    from: f64,
) -> Result<StartState<'s>, Failure> {
    let mut state = State::new(model.plan);
    rates.at(values, &mut state.motion.inputs);
    for (drive, input) in
        model.mechanism.drives.iter().zip(&mut state.motion.inputs).filter(|(d, _)| d.of_time)
    {
        *input = prescribed(drive, input, (from, 0.0), &[]);
    }
    let state = match known {
        Some(known) => placed(model, state, known),
        None => assemble_touching(model, state)?,
    };
    let first = state.motion.inputs.clone();
    if let Some(spring) = state.first_spring_at_zero(model.mechanism) {
        let cause = Cause::Halted { halt: Halt::SpringAtZero { spring }, time: from };
        return Err(Failure { pose: None, cause });
    }
    let angles = first_angles(model, &state);
    Ok(StartState { model, statics, first, from, state, angles, still: None })
}

/// With the bodies where they stand in a known state.
fn placed(model: &Model<'_>, state: State, known: &State) -> State {
    let mut motion = known.motion.clone();
    motion.inputs = state.motion.inputs;
    (motion.works, motion.stops) = (Vec::new(), Vec::new());
    (motion.grips, motion.against) = (Vec::new(), Vec::new());
    let mut state = State { branches: known.branches.clone(), motion, ..state };
    state.take_parting_sides(model);
    state
}

/// The errors allowed: of coordinates absolute, since angles and places are read off them whatever their turns; of rates
/// relative, and where they pass zero by what would move a coordinate in the time of the run; of works of what the run before says
/// is much for them. The work of all loads is not judged.
pub(super) fn allowed(
    equations: &Equations<'_, '_>,
    (tolerance, works): (f64, &[(f64, f64)]),
    length: f64,
) -> Tolerance<f64> {
    let scales = scales(equations);
    let coordinates = scales.iter().map(|scale| (DIGITS, tolerance * scale));
    let rates = scales.iter().map(|scale| (tolerance, tolerance * scale / length));
    let known = |id: usize| works.get(id).filter(|(much, _)| *much > 0.0);
    let work = |id| known(id).map_or(f64::MAX, |(much, nothing)| (tolerance * much).max(*nothing));
    let works = (0..equations.model.mechanism.works.len()).map(|id| (0.0, work(id)));
    let each: Vec<(f64, f64)> = coordinates.chain(rates).chain([(0.0, f64::MAX)]).chain(works).collect();
    Tolerance::each(&each)
}

/// What is much for each free coordinate: a radian, or the extent.
pub(super) fn scales(equations: &Equations<'_, '_>) -> Vec<f64> {
    equations.reduced.free().iter().map(|&drive| scale_of(equations, drive)).collect()
}

/// What is much for the first free coordinate: a radian, or the extent.
pub(super) fn scale(equations: &Equations<'_, '_>) -> f64 {
    equations.reduced.free().first().map_or(1.0, |&drive| scale_of(equations, drive))
}

fn scale_of(equations: &Equations<'_, '_>, drive: usize) -> f64 {
    let model = equations.model;
    if is_length(model, &model.mechanism.drives[drive]) { equations.extent() } else { 1.0 }
}

/// Whether the coordinate of a drive is a length.
pub(super) fn is_length(model: &Model<'_>, drive: &Drive) -> bool {
    !matches!(drive.target, DriveTarget::Point(..)) && !turns(model, drive)
}
