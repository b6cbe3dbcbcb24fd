//! Follows the motion from one position to the next, so that every group keeps its assembly through the change points
//! that the motion passes.
//!
//! The way is divided into steps of at most two degrees of a turning drive. Where a group comes near a singular position
//! (|σ| small) both its assemblies are tried, and that is taken which lies nearer to where its bodies would be if they
//! went on as they came: the parabola through three places well apart, the present one and two before. Elsewhere the sign
//! of the root stays.

use super::inputs::Rates;
use super::solution::Solved;
use super::steps::{APART, MOST_STEPS, StepLimit, between, length};
use crate::answer::first_angles;
use crate::math::Vec2;
use crate::plan::MotionStep;
use crate::position::{DriveValue, Model, State, extent};
use crate::structure::BodyId;
use std::rc::Rc;

/// Below this |σ| both assemblies are tried.
pub(super) const CAREFUL: f64 = 0.3;

/// A group whose |σ| stays above this on its way keeps its assembly: between two places it passes no change point. The
/// rounding of lengths alone makes it about the root of the unit roundoff.
const CHANGES: f64 = 3e-7;
const GOLDEN: f64 = 0.381_966_011_250_105;

/// So many places before the present one are kept.
const KEPT: usize = 4;

/// Pose of a body: origin and direction.
type Pose = (Vec2, Vec2);

/// A place of the mechanism before the present one.
#[derive(Clone, Debug, Default)]
struct Place {
    values: Vec<DriveValue>,
    poses: Vec<Pose>,
}

/// A change to the other assembly.
#[derive(Clone, Debug)]
pub(crate) struct Switch {
    pub group: usize,
    /// Drive values there.
    pub at: Vec<DriveValue>,
}

/// A state that is moved from position to position, with the angles of its bodies followed.
#[derive(Clone, Debug)]
pub(crate) struct Tracker {
    /// The state at the last position that closed.
    pub state: State,
    /// Memory for the next one; after a step the one before.
    spare: State,
    /// Continuous angles of the bodies, rad, and the whole turns of the pairs.
    pub angles: Vec<f64>,
    values: Vec<DriveValue>,
    /// Those before the last step.
    values_before: Vec<DriveValue>,
    /// Places before the present one, the last first, each well apart from the next.
    history: Vec<Rc<Place>>,
    extent: f64,
    pace: StepLimit,
}

impl Tracker {
    /// Starts at an assembled state.
    pub(crate) fn new(model: &Model<'_>, state: State, values: &[DriveValue]) -> Self {
        let angles = first_angles(model, &state);
        let spare = state.clone();
        let (values, history, pace) = (values.to_vec(), Vec::new(), StepLimit::of(model));
        let values_before = values.clone();
        Self { state, spare, angles, values, values_before, history, extent: extent(model), pace }
    }

    /// Puts the tracker at a position that was solved without it.
    pub(super) fn put(&mut self, solved: &Solved, values: &[DriveValue]) {
        self.history.clear();
        self.state.start_from(&solved.state);
        self.angles.clone_from(&solved.angles);
        self.values.clear();
        self.values.extend_from_slice(values);
    }

    /// Puts the tracker where another one of the same model stands.
    pub(super) fn start_from(&mut self, other: &Self) {
        self.state.start_from(&other.state);
        self.angles.clone_from(&other.angles);
        self.values.clone_from(&other.values);
        self.history.clone_from(&other.history);
    }

    /// Moves to other drive values. Returns the groups whose assembly changed on the way, with the values where; on failure
    /// the group that does not close, with the state left at the last place that closed.
    pub(crate) fn advance_to(
        &mut self,
        model: &Model<'_>,
        rates: &Rates,
        target: &[DriveValue],
    ) -> Result<Vec<Switch>, usize> {
        let mut switched: Vec<Switch> = Vec::new();
        let steps = self.pace.steps(&self.values, target);
        if steps > 1.0 {
            let start = self.values.clone();
            let mut values = start.clone();
            let mut done = 1.0;
            while done < steps {
                let way = start.iter().zip(target).map(|(a, b)| between(*a, *b, done / steps));
                values.clear();
                values.extend(way);
                self.step(model, rates, &values, false)?;
                self.note_switches(model, rates, &mut switched);
                done += 1.0;
            }
        }
        self.step(model, rates, target, false)?;
        self.note_switches(model, rates, &mut switched);
        // what changed back is as it was
        let times = |group| switched.iter().filter(|s| s.group == group).count();
        let changed: Vec<bool> = switched.iter().map(|s| times(s.group) % 2 == 1).collect();
        let mut changed = changed.into_iter();
        switched.retain(|_| changed.next() == Some(true));
        Ok(switched)
    }

