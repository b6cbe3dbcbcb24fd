//! Solves all positions of a file.

use super::assemble::{assemble, does_not_close};
use super::cycle::loads_name_quantities;
use super::error::{SolveError, label};
use super::extremes::{Statics, statics};
use super::free_roller::free_rollers;
use super::friction_notes::FrictionNotes;
use super::inputs::Rates;
use super::notes::Notes;
use super::open;
use super::positions::{Wanted, beside, sweep};
use super::refused;
use super::solution::{DriveValue, OpenSizes, Pose, Scene, Solution, Solved};
use super::state::State;
use super::track::{Switch, Tracker};
use super::words::place;
use crate::model::{LoadId, Value};

/// Solves all positions. What fails at one position stands in its pose; what makes all of them meaningless is an error.
///
/// # Errors
/// Constructs not supported yet, requests without the speeds they need, no assembly or several at the first position,
/// forces that are not determined.
pub fn solve(scene: &Scene<'_>) -> Result<Solution, Vec<SolveError>> {
    solve_with(scene, Vec::new())
}

/// As [`solve`], with the values of [`crate::model::Mechanism::criticals`].
///
/// # Errors
/// As [`solve`].
pub fn solve_with(scene: &Scene<'_>, criticals: Vec<f64>) -> Result<Solution, Vec<SolveError>> {
    can_be_solved(scene)?;
    let needs_poses = scene.mechanism.links.len() > 1;
    if !needs_poses {
        return Ok(Solution::default());
    }
    let mut statics = statics(scene).map_err(|e| vec![e])?;
    statics.criticals = criticals;
    let wanted = sweep(scene, &statics);
    let cycle_warnings = super::cycle::cycles(scene, &mut statics, &wanted).map_err(|e| vec![e])?;
    let mut run = Run {
        scene,
        rates: Rates::of(scene, &statics),
        statics,
        evaluated: Vec::new(),
        loads_name_quantities: loads_name_quantities(scene.mechanism),
        memory: None,
        before: None,
        poses: Vec::new(),
        notes: Notes::default(),
        friction: FrictionNotes::default(),
    };
    let mut near = beside(scene, &run.statics, &wanted[0]).into_iter().map(Near::new).collect::<Vec<_>>();
    run.poses.reserve(wanted.len() + near.len());
    run.follow(wanted, &mut near).map_err(|e| vec![e])?;
    run.beside(near);
    let friction = run.friction_problems();
    let mut warnings = run.notes.into_warnings(scene, &run.poses);
    warnings.extend(cycle_warnings);
    warnings.extend(refused::unit_speeds(scene));
    Ok(Solution { poses: run.poses, statics: run.statics, warnings, friction, open: OpenSizes::default() })
}

/// A pose beside the sweep, with the tracker at the nearest position of the sweep that closed.
struct Near {
    pose: Wanted,
    away: f64,
    tracker: Option<Tracker>,
}

impl Near {
    const fn new(pose: Wanted) -> Self {
        Self { pose, away: f64::INFINITY, tracker: None }
    }

    /// Keeps the tracker if its position is nearer than those before.
    fn look(&mut self, tracker: &Tracker, drives: &[DriveValue]) {
        let away = away(drives, &self.pose.drives);
        if away < self.away {
            self.away = away;
            match &mut self.tracker {
                Some(kept) => kept.start_from(tracker),
                None => self.tracker = Some(tracker.clone()),
            }
        }
    }
}

