//! Quantities over the sweep: extremes, means, integrals, and the flywheels that follow from them.
//!
//! The sweep is taken as an interval. Where a condition switches, a load changes its sense or a magnitude passes through
//! zero, a quantity is not smooth: these places are roots of known functions and are found before anything is
//! integrated. Between them a quantity is a Chebyshev series per panel, halved until it has converged; a quantity that
//! is smooth over whole turns has its mean from equally spaced samples, of which the fewest suffice.

mod course;
mod depends;
mod events;
mod flywheel;
mod interval;
mod panels;
mod roots;
mod sampler;
mod switches;

pub(crate) use course::over_sweep;
pub(super) use depends::loads_name_quantities;
pub(crate) use events::{events, never_ended};
pub(super) use switches::denominators;

use super::failure::{Cause, Failure};
use super::note::Note;
use super::positions::Sweep;
use crate::answer::{CycleAnswer, ROUNDING, Undefined, WholeCycle, is_zero};
use crate::math::quadrature::{Mean, mean};
use crate::model::{CycleFunction, Expr, FlywheelPart, Query};
use crate::position::Model;
use depends::{asks_for_ideal_flywheels, counts_turns, depends_on_forces, depends_on_nothing_else};
use flywheel::FlywheelRequest;
use interval::Interval;
use panels::{COARSE, Piecewise};
use sampler::Sampler;

/// The most equally spaced samples.
const MOST_SAMPLES: usize = 128;
/// The fewest; half of them where few digits are wanted.
const FEWEST_SAMPLES: usize = 16;
/// The fewest samples per wave of a term of a Fourier series, and by which factor there may be more. There are twice the fewest per turn: what
/// comes again within a turn is seen between 3N/8 and N/2 whatever the order.
const PER_WAVE: usize = 8;
const FINER: usize = 2;

/// Finds the functions over the sweep and the flywheels of a file.
pub(crate) fn cycles(model: &Model<'_>, statics: &mut WholeCycle, sweep: &Sweep) -> Result<Vec<Note>, Cause> {
    let mechanism = model.mechanism;
    if mechanism.cycles.is_empty() && mechanism.flywheels.is_empty() {
        return Ok(Vec::new());
    }
    let interval = Interval::of(model, statics, sweep).map_err(Cause::NoSweep)?;
    interval.has_whole_turns(&mechanism.cycles).map_err(Cause::NoSweep)?;
    let mut sampler = Sampler::new(model, statics, &interval)?;
    statics.cycles = vec![CycleAnswer::default(); mechanism.cycles.len()];
    // those of motion alone first: loads may depend on them
    let after = |index: &usize| depends_on_forces(mechanism, &mechanism.cycles[*index].expr);
    let (late, early): (Vec<usize>, Vec<usize>) = (0..mechanism.cycles.len()).partition(after);
    let of =
        |indices: &[usize]| indices.iter().map(|i| mechanism.cycles[*i].expr.clone()).collect::<Vec<_>>();
    sampler.share(of(&early).into_iter().filter(|e| depends_on_nothing_else(mechanism, e)));
    for index in early {
        statics.cycles[index] = cycle(model, statics, &mut sampler, index);
        within_curves(&sampler)?;
    }
    let mut notes = Vec::new();
    let ideal = model.plan.effects.loses() && asks_for_ideal_flywheels(mechanism);
    let asked = [false, true].into_iter().take(1 + usize::from(ideal));
    let asked = asked
        .flat_map(|ideal| (0..mechanism.flywheels.len()).map(move |index| FlywheelRequest { index, ideal }));
    let asked: Vec<FlywheelRequest> = asked.collect();
    let wheels = asked.iter().filter_map(|asked| flywheel::numbers(model, statics, *asked));
    sampler.share(
        of(&late).into_iter().filter(|e| depends_on_nothing_else(mechanism, e)).chain(wheels.flatten()),
    );
    for asked in asked {
        let index = asked.index;
        let found = flywheel::flywheel(model, statics, &mut sampler, asked);
        within_curves(&sampler)?;
        let found = found.map_err(|why| Cause::NoFlywheel { flywheel: index, why })?;
        if asked.ideal {
            statics.ideal_flywheels.push(found.answer);
            continue;
        }
        let needless = |[have, needed]: [f64; 2]| Note::NeedlessFlywheel { flywheel: index, have, needed };
        notes.extend(found.needless.map(needless));
        statics.flywheels.push(found.answer);
    }
    for index in late {
        statics.cycles[index] = cycle(model, statics, &mut sampler, index);
        within_curves(&sampler)?;
    }
    Ok(notes)
}

