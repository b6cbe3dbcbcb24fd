//! Solves all positions of a file.

use super::assemble::{assemble, does_not_close, group_labels, group_name};
use super::error::{SolveError, label};
use super::extremes::{Statics, every_expression, statics};
use super::inputs::Rates;
use super::positions::{Wanted, beside, sweep, turns};
use super::residual::residuals;
use super::solution::{DriveValue, Pose, PoseOrigin, Scene, Solution, Solved};
use super::state::State;
use super::track::Tracker;
use super::view::View;
use crate::model::{LoadId, Mechanism, PairId, PairKind, Query, Value};
use crate::plan::{Level, level_of};

/// Below this condition a warning tells how many digits are left.
const WARN: f64 = 1e-3;
/// At and below this condition velocities and forces do not exist.
const DEAD: f64 = 1e-12;

/// Solves all positions. What fails at one position stands in its pose; what makes all of them meaningless is an error.
///
/// # Errors
/// Constructs not supported yet, requests without the speeds they need, no assembly or several at the first position,
/// forces that are not determined.
pub fn solve(scene: &Scene<'_>) -> Result<Solution, Vec<SolveError>> {
    let mut errors = not_supported(scene.mechanism);
    errors.extend(missing_speeds(scene));
    if !errors.is_empty() {
        return Err(errors);
    }
    let needs_poses = scene.mechanism.links.len() > 1;
    if !needs_poses {
        return Ok(Solution::default());
    }
    let statics = statics(scene).map_err(|e| vec![e])?;
    let wanted = sweep(scene, &statics).map_err(|e| vec![e])?;
    let mut run = Run {
        scene,
        rates: Rates::of(scene, &statics),
        statics,
        evaluated: Vec::new(),
        poses: Vec::new(),
        warnings: Vec::new(),
        worst: None,
    };
    let trackers = run.follow(&wanted).map_err(|e| vec![e])?;
    run.beside(&wanted, &trackers);
    run.partial_sweep(wanted.len());
    if let Some(warning) = run.worst.take() {
        run.warnings.push(warning.1);
    }
    Ok(Solution { poses: run.poses, statics: run.statics, warnings: run.warnings })
}

fn not_supported(mechanism: &Mechanism) -> Vec<SolveError> {
    mechanism
        .unsupported
        .iter()
        .map(|u| SolveError::NotSupportedYet { what: u.what.clone(), span: u.span.into() })
        .collect()
}

fn missing_speeds(scene: &Scene<'_>) -> Option<SolveError> {
    let effects = scene.plan.effects;
    let allowed = match (effects.moving, effects.timed) {
        (_, true) => Level::Accelerations,
        (true, false) => Level::Velocities,
        (false, false) => Level::Positions,
    };
    let mut missing = None;
    every_expression(scene.mechanism, &mut |expr| {
        expr.queries(&mut |query| {
            if level_of(query) > allowed {
                missing = Some(level_of(query));
            }
        });
    });
    let (needed, drive) = (missing?, scene.mechanism.drives.first()?);
    let what = if needed == Level::Velocities { "a velocity" } else { "an acceleration" };
    Some(SolveError::NeedsSpeed {
        what: what.to_owned(),
        needs: if needed == Level::Velocities { "a speed" } else { "a speed in time" },
        help: format!("give the drive a speed, as in `drive {} = 0 deg at 60 rpm`", drive.name),
        labels: vec![label("no speed", drive.span)],
    })
}

/// Why a position was not reached, and the tracker where it was before.
struct Stuck {
    error: SolveError,
    back: Option<Tracker>,
}

struct Run<'a, 's> {
    scene: &'s Scene<'a>,
    rates: Rates,
    statics: Statics,
    evaluated: Vec<(LoadId, Value)>,
    poses: Vec<Pose>,
    warnings: Vec<SolveError>,
    /// The worst condition so far and its warning.
    worst: Option<(f64, SolveError)>,
}

