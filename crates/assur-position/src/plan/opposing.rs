//! Loads against the motion as elements that may hold: torques, and forces at points. A point keeps to a line of its link, is moved by one
//! free coordinate alone, or moves in the plane, which takes two elements.

use crate::math::Vec2;
use crate::model::{Drive, LoadId, LoadKind, Mechanism, PairId, Place};
use crate::structure::{JointKind, Structure};
use assur_math::math::ROUNDING;

/// A load against the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opposing {
    /// The load.
    pub load: LoadId,
    /// The body it acts on.
    pub body: usize,
    /// Of a clutch that slips: the body on its other side, and the clutch.
    pub against: Option<(usize, PairId)>,
    /// Of a force: its point, m, and how that moves.
    pub point: Option<(Vec2, Path)>,
    /// Of a freewheel: the sense of its speed in which it does nothing; else 0.
    pub free: f64,
}

/// How a point moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Path {
    /// In this unit direction in the frame of its body.
    Line(Vec2),
    /// On a curve of the mechanism, by the drive that alone moves.
    Curve(usize),
    /// In the plane: by its velocity along x (0) or y (1).
    Plane(usize),
}

/// All of them, in the order of the file.
pub(super) fn plan(mechanism: &Mechanism, structure: &Structure) -> Vec<Opposing> {
    let mut opposing = Vec::new();
    for (index, load) in mechanism.loads.iter().enumerate().filter(|(_, load)| load.is_against_motion()) {
        let id = LoadId::at(index);
        let body_of = |link| structure.replaced.body_of(link).0;
        let turns = |body, against, free| Opposing { load: id, body, against, point: None, free };
        match &load.kind {
            LoadKind::Torque { on, .. } => opposing.push(turns(body_of(*on), None, 0.0)),
            LoadKind::InPair { pair, .. } => {
                let kind = &mechanism.pair(*pair).kind;
                if let Some([first, second]) = kind.slipping().map(|sides| sides.map(body_of)) {
                    opposing.push(turns(second, Some((first, *pair)), kind.freewheel()));
                }
            }
            LoadKind::ForceAgainstMotion { on, at: Place::Local(at), .. } => {
                let (body, at) = structure.replaced.place(*on, *at);
                let paths = paths(mechanism, structure, (body.0, at));
                opposing.extend(
                    paths
                        .into_iter()
                        .map(|path| Opposing { point: Some((at, path)), ..turns(body.0, None, 0.0) }),
                );
            }
            _ => {}
        }
    }
    opposing
}

/// How a point moves: one way, or two where it moves in the plane.
fn paths(mechanism: &Mechanism, structure: &Structure, (body, at): (usize, Vec2)) -> Vec<Path> {
    let one = direction(structure, body, at).map(Path::Line).or_else(|| only(mechanism).map(Path::Curve));
    one.map_or_else(|| vec![Path::Plane(0), Path::Plane(1)], |path| vec![path])
}

/// The drive whose coordinate is free, where no other one moves.
fn only(mechanism: &Mechanism) -> Option<usize> {
    let rests = |drive: &Drive| !drive.of_time && drive.speed.is_none() && drive.acceleration.is_none();
    let mut moving =
        (0..mechanism.drives.len()).filter(|&i| mechanism.drives[i].free || !rests(&mechanism.drives[i]));
    let only = moving.next().filter(|&i| mechanism.drives[i].free)?;
    moving.next().is_none().then_some(only)
}

/// The direction in which a point of a body moves, whatever else moves: across the arm from a hinge on the ground, or along guides
/// that are all parallel.
fn direction(structure: &Structure, body: usize, at: Vec2) -> Option<Vec2> {
    hinged(structure, body, at).or_else(|| guided(structure, body))
}

fn hinged(structure: &Structure, body: usize, at: Vec2) -> Option<Vec2> {
    structure.replaced.joints.iter().find_map(|joint| {
        let JointKind::Revolute(members) = &joint.kind else { return None };
        let place = |of: usize| members.iter().find(|(member, _)| member.0 == of);
        place(0).and(place(body)).and_then(|(_, centre)| (at - *centre).perp().unit())
    })
}

/// From guide to guide down to the ground.
fn guided(structure: &Structure, body: usize) -> Option<Vec2> {
    let guides = steps(structure, body);
    guides
        .into_iter()
        .find(|step| leads_down(structure, *step, structure.replaced.joints.len()))
        .map(|step| step.direction)
}

/// A pair by which a body slides on another.
#[derive(Clone, Copy)]
struct Step {
    joint: usize,
    /// The direction in the frame of the body.
    direction: Vec2,
    other: usize,
    /// And in that of the other.
    there: Vec2,
}

fn steps(structure: &Structure, body: usize) -> Vec<Step> {
    let joints = structure.replaced.joints.iter().enumerate();
    let steps = joints.filter_map(|(joint, kind)| {
        let JointKind::Prismatic { slider, direction, guide, along, .. } = kind.kind else { return None };
        match body {
            _ if body == slider.0 => Some(Step { joint, direction, other: guide.0, there: along }),
            _ if body == guide.0 => Some(Step { joint, direction: along, other: slider.0, there: direction }),
            _ => None,
        }
    });
    steps.collect()
}

/// Whether a chain of at most `most` parallel guides leads on to the ground.
fn leads_down(structure: &Structure, step: Step, most: usize) -> bool {
    let on = |next: &Step| next.joint != step.joint && next.direction.cross(step.there).abs() <= ROUNDING;
    step.other == 0
        || (most > 0
            && steps(structure, step.other)
                .into_iter()
                .filter(on)
                .any(|next| leads_down(structure, next, most - 1)))
}
