//! Starts in a dead position: the rates that are written are those of the motion, or the position has none like them; in a change
//! point two motions begin.

use super::change::FOUND;
use super::coordinates::{Change, Charts, measured, unit};
use super::equations::Equations;
use super::setup::{StartState, is_length};
use crate::answer::{PoseAnswers, WholeCycle};
use crate::math::Vec2;
use crate::math::ode::System;
use crate::model::{DriveTarget, Mechanism};
use crate::position::{Model, Reduced, State, extent};
use crate::solve::assemble::assemble;
use crate::solve::failure::{Cause, Halt};

/// Distance from a change point at which its two motions differ, rad or parts of the extent.
const BESIDE: f64 = 0.1 * std::f64::consts::PI / 180.0;
/// Where something rubs, close to it reactions are too great.
const FAR_BESIDE: f64 = 50.0 * BESIDE;
/// A coordinate is dead that moves by less than this part of what moves most.
const STILL: f64 = 1e-4;
/// Rates are those that are written to this part of the greatest.
const SAME_RATE: f64 = 1e-6;

/// Looks at how the starts stand at the first instant.
///
/// # Errors
/// There are no such rates, or two motions begin.
pub(super) fn check_dead_position(begin: &StartState<'_>, charts: &mut Charts<'_>) -> Result<(), Halt> {
    let mut equations = begin.equations();
    let y = equations.start();
    equations.accepted(begin.from, &y);
    let n = equations.order();
    if n == 0 || equations.condition() >= FOUND {
        return Ok(());
    }
    let mut still = y.clone();
    still[n..2 * n].fill(0.0);
    match charts.better(&equations, &still) {
        None => two_motions(begin, &equations).map_or(Ok(()), Err),
        Some(_) if charts.better(&equations, &y).is_some() => Ok(()),
        Some(change) => Err(without_rate(begin, &equations, &change)),
    }
}

/// A coordinate that has no rate there, and another that has.
fn without_rate(begin: &StartState<'_>, equations: &Equations<'_, '_>, change: &Change) -> Halt {
    let free = equations.reduced.free();
    let written = |drive: usize| begin.model.mechanism.drives[drive].target;
    let others = change.coordinates(begin.model);
    let replaced = free.iter().zip(&others).position(|(drive, other)| written(*drive) != *other);
    let slot = replaced.unwrap_or_default();
    Halt::NoRate { drive: free[slot], other: others[slot], value: change.y[slot] }
}

/// The motions that begin in a change point, by a start next to it and what chooses each there.
fn two_motions(begin: &StartState<'_>, equations: &Equations<'_, '_>) -> Option<Halt> {
    let conditions = &equations.here().1.motion.conditions;
    let mechanism = Mechanism { hints: Vec::new(), ..begin.model.mechanism.clone() };
    let model = Model { mechanism: &mechanism, ..*begin.model };
    for &drive in equations.reduced.free() {
        let first = begin.first[drive];
        let length = is_length(&model, &mechanism.drives[drive]);
        let beside = if model.plan.effects.loses() { FAR_BESIDE } else { BESIDE };
        let far = if length { beside * extent(&model) } else { beside };
        let sense = if first.rate < 0.0 { -1.0 } else { 1.0 };
        for value in [first.value + sense * far, first.value - sense * far] {
            let mut state = State::new(model.plan);
            state.motion.inputs.clone_from(&begin.first);
            let input = &mut state.motion.inputs[drive];
            (input.value, input.place) = (value, Vec2::direction(value));
            let Err(Cause::Ambiguous { groups, .. }) = assemble(&model, state) else { continue };
            let mut groups = groups.into_iter();
            let found = groups.find(|(group, ways)| conditions[*group].abs() < FOUND && ways.len() > 1);
            if let Some((group, ways)) = found {
                return Some(Halt::TwoMotions { drive, value, rate: first.rate, group, ways });
            }
        }
    }
    None
}

/// The rates of the free coordinates of a model that stands in a dead position of others, with which these have the rates that are
/// written; `None` where there are none.
pub(super) fn rates(
    model: &Model<'_>,
    (statics, angles): (&WholeCycle, &[f64]),
    (reduced, mut moved): (&Reduced, State),
    (others, written): (&[DriveTarget], &[f64]),
) -> Option<Vec<f64>> {
    let extent = extent(model);
    let drives = &model.mechanism.drives;
    let speed = |state: &State| {
        let bodies = state.motion.bodies.iter();
        bodies.fold(0.0_f64, |most, body| most.max(body.omega.abs()).max(body.v.norm() / extent))
    };
    let read = |state: &State| {
        let view = PoseAnswers::new(model, state, angles, statics);
        let each = others.iter().map(|other| Some(measured(&view, *other)?.1 / unit(*other, extent)));
        each.collect::<Option<Vec<f64>>>()
    };
    let given = read(&moved)?;
    let wanted = others.iter().zip(written).map(|(other, rate)| rate / unit(*other, extent));
    let rest: Vec<f64> = wanted.clone().zip(given).map(|(rate, given)| rate - given).collect();
    let size = wanted.fold(speed(&moved), |size, rate| size.max(rate.abs()));
    let units: Vec<f64> = reduced.free().iter().map(|&drive| unit(drives[drive].target, extent)).collect();
    let (mut columns, mut most) = (Vec::with_capacity(units.len()), 0.0_f64);
    for (k, scale) in units.iter().enumerate() {
        for (index, body) in moved.motion.bodies.iter_mut().enumerate() {
            let (v, omega) = reduced.unit_motion(k, index);
            (body.v, body.omega) = (v * *scale, omega * *scale);
        }
        columns.push(read(&moved)?);
        most = most.max(speed(&moved));
    }
    let found = solved((columns, rest), (STILL * most, SAME_RATE * size))?;
    Some(found.iter().zip(units).map(|(rate, unit)| rate * unit).collect())
}

/// A solution of equations with these columns, in which what they do not determine is zero; `None` where their rest exceeds what is
/// left out. Pivots that are no greater than `still` are zero.
fn solved(
    (mut columns, mut rest): (Vec<Vec<f64>>, Vec<f64>),
    (still, left_out): (f64, f64),
) -> Option<Vec<f64>> {
    let n = rest.len();
    let mut order: Vec<usize> = (0..n).collect();
    let mut rank = 0;
    while rank < n {
        let places = (rank..n).flat_map(|column| (rank..n).map(move |row| (column, row)));
        let size = |place: &(usize, usize)| columns[place.0][place.1].abs();
        let Some((column, row)) = places.max_by(|a, b| size(a).total_cmp(&size(b))) else { break };
        let pivot = columns[column][row];
        if pivot.is_nan() || pivot.abs() <= still {
            break;
        }
        columns.swap(column, rank);
        order.swap(column, rank);
        columns.iter_mut().for_each(|column| column.swap(row, rank));
        rest.swap(row, rank);
        for row in rank + 1..n {
            let part = columns[rank][row] / pivot;
            columns[rank..].iter_mut().for_each(|column| column[row] -= part * column[rank]);
            rest[row] -= part * rest[rank];
        }
        rank += 1;
    }
    if rest[rank..].iter().any(|x| x.is_nan() || x.abs() > left_out) {
        return None;
    }
    let mut found = vec![0.0; n];
    for row in (0..rank).rev() {
        let known: f64 = (row + 1..rank).map(|column| columns[column][row] * found[order[column]]).sum();
        found[order[row]] = (rest[row] - known) / columns[row][row];
    }
    Some(found)
}