/// A curve that is left between the positions is no less an error than at one of them.
fn within_curves(sampler: &Sampler<'_>) -> Result<(), Cause> {
    sampler.left.clone().map_or(Ok(()), |left| Err(Cause::CurveLeft(left)))
}

/// The functions over the sweep and the flywheels of a solved file once more: with the settings of the model's plan.
///
/// # Errors
/// As [`super::solve`]: a flywheel that cannot be found.
pub fn over_cycle(model: &Model<'_>, found: &WholeCycle) -> Result<WholeCycle, Failure> {
    let mut statics = found.clone();
    statics.flywheels.clear();
    statics.ideal_flywheels.clear();
    let sweep = Sweep::of(model, &statics);
    cycles(model, &mut statics, &sweep)?;
    Ok(statics)
}

fn cycle(model: &Model<'_>, statics: &WholeCycle, sampler: &mut Sampler<'_>, index: usize) -> CycleAnswer {
    let asked = &model.mechanism.cycles[index];
    sampler.begin();
    let found = found(model, statics, sampler, asked.how, &asked.expr);
    sampler.term = None;
    match found {
        Ok(answer) => CycleAnswer { samples: sampler.samples, ..answer },
        Err(why) => CycleAnswer::undefined(why),
    }
}

fn found(
    model: &Model<'_>,
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    how: CycleFunction,
    expr: &Expr,
) -> Result<CycleAnswer, Undefined> {
    if let Some(answer) = of_work(statics, how, expr) {
        return Ok(answer);
    }
    let breaks = switches::breaks(model, statics, sampler, expr)?;
    let splits = breaks.iter().map(|s| sampler.interval.value(*s)).collect();
    let answer = |value, error, [scale, size]: [f64; 2]| {
        // what is nothing is small against what it is made of
        let scale = if is_zero(scale, size) { size } else { scale };
        CycleAnswer { value, error, scale, size, splits, ..CycleAnswer::default() }
    };
    let length = sampler.interval.length();
    let factor = match how {
        CycleFunction::Mean => Some(1.0),
        CycleFunction::Integral => Some(length),
        CycleFunction::Harmonic(_) => Some(2.0),
        CycleFunction::Max | CycleFunction::Min | CycleFunction::Argmax => None,
    };
    let is_smooth = factor.is_some() && breaks.is_empty() && comes_again(model, statics, sampler, expr)?;
    sampler.term = how.harmonic();
    if let Some(factor) = factor
        && is_smooth
        && let Some((mean, size)) = smooth_mean(statics, sampler, expr)?
    {
        let scales = [mean.scale, size].map(|x| x * factor.abs());
        return Ok(answer(mean.value * factor, mean.error * factor.abs(), scales));
    }
    let sign = if how == CycleFunction::Min { -1.0 } else { 1.0 };
    let sought = factor.is_none().then_some(sign);
    let all = panels::piecewise(sampler, statics, (&[expr], sought), &breaks)?;
    let [piecewise] = all.as_slice() else { return Err(Undefined::Unresolved) };
    if let Some(factor) = factor {
        let scales = [piecewise.scale, piecewise.size].map(|x| x * factor.abs());
        return Ok(answer(piecewise.integral() * factor, piecewise.error * factor.abs(), scales));
    }
    let (s, value) = extreme(statics, sampler, expr, piecewise, sign)?;
    Ok(match how {
        CycleFunction::Argmax => {
            answer(sampler.interval.value(s), piecewise.error.min(1.0) * length.abs(), [length.abs(); 2])
        }
        _ => answer(value, piecewise.error, [piecewise.scale, piecewise.size]),
    })
}

