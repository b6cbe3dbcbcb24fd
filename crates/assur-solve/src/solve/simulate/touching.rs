//! The first instant of a motion in which contacts part: as many of them are closed as the starts leave open.

use crate::math::{Lu, Vec2};
use crate::position::{DriveInput, Model, PartingContact, State, extent, turns};
use crate::solve::assemble::assemble;
use crate::solve::failure::{Cause, Failure, Halt};

/// Steps of Newton's method.
const STEPS: usize = 40;
/// Profiles touch that are nearer than this part of the size.
const TOUCHES: f64 = 1e-13;
/// Others may lie in each other by this part of it: rounding.
const ROUNDING: f64 = 1e-10;
/// Differences are taken over this part of the size.
const APART: f64 = 1e-6;

/// Assembles the mechanism where these inputs say, and where contacts are closed for the starts that no statement gives; leaves the
/// inputs.
///
/// # Errors
/// It is not found.
pub(super) fn assemble_touching(model: &Model<'_>, mut state: State) -> Result<State, Failure> {
    let sought = &model.mechanism.touching;
    if sought.is_empty() {
        let mut found = assemble(model, state)?;
        found.take_parting_sides(model);
        return Ok(found);
    }
    let stops = 0..model.mechanism.stops.len();
    let contacts: Vec<PartingContact<'_>> =
        stops.filter_map(|stop| PartingContact::of_stop(model, stop)).collect();
    for set in sets(contacts.len(), sought.len()) {
        let closed: Vec<PartingContact<'_>> = set.iter().map(|i| contacts[*i]).collect();
        let Some(found) = close(model, &state, &closed) else { continue };
        let near = ROUNDING * extent(model);
        if contacts.iter().all(|contact| found.gap(contact) > -near) {
            return Ok(found);
        }
    }
    state.motion.inputs.clear();
    Err(Failure { pose: None, cause: Cause::Halted { halt: Halt::NothingTouches, time: state.motion.time } })
}

/// The choices of some out of several, those named first in front.
fn sets(of: usize, some: usize) -> Vec<Vec<usize>> {
    let mut all: Vec<Vec<usize>> = vec![Vec::new()];
    for _ in 0..some {
        let next = |set: &Vec<usize>| set.last().map_or(0, |last| last + 1);
        all = all
            .iter()
            .flat_map(|set| (next(set)..of).map(|i| set.iter().copied().chain([i]).collect()))
            .collect();
    }
    all
}

/// With these contacts closed, at rates that keep them so.
fn close(model: &Model<'_>, begin: &State, closed: &[PartingContact<'_>]) -> Option<State> {
    let (drives, size) = (&model.mechanism.touching, extent(model));
    let unit = |drive: usize| if turns(model, &model.mechanism.drives[drive]) { 1.0 } else { size };
    let mut inputs = begin.motion.inputs.clone();
    let at = |inputs: &[DriveInput]| {
        let mut state = begin.clone();
        state.motion.inputs.copy_from_slice(inputs);
        let mut found = assemble(model, state).ok()?;
        found.take_parting_sides(model);
        Some(found)
    };
    let mut matrix = Lu::new(closed.len());
    for _ in 0..STEPS {
        let state = at(&inputs)?;
        let mut left: Vec<f64> = closed.iter().map(|contact| state.gap(contact)).collect();
        if left.iter().all(|gap| gap.abs() <= TOUCHES * size) {
            return with_rates(model, state, closed);
        }
        for (column, &drive) in drives.iter().enumerate() {
            let mut beside = inputs.clone();
            put(&mut beside[drive], inputs[drive].value + APART * unit(drive));
            let beside = at(&beside)?;
            for (row, contact) in closed.iter().enumerate() {
                *matrix.at_mut(row, column) = (beside.gap(contact) - left[row]) / (APART * unit(drive));
            }
        }
        if !matrix.factor() {
            return None;
        }
        matrix.solve(&mut left);
        for (&drive, step) in drives.iter().zip(&left) {
            let step = step.clamp(-unit(drive), unit(drive));
            let value = inputs[drive].value - step;
            put(&mut inputs[drive], value);
        }
    }
    None
}

fn put(input: &mut DriveInput, value: f64) {
    (input.value, input.place) = (value, Vec2::direction(value));
}

/// The rates of the starts that no statement gives, with which the contacts stay closed.
fn with_rates(model: &Model<'_>, mut state: State, closed: &[PartingContact<'_>]) -> Option<State> {
    let drives = &model.mechanism.touching;
    state.run_motion::<1>(model.plan);
    let mut left: Vec<f64> = closed.iter().map(|contact| state.gap_rate(contact)).collect();
    let mut matrix = Lu::new(closed.len());
    for (column, &drive) in drives.iter().enumerate() {
        state.motion.inputs[drive].rate += 1.0;
        state.run_motion::<1>(model.plan);
        state.motion.inputs[drive].rate -= 1.0;
        for (row, contact) in closed.iter().enumerate() {
            *matrix.at_mut(row, column) = state.gap_rate(contact) - left[row];
        }
    }
    if !matrix.factor() {
        return None;
    }
    matrix.solve(&mut left);
    for (&drive, rate) in drives.iter().zip(&left) {
        state.motion.inputs[drive].rate -= rate;
    }
    state.run_motion::<1>(model.plan);
    Some(state)
}
