//! Follows the motion from one position to the next, so that every group keeps its assembly through the change points
//! that the motion passes.
//!
//! The way is divided into steps of at most two degrees of a turning drive. Where a group comes near a singular position
//! (|σ| small) both its assemblies are tried, and that is taken which lies nearer to where its bodies would be if they
//! went on as they came: the parabola through their last three places. Elsewhere the sign of the root stays.

use super::inputs::Rates;
use super::solution::{DriveValue, Scene};
use super::state::{Branch, State};
use crate::math::Vec2;
use crate::plan::MotionStep;
use crate::structure::{BodyId, JointKind};

/// Below this |σ| both assemblies are tried.
const CAREFUL: f64 = 0.3;
/// The largest step of a turning drive, rad.
const LARGEST_TURN: f64 = 2.0 * std::f64::consts::PI / 180.0;
/// A way is divided into this many steps at the most.
const MOST_STEPS: f64 = 20_000.0;

/// Pose of a body: origin and direction.
type Pose = (Vec2, Vec2);

/// A change to the other assembly.
#[derive(Clone, Debug)]
pub(super) struct Switch {
    /// The group.
    pub group: usize,
    /// Drive values just behind it.
    pub at: Vec<DriveValue>,
}

/// A state that is moved from position to position, with the angles of its bodies followed.
#[derive(Clone, Debug)]
pub(super) struct Tracker {
    /// The state at the last position that closed.
    pub state: State,
    /// Continuous angles of the bodies, rad.
    pub angles: Vec<f64>,
    values: Vec<DriveValue>,
    /// Poses before the present ones, the last first, at equal steps.
    history: Vec<Vec<Pose>>,
    spacing: f64,
    extent: f64,
}

impl Tracker {
    /// Starts at an assembled state.
    pub(super) fn new(scene: &Scene<'_>, state: State, values: &[DriveValue]) -> Self {
        let mut angles: Vec<f64> = state.bodies.iter().map(|b| b.u.angle()).collect();
        for effort in &scene.structure.drives {
            if let (crate::structure::EffortKind::Angle(body), crate::structure::EffortSource::Drive(id)) =
                (effort.kind, effort.source)
                && let Some(DriveValue::Scalar(value)) = values.get(id.index())
            {
                angles[body.0] = *value;
            }
        }
        Self {
            state,
            angles,
            values: values.to_vec(),
            history: Vec::new(),
            spacing: 0.0,
            extent: extent(scene),
        }
    }

    /// Moves to other drive values. Returns the groups whose assembly changed on the way, with the values where; on failure
    /// the group that does not close, with the state left at the last place that closed.
    pub(super) fn go(
        &mut self,
        scene: &Scene<'_>,
        rates: &Rates,
        target: &[DriveValue],
    ) -> Result<Vec<Switch>, usize> {
        let first: Vec<Branch> = self.state.branches.clone();
        let mut switched: Vec<Switch> = Vec::new();
        let steps = steps(scene, self.extent, &self.values, target);
        let start = self.values.clone();
        if (self.spacing - 1.0 / steps).abs() > 1e-9 || start.is_empty() {
            self.history.clear();
        }
        self.spacing = 1.0 / steps;
        let mut done = 0.0;
        while done < steps {
            done += 1.0;
            let values: Vec<DriveValue> = if done < steps {
                start.iter().zip(target).map(|(a, b)| between(*a, *b, done / steps)).collect()
            } else {
                target.to_vec()
            };
            let before: Vec<f64> = self.state.branches.iter().map(|b| b.root).collect();
            self.step(scene, rates, values, false)?;
            for (group, (before, after)) in before.iter().zip(&self.state.branches).enumerate() {
                if before * after.root < 0.0 {
                    switched.push(Switch { group, at: self.values.clone() });
                }
            }
        }
        // what changed back is as it was
        switched.retain(|s| first[s.group].root * self.state.branches[s.group].root < 0.0);
        Ok(switched)
    }

