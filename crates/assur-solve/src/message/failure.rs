//! The sentence about a failure.

use super::consistent::{blocked, undecided};
use super::format::place;
use super::impossible::{cannot_hold, curve_left, dead, not_finite, spring_at_zero, too_far};
use super::over_sweep::{no_extreme, no_flywheel, no_sweep};
use super::refusal::refused;
use super::simulate::halted;
use super::slip::slip_backwards;
use super::unassembled::{ambiguous, does_not_close, not_found, not_met};
use crate::position::Model;
use crate::solve::{Cause, Failure};
use assur_text::diagnostic::Diagnosis;

/// Why a file, or one of its positions, has no solution.
#[must_use]
pub fn failure(model: &Model<'_>, failure: &Failure) -> Diagnosis {
    let pose = failure.pose.as_ref().map_or_else(String::new, |pose| place(model, pose));
    match &failure.cause {
        Cause::Refused(refusal) => refused(model, refusal),
        Cause::DoesNotClose { group, gap } => does_not_close(model, *group, gap, pose),
        Cause::NotFound { group, point, never_regular } => {
            not_found(model, *group, (*point, *never_regular), pose)
        }
        Cause::Ambiguous { count, groups } => ambiguous(model, *count, groups, pose),
        Cause::HintNotMet { hint, group, assemblies } => not_met(model, (*hint, *group), assemblies, pose),
        Cause::TooFar => too_far(model, pose),
        Cause::Dead { group, condition } => dead(model, *group, *condition, pose),
        Cause::CannotHold { group, condition } => cannot_hold(model, *group, *condition, pose),
        Cause::SpringAtZero { spring } => spring_at_zero(model, *spring, &pose),
        Cause::Lost(lost) => not_finite(model, *lost, pose),
        Cause::CurveLeft(left) => curve_left(left, pose),
        Cause::Undecided => undecided(model, pose),
        Cause::SlipBackwards(pair) => slip_backwards(model, *pair, pose),
        Cause::Blocked => blocked(model, pose),
        Cause::NoExtreme { pair, function, which, why, gap } => {
            no_extreme(model, *pair, (*function, *which), (*why, gap.as_deref()))
        }
        Cause::NoSweep(why) => no_sweep(model, *why),
        Cause::Halted { time, halt } => halted(model, *time, halt),
        Cause::NoFlywheel { flywheel, why } => no_flywheel(model, *flywheel, *why),
    }
}

/// Why a file has no solution.
pub fn failures(model: &Model<'_>, all: &[Failure]) -> impl Iterator<Item = Diagnosis> {
    all.iter().map(|one| failure(model, one))
}
