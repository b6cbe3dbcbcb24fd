//! All the ways in which a general group can be put together.

use super::constraint::Row;
use super::{Constraint, General, Pose};
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
pub struct InitialGuess {
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
    meant: Option<&InitialGuess>,
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
    meant: Option<&InitialGuess>,
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
fn meant_start(group: &General, poses: &[Pose], meant: &InitialGuess) -> Vec<Pose> {
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

// Whether a position is a solution: the theorem of Newton and Kantorovich.
//
// At a position x found, with rounding errors in its residuals φ(x), let β = ‖J⁻¹‖, η ≥ |J⁻¹ φ| and λ a Lipschitz constant
// of J near by. Where h = β λ η ≤ 1/2 there is a solution within 2η of x, and no other within 1/βλ (Ortega and Rheinboldt,
// Iterative Solution of Nonlinear Equations in Several Variables, 12.6.2). The norms are those of the greatest component,
// rows scaled as for the condition figure σ = 1/β, rotations measured in the length L of the group.
//
// Constraints are of second degree in positions, cosines and sines. With ρ_a, ρ_b the arms of the points on bodies that
// move and s their distance, λ of a row is at most
//
// ```text
// revolute                       (|ρ_a| + |ρ_b|) / L²
// offset, coordinate             the same, and (|s| + |ρ_b|) / L² + 2 (√2 + …) / L where the line moves
// distance                       the same as a revolute, and the square of how fast the points part, over |s|
// angle                          0
// law of wheels                  the sum over its coordinates, 0 of an angle
// ```
//
// The bounds are doubled, for they hold at x and are needed within 2η of it.

/// Rounding errors of a residual, in units of the greatest coordinate.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl General {
    /// The figure h of the position last found: at most 1/2 where there is certainly a solution, and only one near by.
    #[must_use]
    pub fn certificate(&self) -> f64 {
        self.certificate
    }

    /// h of the position whose Jacobian was factored last, with this condition figure.
    /// # Given
    /// `size` greatest coordinate in play, m.
    pub(super) fn certify(&self, condition: f64, size: f64, poses: &[Pose]) -> f64 {
        let rounding = ROUNDING * size;
        let (mut lambda, mut residual, mut i) = (0.0_f64, 0.0_f64, 0);
        for constraint in &self.constraints {
            for row in &self.rows[i..i + constraint.rows()] {
                let scale = self.jacobian.row_scale(i);
                lambda = lambda.max(2.0 * scale * self.second_derivative(constraint, row));
                residual = residual.max(scale * (row.residual.abs() * row.weight(self.length) + rounding));
                i += 1;
            }
        }
        for (i, law) in (i..).zip(&self.laws) {
            let scale = self.jacobian.row_scale(i);
            lambda = lambda.max(2.0 * scale * law.bend(self.moving, self.length, poses));
            residual = residual.max(scale * (law.residual(poses).abs() + rounding));
        }
        let beta = 1.0 / condition;
        let h = beta * lambda * beta * residual;
        // what holds at the position holds within 2η as long as that is short
        if 2.0 * beta * residual <= 1e-3 * self.length { h } else { h.max(1.0) }
    }

    /// A bound of the second derivative of a row along two directions of unit components.
    fn second_derivative(&self, constraint: &Constraint, row: &Row) -> f64 {
        let per = 1.0 / self.length;
        let Reach { moves: [a, b], arms: [arm_a, arm_b] } = row.reach(self.moving, self.length);
        match constraint {
            Constraint::Angle { .. } => 0.0,
            Constraint::Revolute { .. } => (arm_a + arm_b) * per,
            Constraint::Distance { law, .. } => {
                let parting = speed(a, arm_a) + speed(b, arm_b);
                (arm_a + arm_b) * per + 2.0 * parting * parting / law.value.abs().max(f64::MIN_POSITIVE)
            }
            Constraint::Offset { .. } | Constraint::Coordinate { .. } => row.bend(self.moving, self.length),
        }
    }
}

/// Which of a row's bodies move, and their arms in lengths of the group.
struct Reach {
    moves: [f64; 2],
    arms: [f64; 2],
}

/// How fast a point of a body moves in any one direction.
fn speed(moves: f64, arm: f64) -> f64 {
    moves * std::f64::consts::SQRT_2 + arm
}

impl Row {
    fn reach(&self, moving: usize, length: f64) -> Reach {
        let [a, b] = [self.a, self.b].map(|body| f64::from(u8::from(body < moving)));
        Reach { moves: [a, b], arms: [a * self.r_a.norm() / length, b * self.r_b.norm() / length] }
    }

    /// A bound of the second derivative of a point's place along or across a line of body b.
    pub(super) fn bend(&self, moving: usize, length: f64) -> f64 {
        let Reach { moves: [a, b], arms: [arm_a, arm_b] } = self.reach(moving, length);
        // r_b of a line reaches to the point: arm and distance in one
        ((arm_a + 2.0 * arm_b) + 2.0 * b * (speed(a, arm_a) + speed(b, arm_b))) / length
    }
}
