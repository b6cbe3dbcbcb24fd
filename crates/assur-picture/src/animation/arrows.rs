//! Arrows on what moves: velocities and accelerations of points, reactions, loads, each in one scale over all frames.

use super::motion::{series, whole};
use crate::error::{no_forces, no_speed, nothing_placed};
use crate::figures::{ACCELERATION, FORCE, VELOCITY};
use crate::forces::{letters, loaded, place};
use crate::kind::Kind;
use crate::motion::{Nodes, acceleration_at, velocity_at};
use crate::paper::Frame;
use crate::scene::Scene;
use assur_drawing::Scale;
use assur_math::math::Vec2;
use assur_model::model::{Level, LinkId, PairId};
use assur_position::position::Origin;
use assur_solve::solve::BodyState;
use assur_text::diagnostic::Diagnosis;
use serde::Serialize;

/// The longest arrow of a kind, mm.
const LONGEST: f64 = 25.0;
/// Steps of a millimetre.
const TENTHS: f64 = 10.0;
/// Where no vector is more than this part of the greatest of its kind, all are rounding.
const ROUNDING: f64 = 1e-9;

/// What arrows stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArrowKind {
    Velocities,
    Accelerations,
    /// Forces in pairs.
    Reactions,
    /// Loads, weights, springs, efforts.
    Loads,
}

impl ArrowKind {
    pub const ALL: [Self; 4] = [Self::Velocities, Self::Accelerations, Self::Reactions, Self::Loads];

    /// Its name on the command line and in messages.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Velocities => "velocities",
            Self::Accelerations => "accelerations",
            Self::Reactions => "reactions",
            Self::Loads => "loads",
        }
    }

    /// The kind of picture that shows as much.
    #[must_use]
    pub const fn kind(self) -> Kind {
        match self {
            Self::Velocities => Kind::Velocities,
            Self::Accelerations => Kind::Accelerations,
            Self::Reactions | Self::Loads => Kind::Forces,
        }
    }

    const fn dimension(self) -> [i8; 4] {
        match self {
            Self::Velocities => VELOCITY,
            Self::Accelerations => ACCELERATION,
            Self::Reactions | Self::Loads => FORCE,
        }
    }

    const fn unit(self) -> &'static str {
        match self {
            Self::Velocities => "m/s",
            Self::Accelerations => "m/s²",
            Self::Reactions | Self::Loads => "N",
        }
    }

    /// The vectors of a position: name, place, m, and vector.
    fn of(self, scene: &Scene<'_>) -> Vec<(String, Vec2, Vec2)> {
        let effects = scene.model.plan.effects;
        match self {
            Self::Velocities if effects.moving && effects.level >= Level::Velocities => {
                points(scene, "v", velocity_at)
            }
            Self::Accelerations if effects.timed && effects.level >= Level::Accelerations => {
                points(scene, "a", acceleration_at)
            }
            Self::Reactions if loaded(scene).is_ok() => reactions(scene),
            Self::Loads if loaded(scene).is_ok() => loads(scene),
            _ => Vec::new(),
        }
    }
}

impl ArrowKind {
    /// Why there are no arrows of this kind.
    pub(super) fn missing(self, scene: &Scene<'_>) -> Diagnosis {
        let effects = scene.model.plan.effects;
        match self {
            Self::Velocities if !effects.moving => no_speed(scene, "velocities"),
            Self::Accelerations if !effects.timed => no_speed(scene, "accelerations"),
            Self::Velocities | Self::Accelerations => {
                nothing_placed(scene, "arrows show velocities of points")
            }
            Self::Loads if loaded(scene).is_ok() => no_forces(
                "no load is a force",
                "a load is written so: `force F on slider at C = 100 N @ 180 deg`",
            ),
            Self::Reactions | Self::Loads => loaded(scene).err().unwrap_or_else(|| {
                no_forces("no force is found over the whole motion", "`assur solve` says where, and why")
            }),
        }
    }
}

/// Arrows of one kind: `player.js` says what each part is.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Arrows {
    pub kind: &'static str,
    scale: String,
    all: Vec<(String, String, String, String, String)>,
}