    /// How far the way to other drive values closes: the last values that do.
    pub(super) fn limit(
        mut self,
        scene: &Scene<'_>,
        rates: &Rates,
        target: &[DriveValue],
    ) -> Vec<DriveValue> {
        if self.go(scene, rates, target).is_ok() {
            return target.to_vec();
        }
        let last = self.values.clone();
        let at = |part: f64| last.iter().zip(target).map(|(a, b)| between(*a, *b, part)).collect::<Vec<_>>();
        let (mut closed, mut open) = (0.0, 1.0 / steps(scene, self.extent, &last, target));
        for _ in 0..50 {
            let middle = 0.5 * (closed + open);
            let mut trial = self.clone();
            trial.history.clear();
            if trial.step(scene, rates, at(middle), false).is_ok() {
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
        scene: &Scene<'_>,
        rates: &Rates,
        values: Vec<DriveValue>,
        over_gap: bool,
    ) -> Result<(), usize> {
        let mut next = self.state.clone();
        rates.at(&values, &mut next.inputs);
        next.start(scene.plan);
        let mut predicted = None;
        for (group, step) in scene.plan.motion.iter().enumerate() {
            next.step::<0>(scene.plan, step);
            let near = self.state.sines[group].abs() < CAREFUL || next.sines[group].abs() < CAREFUL;
            if near
                && next.has_two_roots(step)
                && next.open.is_none()
                && let Some(predicted) = predicted.get_or_insert_with(|| self.predicted())
            {
                let bodies = &scene.structure.motion[group].bodies;
                let kept = distance(&next, predicted, bodies, self.extent);
                next.branches[group].root = -next.branches[group].root;
                next.step::<0>(scene.plan, step);
                if distance(&next, predicted, bodies, self.extent) >= kept {
                    next.branches[group].root = -next.branches[group].root;
                    next.step::<0>(scene.plan, step);
                }
            }
            if let (true, MotionStep::Triad { branch, triad }) = (over_gap && next.open.is_some(), step)
                && next.triad_over_gap(*branch, triad)
            {
                next.open = None;
            }
            if let Some(open) = next.open {
                return Err(open);
            }
        }
        self.history.insert(0, self.state.bodies.iter().map(|b| (b.p, b.u)).collect());
        self.history.truncate(2);
        for (angle, (old, new)) in self.angles.iter_mut().zip(self.state.bodies.iter().zip(&next.bodies)) {
            *angle = continued(*angle, old.u, new.u);
        }
        self.state = next;
        self.values = values;
        Ok(())
    }

    /// Where the bodies would be next: the parabola through the last three places.
    fn predicted(&self) -> Option<Vec<Pose>> {
        let [last, one_before] = self.history.as_slice() else { return None };
        let now = self.state.bodies.iter().map(|b| (b.p, b.u));
        let next = |x: Vec2, y: Vec2, z: Vec2| (x - y) * 3.0 + z;
        Some(
            now.zip(last.iter().zip(one_before))
                .map(|(x, (y, z))| (next(x.0, y.0, z.0), next(x.1, y.1, z.1)))
                .collect(),
        )
    }

    /// Puts the tracker at other values without following the way: after a gap in a sweep. The assembly stays.
    pub(super) fn jump(
        &mut self,
        scene: &Scene<'_>,
        rates: &Rates,
        target: &[DriveValue],
    ) -> Result<(), usize> {
        self.history.clear();
        self.step(scene, rates, target.to_vec(), true)
    }
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
            (state.bodies[b.0].u - u).norm() + (state.bodies[b.0].p - p).norm() / extent
        })
        .sum()
}

/// A length of the mechanism's order, m: the farthest point of a joint from the origin of its body.
pub(super) fn extent(scene: &Scene<'_>) -> f64 {
    let points = scene.structure.replaced.joints.iter().flat_map(|j| match &j.kind {
        JointKind::Revolute(members) => members.iter().map(|m| m.1.norm()).collect(),
        JointKind::Prismatic { point, through, offset, .. } => vec![point.norm(), through.norm(), *offset],
    });
    let extent = points.fold(0.0, f64::max);
    if extent > 0.0 { extent } else { 1.0 }
}

pub(super) fn between(a: DriveValue, b: DriveValue, part: f64) -> DriveValue {
    match (a, b) {
        (DriveValue::Scalar(a), DriveValue::Scalar(b)) => DriveValue::Scalar(a + (b - a) * part),
        (DriveValue::Point(a), DriveValue::Point(b)) => DriveValue::Point(a + (b - a) * part),
        _ => b,
    }
}

pub(super) fn steps(scene: &Scene<'_>, extent: f64, from: &[DriveValue], to: &[DriveValue]) -> f64 {
    let mut steps = 1.0_f64;
    for ((drive, from), to) in scene.mechanism.drives.iter().zip(from).zip(to) {
        let way = match (from, to) {
            (DriveValue::Scalar(a), DriveValue::Scalar(b)) if super::positions::turns(scene, drive) => {
                (b - a).abs() / LARGEST_TURN
            }
            (DriveValue::Scalar(a), DriveValue::Scalar(b)) => (b - a).abs() / (0.02 * extent),
            (DriveValue::Point(a), DriveValue::Point(b)) => (*b - *a).norm() / (0.02 * extent),
            _ => 0.0,
        };
        // a step that is a whole number of largest steps but for rounding takes no step more
        steps = steps.max((way - 1e-9).ceil());
    }
    if steps.is_finite() { steps.min(MOST_STEPS) } else { 1.0 }
}
