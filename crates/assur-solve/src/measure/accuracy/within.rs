//! The settings that a wanted accuracy asks for, by a rule that no clock decides.
//!
//! The solver's settings stand in a fixed order of cost: tolerances loosened to what is wanted, all the digits of `f64`, twice
//! its digits. The first is taken whose answers keep what is wanted, measured against the reference.

use super::answer::{Answer, Source};
use super::error::{errors, scales};
use super::study::{AccuracyStudy, estimated};
use crate::measure::runs::RunStudy;
use crate::model::Mechanism;
use crate::plan::{Level, Precision, Settings};
use crate::solve::{Model, Solution, Solved};
use crate::units::significant;
use assur_text::diagnostic::Diagnosis;
use miette::LabeledSpan;

/// Joints must meet to a millionth of the extent, whatever is wanted: no last step of Newton's method is longer, and no gap
/// wider.
const LARGEST_STEP: f64 = 1e-4;
const LARGEST_GAP: f64 = 1e-8;
/// So many positions are held against a reference that takes its time.
const FEW: usize = 8;
/// Coordinates and angles greater than this, for the shortest link or for a radian, cost digits that show.
const ROUNDED: f64 = 1e6;
/// What rounding alone may do, in units of ε/σ^k: see docs/measured/stability.md.
const ROUNDING: f64 = 64.0;

/// What was wanted, and what was reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AchievedAccuracy {
    /// The greatest error wanted.
    pub within: f64,
    /// The greatest error of all positions; measured or, without a reference of twice the digits, estimated from the condition.
    pub error: f64,
    /// What it was measured against.
    pub source: Source,
    pub settings: Settings,
    /// Positions that were held against the reference.
    pub positions: usize,
}

/// Settings for a wanted accuracy, the cheapest first.
#[must_use]
pub fn candidates(model: &Model<'_>, wanted: f64) -> Vec<Settings> {
    let full = Settings::FULL;
    // what Newton's methods leave is of the order of the square of a step; a hundredth of what is wanted for each, and less
    // of what errors of many panels add up to
    let left = 0.01 * wanted;
    let loose = Settings {
        newton: (0.01 * left.sqrt()).clamp(full.newton, LARGEST_STEP),
        triad: left.clamp(full.triad, LARGEST_GAP),
        samples: (0.003 * wanted).max(full.samples),
        root: (0.001 * left).max(full.root),
        ..full.with_friction(left)
    };
    let mut all = vec![loose, full, Settings { scalar: Precision::DoubleDouble, ..full }];
    // the state of a transmission holds more than forces: it is not put together again
    all.retain(|s| s.scalar == Precision::F64 || model.plan.laws.is_empty());
    all.dedup();
    all
}

/// What a solution reaches. Errors of functions over the sweep count as they are estimated.
#[must_use]
pub fn reached(model: &Model<'_>, solution: &Solution, within: f64) -> AchievedAccuracy {
    let poses = solution.poses.iter().filter_map(|p| p.outcome.as_ref().ok());
    let solved: Vec<&Solved> = poses.filter(|s| !s.state.forces.locked).collect();
    let condition = solved.iter().map(|s| s.condition).fold(1.0, f64::min);
    let (mut got, mut exact) = (Vec::new(), Vec::new());
    for index in held(model, &solved) {
        let solved = solved[index];
        got.push(Answer::of(&solved.state));
        exact.extend(solution.exact(model, solved).map(|e| Answer::exact(e, &solved.state)));
    }
    let settings = model.plan.settings;
    let source = if exact.len() == got.len() { Source::DoubleDouble } else { Source::Full };
    let error = match source {
        Source::DoubleDouble => {
            let scales = scales(model, &exact);
            errors(model, &scales, got.iter().zip(&exact)).greatest()
        }
        Source::Full => {
            let power = match model.plan.effects.level {
                Level::Positions => 1,
                Level::Velocities => 2,
                Level::Accelerations => 3 + i32::from(model.plan.effects.beyond),
            };
            let power = if model.plan.effects.forces { power.max(2) } else { power };
            let loose = settings.newton.powi(2).max(settings.friction).max(settings.triad);
            ROUNDING * f64::EPSILON.max(if settings == Settings::FULL { 0.0 } else { loose })
                / condition.powi(power)
        }
    };
    // digits that no number of the file has are in no answer
    let coarsest = model.mechanism.coarsest().map_or(0.0, |s| s.relative()).max(f64::EPSILON);
    let lost = if coarsest > ROUNDED * f64::EPSILON { coarsest } else { 0.0 };
    let error = error.max(lost).max(estimated(&solution.statics));
    AchievedAccuracy { within, error, source, settings, positions: got.len() }
}

