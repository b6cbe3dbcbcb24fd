//! What goes from one position to the next: the assembly, memory, and what deserves a note so far.

use super::assemble::assemble_from;
use super::centre_notes::CentreNotes;
use super::failure::{Cause, Failure};
use super::friction_notes::FrictionNotes;
use super::inputs::Rates;
use super::note::Closing;
use super::notes::Notes;
use super::simulate::Instant;
use super::solution::{Pose, Solved};
use super::track::{Switch, Tracker};
use super::unassembled::does_not_close;
use crate::answer::WholeCycle;
use crate::model::{LoadId, Value};
use crate::position::{DriveValue, Model, PoseRequest, STARTS, Searched, State, Wrench};

/// Positions in a row at which all starts of a search are tried in vain.
const MANY: usize = 32;
/// Starts at those behind them.
const FEW_STARTS: usize = 4;

/// Why a position was not reached, and the tracker where it was before.
pub(super) struct Stuck {
    pub(super) failure: Failure,
    pub(super) back: Option<Tracker>,
}

/// How a position was reached.
pub(super) enum Arrival {
    /// From the one before, with the changes of assembly on the way.
    Followed(Vec<Switch>),
    /// The way does not close beyond these values, the position itself does.
    Blocked(Vec<DriveValue>),
}

pub(super) struct Run<'a, 's> {
    pub model: &'s Model<'a>,
    pub rates: Rates,
    pub statics: WholeCycle,
    pub evaluated: Vec<(LoadId, Value)>,
    pub loads_name_quantities: bool,
    /// Memory for the steps at one position.
    pub memory: Option<Box<State>>,
    /// Memory for what is carried from group to group.
    pub carried: Vec<f64>,
    /// Memory for the sums of forces on the bodies.
    pub totals: Vec<Wrench>,
    /// Memory for the place before a step of the sweep.
    pub(super) before: Option<Tracker>,
    /// Name and drive values of the position before.
    pub(super) last: Option<(String, Vec<DriveValue>)>,
    /// Searches for an assembly that found none, one after another.
    searched: usize,
    /// The sweep so far.
    pub(super) closing: Closing,
    /// What the search for consistent forces has taken so far.
    pub consistent_searched: Searched,
    /// What deserves a note so far.
    pub notes: Notes,
    pub friction: FrictionNotes,
    pub centres: CentreNotes,
    /// What the drives say at the instant of a motion under loads.
    pub instant: Option<Instant>,
}

impl<'a, 's> Run<'a, 's> {
    /// No position yet, and no instant centre that is looked at.
    pub(super) fn new(
        model: &'s Model<'a>,
        rates: Rates,
        statics: WholeCycle,
        loads_name_quantities: bool,
    ) -> Self {
        Self {
            model,
            rates,
            statics,
            evaluated: Vec::new(),
            loads_name_quantities,
            memory: None,
            carried: Vec::new(),
            totals: Vec::new(),
            before: None,
            last: None,
            searched: 0,
            consistent_searched: Searched::default(),
            closing: Closing::default(),
            notes: Notes::default(),
            friction: FrictionNotes::default(),
            centres: CentreNotes::default(),
            instant: None,
        }
    }
}

impl Run<'_, '_> {
    pub(super) fn assembled(&mut self, pose: &PoseRequest) -> Result<Tracker, Box<Stuck>> {
        let mut state = State::new(self.model.plan);
        self.rates.at(&pose.drives, &mut state.motion.inputs);
        // what was not found at many positions is not looked for as long at the next
        let starts = if self.searched < MANY { STARTS } else { FEW_STARTS };
        match assemble_from(self.model, state, starts) {
            Ok(state) => {
                self.searched = 0;
                Ok(Tracker::new(self.model, state, &pose.drives))
            }
            Err(cause) => {
                self.searched += usize::from(matches!(cause, Cause::NotFound { .. }));
                Err(Box::new(Stuck { failure: Failure::at(pose, cause), back: None }))
            }
        }
    }

    /// Notes how a position was reached from the one before.
    pub(super) fn note_arrival(&mut self, arrival: Arrival, tracker: &Tracker, pose: &PoseRequest) {
        let Some((name, drives)) = &self.last else { return };
        let back = || tracker.clone().limit(self.model, &self.rates, drives);
        if self.notes.in_gap() {
            let end = back();
            self.notes.gap_ends(end);
            return;
        }
        match arrival {
            Arrival::Followed(switched) => {
                for switch in switched {
                    self.notes.switched(switch, name, &pose.name);
                }
            }
            Arrival::Blocked(limit) => {
                let end = back();
                self.notes.gap_begins(Some(limit));
                self.notes.gap_ends(end);
            }
        }
    }

    pub(super) fn moved(&mut self, tracker: &mut Tracker, pose: &PoseRequest) -> Result<Arrival, Box<Stuck>> {
        if tracker.is_too_long(&pose.drives) {
            let failure = Failure::at(pose, Cause::TooFar);
            return Err(Box::new(Stuck { failure, back: Some(tracker.clone()) }));
        }
        let mut before = self.before.take().unwrap_or_else(|| tracker.clone());
        before.start_from(tracker);
        if let Ok(switched) = tracker.advance_to(self.model, &self.rates, &pose.drives) {
            self.before = Some(before);
            return Ok(Arrival::Followed(switched));
        }
        // the way is closed somewhere; the position itself may not be
        tracker.start_from(&before);
        match tracker.jump(self.model, &self.rates, &pose.drives) {
            Ok(()) => Ok(Arrival::Blocked(before.limit(self.model, &self.rates, &pose.drives))),
            Err(group) => {
                let mut state = before.state.clone();
                self.rates.at(&pose.drives, &mut state.motion.inputs);
                state.start(self.model.plan);
                for step in &self.model.plan.motion[..group] {
                    state.step::<0>(self.model.plan, step);
                }
                let failure = Failure::at(pose, does_not_close(self.model, state, group));
                Err(Box::new(Stuck { failure, back: Some(before) }))
            }
        }
    }

    pub(super) fn posed(&mut self, pose: PoseRequest, outcome: Result<Solved, Failure>) -> Pose {
        let PoseRequest { name, origin, drives } = pose;
        self.last = Some((name.clone(), drives.clone()));
        Pose { name, origin, drives, outcome }
    }
}
