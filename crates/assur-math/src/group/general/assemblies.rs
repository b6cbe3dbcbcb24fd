//! All the ways in which a general group can be put together.

use super::{General, Pose};
use crate::math::Vec2;

/// Two assemblies closer than this, relative to the length of the group, are one.
const DISTINCT: f64 = 1e-6;

/// A step below this, relative to the length of the group, ends the iteration.
const SMALL: f64 = 1e-12;

/// Of more bodies than this many starts find little, and where the bodies are meant to stand is enough.
const FEW_BODIES: usize = 12;

/// Places at which a determinant is looked at.
const PROBES: usize = 8;

/// A condition figure of rounding alone.
const VANISHES: f64 = 4.0 * f64::EPSILON;

/// Where the bodies of a group are meant to stand.
#[derive(Clone, Debug)]
pub struct Meant {
    /// One pose for each of the group's own bodies.
    pub poses: Vec<Pose>,
    /// Every one of them follows from places that are named.
    pub whole: bool,
}

/// Assemblies of a group, by Newton's method from many starts. For use when a problem is set up: it allocates.
/// # Given
/// `poses` of all bodies; the known ones are read, and the group's own are the first start. `starts` number of
/// starts; three bodies ask for some hundreds.
/// # Returns
/// Poses of the group's own bodies, distinct, in the order found; the same for the same input. Closed and
/// regular each; there is no proof that there are no others. Angles of the group's bodies that laws of wheels speak of lie
/// between −π and π.
#[must_use]
pub fn assemblies(group: &mut General, poses: &[Pose], starts: usize) -> Vec<Vec<Pose>> {
    assemblies_near(group, poses, starts, None)
}

/// As [`assemblies`], with a start more: where the group's bodies are meant to stand. In a group of many bodies hardly any
/// other start leads anywhere; if all places of such a group are meant and this start closes, it is the only one.
#[must_use]
pub fn assemblies_near(
    group: &mut General,
    poses: &[Pose],
    starts: usize,
    meant: Option<&Meant>,
) -> Vec<Vec<Pose>> {
    let mut found: Vec<Vec<Pose>> = Vec::new();
    if is_never_regular(group, poses) {
        return found;
    }
    let near = meant.and_then(|meant| closed(group, meant_start(group, poses, meant)));
    let alone = group.moving > FEW_BODIES && near.is_some() && meant.is_some_and(|meant| meant.whole);
    let around = surroundings(group, poses);
    for start in 0..if alone { 0 } else { starts } {
        let one = closed(group, started(group, poses, start, around));
        enter(group, &mut found, one);
    }
    enter(group, &mut found, near);
    found
}

/// The first start of the search of [`assemblies_near`] that leads to an assembly: poses of the group's own bodies.
#[must_use]
pub fn start_of(
    group: &mut General,
    poses: &[Pose],
    starts: usize,
    meant: Option<&Meant>,
    assembly: &[Pose],
) -> Option<Vec<Pose>> {
    let around = surroundings(group, poses);
    let leads = |group: &mut General, trial: &[Pose]| {
        let end = closed(group, trial.to_vec());
        end.is_some_and(|end| distance(assembly, &end, group.length) < DISTINCT)
    };
    let near = meant.map(|meant| meant_start(group, poses, meant));
    let near = near.filter(|near| leads(group, near));
    let alone = group.moving > FEW_BODIES && near.is_some() && meant.is_some_and(|meant| meant.whole);
    for start in 0..if alone { 0 } else { starts } {
        let mut trial = started(group, poses, start, around);
        if leads(group, &trial) {
            trial.truncate(group.moving);
            return Some(trial);
        }
    }
    near.map(|mut near| {
        near.truncate(group.moving);
        near
    })
}

/// The poses of a start: as they stand, then scattered.
fn started(group: &General, poses: &[Pose], start: usize, (centre, reach): (Vec2, f64)) -> Vec<Pose> {
    let mut trial = poses.to_vec();
    if start > 0 {
        for (body, pose) in trial[..group.moving].iter_mut().enumerate() {
            *pose = scattered(start, body, centre, reach);
        }
    }
    trial
}

/// The poses of all bodies with the group's own as they are meant.
fn meant_start(group: &General, poses: &[Pose], meant: &Meant) -> Vec<Pose> {
    let mut trial = poses.to_vec();
    trial[..group.moving].copy_from_slice(&meant.poses);
    trial
}

/// Where Newton's method leads from a start, if it closes there.
fn closed(group: &mut General, mut trial: Vec<Pose>) -> Option<Vec<Pose>> {
    group.laws.iter_mut().for_each(|law| law.count_from(group.moving, &trial));
    let closes = group.position(&mut trial, SMALL).is_ok();
    let is_one = closes && group.laws.iter().all(|law| law.is_principal(group.moving, &trial));
    trial.truncate(group.moving);
    is_one.then_some(trial)
}

/// Keeps an assembly that is not known.
fn enter(group: &General, found: &mut Vec<Vec<Pose>>, trial: Option<Vec<Pose>>) {
    let known = |trial: &Vec<Pose>| found.iter().any(|other| distance(other, trial, group.length) < DISTINCT);
    let new = trial.filter(|trial| !known(trial));
    found.extend(new);
}

/// Whether the Jacobian is singular wherever the group's bodies stand, as with guides that are parallel. Its determinant is
/// analytic in the poses: where it vanishes at places that have nothing in common, it vanishes everywhere.
#[must_use]
pub fn is_never_regular(group: &mut General, poses: &[Pose]) -> bool {
    let (centre, reach) = surroundings(group, poses);
    let mut trial = poses.to_vec();
    (1..=PROBES).all(|start| {
        for (body, pose) in trial[..group.moving].iter_mut().enumerate() {
            *pose = scattered(start, body, centre, reach);
        }
        group.factor(&trial).map_or(0.0, |condition| condition) <= VANISHES
    })
}

/// Where the group's bodies may be: round the known bodies, as far as the group reaches.
fn surroundings(group: &General, poses: &[Pose]) -> (Vec2, f64) {
    let joints: Vec<Vec2> =
        group.constraints.iter().flat_map(|c| c.points_of_known(group.moving, poses)).collect();
    let count = joints.len().max(1) as f64;
    let centre = joints.iter().fold(Vec2::zero(), |sum, &p| sum + p) / count;
    let reach = joints.iter().fold(group.length, |most, &p| most.max((p - centre).norm() + group.length));
    (centre, reach)
}

/// The start of one body: a point of a sequence that fills position and direction evenly.
fn scattered(start: usize, body: usize, centre: Vec2, reach: f64) -> Pose {
    // Additive recurrence with powers of the root of x⁴ = x + 1, shifted from body to body.
    const ROOT: f64 = 1.220_744_084_605_759_6;
    let fraction = |power: i32, shift: f64| {
        let x = (start as f64) / ROOT.powi(power) + shift * (body as f64);
        x - x.floor()
    };
    let offset = Vec2::new(fraction(1, 0.37) - 0.5, fraction(2, 0.71) - 0.5) * (2.0 * reach);
    let turn = std::f64::consts::TAU * fraction(3, 0.618_033_988_749_895 * (1.0 + start as f64));
    Pose { p: centre + offset, u: Vec2::direction(turn) }
}

/// The greatest difference of position or direction, relative to `length`.
fn distance(a: &[Pose], b: &[Pose], length: f64) -> f64 {
    a.iter().zip(b).map(|(a, b)| ((a.p - b.p).norm() / length).max((a.u - b.u).norm())).fold(0.0, f64::max)
}
