//! Solves all positions of a file.

use super::again::PoseOutputs;
use super::block::{Block, FreeSweep, is_free};
use super::centre_notes::CentreNotes;
use super::closure_after_turn::{AfterTurns, First};
use super::cycle::{events, loads_name_quantities, never_ended};
use super::extremes::statics;
use super::failure::{Cause, Failure};
use super::inputs::Rates;
use super::note::Note;
use super::positions::{Sweep, beside};
use super::refusals::{refusals, unit_speeds};
use super::run::{Arrival, Run, Stuck};
use super::simulate::{IntegrationOptions, SimulationReport, Trajectory};
use super::solution::{Pose, Solution};
use super::steps::StepLimit;
use super::track::Tracker;
use super::whole_turns::Turns;
use crate::answer::WholeCycle;
use crate::position::{DriveValue, Model, PoseRequest};
use std::collections::VecDeque;

/// Fewer positions are not worth to be solved side by side.
const FEWEST: usize = 8;
/// Solves all positions. What fails at one position stands in its pose; what makes all of them meaningless is an error.
///
/// # Errors
/// Constructs not supported yet, requests without the speeds they need, no assembly or several at the first position,
/// forces that are not determined.
pub fn solve(model: &Model<'_>) -> Result<Solution, Vec<Failure>> {
    solve_with(model, Vec::new())
}

/// As [`solve`], with the values of [`crate::model::Mechanism::criticals`].
///
/// # Errors
/// As [`solve`].
pub fn solve_with(model: &Model<'_>, criticals: Vec<f64>) -> Result<Solution, Vec<Failure>> {
    let Some(mut following) = Following::new(model, criticals)? else { return Ok(Solution::default()) };
    let mut poses = Vec::with_capacity(following.positions());
    while let Some(pose) = following.next() {
        poses.push(pose.map_err(|e| vec![e])?);
    }
    Ok(Solution { poses, ..following.end() })
}

/// The positions of a file, solved one after another: none is kept.
pub struct Following<'a, 's> {
    pub(super) run: Run<'a, 's>,
    sweep: Sweep,
    pace: StepLimit,
    pub(super) next: usize,
    /// A motion under loads, instead of the sweep.
    pub(super) trajectory: Option<Trajectory>,
    current: Option<Tracker>,
    /// Poses beside the sweep, each followed from the nearest position of the sweep that closed.
    near: VecDeque<SidePose>,
    /// The first position.
    begin: Option<First>,
    /// Why the first position that failed did.
    first_failure: Option<Failure>,
    cycle_notes: Vec<Note>,
    /// Positions may depend on the drives and the assembly alone.
    free: bool,
}

