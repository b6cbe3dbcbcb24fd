//! Positions of a triad by Newton's method, with a certificate.
//!
//! x = (G, ρθ) are the unknowns, φ(x) = 0 the closure of the legs. With δ = J⁻¹ φ, η = |δ|, β = ‖J⁻¹‖ and a Lipschitz
//! constant λ of J, the theorem of Newton and Kantorovich says: where h = β λ η ≤ 1/2 there is a solution within 2η, no
//! other within 1/βλ, and Newton's method leads to it (Ortega and Rheinboldt, Iterative Solution of Nonlinear Equations
//! in Several Variables, 12.6.2). The second derivative of φ_i along (δG, δθ) is
//!
//! ```text
//! (|δG + δθ perp ρ_i|² − δθ² r_i·ρ_i) / l_i,    or    −δθ² n_i·ρ_i,
//! ```
//!
//! so that with k_i = |ρ_i| / ρ, and |r_i| ≤ 2 l_i all the way, λ_i = (1 + k_i²) / l_i + 2 k_i / ρ, or k_i / ρ, and
//! λ² = Σ λ_i².
//!
//! A position is followed from the one before: the ends of the legs go straight from where they were to where they are,
//! all at once, or in as many parts as the certificate asks for. At the part s of such a way φ is that of its end times s
//! but for (s − s²) |Δ_i|² / 2l_i, Δ_i the way of O_i, and J changes by no more than κ / β with
//! κ² = β² Σ (1 + k_i²) |Δ_i|² / l_i²; so that
//!
//! ```text
//! β λ (η + β √Σ (|Δ_i|² / 8l_i)²) ≤ (1 − κ)² / 2
//! ```
//!
//! holds the theorem all the way, and the solution found is the one to which the motion leads. (On a guide Δn stands for
//! Δ_i / l_i, and |Δn| |ΔQ| / 4 for |Δ_i|² / 8l_i.)
//!
//! Where the parts become too short the plate is at a dead position. If its motion leads through it, as where two
//! assemblies cross, there is a solution beyond near to where the last part points; if the motion turns back there is
//! none, and the group is open.

use super::Triad;
use crate::group::general::Pose;
use crate::group::{IterationLog, NewtonStep};
use crate::math::Vec2;

/// A part of the way below this is a dead position.
const LEAST: f64 = 1.0 / 65536.0;
/// Rounding errors of a residual in units of the greatest coordinate.
pub const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Steps of Newton's method with certificate: its error falls as 2^(−2^k).
const STEPS: usize = 8;
/// Steps without: at a dead position every step halves the error only.
const MANY_STEPS: usize = 60;

/// What a leg depends on at one position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// The revolute of a link of this length.
    Hinge {
        /// Where it is, m.
        p: Vec2,
        /// Length of the leg, m, > 0.
        length: f64,
    },
    /// The line that holds A_i.
    Guide {
        /// A point of it, m.
        p: Vec2,
        /// Its unit left normal.
        n: Vec2,
    },
}

impl End {
    /// The point of it.
    #[must_use]
    pub const fn place(&self) -> Vec2 {
        match self {
            Self::Hinge { p, .. } | Self::Guide { p, .. } => *p,
        }
    }

    /// A part of the way from one position of it to another.
    fn between(&self, to: &Self, part: f64) -> Self {
        let p = self.place() + (to.place() - self.place()) * part;
        match (self, to) {
            (Self::Guide { n: from, .. }, Self::Guide { n, .. }) => {
                let turned = *from + (*n - *from) * part;
                Self::Guide { p, n: turned.unit().unwrap_or(*n) }
            }
            (_, Self::Hinge { length, .. }) => Self::Hinge { p, length: *length },
            (_, Self::Guide { n, .. }) => Self::Guide { p, n: *n },
        }
    }
}

/// The plate: what does not change. Its poses are those of its frame moved into G.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plate {
    /// A_i − G in the plate's frame, m.
    pub arms: [Vec2; 3],
    /// ρ, m, > 0.
    pub length: f64,
    /// |ρ_i| / ρ.
    shares: [f64; 3],
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Followed {
    /// G and the direction of the plate.
    pub pose: Pose,
    /// h of the position found, rounding errors counted: at most 1/2 where it is certified.
    pub h: f64,
    /// Whether the way to it was certified from end to end.
    pub certified: bool,
}

/// φ, J and their figures in one pose.
struct Local {
    residual: [f64; 3],
    /// δ = J⁻¹ φ, in lengths.
    step: [f64; 3],
    /// |δ|.
    eta: f64,
    /// ‖J⁻¹‖.
    beta: f64,
    /// λ.
    lambda: f64,
    /// The theorem's assumption |r_i| ≤ 2 l_i holds within 2η.
    within: bool,
}

impl Plate {
    /// A plate with these pins in its frame, m; also G in that frame.
    #[must_use]
    pub fn new(pins: [Vec2; 3]) -> (Self, Vec2) {
        let mean = (pins[0] + pins[1] + pins[2]) / 3.0;
        let arms = pins.map(|p| p - mean);
        let length = (arms.iter().map(|a| a.dot(*a)).sum::<f64>() / 3.0).sqrt();
        let length = if length > 0.0 { length } else { 1.0 };
        (Self { arms, length, shares: arms.map(|a| a.norm() / length) }, mean)
    }

