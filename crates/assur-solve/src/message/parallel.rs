//! What is wrong with a follower whose face lies along its own guide: in no position does the face hold it.

use super::format::short;
use crate::math::Vec2;
use crate::model::{LinkId, PairKind, Profile, ProfileShape};
use crate::position::Model;
use crate::structure::Group;
use std::f64::consts::FRAC_PI_2;

/// Directions nearer than this are parallel, rad.
const PARALLEL: f64 = 1e-9;

/// What to write where a face of a group is parallel to the guide of its link.
pub(super) fn turn_the_face(model: &Model<'_>, group: &Group) -> Option<String> {
    let pairs =
        || group.joints.iter().map(|j| model.mechanism.pair(model.structure.replaced.joint(j.joint).pair));
    let faces = pairs().filter_map(|pair| match &pair.kind {
        PairKind::Contact { first, second, .. } => [first, second].into_iter().find_map(straight),
        _ => None,
    });
    faces.into_iter().find_map(|(face, along)| {
        let (guide, direction) = pairs().find_map(|pair| Some((pair, guide_on(&pair.kind, face.link)?)))?;
        (along.cross(direction).abs() < PARALLEL).then(|| {
            let across = Vec2::direction(direction.angle() - FRAC_PI_2).angle();
            format!(
                "turn the line `{}`: it lies along the guide `{}` of `{}`, and nothing holds the link there; `along {} deg` is across \
                 the guide",
                face.name,
                guide.name,
                model.mechanism.link(face.link).name,
                short(across.to_degrees())
            )
        })
    })
}

/// The same where no group is known.
pub(super) fn turn_some_face(model: &Model<'_>) -> Option<String> {
    model.structure.motion.iter().find_map(|group| turn_the_face(model, group))
}

fn straight(profile: &Profile) -> Option<(&Profile, Vec2)> {
    match profile.shape {
        ProfileShape::Line(_, along) => Some((profile, along)),
        _ => None,
    }
}

/// The direction of a guide in the axes of one of its links.
fn guide_on(kind: &PairKind, link: LinkId) -> Option<Vec2> {
    match kind {
        PairKind::Prismatic(g) if g.slider == link => Some(g.direction),
        PairKind::Prismatic(g) if g.guide == link => Some(g.along),
        _ => None,
    }
}
