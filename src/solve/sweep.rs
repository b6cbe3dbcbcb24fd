//! Solves all positions of a file.

use super::assemble::{assemble, does_not_close};
use super::error::SolveError;
use super::extremes::{Statics, statics};
use super::inputs::Rates;
use super::notes::{self, Notes};
use super::positions::{Wanted, beside, sweep};
use super::refused;
use super::residual::residuals;
use super::solution::{DriveValue, Pose, Scene, Solution, Solved};
use super::state::State;
use super::track::{Switch, Tracker};
use super::view::View;
use super::words::place;
use crate::model::{LoadId, PairId, PairKind, Query, Value};
use crate::plan::Level;

/// At and below this condition velocities and forces do not exist.
const DEAD: f64 = 1e-12;

/// Solves all positions. What fails at one position stands in its pose; what makes all of them meaningless is an error.
///
/// # Errors
/// Constructs not supported yet, requests without the speeds they need, no assembly or several at the first position,
/// forces that are not determined.
pub fn solve(scene: &Scene<'_>) -> Result<Solution, Vec<SolveError>> {
    let mut errors = refused::not_supported(scene.mechanism);
    errors.extend(refused::missing_speeds(scene));
    if !errors.is_empty() {
        return Err(errors);
    }
    let needs_poses = scene.mechanism.links.len() > 1;
    if !needs_poses {
        return Ok(Solution::default());
    }
    let statics = statics(scene).map_err(|e| vec![e])?;
    let wanted = sweep(scene, &statics);
    let mut run = Run {
        scene,
        rates: Rates::of(scene, &statics),
        statics,
        evaluated: Vec::new(),
        poses: Vec::new(),
        notes: Notes::default(),
    };
    let trackers = run.follow(&wanted).map_err(|e| vec![e])?;
    run.beside(&wanted, &trackers);
    let warnings = run.notes.into_warnings(scene, &run.poses);
    Ok(Solution { poses: run.poses, statics: run.statics, warnings })
}

/// Why a position was not reached, and the tracker where it was before.
struct Stuck {
    error: SolveError,
    back: Option<Tracker>,
}

/// How a position was reached.
enum Way {
    /// From the one before, with the changes of assembly on the way.
    Followed(Vec<Switch>),
    /// The way does not close beyond these values, the position itself does.
    Blocked(Vec<DriveValue>),
}

struct Run<'a, 's> {
    scene: &'s Scene<'a>,
    rates: Rates,
    statics: Statics,
    evaluated: Vec<(LoadId, Value)>,
    poses: Vec<Pose>,
    notes: Notes,
}

impl Run<'_, '_> {
    /// Follows the sweep; the trackers at its positions, where they closed.
    fn follow(&mut self, wanted: &[Wanted]) -> Result<Vec<Option<Tracker>>, SolveError> {
        let mut trackers: Vec<Option<Tracker>> = Vec::with_capacity(wanted.len());
        let mut current: Option<Tracker> = None;
        let mut first_error = None;
        let keep_all = !beside(self.scene, &self.statics, &wanted[0]).is_empty();
        for (i, pose) in wanted.iter().enumerate() {
            let before = i.checked_sub(1).map(|i| &wanted[i]);
            let came = match current.take() {
                None => self.assembled(pose).map(|t| (t, Way::Followed(Vec::new()))),
                Some(mut tracker) => self.moved(&mut tracker, pose).map(|way| (tracker, way)),
            };
            match came {
                Ok((tracker, way)) => {
                    if let Some(before) = before {
                        self.note_way(way, &tracker, before, pose);
                    }
                    let outcome = self.solved(&tracker, pose);
                    self.push(pose, outcome);
                    trackers.push(keep_all.then(|| tracker.clone()));
                    current = Some(tracker);
                }
                Err(stuck) => {
                    let Stuck { error, back } = *stuck;
                    // without a choice, or with a hint that cannot be met, no position has a meaning
                    if i == 0 && (wanted.len() == 1 || !is_open(&error)) {
                        return Err(error);
                    }
                    first_error.get_or_insert(error.clone());
                    if !self.notes.in_gap() {
                        let limit = back.clone().map(|t| t.limit(self.scene, &self.rates, &pose.drives));
                        self.notes.gap_begins(limit);
                    }
                    self.push(pose, Err(error));
                    trackers.push(None);
                    current = back;
                }
            }
        }
        match (self.poses.iter().any(|p| p.outcome.is_ok()), first_error) {
            (false, Some(error)) if self.poses.iter().all(|p| p.outcome.as_ref().is_err_and(is_open)) => {
                Err(error)
            }
            _ => Ok(trackers),
        }
    }