    /// Directions of the legs' forces and A_i − G in one pose.
    #[inline(always)]
    #[must_use]
    pub fn directions(&self, ends: &[End; 3], pose: &Pose) -> ([Vec2; 3], [Vec2; 3]) {
        let arms = self.arms.map(|a| a.turned(pose.u));
        let d = [0, 1, 2].map(|i| match ends[i] {
            End::Hinge { p, length } => (pose.p + arms[i] - p) / length,
            End::Guide { n, .. } => n,
        });
        (d, arms)
    }

    /// The group in one pose.
    #[inline(always)]
    #[must_use]
    pub fn group(&self, ends: &[End; 3], pose: &Pose) -> Triad<f64> {
        let (d, arms) = self.directions(ends, pose);
        Triad::new(d, arms, self.length)
    }

    #[inline(always)]
    fn local(&self, ends: &[End; 3], pose: &Pose) -> Local {
        let group = self.group(ends, pose);
        let (mut residual, mut lambda) = ([0.0; 3], 0.0);
        for i in 0..3 {
            let k = self.shares[i];
            let mut own = k / self.length;
            residual[i] = match ends[i] {
                End::Hinge { length, .. } => {
                    own = (1.0 + k * k) / length + 2.0 * own;
                    0.5 * length * (group.d[i].dot(group.d[i]) - 1.0)
                }
                End::Guide { p, n } => n.dot(pose.p + group.arms[i] - p),
            };
            lambda += own * own;
        }
        let step = group.solve(residual);
        let eta = super::dot(step, step).sqrt();
        let within = (0..3).all(|i| match ends[i] {
            End::Hinge { length, .. } => {
                residual[i] <= 0.5 * length && 2.0 * eta * (1.0 + self.shares[i]) <= 0.5 * length
            }
            End::Guide { .. } => true,
        });
        Local { residual, step, eta, beta: group.inverse_norm(), lambda: lambda.sqrt(), within }
    }

    /// The equations of a step in m and rad.
    fn seen(&self, ends: &[End; 3], pose: &Pose, local: &Local) -> NewtonStep {
        let (d, arms) = self.directions(ends, pose);
        NewtonStep {
            poses: vec![*pose],
            residuals: local.residual.to_vec(),
            jacobian: (0..3).map(|i| vec![d[i].x, d[i].y, arms[i].cross(d[i])]).collect(),
        }
    }

    /// Whether the theorem holds all the way.
    #[inline(always)]
    fn leads(&self, from: &[End; 3], to: &[End; 3], local: &Local) -> bool {
        let (mut turned, mut bent) = (0.0, 0.0);
        for i in 0..3 {
            let way = to[i].place() - from[i].place();
            let (turn, bend) = match (from[i], to[i]) {
                (End::Guide { n: old, .. }, End::Guide { n, .. }) => {
                    ((n - old).dot(n - old), (n - old).dot(n - old) * way.dot(way) / 16.0)
                }
                (_, End::Hinge { length, .. }) => {
                    let square = way.dot(way) / (length * length);
                    (square, square * way.dot(way) / 64.0)
                }
                _ => (f64::INFINITY, 0.0),
            };
            turned += (1.0 + self.shares[i] * self.shares[i]) * turn;
            bent += bend;
        }
        let rest = 1.0 - local.beta * turned.sqrt();
        let eta = local.eta + local.beta * bent.sqrt();
        local.within && rest > 0.0 && local.beta * local.lambda * eta <= 0.5 * rest * rest
    }

    /// The greatest coordinate in play: what rounding is relative to.
    #[inline]
    fn size(&self, ends: &[End; 3], pose: &Pose) -> f64 {
        ends.iter().fold(pose.p.norm() + self.length, |most, end| most.max(end.place().norm()))
    }

    #[inline]
    fn moved(&self, pose: &Pose, step: &[f64; 3]) -> Pose {
        pose.moved(Vec2::new(-step[0], -step[1]), -step[2] / self.length)
    }

    /// Newton's method where it is certified that it leads to the position to which the motion leads.
    #[inline(always)]
    fn certified(
        &self,
        (from, to): (&[End; 3], &[End; 3]),
        start: &Pose,
        small: f64,
        seen: &mut impl IterationLog,
    ) -> Option<Followed> {
        seen.begin();
        let (mut pose, rounding) = (*start, small.max(ROUNDING) * self.size(to, start));
        for k in 0..STEPS {
            let local = self.local(to, &pose);
            seen.step(|| self.seen(to, &pose, &local));
            if k == 0 && !self.leads(from, to, &local) {
                return None;
            }
            pose = self.moved(&pose, &local.step);
            let slope = local.beta * local.lambda;
            // the next step is no longer than this, about
            let next = slope * local.eta * local.eta;
            if next <= rounding {
                let h = slope * (next + rounding * local.beta);
                return Some(Followed { pose, h, certified: h <= 0.5 });
            }
        }
        None
    }