impl Run<'_, '_> {
    /// Follows the sweep; the trackers at its positions, where they closed.
    fn follow(&mut self, wanted: &[Wanted]) -> Result<Vec<Option<Tracker>>, SolveError> {
        let mut trackers: Vec<Option<Tracker>> = Vec::with_capacity(wanted.len());
        let mut current: Option<Tracker> = None;
        let mut first_error = None;
        let keep_all = !beside(self.scene, &self.statics, &wanted[0]).is_empty();
        for (i, pose) in wanted.iter().enumerate() {
            let came = match current.take() {
                None => self.assembled(pose).map(|t| (t, Vec::new())),
                Some(mut tracker) => self.moved(&mut tracker, pose).map(|s| (tracker, s)),
            };
            match came {
                Ok((tracker, switched)) => {
                    for group in switched {
                        self.warn_switch(group, &wanted[i - 1].name, &pose.name);
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
            .map_err(|e| Box::new(Stuck { error: with_pose(e, &self.place(pose)), back: None }))?;
        Ok(Tracker::new(self.scene, state, &pose.drives))
    }

    fn moved(&self, tracker: &mut Tracker, pose: &Wanted) -> Result<Vec<usize>, Box<Stuck>> {
        let before = tracker.clone();
        if let Ok(switched) = tracker.go(self.scene, &self.rates, &pose.drives) {
            return Ok(switched);
        }
        // the way is closed somewhere; the position itself may not be
        *tracker = before.clone();
        match tracker.jump(self.scene, &self.rates, &pose.drives) {
            Ok(()) => Ok(Vec::new()),
            Err(group) => {
                let mut state = before.state.clone();
                self.rates.at(&pose.drives, &mut state.inputs);
                state.start(self.scene.plan);
                for step in &self.scene.plan.motion[..group] {
                    state.step::<0>(self.scene.plan, step);
                }
                let error = does_not_close(self.scene, state, group, &self.place(pose));
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
        let moves = scene.plan.effects.level > Level::Positions;
        let mut condition = self.motion_condition(&state, pose, moves)?;
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
        } else if !is_finite(&state) {
            return Err(self.not_finite(pose));
        }
        let residuals = residuals(scene, &state);
        let angles = tracker.angles.clone();
        let solved = Solved { state, frictionless, angles, residuals, condition };
        self.warn_contacts(&solved, pose);
        Ok(solved)
    }

    fn motion_condition(&mut self, state: &State, pose: &Wanted, moves: bool) -> Result<f64, SolveError> {
        let mut least = 1.0_f64;
        for (group, sine) in state.sines.iter().enumerate() {
            let condition = sine.abs();
            least = least.min(condition);
            if moves && is_dead(condition) {
                return Err(SolveError::DeadPosition {
                    pose: self.place(pose),
                    group: group_name(self.scene, group),
                    condition,
                    labels: group_labels(self.scene, group),
                });
            }
            if condition < WARN && self.worst.as_ref().is_none_or(|w| condition < w.0) {
                let warning = SolveError::IllConditioned {
                    pose: self.place(pose),
                    group: group_name(self.scene, group),
                    condition,
                    digits: digits_left(condition),
                    labels: group_labels(self.scene, group),
                };
                self.worst = Some((condition, warning));
            }
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
        for (index, sine) in state.force_sines.iter().enumerate() {
            least = least.min(sine.abs());
            if is_dead(sine.abs()) {
                let pairs = scene.structure.forces[index].joints.iter();
                let labels = pairs
                    .map(|j| scene.mechanism.pair(scene.structure.replaced.joint(j.joint).pair))
                    .map(|p| label("in this group", p.span))
                    .collect();
                let (pose, condition) = (self.place(pose), sine.abs());
                return Err(SolveError::EffortCannotHold { pose, condition, labels });
            }
        }
        Ok(least)
    }

    fn warn_contacts(&mut self, solved: &Solved, pose: &Wanted) {
        if !self.scene.plan.effects.forces {
            return;
        }
        let place = self.place(pose);
        for (i, pair) in self.scene.mechanism.pairs.iter().enumerate() {
            let PairKind::Contact { first, .. } = &pair.kind else { continue };
            let view = View::new(self.scene, &solved.state, &solved.angles, &self.statics);
            let Value::Scalar(normal) = view.query(&Query::Normal(PairId::at(i), first.link)) else {
                continue;
            };
            let force = view.reaction(PairId::at(i), first.link).norm();
            if normal < -1e-9 * force.max(f64::MIN_POSITIVE) && normal < -1e-9 {
                self.warnings.push(SolveError::ContactPulls {
                    name: pair.name.clone(),
                    pose: place.clone(),
                    normal,
                    span: pair.span.into(),
                });
            }
        }
    }

    fn warn_switch(&mut self, group: usize, from: &str, to: &str) {
        self.warnings.push(SolveError::BranchSwitch {
            group: group_name(self.scene, group),
            from: from.to_owned(),
            to: to.to_owned(),
            labels: group_labels(self.scene, group),
        });
    }

    /// A warning that tells over which ranges a sweep does not close.
    fn partial_sweep(&mut self, total: usize) {
        let sweep = || self.poses.iter().filter(|p| matches!(p.origin, PoseOrigin::Sweep(_)));
        let closed = sweep().filter(|p| !p.outcome.as_ref().is_err_and(is_open)).count();
        if closed == total {
            return;
        }
        let mut ranges: Vec<(String, String)> = Vec::new();
        let mut open_before = false;
        for pose in sweep() {
            let open = pose.outcome.as_ref().is_err_and(is_open);
            if open {
                let here = self.drive_text(&pose.drives);
                match ranges.last_mut() {
                    Some(range) if open_before => range.1 = here,
                    _ => ranges.push((here.clone(), here)),
                }
            }
            open_before = open;
        }
        let text: Vec<String> = ranges
            .iter()
            .map(|(a, b)| if a == b { format!("open at {a}") } else { format!("open from {a} to {b}") })
            .collect();
        let span = self.scene.mechanism.drives.first().map_or_else(Default::default, |d| d.span);
        self.warnings.push(SolveError::PartialSweep {
            closed,
            total,
            ranges: text.join(", "),
            span: span.into(),
        });
    }

    fn not_finite(&self, pose: &Wanted) -> SolveError {
        let drives = self.scene.mechanism.drives.iter();
        SolveError::NotFinite {
            pose: self.place(pose),
            labels: drives.map(|d| label("at this position", d.span)).collect(),
        }
    }

    fn place(&self, pose: &Wanted) -> String {
        let drives = self.drive_text(&pose.drives);
        match pose.origin {
            _ if drives.is_empty() => String::new(),
            PoseOrigin::Expected(_) => format!(" at {drives}"),
            _ => format!(" at pose {} ({drives})", pose.name),
        }
    }

    fn drive_text(&self, values: &[DriveValue]) -> String {
        let drives = self.scene.mechanism.drives.iter().zip(values);
        let texts = drives.filter_map(|(drive, value)| match value {
            DriveValue::Scalar(x) if turns(self.scene, drive) => {
                Some(format!("{} = {} deg", drive.name, short(x.to_degrees())))
            }
            DriveValue::Scalar(x) => Some(format!("{} = {}", drive.name, super::gap::mm(*x))),
            DriveValue::Point(_) | DriveValue::None => None,
        });
        texts.collect::<Vec<_>>().join(", ")
    }
}

fn is_dead(condition: f64) -> bool {
    condition <= DEAD || condition.is_nan()
}

/// Up to six decimals, without trailing zeros.
fn short(x: f64) -> String {
    let text = format!("{x:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn is_open(error: &SolveError) -> bool {
    matches!(error, SolveError::DoesNotClose { .. } | SolveError::NotFound { .. })
}

fn with_pose(error: SolveError, place: &str) -> SolveError {
    match error {
        SolveError::DoesNotClose { gap, help, labels, .. } => {
            SolveError::DoesNotClose { pose: place.to_owned(), gap, help, labels }
        }
        SolveError::NotFound { group, labels, .. } => {
            SolveError::NotFound { pose: place.to_owned(), group, labels }
        }
        other => other,
    }
}

/// Digits left in accelerations and forces: the error grows as ε/σ³.
fn digits_left(condition: f64) -> u32 {
    let digits = -(f64::EPSILON.log10()) + 3.0 * condition.max(f64::MIN_POSITIVE).log10();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
    {
        digits.clamp(0.0, 16.0) as u32
    }
}

fn is_finite(state: &State) -> bool {
    let body = |b: &super::state::BodyState| {
        [b.p.x, b.p.y, b.u.x, b.u.y, b.v.x, b.v.y, b.omega, b.a.x, b.a.y, b.alpha]
            .iter()
            .all(|x| x.is_finite())
    };
    state.bodies.iter().all(body)
        && state.reactions.iter().all(|r| (r.force.x + r.force.y + r.couple).is_finite())
        && state.efforts.iter().all(|e| e.is_finite())
}