    fn assembled(&self, pose: &Wanted) -> Result<Tracker, Box<Stuck>> {
        let mut state = State::new(self.scene.plan);
        self.rates.at(&pose.drives, &mut state.inputs);
        let state = assemble(self.scene, state)
            .map_err(|e| Box::new(Stuck { error: with_pose(e, &place(self.scene, pose)), back: None }))?;
        Ok(Tracker::new(self.scene, state, &pose.drives))
    }

    /// What is to be said of the way from the position before.
    fn note_way(&mut self, way: Way, tracker: &Tracker, before: &Wanted, pose: &Wanted) {
        let back = || tracker.clone().limit(self.scene, &self.rates, &before.drives);
        if self.notes.in_gap() {
            let end = back();
            self.notes.gap_ends(end);
            return;
        }
        match way {
            Way::Followed(switched) => {
                for switch in switched {
                    self.notes.switched(self.scene, &switch, &before.name, &pose.name);
                }
            }
            Way::Blocked(limit) => {
                let end = back();
                self.notes.gap_begins(Some(limit));
                self.notes.gap_ends(end);
            }
        }
    }

    fn moved(&self, tracker: &mut Tracker, pose: &Wanted) -> Result<Way, Box<Stuck>> {
        let before = tracker.clone();
        if let Ok(switched) = tracker.go(self.scene, &self.rates, &pose.drives) {
            return Ok(Way::Followed(switched));
        }
        // the way is closed somewhere; the position itself may not be
        *tracker = before.clone();
        match tracker.jump(self.scene, &self.rates, &pose.drives) {
            Ok(()) => Ok(Way::Blocked(before.limit(self.scene, &self.rates, &pose.drives))),
            Err(group) => {
                let mut state = before.state.clone();
                self.rates.at(&pose.drives, &mut state.inputs);
                state.start(self.scene.plan);
                for step in &self.scene.plan.motion[..group] {
                    state.step::<0>(self.scene.plan, step);
                }
                let error = does_not_close(self.scene, state, group, &place(self.scene, pose));
                Err(Box::new(Stuck { error, back: Some(before) }))
            }
        }
    }

    /// Poses beside the sweep: each followed from the nearest position of the sweep that closed.
    fn beside(&mut self, wanted: &[Wanted], trackers: &[Option<Tracker>]) {
        for pose in beside(self.scene, &self.statics, &wanted[0]) {
            let near = wanted
                .iter()
                .zip(trackers)
                .filter_map(|(w, t)| t.as_ref().map(|t| (self.away(&w.drives, &pose.drives), t)))
                .min_by(|x, y| x.0.total_cmp(&y.0));
            let outcome = match near {
                Some((_, tracker)) => {
                    let mut tracker = tracker.clone();
                    match self.moved(&mut tracker, &pose) {
                        Ok(_) => self.solved(&tracker, &pose),
                        Err(stuck) => Err(stuck.error),
                    }
                }
                None => self.assembled(&pose).map_err(|e| e.error).and_then(|t| self.solved(&t, &pose)),
            };
            self.push(&pose, outcome);
        }
    }

    fn away(&self, a: &[DriveValue], b: &[DriveValue]) -> f64 {
        let each = a.iter().zip(b).map(|(a, b)| match (a, b) {
            (DriveValue::Scalar(a), DriveValue::Scalar(b)) => (a - b).abs(),
            (DriveValue::Point(a), DriveValue::Point(b)) => (*a - *b).norm(),
            _ => 0.0,
        });
        each.sum()
    }

    fn push(&mut self, pose: &Wanted, outcome: Result<Solved, SolveError>) {
        self.poses.push(Pose {
            name: pose.name.clone(),
            origin: pose.origin,
            drives: pose.drives.clone(),
            outcome,
        });
    }