    /// Newton's method from any pose, by steps of half the plate's length at the most; not certified.
    #[must_use]
    pub fn uncertified(
        &self,
        ends: &[End; 3],
        start: &Pose,
        seen: &mut impl IterationLog,
    ) -> Option<Followed> {
        seen.begin();
        let mut pose = *start;
        for _ in 0..MANY_STEPS {
            let local = self.local(ends, &pose);
            seen.step(|| self.seen(ends, &pose, &local));
            if let Some(found) = self.closed(ends, &pose, &local) {
                return Some(found);
            }
            if !local.eta.is_finite() {
                return None;
            }
            let share = (0.5 * self.length / local.eta).min(1.0);
            pose = self.moved(&pose, &local.step.map(|x| x * share));
        }
        None
    }

    /// A pose that is closed but for rounding errors; a last step mends it where it is regular.
    fn closed(&self, ends: &[End; 3], pose: &Pose, local: &Local) -> Option<Followed> {
        let rounding = ROUNDING * self.size(ends, pose);
        if !local.residual.iter().all(|x| x.abs() <= 4.0 * rounding) {
            return None;
        }
        let h = local.beta * local.lambda * (local.eta + rounding * local.beta);
        let pose = if h <= 0.5 { self.moved(pose, &local.step) } else { *pose };
        Some(Followed { pose, h, certified: false })
    }

    /// The position to which the motion leads from a pose.
    /// # Given
    /// `pose` closes with the ends `from`; they go to `to`. An error of `small`, relative to the greatest coordinate, may
    /// be left.
    /// # Returns
    /// `None` where the motion does not lead there.
    #[inline]
    #[must_use]
    pub fn follow(&self, from: &[End; 3], to: &[End; 3], pose: &Pose, small: f64) -> Option<Followed> {
        self.follow_seen((from, to), pose, small, &mut ())
    }

    /// As [`Plate::follow`], with the steps of its last part seen.
    #[inline]
    #[must_use]
    pub fn follow_seen(
        &self,
        (from, to): (&[End; 3], &[End; 3]),
        pose: &Pose,
        small: f64,
        seen: &mut impl IterationLog,
    ) -> Option<Followed> {
        match self.certified((from, to), pose, small, seen) {
            Some(found) => Some(found),
            None => self.in_parts((from, to), pose, small, seen),
        }
    }

    #[cold]
    fn in_parts(
        &self,
        (from, to): (&[End; 3], &[End; 3]),
        start: &Pose,
        small: f64,
        seen: &mut impl IterationLog,
    ) -> Option<Followed> {
        // where nothing moves, near a dead position, the pose stays
        if let Some(found) = self.closed(to, start, &self.local(to, start)) {
            return Some(found);
        }
        let at = |part: f64| {
            if part < 1.0 { [0, 1, 2].map(|i| from[i].between(&to[i], part)) } else { *to }
        };
        let (mut done, mut part, mut certified) = (0.0, 0.5, true);
        let (mut pose, mut before) = (*start, None);
        loop {
            if let Some(found) = self.certified((&at(done), &at(done + part)), &pose, small, seen) {
                before = Some((pose, part));
                (pose, done) = (found.pose, done + part);
                if done >= 1.0 {
                    return Some(Followed { certified: certified && found.certified, ..found });
                }
                part = (2.0 * part).min(1.0 - done);
                continue;
            }
            part *= 0.5;
            if part < LEAST {
                let (last, length) = before?;
                let (beyond, next) = self.leap(&at, (last, length), (pose, done), seen)?;
                before = Some((pose, next - done));
                (pose, done, certified) = (beyond.pose, next, false);
                if done >= 1.0 {
                    return Some(beyond);
                }
                part = (1.0 - done).min(0.5);
            }
        }
    }

    /// Past a dead position, to where the last part of the way points.
    fn leap(
        &self,
        at: &impl Fn(f64) -> [End; 3],
        (last, length): (Pose, f64),
        (pose, done): (Pose, f64),
        seen: &mut impl IterationLog,
    ) -> Option<(Followed, f64)> {
        let (shift, turn) = ((pose.p - last.p) / length, last.u.cross(pose.u) / length);
        let mut part = 16.0 * LEAST;
        while part <= 1.0 {
            let next = (done + part).min(1.0);
            let way = next - done;
            let predicted = pose.moved(shift * way, turn * way);
            if let Some(found) = self.uncertified(&at(next), &predicted, seen)
                && found.h <= 0.5
                && self.apart(&found.pose, &predicted) <= 0.25 * self.apart(&predicted, &pose)
            {
                return Some((found, next));
            }
            part *= 4.0;
        }
        None
    }

    /// Distance of two poses, m: of G, and of the directions times ρ.
    #[must_use]
    pub fn apart(&self, a: &Pose, b: &Pose) -> f64 {
        (a.p - b.p).norm() + (a.u - b.u).norm() * self.length
    }
}
