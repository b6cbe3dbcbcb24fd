//! The way between drive values, divided into steps that a motion can be followed by.

use crate::math::Vec2;
use crate::model::Drive;
use crate::position::{DriveValue, Model, extent, turns};

/// The largest step of a turning drive, rad.
const LARGEST_TURN: f64 = 2.0 * std::f64::consts::PI / 180.0;
/// A longer way is not followed: 11,111 turns.
pub(super) const MOST_STEPS: f64 = 2e6;

/// Places nearer to each other than this share of the largest step make no parabola: rounding would bend it.
pub(super) const APART: f64 = 0.25;

/// Drive values part of the way between others.
pub(super) fn between(a: DriveValue, b: DriveValue, part: f64) -> DriveValue {
    match (a, b) {
        (DriveValue::Scalar(a), DriveValue::Scalar(b)) => DriveValue::Scalar(a + (b - a) * part),
        (DriveValue::Point(a), DriveValue::Point(b)) => DriveValue::Point(a + (b - a) * part),
        _ => b,
    }
}

/// Drive values one largest step before these.
pub(super) fn step_before(model: &Model<'_>, values: &[DriveValue]) -> Vec<DriveValue> {
    let length = 0.02 * extent(model);
    let drives = model.mechanism.drives.iter().zip(values);
    let before = drives.map(|(drive, value)| match value {
        DriveValue::Scalar(x) if turns(model, drive) => DriveValue::Scalar(x - LARGEST_TURN),
        DriveValue::Scalar(x) => DriveValue::Scalar(x - length),
        DriveValue::Point(p) => DriveValue::Point(*p - Vec2::new(length, 0.0)),
        DriveValue::None => DriveValue::None,
    });
    before.collect()
}

/// The largest steps of the drives.
#[derive(Clone, Debug)]
pub(super) struct StepLimit {
    largest: Vec<f64>,
    /// General groups are followed by finer ones.
    finer: f64,
}

impl StepLimit {
    pub(super) fn of(model: &Model<'_>) -> Self {
        let length = 0.02 * extent(model);
        let largest = |drive: &Drive| if turns(model, drive) { LARGEST_TURN } else { length };
        let finer = model.plan.general.iter().map(|g| g.faster).fold(1.0, f64::max);
        Self { largest: model.mechanism.drives.iter().map(largest).collect(), finer }
    }

    /// The way between drive values, two components of every drive, in largest steps.
    pub(super) fn ways(&self, from: &[DriveValue], to: &[DriveValue]) -> impl Iterator<Item = f64> {
        let way = |((largest, from), to): ((&f64, &DriveValue), &DriveValue)| match (from, to) {
            (DriveValue::Scalar(a), DriveValue::Scalar(b)) => [(b - a) / largest, 0.0],
            (DriveValue::Point(a), DriveValue::Point(b)) => {
                let way = (*b - *a) / *largest;
                [way.x, way.y]
            }
            _ => [0.0; 2],
        };
        self.largest.iter().zip(from).zip(to).flat_map(way)
    }

    /// How many steps it takes.
    pub(super) fn steps(&self, from: &[DriveValue], to: &[DriveValue]) -> f64 {
        let mut steps = 1.0_f64;
        for way in self.ways(from, to) {
            // a step that is a whole number of largest steps but for rounding takes no step more
            steps = steps.max((way.abs() * self.finer - 1e-9).ceil());
        }
        if steps.is_finite() { steps.min(MOST_STEPS) } else { 1.0 }
    }

    /// Whether it takes one.
    pub(super) fn is_one_step(&self, from: &[DriveValue], to: &[DriveValue]) -> bool {
        self.ways(from, to).all(|way| way.abs() * self.finer - 1e-9 <= 1.0)
    }

    /// Whether places are not nearer to each other than those that make a parabola.
    pub(super) fn is_apart(&self, from: &[DriveValue], to: &[DriveValue]) -> bool {
        length(self.ways(from, to)) >= APART
    }
}

/// The length of a way.
pub(super) fn length(way: impl Iterator<Item = f64>) -> f64 {
    way.map(|x| x * x).sum::<f64>().sqrt()
}