    /// Motion, loads, forces and residuals at an assembled position.
    fn solved(&mut self, tracker: &Tracker, pose: &Wanted) -> Result<Solved, SolveError> {
        let scene = self.scene;
        let mut state = tracker.state.clone();
        self.rates.at(&pose.drives, &mut state.inputs);
        match scene.plan.effects.level {
            Level::Positions => state.run_motion::<0>(scene.plan),
            Level::Velocities => state.run_motion::<1>(scene.plan),
            Level::Accelerations => state.run_motion::<2>(scene.plan),
        }
        let mut condition = self.motion_condition(&state, pose)?;
        if scene.plan.effects.forces {
            condition = condition.min(self.forces(&mut state, &tracker.angles, pose)?);
        }
        let frictionless = scene.plan.effects.friction.then(|| {
            let mut state = state.clone();
            state.wrenches.clone_from(&state.applied);
            state.frictions.fill(0.0);
            state.locked = false;
            state.run_forces_without_friction(scene.plan);
            Box::new(state)
        });
        if state.locked {
            state.forget_forces();
        } else if let Some(error) = notes::not_finite(scene, &state, pose) {
            return Err(error);
        }
        let residuals = residuals(scene, &state);
        let angles = tracker.angles.clone();
        let solved = Solved { state, frictionless, angles, residuals, condition };
        self.note_contacts(&solved, pose);
        Ok(solved)
    }

    fn motion_condition(&mut self, state: &State, pose: &Wanted) -> Result<f64, SolveError> {
        let scene = self.scene;
        let level = scene.plan.effects.level;
        let mut least = 1.0_f64;
        for (group, sine) in scene.structure.motion.iter().zip(&state.sines) {
            let condition = sine.abs();
            least = least.min(condition);
            if level > Level::Positions && condition <= DEAD {
                return Err(notes::dead(scene, group, condition, pose));
            }
            let (what, power) = match level {
                Level::Positions => ("positions", 1),
                Level::Velocities => ("velocities", 2),
                Level::Accelerations => ("accelerations", 3),
            };
            self.notes.condition(scene, group, (condition, what, power), pose);
        }
        Ok(least)
    }

    fn forces(&mut self, state: &mut State, angles: &[f64], pose: &Wanted) -> Result<f64, SolveError> {
        let scene = self.scene;
        let view = View::new(scene, state, angles, &self.statics);
        view.evaluated_loads(&mut self.evaluated);
        state.run_loads(scene, &self.evaluated);
        state.applied.clone_from(&state.wrenches);
        state.set_lines(scene);
        state.locked = false;
        if scene.plan.effects.friction {
            state.set_senses(scene.plan);
        }
        state.run_forces(scene.plan);
        let mut least = 1.0_f64;
        for (group, sine) in scene.structure.forces.iter().zip(&state.force_sines) {
            let condition = sine.abs();
            least = least.min(condition);
            if condition <= DEAD {
                return Err(notes::cannot_hold(scene, group, condition, pose));
            }
            self.notes.condition(scene, group, (condition, "forces", 2), pose);
        }
        Ok(least)
    }

    fn note_contacts(&mut self, solved: &Solved, pose: &Wanted) {
        if !self.scene.plan.effects.forces {
            return;
        }
        for (i, pair) in self.scene.mechanism.pairs.iter().enumerate() {
            let PairKind::Contact { first, .. } = &pair.kind else { continue };
            let view = View::new(self.scene, &solved.state, &solved.angles, &self.statics);
            let Value::Scalar(normal) = view.query(&Query::Normal(PairId::at(i), first.link)) else {
                continue;
            };
            let force = view.reaction(PairId::at(i), first.link).norm();
            if normal < -1e-9 * force.max(f64::MIN_POSITIVE) && normal < -1e-9 {
                self.notes.pulls(self.scene, PairId::at(i), normal, pose);
            }
        }
    }
}

fn is_open(error: &SolveError) -> bool {
    matches!(error, SolveError::DoesNotClose { .. } | SolveError::NotFound { .. })
}

fn with_pose(mut error: SolveError, place: &str) -> SolveError {
    match &mut error {
        SolveError::DoesNotClose { pose, .. }
        | SolveError::NotFound { pose, .. }
        | SolveError::Ambiguous { pose, .. }
        | SolveError::HintNotMet { pose, .. } => place.clone_into(pose),
        _ => {}
    }
    error
}
