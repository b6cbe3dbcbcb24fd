//! Positions of a general group.

use super::constraint::Row;
use super::{Constraint, Gearing, Pose};
use crate::group::{IterationLog, NewtonStep};
use crate::math::{Dense, Vec2};

/// Greatest number of steps.
const STEPS: usize = 60;
/// Greatest rotation in one step, rad.
const TURN: f64 = 0.5;
/// A position closes that misses by no more than this, relative to the greatest coordinate.
const SMALL: f64 = 1e-12;

/// Why no position was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// The constraints are not three per body, or name a body that is not there.
    Shape { rows: usize, unknowns: usize },
    /// The group does not close from where the iteration began.
    NotClosed {
        /// By how much the constraints are open, all together, where they are least so, m.
        gap: f64,
    },
    /// The Jacobian is singular in a position that closes: dead, or redundant.
    Singular,
}

/// A group of bodies under constraints, with the memory its solution needs.
///
/// The group's own bodies come first in every slice, bodies of known motion after them; a slice that is too short is
/// an error of the caller.
#[derive(Clone, Debug)]
pub struct General {
    /// Number of bodies whose motion is sought.
    pub moving: usize,
    /// The constraints; drives change their values from position to position.
    pub constraints: Vec<Constraint>,
    /// Laws of wheels: their rows follow those of the constraints.
    pub laws: Vec<Gearing>,
    /// Length that weighs rotations against translations, m.
    pub(super) length: f64,
    /// See [`General::certificate`].
    pub(super) certificate: f64,
    pub(super) jacobian: Dense,
    pub(super) rows: Vec<Row>,
    residuals: Vec<f64>,
    pub(super) step: Vec<f64>,
    sums: Vec<f64>,
    normal: Dense,
    gradient: Vec<f64>,
    now: Vec<Pose>,
    next: Vec<Pose>,
}

impl General {
    /// A group of `moving` bodies among `bodies`, three scalar constraints per moving body.
    /// # Errors
    /// [`Failure::Shape`].
    pub fn new(moving: usize, bodies: usize, constraints: Vec<Constraint>) -> Result<Self, Failure> {
        Self::with_laws(moving, bodies, constraints, Vec::new())
    }

    /// The same with laws of wheels, one scalar constraint each.
    /// # Errors
    /// [`Failure::Shape`].
    pub fn with_laws(
        moving: usize,
        bodies: usize,
        constraints: Vec<Constraint>,
        mut laws: Vec<Gearing>,
    ) -> Result<Self, Failure> {
        let rows = constraints.iter().map(Constraint::rows).sum::<usize>() + laws.len();
        let unknowns = 3 * moving;
        let known = constraints.iter().all(|c| c.bodies().iter().all(|&body| body < bodies))
            && laws.iter().all(|law| law.is_within(bodies));
        if rows != unknowns || moving > bodies || !known {
            return Err(Failure::Shape { rows, unknowns });
        }
        let extents = constraints.iter().map(Constraint::extent).chain(laws.iter().map(Gearing::extent));
        let extent = extents.fold(0.0, f64::max);
        let length = if extent > 0.0 { extent } else { 1.0 };
        laws.iter_mut().for_each(|law| law.weigh(length));
        Ok(Self {
            moving,
            constraints,
            laws,
            length,
            certificate: f64::INFINITY,
            jacobian: Dense::new(unknowns),
            rows: Vec::with_capacity(rows),
            residuals: vec![0.0; unknowns],
            step: vec![0.0; unknowns],
            sums: vec![0.0; unknowns],
            normal: Dense::new(unknowns),
            gradient: vec![0.0; unknowns],
            now: Vec::with_capacity(bodies),
            next: Vec::with_capacity(bodies),
        })
    }

    /// Finds the position to which Newton's method leads from `poses`, and factors its Jacobian.
    /// # Given
    /// `poses` of all bodies; those of the group are the start, and on success the answer. A step below `small`, relative
    /// to the length of the group, ends the iteration.
    /// # Returns
    /// The condition figure, in (0, 1].
    /// # Errors
    /// [`Failure::NotClosed`], [`Failure::Singular`]; `poses` are then as they were.
    pub fn position(&mut self, poses: &mut [Pose], small: f64) -> Result<f64, Failure> {
        self.position_seen(poses, small, &mut ())
    }

