//! Whether nothing is to be said of a position.

use super::failure::{Cause, GroupId};
use super::lost::{is_moderate, out_of_scale};
use super::note::Loss;
use super::notes::Notes;
use crate::plan::Level;
use crate::position::{DEAD, Model, PoseRequest, Residuals, State};

/// Conditions above this are not worth a note, whatever they are of, and make no group behind them worse.
pub(super) const NO_NOTE: f64 = 0.05;

/// The conditions of the groups of motion: the least of them, and notes about those that lose digits. `carried` is memory.
pub(super) fn of_motion(
    model: &Model<'_>,
    state: &State,
    carried: &mut Vec<f64>,
    notes: &mut Notes,
    pose: &PoseRequest,
) -> Result<f64, Cause> {
    let level = model.plan.effects.level;
    let mut least = 1.0_f64;
    carried.clear();
    carried.resize(state.motion.bodies.len(), 1.0_f64);
    let groups = model.structure.motion.iter().zip(&state.motion.certificates);
    for (i, ((group, &h), conditioning)) in groups.zip(&state.motion.conditions).enumerate() {
        let condition = conditioning.abs();
        least = least.min(condition);
        let before = group.joints.iter().map(|j| carried[j.base.0]).fold(1.0, f64::min);
        // what is left of a group that depends on others goes by the product
        group.bodies.iter().for_each(|b| carried[b.0] = before * (condition / NO_NOTE).min(1.0));
        if level > Level::Positions && condition <= DEAD {
            return Err(Cause::Dead { group: GroupId::Motion(i), condition });
        }
        // positions near a double root keep half their digits
        let loss = match level {
            Level::Positions => None,
            Level::Velocities => Some(Loss::Velocities),
            Level::Accelerations => Some(Loss::Accelerations),
        };
        if let Some(loss) = loss {
            notes.condition(model, GroupId::Motion(i), (condition * before, loss), pose);
        }
        notes.certificate(i, h, condition, pose);
    }
    Ok(least)
}

/// The same of the groups of forces.
pub(super) fn of_forces(
    model: &Model<'_>,
    state: &State,
    notes: &mut Notes,
    pose: &PoseRequest,
) -> Result<f64, Cause> {
    let mut least = 1.0_f64;
    let groups = model.structure.forces.iter().zip(&state.forces.conditions);
    for (i, (group, conditioning)) in groups.enumerate() {
        let condition = conditioning.abs();
        least = least.min(condition);
        if condition <= DEAD {
            return Err(match group.efforts.as_slice() {
                [] => Cause::Dead { group: GroupId::Forces(i), condition },
                _ => Cause::CannotHold { group: i, condition },
            });
        }
        notes.condition(model, GroupId::Forces(i), (condition, Loss::Forces), pose);
    }
    Ok(least)
}

/// Whether numbers are far from what `f64` holds, and the pairs meet.
pub(super) fn is_sound(state: &State, residuals: &Residuals) -> bool {
    is_moderate(state) && out_of_scale(residuals).is_none()
}

/// The conditions of all groups that a plan has.
pub(super) fn conditions<'s>(model: &Model<'_>, state: &'s State) -> impl Iterator<Item = f64> + use<'s> {
    let forces = if model.plan.effects.forces { state.forces.conditions.as_slice() } else { &[] };
    state.motion.conditions.iter().chain(forces).map(|c| c.abs())
}
