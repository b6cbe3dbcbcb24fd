//! The error of a run, from a coarser run over the same motion.
//!
//! What both differ by is the error of the coarser one, but for that of the finer one. How much finer the latter is, two
//! witnesses tell that know nothing of each other: what the steps of each leave off by their own estimates, and what is missing in
//! the energy of each, which no step looks at. Either is off by the chance with which errors of steps add up or cancel; the
//! geometric mean of both is less so.

use super::compare::Compared;
use super::report::Method;
use super::run::Run;

/// The error of a finer run is that of the coarser one times what both witnesses tell, but for chance: over the examples, at
/// tolerances from 1e-3 to 1e-13, 97 of 100 are no more than so many times greater.
const BY_CHANCE: f64 = 5.0;
/// What steps of both runs have in common neither witness sees: of DOP853 the error is not said to be less than this part of the
/// difference.
const IN_COMMON: f64 = 0.1;
/// The estimates of Radau IIA are of its order 3, and do not tell how much finer a run is: over the examples its error is rarely
/// greater than so many times the difference.
const IMPLICIT: f64 = 2.5;
/// What is missing in the energy is rounding below this part of it.
const SEEN: f64 = 1e-13;
/// Where mass and force are known along the coordinate, what is missing in the energy is what their series leave off at an instant
/// that is printed: between them it may be so many times that.
const BETWEEN: f64 = 3.0;
/// Two runs may agree by chance: the error is not said to be less than this part of the worst that a step leaves off.
const LEAST: f64 = 0.05;
/// Rounding adds up as a random walk: so many times its mean distance, as over the examples.
const WALK: f64 = 3.0;
/// The instant of an event is known to so many roundings of the run, as over the examples with stops, and all that follows shifts
/// with it: what passes slowly is passed less exactly.
const OF_EVENT: f64 = 30.0;
/// Over a change point of several coordinates accelerations are found from positions close to it: near there they are known to so
/// many roundings, as the angular acceleration of a coupler that does not turn shows.
const OF_CHANGE: f64 = 2e5;
/// Rounding is not said to grow more than by this condition.
const LEAST_CONDITION: f64 = 1e-3;
/// A difference of no more than so many roundings is taken as it is.
const ROUNDINGS: f64 = 10.0;

/// The error of the finer of two runs. `scales` are what is much for each free coordinate; `conserved` where no drive that is
/// prescribed moves.
pub(super) fn estimate(
    compared: Compared,
    (coarse, fine): (&Run, &Run),
    scales: &[f64],
    conserved: bool,
) -> Compared {
    let difference = compared.error;
    let by_chance = BY_CHANCE * finer(coarse, fine, conserved);
    let reduced = difference
        * match fine.method {
            Method::Radau => IMPLICIT,
            Method::Dop853 => by_chance.clamp(IN_COMMON, 1.0),
            Method::Energy => by_chance.min(1.0),
        };
    let missing = if fine.method == Method::Energy { BETWEEN * fine.energy.balance } else { 0.0 };
    let rounding = rounding(fine, scales);
    let floor = rounding.max(LEAST * fine.left_off.worst).max(missing);
    let error = reduced.max(floor).max(difference.min(ROUNDINGS * rounding));
    Compared { error, is_rounding: error <= rounding, ..compared }
}

/// The error of the finer run over that of the coarser one, as both witnesses tell.
fn finer(coarse: &Run, fine: &Run, conserved: bool) -> f64 {
    let by_energy = fine.method == Method::Energy;
    let of_steps = match (fine.left_off, coarse.left_off) {
        (fine, coarse) if by_energy => part(fine.worst, coarse.worst),
        // of fewer steps the finer ones are so by chance
        _ if fine.counts.steps <= coarse.counts.steps => 1.0,
        (fine, coarse) => part(fine.all, coarse.all),
    };
    let missing = (coarse.energy.balance, fine.energy.balance);
    let seen = conserved && missing.0 > SEEN;
    let of_energy = if seen { part(missing.1.max(SEEN), missing.0) } else { of_steps };
    if by_energy { of_energy } else { (of_steps * of_energy).sqrt() }
}

/// One over the other, where it is no more.
fn part(fine: f64, coarse: f64) -> f64 {
    if fine < coarse { fine / coarse } else { 1.0 }
}

/// What rounding makes of a run: that of the greatest coordinate adds up from step to step, and grows near dead positions; that of
/// the instants at which steps are ended shifts what comes after; and that of change points is added.
#[allow(clippy::cast_precision_loss)] // far below 2^52
fn rounding(run: &Run, scales: &[f64]) -> f64 {
    let kept = (0..run.records.count).flat_map(|index| run.records.state(index).iter().zip(scales));
    let greatest = kept.map(|(q, scale)| q.abs() / scale).fold(1.0, f64::max);
    let walk =
        WALK * greatest * (run.counts.steps as f64).sqrt() / run.worst_condition.0.max(LEAST_CONDITION);
    let changes = if run.records.order > 1 { OF_CHANGE * (run.crossed.len() as f64).sqrt() } else { 0.0 };
    f64::EPSILON * (walk + OF_EVENT * run.counts.shortened as f64 + changes)
}