/// Extremes of a flywheel's work are known with it.
fn of_work(statics: &WholeCycle, how: CycleFunction, expr: &Expr) -> Option<CycleAnswer> {
    let (query, sign) = match expr {
        Expr::Query(query) => (query, 1.0),
        Expr::Negate(inner) => match &**inner {
            Expr::Query(query) => (query, -1.0),
            _ => return None,
        },
        _ => return None,
    };
    let Query::Flywheel(index, FlywheelPart::Work) = query else { return None };
    let found = statics.flywheels.get(*index)?;
    let greatest = match how {
        CycleFunction::Max | CycleFunction::Argmax => sign > 0.0,
        CycleFunction::Min => sign < 0.0,
        CycleFunction::Mean | CycleFunction::Integral | CycleFunction::Harmonic(_) => return None,
    };
    let at = found.extremes[usize::from(greatest)];
    let value = if how == CycleFunction::Argmax { at } else { sign * found.work(at) };
    let argmax = how == CycleFunction::Argmax;
    let (error, scale) =
        if argmax { (1e-12, found.interval.1.abs()) } else { (found.error, found.fluctuation) };
    Some(CycleAnswer { value, error, scale, splits: found.splits.clone(), ..CycleAnswer::default() })
}

/// Whether the quantity is at the sweep's end what it was at its beginning: an angle that goes round is not.
fn comes_again(
    model: &Model<'_>,
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    expr: &Expr,
) -> Result<bool, Undefined> {
    if !sampler.interval.is_closed || !sampler.comes_again() {
        return Ok(false);
    }
    if !counts_turns(model.mechanism, expr) {
        return Ok(true);
    }
    let mut at = |s| sampler.sample(statics, s, expr);
    let [first, last, between] = [at(0.0)?, at(1.0)?, at(0.3)?];
    let greatest = [first, last, between].iter().fold(0.0_f64, |most, x| most.max(x.value.abs()));
    let apart = (first.value - last.value).abs();
    Ok(apart <= 1e-9 * greatest || is_zero(apart, first.size + last.size))
}

/// The mean of a smooth quantity over whole turns, with its size; `None` where samples do not converge.
fn smooth_mean(
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    expr: &Expr,
) -> Result<Option<(Mean, f64)>, Undefined> {
    let (mut samples, mut size): (Vec<f64>, f64) = (Vec::new(), 0.0);
    let tolerance = sampler.tolerance;
    let fewest = if tolerance > COARSE { FEWEST_SAMPLES / 2 } else { FEWEST_SAMPLES };
    let mut count = match sampler.waves() {
        Some([waves, turns]) => (PER_WAVE * waves).max(2 * fewest * turns).next_power_of_two(),
        None => fewest,
    };
    let most = MOST_SAMPLES.max(FINER * count);
    while count <= most {
        let mut next = Vec::with_capacity(count);
        for i in 0..count {
            let known = if i % 2 == 0 { samples.get(i / 2).copied() } else { None };
            #[allow(clippy::cast_precision_loss)] // far below 2^52
            let at = i as f64 / count as f64;
            next.push(match known {
                Some(f) => f,
                None => {
                    let sample = sampler.sample(statics, at, expr)?;
                    size = size.max(sample.size);
                    sample.value
                }
            });
        }
        samples = next;
        let mut mean = mean(&samples);
        if mean.has_converged(tolerance) || is_zero(mean.scale, size) {
            if is_zero(mean.value, size) {
                mean.value = 0.0;
            }
            mean.error = mean.error.max(if is_zero(mean.scale, size) { f64::EPSILON * size } else { 0.0 });
            return Ok(Some((mean, size)));
        }
        count *= 2;
    }
    Ok(None)
}

/// The greatest value (of the quantity times `sign`): where, and the quantity there.
fn extreme(
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    expr: &Expr,
    piecewise: &Piecewise,
    sign: f64,
) -> Result<(f64, f64), Undefined> {
    if piecewise.is_nothing() {
        return Ok((0.0, 0.0));
    }
    let mut best: Option<(f64, f64)> = None;
    let near = (1e-12 * piecewise.scale).max(ROUNDING * piecewise.size);
    for candidate in piecewise.candidates() {
        // at a jump it is the value on the side of the panel that counts
        let value = if candidate.at_jump {
            candidate.value
        } else {
            sampler.sample(statics, candidate.at, expr)?.value
        };
        // of equal ones the first
        if best.is_none_or(|(_, most)| sign * value > sign * most + near) {
            best = Some((candidate.at, value));
        }
    }
    let (at, value) = best.ok_or(Undefined::Unresolved)?;
    Ok((at, if is_zero(value, piecewise.size) { 0.0 } else { value }))
}
