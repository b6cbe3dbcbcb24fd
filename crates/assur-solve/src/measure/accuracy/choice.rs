//! What to ask for where positions are solved: the file as it is, looser tolerances, twice the digits.

use super::setting::{Kind, Setting};
use super::study::{AccuracyStudy, Measured, estimated, sampled};
use super::within::{candidates, checked};
use crate::measure::price::CLEARLY;
use crate::plan::{Precision, Settings};
use crate::solve::WholeCycle;

/// Looser accuracies that are tried.
const LOOSER: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];
/// Twice the digits are asked for by this, where `f64` does not keep it: answers are handed on in `f64`.
const TWICE: f64 = 1e-15;

/// One accuracy that `--within` can ask for.
#[derive(Clone, Debug, PartialEq)]
pub struct PositionChoice {
    /// What to ask for; nothing of the file as it is, and of a reference that gives no more digits to the answers.
    pub within: Option<f64>,
    /// What the solver takes for it.
    pub settings: Settings,
    pub micros: f64,
    /// The greatest error, that of functions over the sweep among them.
    pub error: f64,
    /// Samples of the functions over the sweep, and microseconds of all of them.
    pub cycle: Option<(usize, f64)>,
    /// Microseconds of all positions and functions, and of comparing them where that is to be kept.
    pub total: f64,
}

impl PositionChoice {
    /// Digits that are right.
    #[must_use]
    pub fn digits(&self) -> f64 {
        -libm::log10(self.error.max(1e-40))
    }

    /// Whether answers can be had with it.
    #[must_use]
    pub fn can_be_had(&self) -> bool {
        self.within.is_some() || self.settings.scalar == Precision::F64
    }
}

/// What can be asked for: the file as it is first, then from loose to tight.
pub(super) fn choices(
    all: &mut Measured<'_, '_>,
    statics: &WholeCycle,
    study: &AccuracyStudy,
) -> Vec<PositionChoice> {
    let knob = |kind| study.knobs.iter().find(|knob: &&Setting| knob.kind == kind);
    let scalar = |name: &str| {
        let row = knob(Kind::Scalar)?.rows.iter().find(|row| row.setting == name)?;
        Some((row.micros, row.error?))
    };
    let samples = knob(Kind::Samples).and_then(|knob| knob.rows.last()?.samples);
    let priced = |samples: Option<usize>| samples.map(|count| (count, study.sample.time(count)));
    // `--within` compares positions with the reference
    let (twice, compared) = (scalar("double-double"), checked(all.model, study.count));
    let check = compared as f64 * twice.map_or(0.0, |found| found.0);
    let (worst, positions) = (estimated(statics), study.count as f64);
    let choice = |within: Option<f64>, settings, (micros, error): (f64, f64), cycle: Option<(usize, f64)>| {
        let total = positions * micros + cycle.map_or(0.0, |c| c.1);
        let total = if within.is_some() { total + check } else { total };
        PositionChoice { within, settings, micros, error, cycle, total }
    };
    let Some((full, error)) = scalar("f64") else { return Vec::new() };
    let own = choice(None, Settings::FULL, (full, error.max(worst)), priced(samples));
    let iterated = [Kind::Friction, Kind::Newton, Kind::Triad].into_iter().any(|kind| knob(kind).is_some());
    let mut found: Vec<PositionChoice> = Vec::new();
    for within in LOOSER.into_iter().filter(|_| iterated || samples.is_some()) {
        let Some(&settings) = candidates(all.model, within).first().filter(|s| **s != Settings::FULL) else {
            continue;
        };
        // a position with looser tolerances takes no longer
        let (micros, error) = if iterated {
            let (micros, error) = all.with(settings);
            (micros.min(full), error.max(study.floor))
        } else {
            (full, error)
        };
        let (off, count) =
            if samples.is_some() { sampled(all.model, statics, settings) } else { (None, None) };
        let error = off.map_or(error, |off| off.max(worst).max(error));
        // what does not keep it is not what the solver takes for it
        if error <= within && samples.is_some() == count.is_some() {
            found.push(choice(Some(within), settings, (micros, error), priced(count)));
        }
    }
    found.retain(|choice| choice.error > own.error);
    found.dedup_by(|tighter, looser| tighter.error >= looser.error);
    if let Some((micros, error)) = twice.map(|(micros, error)| (micros, error.max(worst))) {
        let needed = own.error > TWICE && error <= TWICE && all.model.plan.laws.is_empty();
        let (within, error) =
            if needed { (Some(TWICE), error.max(0.5 * f64::EPSILON)) } else { (None, error) };
        let settings = Settings { scalar: Precision::DoubleDouble, ..Settings::FULL };
        if error < own.error {
            found.push(choice(within, settings, (micros, error), own.cycle));
        }
    }
    found.insert(0, own);
    found
}

/// The file as it is, unless it does not keep the error wanted or the loosest that does is clearly faster.
pub(super) fn recommended(choices: &[PositionChoice], wanted: f64) -> Option<usize> {
    let keeps = |i: &usize| choices[*i].can_be_had() && choices[*i].error <= wanted;
    let own = choices.first()?;
    let loosest = (1..choices.len()).find(keeps);
    let faster = loosest.filter(|i| choices[*i].total <= CLEARLY * own.total);
    faster.or_else(|| Some(0).filter(keeps)).or(loosest)
}
