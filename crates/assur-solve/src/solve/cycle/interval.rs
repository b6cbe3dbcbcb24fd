//! The sweep as an interval: s from 0 to 1.

use super::super::positions::Sweep;
use super::super::steps::{between, ways};
use crate::answer::{WholeCycle, constant};
use crate::message::{SolveError, label};
use crate::model::Positions;
use crate::position::{DriveValue, Scene, extent, turns};
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
    pub(crate) fn of(scene: &Scene<'_>, statics: &WholeCycle, sweep: &Sweep) -> Result<Self, SolveError> {
        let drives = &scene.mechanism.drives;
        let Some(last) = sweep.len().checked_sub(1) else { return Err(none(scene)) };
        let (from, mut to) = (sweep.values(0), sweep.values(last));
        for ((drive, end), from) in drives.iter().zip(&mut to).zip(&from) {
            match &drive.positions {
                // over a whole turn the last position is left out
                Positions::Range { to: written, .. } => {
                    if let crate::model::Value::Scalar(x) = constant(scene, statics, written) {
                        *end = DriveValue::Scalar(x);
                    }
                }
                Positions::List(list) if list.len() > 1 && (drives.len() > 1 || !in_order(sweep)) => {
                    return Err(unordered(scene, drive.span));
                }
                _ => *end = if sweep.len() > 1 { *end } else { *from },
            }
        }
        let way = Self { is_closed: false, turns: None, from, to };
        if way.from == way.to {
            return Err(none(scene));
        }
        // also where a way is no number
        if !ways(scene, extent(scene), &way.from, &way.to).all(|way| way.abs() <= LONGEST) {
            return Err(too_long(scene));
        }
        let turning = matches!(drives.as_slice(), [drive] if turns(scene, drive));
        let turns = turning.then(|| way.length() / TAU);
        let is_closed = turns.is_some_and(|n| n.round() != 0.0 && (n - n.round()).abs() < 1e-12);
        Ok(Self { is_closed, turns, ..way })
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

/// Where the functions stand that need a sweep.
fn asked(scene: &Scene<'_>) -> Vec<miette::LabeledSpan> {
    let mechanism = scene.mechanism;
    let cycles = mechanism.cycles.iter().map(|c| label("taken over the sweep", c.span));
    let flywheels = mechanism.flywheels.iter().map(|f| label("found over a cycle", f.span));
    cycles.chain(flywheels).collect()
}

fn none(scene: &Scene<'_>) -> SolveError {
    let mut labels = asked(scene);
    let drive = scene.mechanism.drives.first();
    labels.extend(drive.map(|d| label("one position", d.span)));
    let (name, range) = match drive {
        Some(d) if turns(scene, d) => (d.name.as_str(), "0 deg .. 360 deg in 12 steps"),
        Some(d) => (d.name.as_str(), "0 mm .. 200 mm in 10 steps"),
        None => ("crank", "0 deg .. 360 deg in 12 steps"),
    };
    let (why, help) =
        ("the file has one position".to_owned(), format!("let the drive sweep: `drive {name} = {range}`"));
    SolveError::NoSweep { why, help, labels }
}

fn too_long(scene: &Scene<'_>) -> SolveError {
    let mut labels = asked(scene);
    labels.extend(scene.mechanism.drives.iter().map(|d| label("swept that far", d.span)));
    let turning = matches!(scene.mechanism.drives.as_slice(), [drive] if turns(scene, drive));
    let (most, help) = if turning {
        ("111 turns", "look at the unit, or sweep over one cycle: `0 deg .. 360 deg in 12 steps`")
    } else {
        ("400 times the length of the mechanism", "look at the unit, or sweep over less")
    };
    SolveError::NoSweep { why: format!("the sweep is longer than {most}"), help: help.to_owned(), labels }
}

fn unordered(scene: &Scene<'_>, span: crate::source::Span) -> SolveError {
    let mut labels = asked(scene);
    labels.push(label("listed positions", span));
    let why = "the listed positions are no way from a first value to a last".to_owned();
    let help =
        "list the values of one drive in their order, or write a range: `0 deg .. 360 deg in 12 steps`";
    SolveError::NoSweep { why, help: help.to_owned(), labels }
}
