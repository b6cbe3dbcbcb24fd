//! What solving gives: one state per position, with residuals and condition.

use super::failure::{Cause, Failure};
use super::note::Note;
use super::simulate::SimulationReport;
use crate::answer::{PoseAnswers, WholeCycle};
use crate::model::{Mechanism, Value};
use crate::position::{DriveValue, Model, PoseOrigin, Residuals, State};

/// All positions of a file.
#[derive(Debug, Default)]
pub struct Solution {
    /// The sweep's poses in order, then the file's own, then those that an `expect … at` adds. Of a motion that was
    /// followed position by position those alone that an expectation names.
    pub poses: Vec<Pose>,
    /// How many positions the sweep has.
    pub positions: usize,
    /// Dead positions and strokes of the pairs asked for.
    pub statics: WholeCycle,
    /// What a motion under loads says of itself.
    pub simulation: Option<SimulationReport>,
    /// What deserves a warning or a note.
    pub notes: Vec<Note>,
    /// How many more there are than are kept.
    pub unlisted: usize,
    /// What depends on sizes that the file leaves open: nothing of it is reported.
    pub open: OpenSizes,
}

/// Results that depend on sizes of wheels that the file leaves open.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OpenSizes {
    /// Links whose rates do.
    pub links: Vec<usize>,
    /// Unknown efforts that do.
    pub efforts: Vec<usize>,
    /// Laws of transmissions whose forces do.
    pub laws: Vec<usize>,
}

#[derive(Clone, Debug)]
pub struct Pose {
    /// `1`, `2`, … for a sweep; the name of a pose of its own; for an added one the drive values in words.
    pub name: String,
    /// Where it comes from.
    pub origin: PoseOrigin,
    /// Values of the drives, in their order.
    pub drives: Vec<DriveValue>,
    /// The state, or why there is none.
    pub outcome: Result<Solved, Failure>,
}

#[derive(Clone, Debug, Default)]
pub struct Solved {
    /// Bodies, reactions, efforts.
    pub state: State,
    /// The same without friction, where the file declares any.
    pub frictionless: Option<Box<(State, Vec<Value>)>>,
    /// Values of the file's quantities.
    pub quantities: Vec<Value>,
    /// Angles of the bodies by slot, continuous over the sweep, rad.
    pub angles: Vec<f64>,
    /// How well independent equations hold.
    pub residuals: Residuals,
    /// The least condition figure of all groups, in (0, 1].
    pub condition: f64,
}

impl Pose {
    /// Whether it is a position, and not only says at the end of a motion that its accuracy was missed.
    #[must_use]
    pub fn is_position(&self) -> bool {
        let missed =
            |failure: &Failure| matches!(&failure.cause, Cause::Halted { halt, .. } if halt.is_inaccurate());
        !self.outcome.as_ref().is_err_and(missed)
    }

    /// Why it has no solution, except for one of a sweep that does not close: one warning speaks of them all.
    #[must_use]
    pub fn failure(&self) -> Option<&Failure> {
        let failure = self.outcome.as_ref().err()?;
        match self.origin {
            PoseOrigin::Expected(_) => None,
            PoseOrigin::Sweep(_) if failure.cause.is_open() => None,
            _ => Some(failure),
        }
    }

    /// It belongs to a sweep and has several assemblies.
    #[must_use]
    pub fn is_ambiguous(&self) -> bool {
        let ambiguous = self.outcome.as_ref().is_err_and(|f| matches!(f.cause, Cause::Ambiguous { .. }));
        ambiguous && matches!(self.origin, PoseOrigin::Sweep(_))
    }
}

impl Solved {
    /// The position, seen from the language.
    #[must_use]
    pub fn view<'a>(&'a self, model: &Model<'a>, statics: &'a WholeCycle) -> PoseAnswers<'a> {
        let view = PoseAnswers::new(model, &self.state, &self.angles, statics);
        let frictionless = self.frictionless.as_deref().map(|(state, values)| (state, values.as_slice()));
        PoseAnswers { quantities: &self.quantities, frictionless, ..view }
    }
}

impl Solution {
    /// One of its positions, seen from the language.
    #[must_use]
    pub fn view<'a>(&'a self, model: &Model<'a>, solved: &'a Solved) -> PoseAnswers<'a> {
        solved.view(model, &self.statics)
    }

    /// Where a pose stands among the events: its instant, s, or the value of the swept drive, rad or m.
    #[must_use]
    pub fn place_of(&self, pose: &Pose) -> Option<f64> {
        match &self.statics.swept {
            None => Some(pose.outcome.as_ref().ok()?.state.motion.time),
            Some(swept) => match pose.drives.get(swept.drive)? {
                DriveValue::Scalar(value) => Some(*value),
                _ => None,
            },
        }
    }

    /// The events that happen at a pose, by their names.
    #[must_use]
    pub fn events_at<'m>(&self, mechanism: &'m Mechanism, pose: &Pose) -> Vec<&'m str> {
        let place = self.place_of(pose);
        let all = mechanism.events.iter().zip(&self.statics.events);
        let here = all.filter(|(_, places)| place.is_some_and(|place| places.contains(&place)));
        here.map(|(event, _)| event.name.as_deref().unwrap_or("end")).collect()
    }
}