    /// Which assemblies changed in the last step.
    fn note_switches(&self, model: &Model<'_>, rates: &Rates, switched: &mut Vec<Switch>) {
        let branches = self.spare.branches.iter().zip(&self.state.branches);
        for (group, (before, after)) in branches.enumerate() {
            if before.root * after.root < 0.0 {
                let (from, to) = (&self.values_before, &self.values);
                let part = change_point(model, rates, (&self.spare, from), to, group).unwrap_or(1.0);
                let at = from.iter().zip(to).map(|(a, b)| between(*a, *b, part)).collect();
                switched.push(Switch { group, at });
            }
        }
    }

    /// Whether the way to other drive values is too long to be followed: its angles would be guesses.
    pub(super) fn is_too_long(&self, target: &[DriveValue]) -> bool {
        self.pace.ways(&self.values, target).any(|way| way.abs() > MOST_STEPS)
    }

    /// How far the way to other drive values closes: the last values that do.
    pub(super) fn limit(
        mut self,
        model: &Model<'_>,
        rates: &Rates,
        target: &[DriveValue],
    ) -> Vec<DriveValue> {
        if self.advance_to(model, rates, target).is_ok() {
            return target.to_vec();
        }
        let last = self.values.clone();
        let at = |part: f64| last.iter().zip(target).map(|(a, b)| between(*a, *b, part)).collect::<Vec<_>>();
        let (mut closed, mut open) = (0.0, 1.0 / self.pace.steps(&last, target));
        for _ in 0..50 {
            let middle = 0.5 * (closed + open);
            let mut trial = self.clone();
            trial.history.clear();
            if trial.step(model, rates, &at(middle), false).is_ok() {
                closed = middle;
            } else {
                open = middle;
            }
        }
        at(closed)
    }

    /// One step; `over_gap` where the way to it is not followed.
    fn step(
        &mut self,
        model: &Model<'_>,
        rates: &Rates,
        values: &[DriveValue],
        over_gap: bool,
    ) -> Result<(), usize> {
        let mut next = std::mem::take(&mut self.spare);
        let found = self.solve_next(model, rates, values, over_gap, &mut next);
        if found.is_ok() {
            self.remember();
            self.follow_angles(model, &next);
            std::mem::swap(&mut self.state, &mut next);
            std::mem::swap(&mut self.values, &mut self.values_before);
            self.values.clear();
            self.values.extend_from_slice(values);
        }
        self.spare = next;
        found
    }

    /// The state at the next values, each group with the assembly that the motion leads to.
    fn solve_next(
        &self,
        model: &Model<'_>,
        rates: &Rates,
        values: &[DriveValue],
        over_gap: bool,
        next: &mut State,
    ) -> Result<(), usize> {
        next.start_from(&self.state);
        rates.at(values, &mut next.motion.inputs);
        next.start(model.plan);
        let mut predicted = None;
        for (group, step) in model.plan.motion.iter().enumerate() {
            next.step::<0>(model.plan, step);
            let near = self.state.motion.conditions[group].abs() < CAREFUL
                || next.motion.conditions[group].abs() < CAREFUL;
            if near
                && step.has_two_roots()
                && next.motion.open.is_none()
                && let Some(predicted) = predicted.get_or_insert_with(|| self.predicted(values))
            {
                let bodies = &model.structure.motion[group].bodies;
                let kept = distance(next, predicted, bodies, self.extent);
                next.branches[group].root = -next.branches[group].root;
                next.step::<0>(model.plan, step);
                let other_is_farther = distance(next, predicted, bodies, self.extent) >= kept;
                let passes =
                    || change_point(model, rates, (&self.state, &self.values), values, group).is_some();
                if other_is_farther || !passes() {
                    next.branches[group].root = -next.branches[group].root;
                    next.step::<0>(model.plan, step);
                }
            }
            if let (true, MotionStep::Triad { branch, triad }) =
                (over_gap && next.motion.open.is_some(), step)
                && next.triad_over_gap(*branch, triad)
            {
                next.motion.open = None;
            }
            if let Some(open) = next.motion.open {
                return Err(open);
            }
        }
        Ok(())
    }

    fn follow_angles(&mut self, model: &Model<'_>, next: &State) {
        for (angle, (old, new)) in
            self.angles.iter_mut().zip(self.state.motion.bodies.iter().zip(&next.motion.bodies))
        {
            *angle = continued(*angle, old.u, new.u);
        }
        // a train turns further in one step than a direction tells
        for &body in &model.plan.turning {
            self.angles[body] = next.motion.bodies[body].turned;
        }
    }

    /// Keeps the present place, if it is well apart from the last one kept.
    fn remember(&mut self) {
        if self.history.first().is_some_and(|last| !self.pace.is_apart(&last.values, &self.values)) {
            return;
        }
        // the oldest gives its memory
        let oldest = if self.history.len() < KEPT { None } else { self.history.pop() };
        let mut here = oldest.unwrap_or_default();
        let place = Rc::make_mut(&mut here);
        place.values.clear();
        place.values.extend_from_slice(&self.values);
        place.poses.clear();
        place.poses.extend(self.state.motion.bodies.iter().map(|b| (b.p, b.u)));
        self.history.insert(0, here);
    }