/// The number of positions that are compared with the reference.
pub(super) fn checked(model: &Model<'_>, count: usize) -> usize {
    if model.plan.is_batchable() { count } else { count.min(FEW) }
}

/// The positions that are held against the reference: all of them by closed forms; else, because it takes its time, a few:
/// half of them evenly spread, half of them those of the least condition.
fn held(model: &Model<'_>, solved: &[&Solved]) -> Vec<usize> {
    let count = solved.len();
    if checked(model, count) == count {
        return (0..count).collect();
    }
    let mut all: Vec<usize> = (0..count).collect();
    all.sort_by(|&i, &j| solved[i].condition.total_cmp(&solved[j].condition));
    let even = (0..FEW / 2).map(|i| i * count / (FEW / 2));
    let mut chosen: Vec<usize> = all.into_iter().take(FEW / 2).chain(even).collect();
    chosen.sort_unstable();
    chosen.dedup();
    chosen
}

impl AchievedAccuracy {
    /// Whether what is wanted is kept.
    #[must_use]
    pub fn is_kept(&self) -> bool {
        self.error <= self.within
    }

    /// What is said where it is not.
    #[must_use]
    pub fn missed(&self, mechanism: &Mechanism) -> Diagnosis {
        missed(mechanism, "--within", self.within, self.error)
    }
}

/// What is said where no setting keeps what is wanted.
#[must_use]
pub fn out_of_reach(study: &AccuracyStudy, mechanism: &Mechanism) -> Diagnosis {
    let reached =
        study.choices.iter().filter(|c| c.can_be_had()).map(|c| c.error).fold(f64::INFINITY, f64::min);
    missed(mechanism, "--for", study.wanted, reached)
}

/// What is said where no accuracy of a motion under loads keeps what is wanted.
#[must_use]
pub fn run_out_of_reach(study: &RunStudy, mechanism: &Mechanism) -> Diagnosis {
    let rows = study.methods.first().into_iter().flat_map(|method| &method.rows);
    let reached = rows.map(|row| row.error).fold(f64::INFINITY, f64::min).max(study.floor);
    missed(mechanism, "--for", study.wanted, reached)
}

fn missed(mechanism: &Mechanism, option: &str, wanted: f64, reached: f64) -> Diagnosis {
    // the next power of ten above what is reached
    let reachable = libm::pow(10.0, libm::ceil(libm::log10(reached.max(f64::EPSILON))));
    let instead =
        if reachable < 1.0 { format!("write `{option} {reachable:.0e}`, or ") } else { String::new() };
    let label = |span: crate::source::Span| {
        LabeledSpan::new_with_span(Some("driven to these positions".to_owned()), span)
    };
    Diagnosis::error(
        "mech::accuracy::out_of_reach",
        format!(
            "an accuracy of {} cannot be reached: the error of the answers is {reached:.0e}",
            significant(wanted, 2)
        ),
    )
    .labels(mechanism.drives.iter().map(|d| label(d.span)))
    .help(format!(
        "{instead}avoid the position of the least condition, which `assur solve` \
         prints for every pose"
    ))
}