/// Everything that can be refused before any position is looked at.
pub(super) fn can_be_solved(scene: &Scene<'_>) -> Result<(), Vec<SolveError>> {
    let mut errors = refused::not_supported(scene.mechanism);
    errors.extend(refused::cams(scene));
    errors.extend(refused::missing_speeds(scene));
    errors.extend(free_rollers(scene));
    errors.extend(open::without_position(scene));
    errors.extend(open::without_place(scene));
    errors.extend(open::friction_beside(scene));
    errors.extend(open::friction_couples(scene));
    if errors.is_empty() { Ok(()) } else { Err(errors) }
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

pub(super) struct Run<'a, 's> {
    pub scene: &'s Scene<'a>,
    pub rates: Rates,
    pub statics: Statics,
    pub evaluated: Vec<(LoadId, Value)>,
    pub loads_name_quantities: bool,
    /// Memory for the steps at one position.
    pub memory: Option<State>,
    /// Memory for the place before a step of the sweep.
    before: Option<Tracker>,
    poses: Vec<Pose>,
    pub notes: Notes,
    /// What is said of friction.
    pub friction: FrictionNotes,
}

impl Run<'_, '_> {
    /// Follows the sweep, past the poses beside it.
    fn follow(&mut self, wanted: Vec<Wanted>, near: &mut [Near]) -> Result<(), SolveError> {
        let mut current: Option<Tracker> = None;
        let mut first_error = None;
        let alone = wanted.len() == 1;
        for (i, pose) in wanted.into_iter().enumerate() {
            let came = match current.take() {
                None => self.assembled(&pose).map(|t| (t, Way::Followed(Vec::new()))),
                Some(mut tracker) => self.moved(&mut tracker, &pose).map(|way| (tracker, way)),
            };
            match came {
                Ok((tracker, way)) => {
                    self.note_way(way, &tracker, &pose);
                    let outcome = self.solved(&tracker, &pose);
                    near.iter_mut().for_each(|n| n.look(&tracker, &pose.drives));
                    self.push(pose, outcome);
                    current = Some(tracker);
                }
                Err(stuck) => {
                    let Stuck { error, back } = *stuck;
                    // without a choice, or with a hint that cannot be met, no position has a meaning
                    if i == 0 && (alone || !is_open(&error)) {
                        return Err(error);
                    }
                    first_error.get_or_insert(error.clone());
                    if is_open(&error) && !self.notes.in_gap() {
                        let limit = back.clone().map(|t| t.limit(self.scene, &self.rates, &pose.drives));
                        self.notes.gap_begins(limit);
                    }
                    self.push(pose, Err(error));
                    current = back;
                }
            }
        }
        match first_error {
            Some(error) if self.poses.iter().all(|p| p.outcome.as_ref().is_err_and(is_open)) => Err(error),
            _ => Ok(()),
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
    fn note_way(&mut self, way: Way, tracker: &Tracker, pose: &Wanted) {
        let Some(before) = self.poses.last() else { return };
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

    fn moved(&mut self, tracker: &mut Tracker, pose: &Wanted) -> Result<Way, Box<Stuck>> {
        if tracker.is_too_long(self.scene, &pose.drives) {
            let labels =
                self.scene.mechanism.drives.iter().map(|d| label("driven that far", d.span)).collect();
            let error = SolveError::WayTooLong { pose: place(self.scene, pose), labels };
            return Err(Box::new(Stuck { error, back: Some(tracker.clone()) }));
        }
        let mut before = self.before.take().unwrap_or_else(|| tracker.clone());
        before.start_from(tracker);
        if let Ok(switched) = tracker.go(self.scene, &self.rates, &pose.drives) {
            self.before = Some(before);
            return Ok(Way::Followed(switched));
        }
        // the way is closed somewhere; the position itself may not be
        tracker.start_from(&before);
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
    fn beside(&mut self, near: Vec<Near>) {
        for Near { pose, tracker, .. } in near {
            let outcome = match tracker {
                Some(mut tracker) => match self.moved(&mut tracker, &pose) {
                    Ok(_) => self.solved(&tracker, &pose),
                    Err(stuck) => Err(stuck.error),
                },
                None => self.assembled(&pose).map_err(|e| e.error).and_then(|t| self.solved(&t, &pose)),
            };
            self.push(pose, outcome);
        }
    }

    fn push(&mut self, pose: Wanted, outcome: Result<Solved, SolveError>) {
        let Wanted { name, origin, drives } = pose;
        self.poses.push(Pose { name, origin, drives, outcome });
    }
}

/// How far drive values are apart.
fn away(a: &[DriveValue], b: &[DriveValue]) -> f64 {
    let each = a.iter().zip(b).map(|(a, b)| match (a, b) {
        (DriveValue::Scalar(a), DriveValue::Scalar(b)) => (a - b).abs(),
        (DriveValue::Point(a), DriveValue::Point(b)) => (*a - *b).norm(),
        _ => 0.0,
    });
    each.sum()
}

fn is_open(error: &SolveError) -> bool {
    matches!(error, SolveError::DoesNotClose { .. } | SolveError::NotFound { .. })
}

pub(super) fn with_pose(mut error: SolveError, place: &str) -> SolveError {
    match &mut error {
        SolveError::DoesNotClose { pose, .. }
        | SolveError::NotFound { pose, .. }
        | SolveError::Ambiguous { pose, .. }
        | SolveError::HintNotMet { pose, .. } => place.clone_into(pose),
        _ => {}
    }
    error
}
