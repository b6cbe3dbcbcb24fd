//! The sweep as an interval: s from 0 to 1.

use super::super::positions::Sweep;
use super::super::steps::{StepLimit, between};
use crate::answer::{NoSweep, SweepPlace, WholeCycle, constant};
use crate::model::{Cycle, Harmonic, Positions};
use crate::position::{DriveValue, Model, turns};
use std::f64::consts::TAU;

/// The longest way, in largest steps: each is a place that is kept.
const LONGEST: f64 = 20_000.0;

/// The way from the sweep's first position to its last.
#[derive(Clone, Debug)]
pub(super) struct Interval {
    /// Drive values at its beginning.
    pub from: Vec<DriveValue>,
    /// And at its end.
    pub to: Vec<DriveValue>,
    /// It goes through whole turns of the one drive and ends where it began.
    pub is_closed: bool,
    /// Turns of the one drive, where it turns.
    pub turns: Option<f64>,
}

impl Interval {
    /// The sweep of a file.
    pub(crate) fn of(model: &Model<'_>, statics: &WholeCycle, sweep: &Sweep) -> Result<Self, NoSweep> {
        let drives = &model.mechanism.drives;
        let Some(last) = sweep.len().checked_sub(1) else { return Err(NoSweep::OnePosition) };
        let (from, mut to) = (sweep.values(0), sweep.values(last));
        for (index, ((drive, end), from)) in drives.iter().zip(&mut to).zip(&from).enumerate() {
            match &drive.positions {
                // over a whole turn the last position is left out
                Positions::Range { to: written, .. } => {
                    if let crate::model::Value::Scalar(x) = constant(model, statics, written) {
                        *end = DriveValue::Scalar(x);
                    }
                }
                positions if positions.is_long_list() && (drives.len() > 1 || !in_order(sweep)) => {
                    return Err(NoSweep::Unordered(index));
                }
                _ => *end = if sweep.len() > 1 { *end } else { *from },
            }
        }
        if let Some(swept) = &statics.swept
            && let Some(end) = to.get_mut(swept.drive)
        {
            *end = DriveValue::Scalar(swept.to);
        }
        let interval = Self { is_closed: false, turns: None, from, to };
        if interval.from == interval.to {
            return Err(NoSweep::OnePosition);
        }
        // also where a way is no number
        if !StepLimit::of(model).ways(&interval.from, &interval.to).all(|interval| interval.abs() <= LONGEST)
        {
            return Err(NoSweep::TooLong);
        }
        let turning = matches!(drives.as_slice(), [drive] if turns(model, drive));
        let turns = turning.then(|| interval.length() / TAU);
        let is_closed = turns.is_some_and(|n| n.round() != 0.0 && (n - n.round()).abs() < 1e-12);
        Ok(Self { is_closed, turns, ..interval })
    }

    /// Terms of Fourier series need whole turns, those of a half order an even number of them.
    pub(super) fn has_whole_turns(&self, cycles: &[Cycle]) -> Result<(), NoSweep> {
        let mut terms = cycles.iter().filter_map(|cycle| cycle.how.harmonic());
        let turns = self.turns.unwrap_or(f64::NAN);
        let comes_again = |term: Harmonic| {
            self.is_closed && (term.halves.is_multiple_of(2) || (turns.round() / 2.0).fract() == 0.0)
        };
        match terms.find(|term| !comes_again(*term)) {
            Some(term) => Err(NoSweep::PartOfTurn { turns: self.turns, two: term.halves % 2 != 0 }),
            None => Ok(()),
        }
    }

    /// Drive values at a place of the sweep.
    pub(super) fn values(&self, s: f64) -> impl Iterator<Item = DriveValue> {
        self.from.iter().zip(&self.to).map(move |(a, b)| between(*a, *b, s))
    }

    /// Value of the first drive at a place of the sweep.
    pub(super) fn value(&self, s: f64) -> f64 {
        match (self.from.first(), self.to.first()) {
            (Some(DriveValue::Scalar(a)), Some(DriveValue::Scalar(b))) => a + (b - a) * s,
            _ => f64::NAN,
        }
    }

    /// The place of the sweep with these drive values.
    pub(super) fn share(&self, values: &[DriveValue]) -> Option<f64> {
        let ends = self.from.iter().zip(&self.to).zip(values);
        ends.filter_map(|((from, to), at)| match (from, to, at) {
            (DriveValue::Scalar(a), DriveValue::Scalar(b), DriveValue::Scalar(x)) if a != b => {
                Some((x - a) / (b - a))
            }
            _ => None,
        })
        .next()
    }

    /// A place of the sweep with its drive value.
    pub(super) fn place(&self, s: f64) -> SweepPlace {
        SweepPlace { share: s, drive: self.value(s) }
    }

    /// Last less first value of the first drive.
    pub(super) fn length(&self) -> f64 {
        match (self.from.first(), self.to.first()) {
            (Some(DriveValue::Scalar(a)), Some(DriveValue::Scalar(b))) => b - a,
            _ => f64::NAN,
        }
    }
}

/// Whether the values of the one drive go one way.
fn in_order(sweep: &Sweep) -> bool {
    let value = |i: usize| match sweep.values(i).as_slice() {
        [DriveValue::Scalar(x)] => Some(*x),
        _ => None,
    };
    let differences = (1..sweep.len()).map(|i| Some(value(i)? - value(i - 1)?));
    let Some(all) = differences.collect::<Option<Vec<f64>>>() else { return false };
    all.iter().all(|d| *d > 0.0) || all.iter().all(|d| *d < 0.0)
}
