//! Angles at a position from which the motion is followed.

use crate::model::{LinkId, PairKind};
use crate::position::{Model, State};
use crate::structure::{BodyId, EffortKind, EffortSource};
use std::f64::consts::{PI, TAU};

/// The angles of the bodies by their slots, and after them for every pair the whole turns, rad, that its coordinate has more
/// than the difference of the two angles. Driven angles are as they are written, with their whole turns; the angle of a hinge
/// that no drive gives is between −180° and 180°, that of a link too.
pub(crate) fn first_angles(model: &Model<'_>, state: &State) -> Vec<f64> {
    let mut angles: Vec<f64> = state.motion.bodies.iter().map(|b| b.u.angle()).collect();
    let mut counted = vec![false; angles.len()];
    counted[LinkId::GROUND.index()] = true;
    let mut hinges = Vec::new();
    for effort in &model.structure.drives {
        let EffortSource::Drive(id) = effort.source else { continue };
        let value = state.motion.inputs[id.index()].value;
        match effort.kind {
            EffortKind::Angle(body) => {
                angles[body.0] = value;
                counted[body.0] = true;
            }
            EffortKind::RelativeAngle { first, second, .. } => hinges.push(([first, second], value)),
            _ => {}
        }
    }
    for &body in &model.plan.turning {
        angles[body] = state.motion.bodies[body].turned;
        counted[body] = true;
    }
    let turns = model.mechanism.pairs.iter().map(|pair| {
        let PairKind::Revolute(pins) = &pair.kind else { return 0.0 };
        let [first, second] = pins.as_slice() else { return 0.0 };
        let ends = [first.link, second.link].map(|link| BodyId(link.index()));
        let apart = angles[ends[1].0] - angles[ends[0].0];
        match hinges.iter().find(|(of, _)| *of == ends) {
            Some((_, value)) => whole_turns(value - apart),
            None if ends.iter().all(|body| counted[body.0]) => 0.0,
            None if apart > PI || apart <= -PI => -whole_turns(apart),
            None => 0.0,
        }
    });
    let turns: Vec<f64> = turns.collect();
    angles.extend(turns);
    angles
}

fn whole_turns(angle: f64) -> f64 {
    (angle / TAU).round() * TAU
}
