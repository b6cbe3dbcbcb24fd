//! Where the bodies of a general group are meant to stand: places that `near` names, places of bodies that stand already, and
//! what follows from both through hinges.

use crate::group::general::{InitialGuess, Pose};
use crate::math::Vec2;
use crate::model::HintKind;
use crate::plan::GeneralMotion;
use crate::position::{Model, State};
use crate::structure::JointKind;

/// A point of a body, in its frame, and its place.
type Placed = (Vec2, Vec2);

/// `None` where `near` names no point of the group.
pub(super) fn initial_guess(
    model: &Model<'_>,
    state: &State,
    index: usize,
    group: &GeneralMotion,
) -> Option<InitialGuess> {
    let own = &group.bodies[..group.moving];
    let mut placed: Vec<Vec<Placed>> = vec![Vec::new(); own.len()];
    let mut is_named = false;
    for hint in &model.mechanism.hints {
        let HintKind::Near { point: (link, at), place } = hint.kind else { continue };
        let (body, at) = model.structure.replaced.place(link, at);
        if let Some(body) = own.iter().position(|slot| *slot == body.0) {
            placed[body].push((at, place));
            is_named = true;
        }
    }
    is_named.then(|| Search { model, state, own, hinges: hinges(model, index, own) }.poses(placed))
}

/// A hinge: its points on the group's own bodies, and its place where another body of it stands already.
struct Hinge {
    points: Vec<(usize, Vec2)>,
    standing: Option<(usize, Vec2)>,
}

/// The hinges of a group.
fn hinges(model: &Model<'_>, index: usize, own: &[usize]) -> Vec<Hinge> {
    let mut joints: Vec<_> = model.structure.motion[index].joints.iter().map(|j| j.joint).collect();
    joints.sort_unstable();
    joints.dedup();
    let hinge = |members: &Vec<(crate::structure::BodyId, Vec2)>| {
        let place = |slot: usize| own.iter().position(|own| *own == slot);
        let points = members.iter().filter_map(|(body, at)| Some((place(body.0)?, *at))).collect();
        let standing =
            members.iter().find(|(body, _)| place(body.0).is_none()).map(|(body, at)| (body.0, *at));
        Hinge { points, standing }
    };
    let joints = joints.iter().map(|joint| &model.structure.replaced.joint(*joint).kind);
    joints
        .filter_map(|kind| match kind {
            JointKind::Revolute(members) => Some(hinge(members)),
            JointKind::Prismatic { .. } | JointKind::Weld { .. } | JointKind::Law(_) => None,
        })
        .collect()
}

struct Search<'a> {
    model: &'a Model<'a>,
    state: &'a State,
    own: &'a [usize],
    hinges: Vec<Hinge>,
}

impl Search<'_> {
    fn poses(&self, mut placed: Vec<Vec<Placed>>) -> InitialGuess {
        let mut poses: Vec<Option<Pose>> = vec![None; self.own.len()];
        let mut place_of: Vec<Option<Vec2>> = self
            .hinges
            .iter()
            .map(|hinge| hinge.standing.map(|(slot, at)| self.state.motion.bodies[slot].position(at)))
            .collect();
        let extent = crate::position::extent(self.model);
        // every round but the last places a hinge or a body; a point that is no number is never found again
        for _ in 0..=self.hinges.len() + self.own.len() {
            let mut changed = false;
            for (hinge, place) in self.hinges.iter().zip(&mut place_of) {
                if place.is_none() {
                    *place = hinge.points.iter().find_map(|(body, at)| {
                        let named = placed[*body].iter().find(|(point, _)| point == at).map(|p| p.1);
                        named.or_else(|| poses[*body].map(|pose| pose.point(*at)))
                    });
                }
                let Some(place) = *place else { continue };
                for (body, at) in &hinge.points {
                    if !placed[*body].iter().any(|(point, _)| point == at) {
                        placed[*body].push((*at, place));
                        changed = true;
                    }
                }
            }
            for (pose, placed) in poses.iter_mut().zip(&placed).filter(|(pose, _)| pose.is_none()) {
                *pose = fitted(placed, extent);
                changed |= pose.is_some();
            }
            if !changed {
                break;
            }
        }
        let whole = poses.iter().all(Option::is_some);
        let poses = poses.iter().zip(&placed).map(|(pose, placed)| pose.unwrap_or_else(|| beside(placed)));
        InitialGuess { poses: poses.collect(), whole }
    }
}

/// The pose of a body of which two points are placed.
fn fitted(placed: &[Placed], extent: f64) -> Option<Pose> {
    let (first, place) = *placed.first()?;
    let (second, other) = *placed[1..].iter().max_by(|a, b| {
        let far = |p: &Placed| (p.0 - first).norm();
        far(a).total_cmp(&far(b))
    })?;
    let (own, is) = (second - first, other - place);
    let apart = crate::position::SAME * extent;
    if own.norm() <= apart || is.norm() <= apart {
        return None;
    }
    let u = is.turned_back(own).unit()?;
    Some(Pose { p: place - first.turned(u), u })
}

/// The pose of a body of which one point is placed, or none.
fn beside(placed: &[Placed]) -> Pose {
    let (at, place) = placed.first().copied().unwrap_or((Vec2::zero(), Vec2::zero()));
    Pose { p: place - at, u: Vec2::new(1.0, 0.0) }
}
