//! Groups whose links stand as they are written: their frames are that of the ground, as in a truss by coordinates.

use crate::group::general::{InitialGuess, Pose};
use crate::math::Vec2;
use crate::model::LinkId;
use crate::plan::GeneralMotion;
use crate::position::{BodyState, Model, SAME, State, extent};
use crate::structure::{Body, BodyId, BodyOrigin, Group, JointKind};

const WRITTEN: Pose = Pose { p: Vec2::new(0.0, 0.0), u: Vec2::new(1.0, 0.0) };

/// Per group of the motion, whether no drive and no start moves it.
pub(super) fn resting(model: &Model<'_>) -> Vec<bool> {
    let replaced = &model.structure.replaced;
    let is_outside =
        |(i, body): (usize, &Body)| body.known && replaced.body_of(LinkId::at(i)) != BodyId::GROUND;
    let mut moves: Vec<bool> = replaced.bodies.iter().enumerate().map(is_outside).collect();
    let mut rests = |group: &Group| {
        let on_moving = group.joints.iter().any(|j| moves[j.base.0])
            || group.laws.iter().any(|law| replaced.joint(*law).bodies().iter().any(|b| moves[b.0]));
        let rests = group.efforts.is_empty() && !on_moving;
        group.bodies.iter().for_each(|b| moves[b.0] = !rests);
        rests
    };
    model.structure.motion.iter().map(&mut rests).collect()
}

/// Whether the links among the bodies of a group stand as written; what stands for a higher pair follows them.
pub(super) fn is_as_written(model: &Model<'_>, index: usize, stand: &[BodyState], extent: f64) -> bool {
    let bodies = model.structure.motion[index].bodies.iter().zip(stand);
    bodies.filter(|(body, _)| is_link(model, body.0)).all(|(_, stands)| {
        (stands.u - WRITTEN.u).norm() <= SAME && (stands.p - WRITTEN.p).norm() <= SAME * extent
    })
}

pub(super) fn stands_as_written(model: &Model<'_>, state: &State, index: usize) -> bool {
    let bodies = model.structure.motion[index].bodies.iter();
    let stand: Vec<BodyState> = bodies.map(|body| state.motion.bodies[body.0]).collect();
    is_as_written(model, index, &stand, extent(model))
}

/// Where the bodies of a general group are if its links stand as written.
pub(super) fn written(model: &Model<'_>, state: &State, index: usize, group: &GeneralMotion) -> InitialGuess {
    let own = &group.bodies[..group.moving];
    let links = |body: usize| {
        if !own.contains(&body) {
            let stands = &state.motion.bodies[body];
            return Pose { p: stands.p, u: stands.u };
        }
        WRITTEN
    };
    let pose = |body: &usize| if is_link(model, *body) { WRITTEN } else { block(model, index, *body, links) };
    InitialGuess { poses: own.iter().map(pose).collect(), whole: true }
}

/// The pose of a block that stands for a higher pair: on its pin, along its guide.
fn block(model: &Model<'_>, index: usize, body: usize, links: impl Fn(usize) -> Pose) -> Pose {
    let mut pose = WRITTEN;
    for joint in &model.structure.motion[index].joints {
        match &model.structure.replaced.joint(joint.joint).kind {
            JointKind::Revolute(members) if members.iter().any(|m| m.0.0 == body) => {
                let pin = members.iter().find(|m| m.0.0 != body);
                pose.p = pin.map_or(pose.p, |(link, at)| links(link.0).point(*at));
            }
            JointKind::Prismatic { slider, guide, along, .. } if slider.0 == body => {
                pose.u = along.turned(links(guide.0).u);
            }
            _ => {}
        }
    }
    pose
}

fn is_link(model: &Model<'_>, body: usize) -> bool {
    matches!(model.structure.replaced.bodies[body].origin, BodyOrigin::Link(_))
}
