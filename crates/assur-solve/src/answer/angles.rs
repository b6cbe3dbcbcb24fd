//! Angles at a position from which the motion is followed.

use crate::model::{LinkId, PairKind};
use crate::position::{Model, State};
use crate::structure::{BodyId, EffortKind, EffortSource};
use std::f64::consts::{PI, TAU};

/// The angles of the bodies by their slots, and after them for every pair the whole turns, rad, that its coordinate has more
/// than the difference of the two angles. Driven angles are as they are written, with their whole turns; the angle of a hinge
/// that no drive gives is between −180° and 180°, that of a link too.
pub(crate) fn first_angles(model: &Model<'_>, state: &State) -> Vec<f64> {
    let mut angles = Vec::with_capacity(state.motion.bodies.len() + model.mechanism.pairs.len());
    first_angles_in(model, state, &mut angles);
    angles
}

/// As [`first_angles`], in the memory of a list.
pub(crate) fn first_angles_in(model: &Model<'_>, state: &State, angles: &mut Vec<f64>) {
    angles.clear();
    angles.extend(state.motion.bodies.iter().map(|b| b.u.angle()));
    let drives = || {
        model.structure.drives.iter().filter_map(|effort| match effort.source {
            EffortSource::Drive(id) => Some((effort, state.motion.inputs[id.index()].value)),
            EffortSource::Balance(_) => None,
        })
    };
    for (effort, value) in drives() {
        if let EffortKind::Angle(body) = effort.kind {
            // of a welded link: the angle is that of the link, and the body has its own
            let link = effort.link(model.mechanism).map_or(body.0, LinkId::index);
            angles[link] = value;
            if link != body.0 {
                angles[body.0] += whole_turns(value - angles[body.0]);
            }
        }
    }
    for &body in &model.plan.turning {
        angles[body] = state.motion.bodies[body].turned;
    }
    let is_driven =
        |body: BodyId| drives().any(|(effort, _)| matches!(effort.kind, EffortKind::Angle(b) if b == body));
    let is_counted = |body: BodyId| {
        body.0 == LinkId::GROUND.index() || model.plan.turning.contains(&body.0) || is_driven(body)
    };
    for pair in &model.mechanism.pairs {
        let turns = match &pair.kind {
            PairKind::Revolute(pins) => match pins.as_slice() {
                [first, second] => {
                    let ends = [first.link, second.link].map(|link| BodyId(link.index()));
                    let apart = angles[ends[1].0] - angles[ends[0].0];
                    let bodies = [first.link, second.link].map(|link| model.structure.replaced.body_of(link));
                    let driven = drives().find_map(|(effort, value)| match effort.kind {
                        EffortKind::RelativeAngle { first, second, .. } if [first, second] == bodies => {
                            Some(value)
                        }
                        _ => None,
                    });
                    match driven {
                        Some(value) => whole_turns(value - apart),
                        None if ends.into_iter().all(is_counted) => 0.0,
                        None if apart > PI || apart <= -PI => -whole_turns(apart),
                        None => 0.0,
                    }
                }
                _ => 0.0,
            },
            _ => 0.0,
        };
        angles.push(turns);
    }
}

/// The whole turns in an angle, rad.
pub(crate) fn whole_turns(angle: f64) -> f64 {
    (angle / TAU).round() * TAU
}
