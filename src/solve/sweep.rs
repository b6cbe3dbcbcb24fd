//! Solves all positions of a file.

use super::assemble::{assemble, does_not_close, group_labels, group_name};
use super::error::{SolveError, label};
use super::extremes::{Statics, every_expression, statics};
use super::friction_notes::FrictionNotes;
use super::inputs::Rates;
use super::positions::{Wanted, beside, sweep, turns};
use super::solution::{DriveValue, Pose, PoseOrigin, Scene, Solution, Solved};
use super::state::State;
use super::track::Tracker;
use crate::model::{LoadId, Mechanism, Value};
use crate::plan::{Level, level_of};

/// Solves all positions. What fails at one position stands in its pose; what makes all of them meaningless is an error.
///
/// # Errors
/// Constructs not supported yet, requests without the speeds they need, no assembly or several at the first position,
/// forces that are not determined.
pub fn solve(scene: &Scene<'_>) -> Result<Solution, Vec<SolveError>> {
    solve_with(scene, Vec::new())
}

/// As [`solve`], with the values of [`Mechanism::criticals`].
///
/// # Errors
/// As [`solve`].
pub fn solve_with(scene: &Scene<'_>, criticals: Vec<f64>) -> Result<Solution, Vec<SolveError>> {
    let mut errors = not_supported(scene.mechanism);
    errors.extend(missing_speeds(scene));
    if !errors.is_empty() {
        return Err(errors);
    }
    let needs_poses = scene.mechanism.links.len() > 1;
    if !needs_poses {
        return Ok(Solution::default());
    }
    let mut statics = statics(scene).map_err(|e| vec![e])?;
    statics.criticals = criticals;
    let wanted = sweep(scene, &statics).map_err(|e| vec![e])?;
    let mut run = Run {
        scene,
        rates: Rates::of(scene, &statics),
        statics,
        evaluated: Vec::new(),
        poses: Vec::new(),
        warnings: Vec::new(),
        worst: None,
        friction: FrictionNotes::default(),
    };
    let trackers = run.follow(&wanted).map_err(|e| vec![e])?;
    run.beside(&wanted, &trackers);
    run.partial_sweep(wanted.len());
    let friction = run.friction_problems();
    if let Some(warning) = run.worst.take() {
        run.warnings.push(warning.1);
    }
    Ok(Solution { poses: run.poses, statics: run.statics, warnings: run.warnings, friction })
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

pub(super) struct Run<'a, 's> {
    pub scene: &'s Scene<'a>,
    pub rates: Rates,
    pub statics: Statics,
    pub evaluated: Vec<(LoadId, Value)>,
    poses: Vec<Pose>,
    pub warnings: Vec<SolveError>,
    /// The worst condition so far and its warning.
    pub worst: Option<(f64, SolveError)>,
    /// What is said of friction.
    pub friction: FrictionNotes,
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

    pub(super) fn not_finite(&self, pose: &Wanted) -> SolveError {
        let drives = self.scene.mechanism.drives.iter();
        SolveError::NotFinite {
            pose: self.place(pose),
            labels: drives.map(|d| label("at this position", d.span)).collect(),
        }
    }

    pub(super) fn place(&self, pose: &Wanted) -> String {
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
