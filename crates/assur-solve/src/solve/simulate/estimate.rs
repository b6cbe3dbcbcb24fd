//! The error of a run, from a coarser run over the same motion.
//!
//! What both differ by is the error of the coarser one, but for that of the finer one. How much finer the latter is, witnesses tell
//! that know nothing of each other: the order of the method, since its steps are halves or two thirds of those of the coarser run; what
//! is missing in the energy of each, which no step looks at; and what all steps of the finer run leave off by their own estimates, beside
//! the difference, which is small where errors of the coarser run cancel by chance. Each is off by the chance with which errors of steps
//! add up or cancel; a geometric mean is less so. By the method of energy both leave off what their series do.

use super::compare::Compared;
use super::report::Method;
use super::run::Run;
use super::trace::Fraction;
use crate::answer::LEAST_CONDITION;

/// The error of a finer run is that of the coarser one times what the witnesses tell, but for chance: over the examples and a thousand
/// random motions, at tolerances from 1e-3 to 1e-13, the ratio of the two exceeds this in 3 of 100 runs.
const BY_CHANCE: f64 = 3.5;
/// Works are integrals along the motion, and known better: their errors are this part.
const OF_WORKS: f64 = 0.4;
/// The same as by chance by the method of energy.
const BY_ENERGY: f64 = 5.0;
/// Of Radau IIA the iteration that solves a step leaves errors that do not fall by its order: over the examples the error is rarely
/// greater than this part of the difference.
const IMPLICIT: f64 = 0.6;
/// What is missing in the energy is rounding below this part of it.
const SEEN: f64 = 1e-13;
/// Where mass and force are known along the coordinate, what is missing in the energy is what their series leave off at an instant
/// that is printed: between them it may be so many times that.
const BETWEEN: f64 = 8.0;
/// Two runs may agree by chance: by the method of energy the error is not said to be less than this part of the worst that a series
/// leaves off.
const LEAST: f64 = 0.05;
/// Rounding adds up as a random walk: so many times its mean distance, as over the examples.
const WALK: f64 = 3.0;
/// By the method of energy time is a sum of integrals along the same intervals again and again, which are rounded in the same sense:
/// the number of roundings that it may be off, as measured on pendulums over 1e5 s.
const OF_TIME: f64 = 3.0;
/// The instant of an event is known to so many roundings of the run, as over the examples with stops, and all that follows shifts
/// with it: what passes slowly is passed less exactly.
const OF_EVENT: f64 = 30.0;
/// Over a change point of several coordinates accelerations are found from positions close to it: near there they are known to so
/// many roundings, as the angular acceleration of a coupler that does not turn shows.
const OF_CHANGE: f64 = 2e5;
/// Rounding differs in two runs of other steps: of DOP853 it is not said to be more than so many times the difference.
const APART: f64 = 3.0;
/// Above this difference two runs are so unlike that it is the error of either.
const UNLIKE: f64 = 2e-3;
/// A difference that is so many times as much beside what steps leave off as one before does not fall with the step: then it is the
/// error of either run.
const MORE: f64 = 5.0;
/// A difference of no more than so many roundings is taken as it is.
const ROUNDINGS: f64 = 10.0;

/// The error of the finer of two runs. `least` is how many times what the steps of the coarser run leave off two runs have differed by
/// so far, at least; `scales` are what is much for each free coordinate; `conserved` where no drive that is prescribed moves.
pub(super) fn estimate(
    compared: Compared,
    (coarse, fine): (&Run, &Run),
    least: &mut f64,
    scales: &[f64],
    conserved: bool,
) -> Compared {
    let difference = compared.error;
    let greatest = greatest(fine, scales);
    let rounding = rounding(fine, scales, greatest);
    let (finer, works) = match (coarse.method, fine.method) {
        (Method::Radau, _) | (_, Method::Radau) => (IMPLICIT, 1.0),
        (_, Method::Dop853) => (BY_CHANCE * shorter((coarse, fine), difference, conserved), OF_WORKS),
        (_, Method::Energy) => (BY_ENERGY * by_energy((coarse, fine), conserved), 1.0),
    };
    let by_steps = coarse.method == Method::Dop853 && fine.method == Method::Dop853;
    // chaos makes rounding grow as it does what steps leave off
    let grows = difference / coarse.left_off.all;
    let stays = by_steps && grows > MORE * *least && difference.is_finite();
    if by_steps {
        *least = least.min(grows);
    }
    let same = stays || difference > UNLIKE;
    let compared = compared.reduced(if same { 1.0 } else { finer.min(1.0) }, works);
    let grown = if by_steps { (*least * rounding).min(APART * difference) } else { 0.0 };
    let reduced = compared.error.max(grown);
    let left_off = if fine.method == Method::Energy {
        (LEAST * fine.left_off.worst).max(BETWEEN * fine.energy.balance)
    } else {
        0.0
    };
    // what of it shows, if not by chance less than the last digit
    let shown = if fine.method == Method::Dop853 { APART * difference } else { rounding };
    let shown = shown.max(f64::EPSILON * greatest);
    let floor = rounding.min(shown.max(fine.shift)).max(left_off);
    let error = reduced.max(floor).max(difference.min(ROUNDINGS * rounding));
    let is_rounding = error.max(shown) <= rounding;
    Compared { error, difference, is_rounding, ..compared }
}