    /// Where the bodies would be at these values: the parabola through the present place and two others on the line of
    /// the way.
    fn predicted(&self, target: &[DriveValue]) -> Option<Vec<Pose>> {
        let way = || self.pace.ways(&self.values, target);
        let t = length(way());
        if t == 0.0 {
            return None;
        }
        let mut chosen: Vec<(f64, &Place)> = Vec::with_capacity(2);
        for place in &self.history {
            let back = || self.pace.ways(&self.values, &place.values).zip(way());
            let along = back().map(|(a, b)| a * b).sum::<f64>() / t;
            let off = back().map(|(a, b)| (a - b * along / t).abs()).fold(0.0, f64::max);
            let apart = along.abs() >= APART && chosen.iter().all(|c| (c.0 - along).abs() >= APART);
            if off <= 1e-6 * along.abs() && apart && chosen.len() < 2 {
                chosen.push((along, place));
            }
        }
        let [(t_1, one), (t_2, two)] = chosen.as_slice() else { return None };
        // Lagrange's form on the nodes 0, t_1, t_2
        let share = [
            (t - t_1) * (t - t_2) / (t_1 * t_2),
            t * (t - t_2) / (t_1 * (t_1 - t_2)),
            t * (t - t_1) / (t_2 * (t_2 - t_1)),
        ];
        let now = self.state.motion.bodies.iter().map(|b| (b.p, b.u));
        let next = |x: Vec2, y: Vec2, z: Vec2| x * share[0] + y * share[1] + z * share[2];
        let before = one.poses.iter().zip(&two.poses);
        Some(now.zip(before).map(|(x, (y, z))| (next(x.0, y.0, z.0), next(x.1, y.1, z.1))).collect())
    }

    /// Puts the tracker at other values without following the way: after a gap in a sweep. The assembly stays.
    pub(crate) fn jump(
        &mut self,
        model: &Model<'_>,
        rates: &Rates,
        target: &[DriveValue],
    ) -> Result<(), usize> {
        self.history.clear();
        self.step(model, rates, target, true)
    }
}

/// The part of the way to other values at which |σ| of a group vanishes: found by golden section.
fn change_point(
    model: &Model<'_>,
    rates: &Rates,
    (from, values): (&State, &[DriveValue]),
    target: &[DriveValue],
    group: usize,
) -> Option<f64> {
    let mut state = from.clone();
    let mut sigma = |part: f64| {
        let values: Vec<DriveValue> = values.iter().zip(target).map(|(a, b)| between(*a, *b, part)).collect();
        rates.at(&values, &mut state.motion.inputs);
        state.start(model.plan);
        for step in &model.plan.motion[..=group] {
            state.step::<0>(model.plan, step);
        }
        state.motion.conditions[group].abs()
    };
    // what falls on to the very end comes near a change point, but does not pass it
    let vanishes = CHANGES.min(0.5 * sigma(1.0));
    if sigma(0.0) <= vanishes {
        return Some(0.0);
    }
    let (mut low, mut high) = (0.0, 1.0);
    let mut inner = [low + GOLDEN * (high - low), high - GOLDEN * (high - low)];
    let mut values = inner.map(&mut sigma);
    for _ in 0..60 {
        if values[0] < values[1] {
            (high, inner[1], values[1]) = (inner[1], inner[0], values[0]);
            inner[0] = low + GOLDEN * (high - low);
            values[0] = sigma(inner[0]);
        } else {
            (low, inner[0], values[0]) = (inner[0], inner[1], values[1]);
            inner[1] = high - GOLDEN * (high - low);
            values[1] = sigma(inner[1]);
        }
    }
    (values[0].min(values[1]) <= vanishes).then_some(inner[0])
}

/// An angle carried on from one direction to the next by the difference between them.
pub(super) fn continued(angle: f64, old: Vec2, new: Vec2) -> f64 {
    // the sine is near enough to the angle to tell the whole turns
    let (sin, cos) = (old.cross(new), old.dot(new));
    let turned = if cos > 0.0 { sin } else { libm::atan2(sin, cos) };
    // the whole turns are carried on, the rest is read off the direction itself: no error adds up
    let estimate = angle + turned;
    let principal = new.angle();
    principal + std::f64::consts::TAU * ((estimate - principal) / std::f64::consts::TAU).round()
}

fn distance(state: &State, predicted: &[Pose], bodies: &[BodyId], extent: f64) -> f64 {
    bodies
        .iter()
        .map(|b| {
            let (p, u) = predicted[b.0];
            (state.motion.bodies[b.0].u - u).norm() + (state.motion.bodies[b.0].p - p).norm() / extent
        })
        .sum()
}