impl<'a, 's> Following<'a, 's> {
    /// Finds all that needs no position; `None` where there is no mechanism to follow.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn new(model: &'s Model<'a>, criticals: Vec<f64>) -> Result<Option<Self>, Vec<Failure>> {
        Self::conducted(model, criticals, &IntegrationOptions::default())
    }

    /// As [`Following::new`]; a motion under loads is integrated as `conduct` says.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn conducted(
        model: &'s Model<'a>,
        criticals: Vec<f64>,
        conduct: &IntegrationOptions<'_>,
    ) -> Result<Option<Self>, Vec<Failure>> {
        let refused = refusals(model);
        if !refused.is_empty() {
            return Err(refused);
        }
        let needs_poses = model.mechanism.links.len() > 1;
        if !needs_poses {
            return Ok(None);
        }
        let mut statics = statics(model).map_err(|cause| vec![cause.into()])?;
        statics.criticals = criticals;
        let mut sweep = Sweep::of(model, &statics);
        if let Some(empty) = sweep.empty_range(model.mechanism) {
            return Err(vec![Cause::Refused(empty).into()]);
        }
        let rates = Rates::of(model, &statics);
        let first = sweep.at(0).drives;
        let (mut trajectory, mut cycle_notes) = (None, Vec::new());
        if let Some(simulation) = &model.mechanism.simulation {
            let found = super::simulate::trajectory(model, &statics, &rates, &first, simulation, conduct);
            let found = found.map_err(|failure| vec![failure])?;
            found.report_to(model.mechanism, &mut statics);
            trajectory = Some(found);
        } else {
            if !model.mechanism.events.is_empty() {
                events(model, &mut statics, &sweep).map_err(|cause| vec![cause.into()])?;
                sweep = Sweep::of(model, &statics);
            }
            cycle_notes =
                super::cycle::cycles(model, &mut statics, &sweep).map_err(|cause| vec![cause.into()])?;
        }
        let near = beside(model, &statics, &sweep.at(0)).into_iter().map(SidePose::new).collect();
        let mut run = Run::new(model, rates, statics, loads_name_quantities(model.mechanism));
        run.centres = CentreNotes::of(model.mechanism);
        // positions farther apart are followed on a way between them
        let pace = StepLimit::of(model);
        let apart = || pace.steps(&sweep.values(0), &sweep.values(1));
        let free = trajectory.is_none() && is_free(model) && run.centres.is_empty() && apart() <= 1.0;
        let (next, current, begin, first_failure) = (0, None, None, None);
        Ok(Some(Self {
            run,
            sweep,
            pace,
            next,
            trajectory,
            current,
            near,
            begin,
            first_failure,
            cycle_notes,
            free,
        }))
    }

    /// How many positions there are, with the poses beside the sweep.
    #[must_use]
    pub fn positions(&self) -> usize {
        match &self.trajectory {
            Some(trajectory) => trajectory.records.count + usize::from(trajectory.ended.is_some()),
            None => self.sweep.len() + self.near.len(),
        }
    }

    /// How many positions the sweep has.
    #[must_use]
    pub fn swept(&self) -> usize {
        match &self.trajectory {
            Some(trajectory) => trajectory.printed(),
            None => self.sweep.len(),
        }
    }

    /// Dead positions, strokes, functions over the sweep.
    #[must_use]
    pub const fn statics(&self) -> &WholeCycle {
        &self.run.statics
    }

    /// What a motion under loads says of itself.
    #[must_use]
    pub fn simulation(&self) -> Option<&SimulationReport> {
        self.trajectory.as_ref().map(|trajectory| &trajectory.report)
    }

    /// Whether a position that was looked at has a meaning.
    #[must_use]
    pub const fn has_begun(&self) -> bool {
        self.run.closing.open < self.run.closing.swept
    }

    /// The next position: those of the sweep in order, then those beside it. An error where no position has a meaning.
    #[allow(clippy::should_implement_trait)] // an error ends the file
    pub fn next(&mut self) -> Option<Result<Pose, Failure>> {
        if self.trajectory.is_some() {
            return self.next_instant();
        }
        if self.next < self.sweep.len() {
            let pose = self.sweep.at(self.next);
            self.next += 1;
            let pose = self.swept_pose(pose);
            self.look_after_turns();
            return Some(pose);
        }
        if let (Some(failure), false) = (self.first_failure.take(), self.has_begun()) {
            self.near.clear();
            return Some(Err(failure));
        }
        self.near.pop_front().map(|near| Ok(self.run.beside(near)))
    }

    /// Hands out all positions behind the first at once, if none of them depends on the one before; `None` where they are to be followed.
    /// What of them is read beside their answers is given. `each` calls its argument for all numbers below a count, on any thread.
    /// Returns what `hand_out` does.
    pub fn side_by_side<S: ?Sized>(
        &mut self,
        reads: PoseOutputs,
        sink: &mut S,
        each: impl Fn(&S, usize, &(dyn Fn(usize) + Sync)),
        hand_out: impl FnOnce(&mut S, &FreeSweep<'_>) -> bool,
    ) -> Option<bool> {
        let tracker = self.current.as_mut().filter(|_| self.next == 1 && self.near.is_empty())?;
        let first = std::mem::replace(&mut self.free, false) && self.sweep.len() > FEWEST;
        first.then_some(())?;
        let Run { model, rates, statics, closing, last, .. } = &mut self.run;
        let begin = Turns::begin(&tracker.angles, tracker.state.motion.bodies.iter().map(|b| b.u));
        let (branches, turns) = (tracker.state.branches.clone(), &begin);
        let (sweep, pace, first) = (&self.sweep, &self.pace, self.next);
        let all = FreeSweep { model, rates, statics, sweep, pace, branches: &branches, turns, first, reads };
        let turns = &all.turns(&|count, work| each(sink, count, work))?;
        let goes_on = hand_out(sink, &FreeSweep { turns, ..all });
        let mut block = Block::default();
        FreeSweep { turns, reads: PoseOutputs::ALL, ..all }.solve(all.blocks() - 1, &mut block);
        if let Some(Pose { name, drives, outcome: Ok(solved), .. }) = block.poses().last() {
            tracker.put(solved, drives);
            *last = Some((name.clone(), drives.clone()));
        }
        closing.swept += all.count();
        self.next = self.sweep.len();
        self.look_after_turns();
        Some(goes_on)
    }

    /// What was found over all positions.
    #[must_use]
    pub fn end(self) -> Solution {
        let positions = self.swept();
        let (mut notes, unlisted) = self.run.notes.into_notes(self.run.closing);
        notes.extend(self.cycle_notes);
        notes.extend(unit_speeds(self.run.model));
        notes.extend(self.run.friction.into_notes());
        notes.extend(self.run.centres.into_notes());
        notes.extend(never_ended(self.run.model, &self.run.statics));
        if let Some(trajectory) = &self.trajectory {
            notes.extend(trajectory.never_ended(self.run.model.mechanism));
        }
        let simulation = self.trajectory.map(|trajectory| trajectory.report);
        Solution { statics: self.run.statics, notes, unlisted, positions, simulation, ..Solution::default() }
    }

    /// Notes at the end of the sweep where the mechanism does not come back after whole turns; where only something is wound up,
    /// the position after them belongs to the sweep.
    fn look_after_turns(&mut self) {
        let Some(tracker) = self.current.as_ref().filter(|_| self.run.closing.open == 0) else { return };
        if self.next == 1 {
            self.begin = self.run.begin(tracker, &self.sweep);
        }
        if self.next == self.sweep.len()
            && let Some(begin) = &self.begin
        {
            match self.run.after_turns(begin, tracker, &self.sweep) {
                Some(AfterTurns::Elsewhere(note)) => self.cycle_notes.push(note),
                Some(AfterTurns::Wound) => self.sweep.keep_last(),
                None => {}
            }
        }
    }

    fn swept_pose(&mut self, pose: PoseRequest) -> Result<Pose, Failure> {
        let run = &mut self.run;
        let came = match self.current.take() {
            None => run.assembled(&pose).map(|t| (t, Arrival::Followed(Vec::new()))),
            Some(mut tracker) => run.moved(&mut tracker, &pose).map(|arrival| (tracker, arrival)),
        };
        let outcome = match came {
            Ok((tracker, arrival)) => {
                run.note_arrival(arrival, &tracker, &pose);
                let outcome = run.solved(&tracker, &pose);
                self.near.iter_mut().for_each(|n| n.update(&tracker, &pose.drives));
                self.current = Some(tracker);
                outcome
            }
            Err(stuck) => {
                let Stuck { failure, back } = *stuck;
                let is_open = failure.cause.is_open();
                // without a choice, or with a hint that cannot be met, no position has a meaning
                if self.next == 1 && (self.sweep.len() == 1 || !is_open) {
                    self.next = self.sweep.len();
                    self.near.clear();
                    return Err(failure);
                }
                if self.first_failure.is_none() {
                    self.first_failure = Some(failure.clone());
                }
                if is_open && !run.notes.in_gap() {
                    let limit = back.clone().map(|t| t.limit(run.model, &run.rates, &pose.drives));
                    run.notes.gap_begins(limit);
                }
                self.current = back;
                Err(failure)
            }
        };
        run.closing.swept += 1;
        let cause = outcome.as_ref().err().map(|failure| &failure.cause);
        run.closing.open += usize::from(cause.is_some_and(Cause::is_open));
        run.closing.ambiguous |= matches!(cause, Some(Cause::Ambiguous { .. }));
        Ok(run.posed(pose, outcome))
    }
}

/// A pose beside the sweep, with the tracker at the nearest position of the sweep that closed.
struct SidePose {
    pose: PoseRequest,
    away: f64,
    tracker: Option<Tracker>,
}

impl SidePose {
    const fn new(pose: PoseRequest) -> Self {
        Self { pose, away: f64::INFINITY, tracker: None }
    }

    /// Keeps the tracker if its position is nearer than those before.
    fn update(&mut self, tracker: &Tracker, drives: &[DriveValue]) {
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

impl Run<'_, '_> {
    /// A pose beside the sweep.
    fn beside(&mut self, near: SidePose) -> Pose {
        let SidePose { pose, tracker, .. } = near;
        let outcome = match tracker {
            Some(mut tracker) => match self.moved(&mut tracker, &pose) {
                Ok(_) => self.solved(&tracker, &pose),
                Err(stuck) => Err(stuck.failure),
            },
            None => self.assembled(&pose).map_err(|stuck| stuck.failure).and_then(|t| self.solved(&t, &pose)),
        };
        self.posed(pose, outcome)
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