    /// As [`General::position`], with its steps seen.
    /// # Errors
    /// As [`General::position`].
    pub fn position_seen(
        &mut self,
        poses: &mut [Pose],
        small: f64,
        seen: &mut impl IterationLog,
    ) -> Result<f64, Failure> {
        let (mut now, mut next) = (std::mem::take(&mut self.now), std::mem::take(&mut self.next));
        for buffer in [&mut now, &mut next] {
            buffer.clear();
            buffer.extend_from_slice(poses);
        }
        seen.begin();
        let outcome = self.iterate(&mut now, &mut next, small, seen);
        if outcome.is_ok() {
            poses[..self.moving].copy_from_slice(&now[..self.moving]);
        }
        (self.now, self.next) = (now, next);
        outcome
    }

    /// The iteration from `now`, which holds the answer on success.
    fn iterate(
        &mut self,
        now: &mut [Pose],
        next: &mut [Pose],
        small: f64,
        seen: &mut impl IterationLog,
    ) -> Result<f64, Failure> {
        let mut error = self.residual(now);
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let rounding = 8.0 * f64::EPSILON * self.size(now);
            // the rows are those of `now`: its residual was the last that was asked for
            let regular = self.linearise(now);
            seen.step(|| self.seen(now));
            if regular {
                self.step.copy_from_slice(&self.residuals);
                self.jacobian.solve(&mut self.step);
                let size = greatest(&self.step) / self.length;
                let quadratic = size <= small && size <= 0.25 * last;
                if quadratic || self.is_rounding(size, rounding) {
                    self.advance(now, next, 1.0);
                    now.copy_from_slice(next);
                    return self.accept(now, small);
                }
                last = size;
            } else if error <= rounding {
                return Err(Failure::Singular);
            }
            let newton = regular && self.descend(now, next, &mut error, rounding);
            if !newton && !self.regularised(now, next, &mut error) {
                break;
            }
        }
        Err(self.open(now))
    }

    /// The equations of a step in m and rad.
    fn seen(&self, now: &[Pose]) -> NewtonStep {
        let weights = self.rows.iter().map(|row| row.weight(self.length));
        let weights: Vec<f64> = weights.chain(self.laws.iter().map(Gearing::weight)).collect();
        let line = |(i, weight): (usize, &f64)| {
            let entries = self.jacobian.row(i).iter().enumerate();
            entries.map(|(j, x)| if j % 3 == 2 { x * self.length / weight } else { x / weight }).collect()
        };
        NewtonStep {
            poses: now[..self.moving].to_vec(),
            residuals: self.residuals.iter().zip(&weights).map(|(x, weight)| x / weight).collect(),
            jacobian: weights.iter().enumerate().map(line).collect(),
        }
    }

    /// Whether a step is no more than rounding makes of it: ε/σ.
    fn is_rounding(&mut self, size: f64, rounding: f64) -> bool {
        size < 1e-6 && size * self.condition() <= rounding / self.length
    }

    /// Factors the last position, if it closes.
    fn accept(&mut self, now: &[Pose], small: f64) -> Result<f64, Failure> {
        let residual = self.residual(now);
        if residual > small.max(SMALL) * self.size(now) {
            return Err(self.open(now));
        }
        let condition = self.linearised(now)?;
        self.certificate = self.certify(condition, self.size(now), now);
        Ok(condition)
    }

    /// A chain that is too short by a gap has its least squares where every joint opens by a share of it.
    fn open(&mut self, now: &[Pose]) -> Failure {
        self.evaluate(now);
        let (mut gap, mut i) = (0.0, 0);
        for c in &self.constraints {
            gap += self.residuals[i..i + c.rows()].iter().map(|x| x * x).sum::<f64>().sqrt();
            i += c.rows();
        }
        gap += self.residuals[i..].iter().map(|x| x.abs()).sum::<f64>();
        Failure::NotClosed { gap }
    }

    /// Factors the Jacobian of the constraints at `poses`, as velocity, acceleration and reactions need it.
    /// # Returns
    /// The condition figure, in (0, 1].
    /// # Errors
    /// [`Failure::Singular`].
    pub fn factor(&mut self, poses: &[Pose]) -> Result<f64, Failure> {
        self.evaluate(poses);
        self.linearised(poses)
    }

    /// As [`General::factor`], the rows being those of `poses`.
    fn linearised(&mut self, poses: &[Pose]) -> Result<f64, Failure> {
        let condition = if self.linearise(poses) { self.condition() } else { 0.0 };
        if condition > f64::EPSILON { Ok(condition) } else { Err(Failure::Singular) }
    }

    /// Changes a constraint: a drive's value, the side of an offset, the line of a force. Its kind stays.
    pub fn change(&mut self, index: usize, edit: impl FnOnce(&mut Constraint)) {
        if let Some(constraint) = self.constraints.get_mut(index) {
            edit(constraint);
        }
    }

    /// Sign of the determinant of the Jacobian last factored: one branch keeps it.
    #[must_use]
    pub fn branch(&self) -> f64 {
        self.jacobian.sign()
    }

    fn condition(&mut self) -> f64 {
        self.jacobian.reciprocal_condition(&mut self.sums)
    }

    /// The Jacobian from rows that are those of `poses`; whether it could be factored.
    fn linearise(&mut self, poses: &[Pose]) -> bool {
        self.jacobian.clear();
        let (length, moving) = (self.length, self.moving);
        for (i, row) in self.rows.iter().enumerate() {
            let line = self.jacobian.row_mut(i);
            let mut enter = |body: usize, g: Vec2, moment: f64| {
                if body < moving {
                    line[3 * body] += g.x;
                    line[3 * body + 1] += g.y;
                    line[3 * body + 2] += moment;
                }
            };
            enter(row.a, row.g, row.r_a.cross(row.g) / length - row.turn);
            enter(row.b, -row.g, row.turn - row.r_b.cross(row.g) / length);
        }
        for (i, law) in self.laws.iter().enumerate() {
            law.enter(poses, moving, length, self.jacobian.row_mut(self.rows.len() + i));
        }
        self.jacobian.factor()
    }

    fn evaluate(&mut self, poses: &[Pose]) {
        self.rows.clear();
        for c in &self.constraints {
            self.rows.extend((0..c.rows()).map(|k| c.row(k, poses)));
        }
        for (residual, row) in self.residuals.iter_mut().zip(&self.rows) {
            *residual = row.residual * row.weight(self.length);
        }
        for (residual, law) in self.residuals[self.rows.len()..].iter_mut().zip(&self.laws) {
            *residual = law.residual(poses);
        }
    }

    /// Root of the sum of squares of the residuals, m.
    fn residual(&mut self, poses: &[Pose]) -> f64 {
        self.evaluate(poses);
        self.residuals.iter().map(|x| x * x).sum::<f64>().sqrt()
    }

    /// The greatest coordinate in play: what rounding is relative to.
    fn size(&self, poses: &[Pose]) -> f64 {
        let most = self.laws.iter().fold(self.length, |most, law| most.max(law.size()));
        poses.iter().fold(most, |most, pose| most.max(pose.p.norm()))
    }

    /// `next` is `now` less `share` of the step.
    fn advance(&self, now: &[Pose], next: &mut [Pose], share: f64) {
        for ((pose, next), step) in now.iter().zip(next).zip(self.step.chunks_exact(3)) {
            let turn = -share * step[2] / self.length;
            *next = pose.moved(Vec2::new(-share * step[0], -share * step[1]), turn);
        }
    }

    /// The step, bounded, then halved until the residual lessens; whether it did.
    fn descend(&mut self, now: &mut [Pose], next: &mut [Pose], error: &mut f64, rounding: f64) -> bool {
        let turn = self.step.chunks_exact(3).fold(0.0, |most: f64, step| most.max(step[2].abs()));
        let mut share = (TURN * self.length / turn.max(f64::MIN_POSITIVE)).min(1.0);
        for _ in 0..8 {
            self.advance(now, next, share);
            let residual = self.residual(next);
            if residual <= (1.0 - 0.1 * share) * *error || residual <= rounding {
                *error = residual;
                now.copy_from_slice(next);
                return true;
            }
            share *= 0.5;
        }
        false
    }

    /// A step of (JᵀJ + μ) δ = −Jᵀφ, μ raised until the residual lessens; whether it did.
    fn regularised(&mut self, now: &mut [Pose], next: &mut [Pose], error: &mut f64) -> bool {
        self.evaluate(now);
        self.linearise(now);
        self.form_normal();
        let before = *error;
        let (mut damping, mut entered) = ((before / self.length).clamp(1e-9, 1.0), 0.0);
        for _ in 0..16 {
            for i in 0..self.step.len() {
                self.normal.row_mut(i)[i] += damping - entered;
            }
            entered = damping;
            if self.normal.factor() {
                self.step.copy_from_slice(&self.gradient);
                self.normal.solve(&mut self.step);
                if self.descend(now, next, error, 0.0) {
                    return *error < (1.0 - 1e-6) * before;
                }
            }
            damping *= 4.0;
        }
        false
    }

    /// JᵀJ and Jᵀφ.
    fn form_normal(&mut self) {
        self.normal.clear();
        self.gradient.fill(0.0);
        for (k, residual) in self.residuals.iter().enumerate() {
            let row = self.jacobian.row(k);
            for (i, &x) in row.iter().enumerate() {
                self.gradient[i] += x * residual;
                for (sum, y) in self.normal.row_mut(i).iter_mut().zip(row) {
                    *sum += x * y;
                }
            }
        }
    }
}

fn greatest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, x| most.max(x.abs()))
}