/// The error of the finer run over that of the coarser one, in shorter steps.
fn shorter((coarse, fine): (&Run, &Run), difference: f64, conserved: bool) -> f64 {
    let of_order = fine.part.unwrap_or(Fraction::Half).of_error();
    let of_energy = of_energy((coarse, fine), conserved).unwrap_or(of_order);
    if difference > 0.0 {
        (of_energy * (of_order * fine.left_off.all / difference).sqrt()).sqrt()
    } else {
        0.0
    }
}

/// The same by the method of energy.
fn by_energy((coarse, fine): (&Run, &Run), conserved: bool) -> f64 {
    of_energy((coarse, fine), conserved).unwrap_or_else(|| one_over(fine.left_off.all, coarse.left_off.all))
}

/// What is missing in the energy of both, where it can be seen.
fn of_energy((coarse, fine): (&Run, &Run), conserved: bool) -> Option<f64> {
    let missing = (coarse.energy.balance, fine.energy.balance);
    (conserved && missing.0 > SEEN).then(|| one_over(missing.1.max(SEEN), missing.0))
}

/// One over the other, where it is no more.
fn one_over(fine: f64, coarse: f64) -> f64 {
    if fine < coarse { fine / coarse } else { 1.0 }
}

/// The greatest coordinate of a run, of what is much for it.
fn greatest(run: &Run, scales: &[f64]) -> f64 {
    let kept = (0..run.records.count).flat_map(|index| run.records.state(index).iter().zip(scales));
    kept.map(|(q, scale)| q.abs() / scale).fold(1.0, f64::max)
}

/// What rounding makes of a run: that of the greatest coordinate adds up from step to step, and grows near dead positions; that of
/// the instants at which steps are ended shifts what comes after; and that of change points is added.
#[allow(clippy::cast_precision_loss)] // far below 2^52
fn rounding(run: &Run, scales: &[f64], greatest: f64) -> f64 {
    let walk =
        WALK * greatest * (run.counts.steps as f64).sqrt() / run.worst_condition.0.max(LEAST_CONDITION);
    let changes = if run.records.order > 1 { OF_CHANGE * (run.crossed.len() as f64).sqrt() } else { 0.0 };
    let passed = if run.method == Method::Energy { OF_TIME * passed(run, scales) } else { 0.0 };
    f64::EPSILON * (walk + OF_EVENT * run.counts.shortened as f64 + changes + passed)
        + run.shift
        + run.late * pace(run, scales)
}

/// How fast coordinates and rates change at most, of what is much for them and of the greatest rate, 1/s.
fn pace(run: &Run, scales: &[f64]) -> f64 {
    let order = run.records.order;
    let greatest = |of: &dyn Fn(usize) -> f64| (0..run.records.count).map(of).fold(0.0, f64::max);
    let over =
        |values: &[f64]| values.iter().zip(scales).map(|(x, scale)| x.abs() / scale).fold(0.0, f64::max);
    let rate = greatest(&|index| over(&run.records.state(index)[order..]));
    let acceleration = greatest(&|index| over(run.records.accelerations(index)));
    if rate > 0.0 { rate.max(acceleration / rate) } else { 0.0 }
}

/// How far coordinates would come in the time of the run at their greatest rates.
fn passed(run: &Run, scales: &[f64]) -> f64 {
    let rates = |index: usize| run.records.state(index)[run.records.order..].iter().zip(scales);
    let greatest = (0..run.records.count).flat_map(rates).map(|(rate, scale)| rate.abs() / scale);
    greatest.fold(0.0, f64::max) * run.records.times.last().map_or(0.0, |last| last - run.records.times[0])
}