/// The arrows of all kinds that the solution has, on paper.
pub fn arrows(frames: &[Scene<'_>], paper: &Frame, decimal: char) -> Vec<Arrows> {
    ArrowKind::ALL.into_iter().filter_map(|kind| of_kind(kind, frames, paper, decimal)).collect()
}

/// Place, m, and vector of an arrow in every frame; none where it has none.
type Places = Vec<Option<(Vec2, Vec2)>>;

fn of_kind(kind: ArrowKind, frames: &[Scene<'_>], paper: &Frame, decimal: char) -> Option<Arrows> {
    let mut found: Vec<(String, Places)> = Vec::new();
    for (i, scene) in frames.iter().enumerate() {
        for (name, at, vector) in kind.of(scene) {
            let index = found.iter().position(|one| one.0 == name).unwrap_or_else(|| {
                found.push((name, vec![None; frames.len()]));
                found.len() - 1
            });
            found[index].1[i] = Some((at, vector)).filter(|_| vector.norm().is_finite());
        }
    }
    let greatest = found.iter().flat_map(|one| &one.1).flatten().map(|(_, v)| v.norm()).fold(0.0, f64::max);
    let rounding = ROUNDING * frames.first()?.greatest.in_si(kind.dimension());
    let scale = Scale::fitting(greatest, LONGEST).filter(|_| greatest > rounding)?;
    let factor = scale.factor();
    let of = |(name, all): (String, Places)| {
        let column = |part: &dyn Fn(Vec2, Vec2) -> f64| {
            series(
                all.iter()
                    .map(|one| one.and_then(|(at, v)| whole(TENTHS * part(paper.point(at), v / factor)))),
            )
        };
        let tail = (column(&|at, _| at.x), column(&|at, _| at.y));
        (name, tail.0, tail.1, column(&|_, v| v.x), column(&|_, v| -v.y))
    };
    let text = scale.text().replace('.', &decimal.to_string());
    Some(Arrows {
        kind: kind.name(),
        scale: format!("1 mm ≙ {text} {}", kind.unit()),
        all: found.into_iter().map(of).collect(),
    })
}

/// A vector of every moving joint, and of every other point that the file names.
fn points(scene: &Scene<'_>, letter: &str, of: fn(&BodyState, Vec2) -> Vec2) -> Vec<(String, Vec2, Vec2)> {
    let nodes = Nodes::of(scene, false);
    // a place of a guide under its slider is no point that moves along its own velocity
    let under: Vec<usize> = nodes.sliding.iter().map(|sliding| sliding.guide).collect();
    let joints = nodes.nodes.iter().enumerate().filter(|(i, node)| !node.fixed && !under.contains(i));
    let joints = joints.map(|(_, node)| node);
    let joints = joints
        .map(|node| (format!("{letter}_{}", node.index()), node.at, of(scene.body(node.link), node.at)));
    let others = nodes
        .others(scene)
        .map(|(link, name, at)| (format!("{letter}_{name}"), at, of(scene.body(link), at)));
    joints.chain(others).collect()
}

/// The force in every pair on its later links.
fn reactions(scene: &Scene<'_>) -> Vec<(String, Vec2, Vec2)> {
    let (view, mut found) = (scene.view(), Vec::new());
    if scene.solved.state.forces.locked {
        return found;
    }
    let all = view.all_actions();
    for (i, pair) in scene.mechanism().pairs.iter().enumerate() {
        let id = PairId::at(i);
        let links = pair.kind.links();
        let base = links.iter().copied().find(|link| *link == LinkId::GROUND).or(links.first().copied());
        let Some(base) = base.filter(|_| !view.shares_friction(id)) else { continue };
        for on in links.iter().copied().filter(|link| *link != base) {
            let acting = all.iter().flat_map(|action| [Some(*action), action.opposite()]).flatten();
            let acting =
                acting.filter(|action| action.on == on.index() && view.pair_of(action.from) == Some(id));
            let force = acting.fold(Vec2::zero(), |sum, action| sum + action.force);
            if let Some(at) = place(scene, id, on).filter(|_| force != Vec2::zero()) {
                let name = format!("{} ({})", scene.reaction_name(id, base, on).plain(), pair.name);
                found.push((name, at, force));
            }
        }
    }
    found
}

/// Loads, weights, springs and efforts that are forces.
fn loads(scene: &Scene<'_>) -> Vec<(String, Vec2, Vec2)> {
    let view = scene.view();
    let outside = view.all_actions().into_iter().filter(|action| {
        view.pair_of(action.from).is_none()
            && !matches!(action.from, Origin::Inertia)
            && action.force != Vec2::zero()
    });
    let links = scene.mechanism().links.len();
    let named = outside.filter(|action| (1..links).contains(&action.on)).map(|action| {
        (letters(scene, action.from, LinkId::at(action.on), true).plain(), action.at, action.force)
    });
    named.collect()
}
