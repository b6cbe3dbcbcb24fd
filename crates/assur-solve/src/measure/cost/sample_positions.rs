//! Places to run a plan at: assembled and followed once, before anything is measured.

use crate::position::{DriveValue, Model, State, turns};
use crate::solve::{Cause, Rates, Sweep, Tracker, WholeCycle, assemble};

/// So many places are enough; more would leave the nearest memory.
const ENOUGH: usize = 64;

/// Where the plan was run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// The positions of the file, or some of them at equal distances.
    Positions,
    /// A turn of the drive, as far as the mechanism closes.
    Turn,
}

pub(super) struct Place {
    /// Inputs, assemblies, bodies.
    pub state: State,
    /// Angles of the bodies, rad.
    pub angles: Vec<f64>,
}

/// The positions of a file that close; of one alone those of a turn of its drive.
pub(super) fn places(
    model: &Model<'_>,
    statics: &WholeCycle,
    rates: &Rates,
) -> Result<(Over, Vec<Place>), Cause> {
    let sweep = Sweep::of(model, statics);
    let apart = sweep.len().div_ceil(ENOUGH).max(1);
    let values: Vec<Vec<DriveValue>> = (0..sweep.len()).step_by(apart).map(|i| sweep.values(i)).collect();
    let (over, ways) = match (values.as_slice(), model.mechanism.drives.as_slice()) {
        ([one], [drive]) if turns(model, drive) => match one[0] {
            DriveValue::Scalar(start) => (Over::Turn, turn(start)),
            _ => (Over::Positions, [values, Vec::new()]),
        },
        _ => (Over::Positions, [values, Vec::new()]),
    };
    // the file's own position, where it has one alone
    let first = first(model, rates, if over == Over::Turn { &ways[0][..1] } else { &ways[0] })?;
    let mut places = Vec::with_capacity(ENOUGH);
    for way in ways {
        let mut tracker = first.clone();
        for values in way {
            if reached(model, rates, &mut tracker, &values, over) {
                rates.at(&values, &mut tracker.state.motion.inputs);
                places.push(Place { state: tracker.state.clone(), angles: tracker.angles.clone() });
            } else if over == Over::Turn {
                break;
            }
        }
    }
    Ok((over, places))
}

/// Moves a tracker to other values, between positions of the file over a gap too; it stays where it is if they do not close.
fn reached(
    model: &Model<'_>,
    rates: &Rates,
    tracker: &mut Tracker,
    values: &[DriveValue],
    over: Over,
) -> bool {
    let before = tracker.clone();
    if tracker.advance_to(model, rates, values).is_ok() {
        return true;
    }
    *tracker = before.clone();
    if over == Over::Positions && tracker.jump(model, rates, values).is_ok() {
        return true;
    }
    *tracker = before;
    false
}

/// The first position that can be assembled; the cause of the first where none can.
fn first(model: &Model<'_>, rates: &Rates, way: &[Vec<DriveValue>]) -> Result<Tracker, Cause> {
    let assembled = |values: &[DriveValue]| {
        let mut state = State::new(model.plan);
        rates.at(values, &mut state.motion.inputs);
        assemble(model, state).map(|state| Tracker::new(model, state, values))
    };
    let found = assembled(way.first().map_or(&[], Vec::as_slice));
    match found {
        Err(cause) if cause.is_open() => {
            way.iter().skip(1).find_map(|values| assembled(values).ok()).ok_or(cause)
        }
        found => found,
    }
}

/// Half a turn from the start to either side.
fn turn(start: f64) -> [Vec<Vec<DriveValue>>; 2] {
    #[allow(clippy::cast_precision_loss)] // 64
    let at = |i: usize, sense: f64| {
        vec![DriveValue::Scalar(start + sense * std::f64::consts::TAU * i as f64 / ENOUGH as f64)]
    };
    let half = ENOUGH / 2;
    [(0..half).map(|i| at(i, 1.0)).collect(), (1..=half).map(|i| at(i, -1.0)).collect()]
}
