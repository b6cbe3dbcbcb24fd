//! A machine with all its places: what the file leaves without one, shafts, sliders, ropes, is laid out for the picture, once for every
//! view.

pub mod arrangement;
mod frames;
mod layout;
mod rope;

pub use frames::{Frames, frames};
pub use rope::{End, Rope, wound};

use crate::scene::Scene;
use arrangement::Arrangement;
use assur_model::model::{Bearing, LinkId, Mechanism, PairKind, TransmissionKind};
use assur_position::position::BodyState;
use assur_solve::solve::{Model, Pose};

/// A mechanism whose shafts and sliders all have places, at some positions.
pub struct Laid {
    mechanism: Mechanism,
    poses: Vec<Pose>,
    ways: Vec<(f64, f64)>,
    pub arrangement: Arrangement,
}

impl Laid {
    /// The mechanism of a scene at positions; none where nothing is laid out: all has a place, and no rope, worm or screw runs.
    pub fn of(scene: &Scene<'_>, poses: &mut Vec<Pose>) -> Option<Self> {
        if !is_needed(scene) {
            return None;
        }
        let (mechanism, arrangement) = layout::placed(scene, poses);
        let ways = ways(scene, &mechanism, poses);
        let poses = std::mem::take(poses);
        let mut laid = Self { mechanism, poses, ways, arrangement };
        for pose in &mut laid.poses {
            if let Ok(solved) = &mut pose.outcome {
                place_bodies(&laid.mechanism, &mut solved.state.motion.bodies, &laid.arrangement.shares);
            }
        }
        Some(laid)
    }

    /// The mechanism of a scene at its position and on its way.
    pub fn at_rest(scene: &Scene<'_>) -> Option<Self> {
        if !is_needed(scene) {
            return None;
        }
        let all = std::iter::once(scene.pose).chain(scene.turn);
        Self::of(scene, &mut all.cloned().collect())
    }

    /// The scene of its first position, the others on the way around it.
    pub fn still<'l>(&'l self, scene: &Scene<'l>) -> Option<Scene<'l>> {
        let first = self.scenes(scene).into_iter().next()?;
        Some(Scene { turn: self.poses.get(1..).unwrap_or_default(), ..first })
    }

    /// The scenes of its positions.
    pub fn scenes<'l>(&'l self, scene: &Scene<'l>) -> Vec<Scene<'l>> {
        let model = Model { mechanism: &self.mechanism, ..scene.model };
        let is_open = self.mechanism.pairs.iter().any(|pair| pair.bearing == Some(Bearing::Open));
        let of = |pose: &'l Pose| {
            let solved = pose.outcome.as_ref().ok()?;
            Some(Scene {
                model,
                pose,
                solved,
                is_open,
                ways: &self.ways,
                laid: Some(&self.arrangement),
                ..*scene
            })
        };
        self.poses.iter().filter_map(of).collect()
    }
}

/// Whether anything is laid out: something has no place, or a rope, a worm or a screw runs.
fn is_needed(scene: &Scene<'_>) -> bool {
    let runs = |kind: &PairKind| match kind {
        PairKind::Transmission(t) => {
            matches!(t.kind, TransmissionKind::Rope | TransmissionKind::Worm | TransmissionKind::Screw)
        }
        _ => false,
    };
    scene.is_open || scene.mechanism().pairs.iter().any(|pair| runs(&pair.kind))
}

/// The ways of all pairs; of sliders that were laid out over these positions.
fn ways(scene: &Scene<'_>, mechanism: &Mechanism, poses: &[Pose]) -> Vec<(f64, f64)> {
    let mut ways = scene.all_ways();
    for (pair, way) in mechanism.pairs.iter().zip(&mut ways) {
        if let PairKind::Prismatic(g) = &pair.kind
            && pair.bearing == Some(Bearing::Placed)
        {
            let [least, greatest] = range(poses, g.slider);
            *way = (least, greatest);
        }
    }
    ways
}

/// The least and the greatest coordinate of a slider without a place, m.
fn range(poses: &[Pose], link: LinkId) -> [f64; 2] {
    let at = |pose: &Pose| Some(pose.outcome.as_ref().ok()?.state.motion.bodies[link.index()].p.x);
    let all = poses.iter().filter_map(at).filter(|x| x.is_finite());
    let [least, greatest] = all.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
    if least <= greatest { [least, greatest] } else { [0.0, 0.0] }
}

/// Puts shafts and sliders where their pairs are; those on others after these.
fn place_bodies(mechanism: &Mechanism, bodies: &mut [BodyState], shares: &[f64]) {
    let own = |i: &usize| mechanism.pairs[*i].bearing == Some(Bearing::Placed);
    let mut left: Vec<usize> = (0..mechanism.pairs.len()).filter(own).collect();
    let moved = |i: usize| moved_link(&mechanism.pairs[i].kind);
    while !left.is_empty() {
        let waits = |i: &usize| left.iter().any(|other| moved(*other) == base(&mechanism.pairs[*i].kind));
        let (later, now): (Vec<usize>, Vec<usize>) = left.iter().partition(|i| waits(i));
        now.iter().for_each(|i| place_body(&mechanism.pairs[*i].kind, bodies, shares));
        if now.is_empty() {
            return;
        }
        left = later;
    }
}

fn place_body(kind: &PairKind, bodies: &mut [BodyState], shares: &[f64]) {
    match kind {
        PairKind::Revolute(pins) => {
            let [base, own] = [&pins[0], &pins[pins.len() - 1]];
            let carries = bodies[base.link.index()];
            let body = &mut bodies[own.link.index()];
            body.p = carries.position(base.at) - own.at.turned(body.u);
            body.v = carries.velocity(base.at);
        }
        PairKind::Prismatic(g) => {
            let body = &mut bodies[g.slider.index()];
            let (s, v, a) = (body.p.x, body.v.x, body.a.x);
            body.p = g.through + g.along * (s * shares[g.slider.index()]);
            (body.v, body.a) = (g.along * v, g.along * a);
        }
        _ => {}
    }
}

/// Whether all links are shafts and sliders.
pub fn has_shafts_alone(mechanism: &Mechanism) -> bool {
    let owned = |link: LinkId| {
        mechanism.pairs.iter().any(|pair| pair.bearing.is_some() && moved_link(&pair.kind) == link)
    };
    (1..mechanism.links.len()).map(LinkId::at).all(owned)
}

/// The link that a pair of a shaft or a slider brings along, and the one on which that moves.
pub(super) fn moved_link(kind: &PairKind) -> LinkId {
    match kind {
        PairKind::Revolute(pins) => pins.last().map_or(LinkId::GROUND, |pin| pin.link),
        PairKind::Prismatic(g) => g.slider,
        _ => LinkId::GROUND,
    }
}

pub(super) fn base(kind: &PairKind) -> LinkId {
    match kind {
        PairKind::Revolute(pins) => pins.first().map_or(LinkId::GROUND, |pin| pin.link),
        _ => LinkId::GROUND,
    }
}
