//! The input of a report of answers.

use crate::exercise::Outcome;
use assur_model::model::{Drive, DriveTarget, FindKind, Mechanism};
use assur_solve::measure::accuracy::AchievedAccuracy;
use assur_solve::solve::{DriveValue, Model, MotionScales, Pose, PoseOrigin, Solution};
use assur_text::units::{Dimension, significant};

#[derive(Clone, Copy, Debug)]
pub struct Answers<'a> {
    pub model: Model<'a>,
    pub solution: &'a Solution,
    /// The outcomes of its expectations.
    pub outcomes: &'a [Outcome],
    /// The accuracy wanted and reached, if one was.
    pub reached: Option<&'a AchievedAccuracy>,
    /// How numbers are rounded for people.
    pub precision: PrintedDigits,
}

/// How numbers are rounded for people.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrintedDigits {
    pub digits: usize,
    /// Numbers below this part of the greatest one in their column are printed as 0: they are rounding errors.
    pub noise: f64,
    /// Residuals are printed as a power of ten that they stay below, not in digits.
    pub coarse_residuals: bool,
}

impl PrintedDigits {
    pub const READABLE: Self = Self { digits: 6, noise: 1e-13, coarse_residuals: false };
    /// Independent of the last digits of the arithmetic.
    pub const STABLE: Self = Self { digits: 6, noise: 1e-9, coarse_residuals: true };

    /// A number in figures; `scale` is the greatest magnitude in its column. What is no number has none.
    #[must_use]
    pub fn figures(&self, x: f64, scale: f64) -> String {
        let noise = if scale.is_finite() { self.noise * scale } else { 0.0 };
        match x.abs() {
            magnitude if !magnitude.is_finite() => NONE.to_owned(),
            magnitude if magnitude <= noise => "0".to_owned(),
            _ => significant(x, self.digits),
        }
    }
}

/// A number of a motion that is less than this part of the greatest in its column may be its error. A greater one is never 0, however
/// large the error is: it is reported in addition to the numbers.
const ERROR_OF_MOTION: f64 = 1e-9;

/// The text for a missing number.
pub(super) const NONE: &str = "—";

impl<'a> Answers<'a> {
    /// The poses that are reported: all but those that an `expect` adds.
    pub fn poses(&self) -> impl Iterator<Item = &'a Pose> + use<'a> {
        self.asked_for().filter(|pose| pose.is_position())
    }

    /// The same with what says that a motion missed its accuracy.
    pub fn asked_for(&self) -> impl Iterator<Item = &'a Pose> + Clone + use<'a> {
        self.solution.poses.iter().filter(|p| !matches!(p.origin, PoseOrigin::Expected(_)))
    }

    /// What heads the column with the names of poses: of a motion under loads these are its instants.
    #[must_use]
    pub fn pose_header(&self) -> String {
        pose_header(self.model.mechanism)
    }

    /// The name of a pose in a table for people: an instant is rounded.
    pub(super) fn pose_cell(&self, pose: &Pose) -> String {
        let mechanism = self.model.mechanism;
        match (&mechanism.simulation, &pose.outcome) {
            (Some(_), Ok(solved)) => {
                let time = mechanism.display_of(Dimension::TIME).of_si(solved.state.motion.time);
                significant(time, self.precision.digits)
            }
            _ => pose.name.clone(),
        }
    }

    /// How quantities of a position, or of all, are rounded: of a motion what is below its error is 0. At the first instant, which is
    /// given, there is none.
    pub(super) fn precision_of(&self, pose: Option<&Pose>) -> PrintedDigits {
        let time = pose.and_then(|pose| Some(pose.outcome.as_ref().ok()?.state.motion.time));
        let error = match &self.solution.simulation {
            Some(run) if run.steady.is_some() || time != Some(0.0) => run.error.min(ERROR_OF_MOTION),
            _ => 0.0,
        };
        PrintedDigits { noise: self.precision.noise.max(error), ..self.precision }
    }

    /// A pose by its name, in a sentence.
    pub(super) fn at_pose(&self, name: &str) -> String {
        let mechanism = self.model.mechanism;
        match mechanism.simulation {
            Some(_) => format!("at {name} {}", mechanism.display_of(Dimension::TIME).unit),
            None => format!("at pose {name}"),
        }
    }

    /// What the quantities of these poses are large against.
    #[must_use]
    pub fn greatest(&self) -> MotionScales {
        MotionScales::of(&self.model, self.poses().filter_map(|pose| pose.outcome.as_ref().ok()))
    }

    /// Whether the file asks for all reactions.
    #[must_use]
    pub fn wants_reactions(&self) -> bool {
        self.model.mechanism.finds.iter().any(|f| matches!(f.kind, FindKind::Reactions))
    }

    /// The drives whose values are printed with the answers: none where a motion follows from the loads, since the instants are.
    pub(super) fn shown_drives(&self) -> impl Iterator<Item = (usize, &'a Drive)> + use<'a> {
        let mechanism = self.model.mechanism;
        mechanism.drives.iter().enumerate().filter(|_| mechanism.simulation.is_none())
    }

    /// The value of a drive at a pose in figures, in the author's unit.
    pub(super) fn drive_figures(&self, target: DriveTarget, value: Option<&DriveValue>) -> String {
        let display = self.model.mechanism.drive_display(target);
        let value = value.and_then(DriveValue::value);
        value.map_or_else(|| NONE.to_owned(), |v| display.figures(v, self.precision.digits))
    }
}

/// As [`Answers::pose_header`].
#[must_use]
pub fn pose_header(mechanism: &Mechanism) -> String {
    match mechanism.simulation {
        Some(_) => with_unit("time", &mechanism.display_of(Dimension::TIME).unit),
        None => "pose".to_owned(),
    }
}

/// A name with its unit in brackets, as it heads a column.
pub(super) fn with_unit(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") }
}
